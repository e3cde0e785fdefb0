"""Other people's software that runs in node: where it is, and how a test asks it something.

``make node`` installs it into ``build/node``, in the versions of ``tests/node/package.json``.
Without it a test is skipped, or fails if the environment has ``ORISHELL_REQUIRE_NODE=1``, as in
``.ci/run``, so that nothing is skipped there unnoticed.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any, NoReturn

import pytest

ROOT = Path(__file__).parents[1]
SCRIPTS = ROOT / "tests" / "node"
PACKAGES = ROOT / "build" / "node" / "node_modules"
REQUIRED = "ORISHELL_REQUIRE_NODE"
BUILT_DOCS = "ORISHELL_BUILT_DOCS"
"""In the environment of ``.ci/run``: where `make docs` builds the site, beside the tests, so that
it is built once."""


def ask_node(script: str, question: Any) -> Any:
    """Run a script of ``tests/node`` with JSON on its standard input; return the JSON it prints.

    Parameters
    ----------
    script
        Name of the file.
    question
        What it is asked; anything that JSON holds.
    """
    node = _find_node()
    answer = subprocess.run(
        [node, SCRIPTS / script],
        input=json.dumps(question, allow_nan=False),
        env={**os.environ, "NODE_PATH": str(PACKAGES)},
        capture_output=True,
        encoding="utf-8",
        timeout=60,
        check=False,
    )
    assert answer.returncode == 0, f"{script}: {answer.stderr}"
    return json.loads(answer.stdout)


def _find_node() -> str:
    """The node program; the test ends here if it or a package is missing."""
    node = shutil.which("node")
    if node is None:
        lacking("node is not installed: on Debian, apt-get install nodejs npm; then make node")
    stale = [name for name, pinned in _pinned().items() if _installed(name) != pinned]
    if stale:
        lacking(f"{', '.join(stale)}: not installed as tests/node/package.json asks; make node")
    return node


def _pinned() -> dict[str, str]:
    wanted: dict[str, str] = json.loads((SCRIPTS / "package.json").read_text())["dependencies"]
    return wanted


def _installed(name: str) -> str | None:
    manifest = PACKAGES / name / "package.json"
    return json.loads(manifest.read_text())["version"] if manifest.is_file() else None


def lacking(what: str, required: str = REQUIRED) -> NoReturn:
    """End a test that lacks something: skipped, or failed where the environment requires it."""
    if os.environ.get(required) == "1":
        pytest.fail(f"{required}=1, but {what}", pytrace=False)
    pytest.skip(what)
