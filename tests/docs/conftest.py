"""The site, built once for all tests of it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from viewer_pages import require_viewer

ROOT = Path(__file__).parents[2]
NEEDED = ("sphinx", "furo", "myst_parser", "sphinx_gallery")
BUILT = "ORISHELL_BUILT_DOCS"
"""In the environment of ``.ci/run``: where `make docs` has built it, so that it is built once."""


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the site is, in ``docs``, and its code's output, in ``doctest``, as of `make docs`.

    Built here, it is built from a copy, so that nothing is written beside the sources.
    """
    if BUILT in os.environ:
        return ROOT / os.environ[BUILT]
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        pytest.skip(f"the site needs {', '.join(missing)}: make docs")
    require_viewer()
    place = tmp_path_factory.mktemp("site")
    source = place / "source"
    for folder in ("docs", "examples"):
        leave = shutil.ignore_patterns("__pycache__", "gallery" if folder == "docs" else "")
        shutil.copytree(ROOT / folder, source / folder, ignore=leave)
    for page in ROOT.glob("*.md"):
        shutil.copy(page, source)
    build(source / "docs", place / "docs", "-b", "html", "-W", "--keep-going")
    build(source / "docs", place / "doctest", "-b", "doctest", "-t", "doctest")
    return place


def build(source: Path, out: Path, *options: str) -> None:
    """Build the site; every warning is a failure."""
    words = [sys.executable, "-m", "sphinx", "-q", *options, str(source), str(out)]
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr


@pytest.fixture(scope="session")
def site(built: Path) -> Path:
    """The site's pages."""
    return built / "docs"
