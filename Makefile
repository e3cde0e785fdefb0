# make demo    the paper's Figure 1 shell into build/demo/
# make quick   the tests of what changed since main, or of a room: make quick ROOM=locking; a minute
# make test    all tests
# make thorough  the same, with what is long and rarely fails, and eight times as many random examples
# make least   every command once with the least versions that pyproject.toml allows, and the newest
# make portable  those that compare numbers, as other processors round them
# Both install what they need into .venv; Python 3.11 or newer is all they ask for.
# make pages   builds the studio and the viewer from TypeScript (node 18 or newer, npm)
# make test-pages  their own tests
# make studio  builds and starts the studio
# make screenshots  the guide's, of the pages as they are, into docs/images: look at them, commit them
# make docs    the documentation, with the viewer in it (builds the pages first), into build/docs/
# make paper   the paper's figures and numbers beside ours, into build/paper/
# make cad     build123d for STEP and the tests that ask it, 0.7 GB
# make blender  the add-on for Blender, into build/orishell-blender.zip
# make bpy      Blender as a module, and orishell beside it, into build/bpy for the add-on's tests, 0.9 GB (Python 3.11)
# make everything  what all of these need, at once
# make node    other people's software for the tests that ask it, into build/node (node, npm)

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
NODE := build/node
PAGES := src/orishell/studio/static/index.html
# Two more than there are cores: tests of pages wait as often as they work.
PARALLEL := --numprocesses $(shell echo $$(($$(nproc) + 2))) --dist worksteal
FRONTEND := $(shell find frontend -type f -not -path "*/node_modules/*" 2>/dev/null)
# uv takes a tenth of the time that pip does, which does it where uv cannot: an index of pip's own.
LISTED := --constraint constraints.txt
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet install --no-compile $(LISTED)
UV := $(BIN)/uv pip install --quiet --python $(BIN)/python $(LISTED)
INSTALL := { $(PIP) uv && $(UV) --editable "$$it"; } || $(PIP) --editable "$$it"
# What is imported is compiled then, once; most of what is installed never is.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test thorough least portable docs paper screenshots pages test-pages studio cad node blender bpy everything quick bench lint types contracts check format clean

demo: $(VENV)/.run
	@mkdir -p build
	$(BIN)/orishell design examples/figure1.toml --out build/demo

# As many tests at a time as there are cores; so each keeps its arithmetic on one.
test thorough quick: export OPENBLAS_NUM_THREADS := 1
test thorough quick: export IGL_NUM_THREADS := 1
thorough: export ORISHELL_THOROUGH := 1

test thorough: $(VENV)/.test
	$(BIN)/python -m pytest --benchmark-skip $(PARALLEL) --durations=15

thorough: least

least: $(VENV)/.run $(PAGES)
	.ci/least

portable: $(VENV)/.test
	.ci/portable

pages: $(PAGES)

test-pages: $(PAGES)
	cd frontend && npm run --silent test

studio: $(VENV)/.studio $(PAGES)
	$(BIN)/orishell studio

screenshots: $(VENV)/.test $(PAGES)
	ORISHELL_WRITE_PICTURES=1 ORISHELL_THOROUGH=1 ORISHELL_REQUIRE_NODE=1 $(BIN)/python -m pytest -q tests/studio
	$(BIN)/python tests/screenshots.py

docs: $(VENV)/.docs $(PAGES)
	$(BIN)/python docs/_ext/proofreading.py
	$(BIN)/python -m sphinx -q -W --keep-going -b html -d build/doctrees docs build/docs
	@echo "build/docs/index.html"

paper: $(VENV)/.run
	$(BIN)/python examples/paper.py build/paper

cad: $(VENV)/.cad

node: $(NODE)/.installed

blender: $(VENV)/.run
	$(BIN)/python blender/pack.py build/orishell-blender.zip
	@echo "build/orishell-blender.zip"

# An environment of its own: bpy asks for an older NumPy than the one that is listed.
bpy: pyproject.toml
	@$(PYTHON) -m venv build/bpy
	build/bpy/bin/python -m pip --disable-pip-version-check --quiet install --no-compile --editable ".[blender]"

quick: $(VENV)/.test
	tests=$$($(BIN)/python tests/worked_in.py $(ROOM)) && \
	  $(BIN)/python -m pytest --benchmark-skip $(PARALLEL) -m "not slow" $$tests

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

everything: $(VENV)/bin/python
	@echo "installing into $(VENV) ..."
	@it=".[test,quality,cad,docs]"; $(INSTALL)
	@touch $(VENV)/.run $(VENV)/.test $(VENV)/.quality $(VENV)/.cad $(VENV)/.studio $(VENV)/.docs

$(VENV)/.run: $(VENV)/bin/python pyproject.toml constraints.txt
	@echo "installing into $(VENV) ..."
	@it="."; $(INSTALL)
	@touch $@

$(VENV)/.studio: $(VENV)/.run
	@echo "installing into $(VENV) ..."
	@it=".[studio,notebook]"; $(INSTALL)
	@touch $@

$(PAGES): $(FRONTEND)
	@command -v npm >/dev/null || { \
	  echo "Node.js 18 or newer and npm are needed: on Debian, apt-get install nodejs npm." >&2; \
	  exit 1; }
	@echo "building the pages ..."
	@cd frontend && npm run --silent pages >/dev/null

$(VENV)/.test: $(VENV)/.run
	@echo "installing into $(VENV) ..."
	@it=".[test]"; $(INSTALL)
	@touch $@

$(VENV)/.cad: $(VENV)/.test
	@echo "installing into $(VENV) ..."
	@it=".[test,cad]"; $(INSTALL)
	@touch $@

$(VENV)/.docs: $(VENV)/.studio
	@echo "installing into $(VENV) ..."
	@it=".[docs]"; $(INSTALL)
	@touch $@

$(VENV)/.quality: $(VENV)/.test
	@echo "installing into $(VENV) ..."
	@it=".[test,quality]"; $(INSTALL)
	@touch $@

$(NODE)/.installed: tests/node/package.json
	@command -v node >/dev/null && command -v npm >/dev/null || { \
	  echo "node and npm are needed: on Debian, apt-get install nodejs npm." >&2; \
	  exit 1; }
	@echo "installing into $(NODE) ..."
	@mkdir -p $(NODE)
	@cp tests/node/package.json $(NODE)
	@cd $(NODE) && npm install --loglevel=error --prefer-offline --ignore-scripts \
	  --no-package-lock --no-audit --no-fund >/dev/null
	@touch $@
