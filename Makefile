# make demo    the paper's Figure 1 shell into build/demo/
# make test    all tests
# Both install what they need into .venv; Python 3.11 or newer is all they ask for.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet install --constraint constraints.txt

.PHONY: demo test quick bench lint types contracts check format clean

demo: $(VENV)/.run
	@mkdir -p build
	$(BIN)/orishell design examples/figure1.toml --out build/demo

test: $(VENV)/.test
	$(BIN)/python -m pytest --benchmark-skip

quick: $(VENV)/.test
	$(BIN)/python -m pytest --benchmark-skip -m "not slow"

bench: $(VENV)/.test
	$(BIN)/python -m pytest benchmarks --benchmark-only --benchmark-columns=min,median,rounds --benchmark-sort=name

lint: $(VENV)/.quality
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(VENV)/.quality
	$(BIN)/mypy

contracts: $(VENV)/.quality
	$(BIN)/lint-imports

check: lint types contracts

format: $(VENV)/.quality
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

clean:
	rm -rf build dist $(VENV) .mypy_cache .ruff_cache .hypothesis .benchmarks

$(VENV)/bin/python:
	@$(PYTHON) -m venv $(VENV) || { \
	  rm -rf $(VENV); \
	  echo "A virtual environment is needed: on Debian, apt-get install python3-venv." >&2; \
	  exit 1; }

$(VENV)/.run: $(VENV)/bin/python pyproject.toml constraints.txt
	@echo "installing into $(VENV) ..."
	@$(PIP) --editable .
	@touch $@

$(VENV)/.test: $(VENV)/.run
	@echo "installing into $(VENV) ..."
	@$(PIP) --editable ".[test]"
	@touch $@

$(VENV)/.quality: $(VENV)/.test
	@echo "installing into $(VENV) ..."
	@$(PIP) --editable ".[test,quality]"
	@touch $@
