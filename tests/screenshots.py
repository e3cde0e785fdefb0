"""The guide's screenshots, which tests keep; ``make screenshots`` runs these, and no others."""

from __future__ import annotations

import os
from hashlib import sha256
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PICTURES = ROOT / "docs" / "images"
DIGEST = PICTURES / "screenshots.sha256"
"""Of the pages that they show; this module writes it when it is run."""
WRITES = os.environ.get("ORISHELL_WRITE_PICTURES") == "1"
SOURCES = (ROOT / "frontend" / "src", ROOT / "src" / "orishell" / "studio" / "words.toml")


def digest_of_pages() -> str:
    """Of everything that the pages are built from, and of their words."""
    digest = sha256()
    for source in SOURCES:
        for path in sorted(source.rglob("*.*")) if source.is_dir() else [source]:
            digest.update(path.relative_to(ROOT).as_posix().encode() + b"\n" + path.read_bytes())
    return digest.hexdigest()


def keeps_picture(item: pytest.Item) -> bool:
    """Whether a test takes a screenshot for the guide."""
    function = getattr(item, "function", None)
    return "keep_picture" in getattr(getattr(function, "__code__", None), "co_names", ())


if __name__ == "__main__":
    DIGEST.write_text(f"{digest_of_pages()}\n")
