"""The guide shows the pages as they are."""

from __future__ import annotations

import re

from samples import thorough
from screenshots import DIGEST, PICTURES, ROOT, digest_of_pages


@thorough
def test_screenshots_are_no_older_than_the_pages() -> None:
    """Anew with ``make screenshots``; only before a release, as every change of a page asks it."""
    assert DIGEST.is_file(), "make screenshots"
    assert DIGEST.read_text() == f"{digest_of_pages()}\n", "make screenshots"


def test_every_screenshot_is_made() -> None:
    """None is left that no test makes anew."""
    tests = [path.read_text() for path in (ROOT / "tests" / "studio").glob("test_*.py")]
    kept = {name for text in tests for name in re.findall(r'keep_picture\(page, "(.+)"\)', text)}
    shown = {path.stem for path in PICTURES.glob("studio*.png")}
    assert kept == shown | {"viewer"}
