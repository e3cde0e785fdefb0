"""The site, built once for all tests of it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import pytest

from node_tools import BUILT_DOCS, lacking
from samples import THOROUGH
from viewer_pages import require_viewer

ROOT = Path(__file__).parents[2]
NEEDED = ("sphinx", "furo", "myst_parser", "sphinx_gallery")
SECONDS = 1200
"""So long that may take."""


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site's pages, as of `make docs`; without the gallery's long scripts in `make test`.

    Built here, they are built from a copy, so that nothing is written beside the sources.
    """
    if BUILT_DOCS in os.environ:
        built = ROOT / os.environ[BUILT_DOCS]
        end = time.monotonic() + SECONDS
        while not (built / "docs.done").exists():
            assert time.monotonic() < end, "the site is not built"
            time.sleep(1)
        return built / "docs"
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        lacking(f"the site needs {', '.join(missing)}: make docs")
    require_viewer()
    place = tmp_path_factory.mktemp("site")
    source = place / "source"
    for folder in ("docs", "examples", "frontend/src/shared"):
        leave = shutil.ignore_patterns("__pycache__", "gallery" if folder == "docs" else "")
        shutil.copytree(ROOT / folder, source / folder, ignore=leave)
    for page in ROOT.glob("*.md"):
        shutil.copy(page, source)
    # Every warning is a failure.
    options = ["-q", "-b", "html", "-W", "--keep-going"]
    folders = [str(source / "docs"), str(place / "docs")]
    words = [sys.executable, "-m", "sphinx", *options, *folders]
    briefly = {} if THOROUGH else {"ORISHELL_BRIEFLY": "1"}
    variables = os.environ | briefly
    ran = subprocess.run(words, env=variables, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return place / "docs"
