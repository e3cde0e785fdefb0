"""One whole search for all tests that compare with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from search.searching import design, searched, written


@pytest.fixture(scope="session")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A design file with a small search."""
    return design(tmp_path_factory.mktemp("search"))


@pytest.fixture(scope="session")
def whole(file: Path) -> dict[str, bytes]:
    """What that search writes with one process, into ``one`` beside the file."""
    out = file.parent / "one"
    searched(file, out, "--processes", "1")
    return written(out)
