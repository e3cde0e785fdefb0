"""Nothing of the site's pages lies outside its box, at four widths, in two themes."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from outside import outside_anywhere
from samples import led_by

if TYPE_CHECKING:
    from playwright.sync_api import Browser

pytestmark = pytest.mark.slow

PAGES = ("index", "notation", "guide/structure", "theory/vertex", "api/cli", "gallery/plot_canopy")


def wrong(browser: Browser, site: Path, pages: list[Path]) -> dict[str, dict[str, list[str]]]:
    """What lies outside in pages, by their names."""
    found = {}
    with closing(browser.new_page()) as page:
        for path in pages:
            page.goto(path.as_uri())
            if lies := outside_anywhere(page):
                found[str(path.relative_to(site))] = lies
    return found


@pytest.mark.parametrize("some", led_by(["the first of each kind", "all"]))
def test_nothing_of_the_site_lies_outside(browser: Browser, site: Path, some: str) -> None:
    every = sorted(path for path in site.rglob("*.html") if "live" not in path.parts)
    assert len(every) > 40
    pages = [site / f"{name}.html" for name in PAGES] if some != "all" else every
    assert wrong(browser, site, pages) == {}
