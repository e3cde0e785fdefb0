"""variants.html in a real browser: sliders choose among designs that were made beforehand."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from orishell.search import alone
from orishell.search.variants import write_variants
from outside import outside_anywhere
from page_checks import serious_findings
from samples import thorough
from search.test_page import posed
from search.test_variants import GRID
from viewer_pages import await_frames, require_viewer, wait_until, watched_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a small grid, two of whose six designs are refused."""
    require_viewer()
    place = tmp_path_factory.mktemp("variants")
    problem, found = posed(place, GRID)
    with alone() as pool:
        write_variants(place / "variants.html", problem, found, pool)
    return place / "variants.html"


def settled(page: Page) -> None:
    """What the sliders ask for is shown."""
    wait_until(page, "window.orishell !== undefined && orishell.idle")
    await_frames(page)


def test_sliders_choose_the_nearest_design_that_works(browser: Browser, path: Path) -> None:
    with watched_page(browser, bypass_csp=True) as page:
        page.goto(path.as_uri())
        settled(page)
        rows, angle = page.get_by_role("slider", name="Rows"), page.locator(".variant input").nth(1)
        panels = "orishell.view.faces.length / 4"
        assert page.evaluate(panels) == 36  # 5 x 5 inner vertices
        assert page.locator(".variant-said").is_hidden()
        page.evaluate("orishell.player.set(0.25)")
        rows.focus()
        page.keyboard.press("ArrowLeft")
        settled(page)
        assert rows.get_attribute("aria-valuetext") == "3"
        assert page.evaluate(panels) == 24
        assert page.evaluate("orishell.shell.fold") == pytest.approx(0.25)  # as far folded
        assert page.locator(".variant-figures dd").nth(1).inner_text() == "24"

        # 70 degrees do not work: the nearest design is shown, and why that is so.
        angle.focus()
        page.keyboard.press("End")
        settled(page)
        said = page.locator(".variant-said").inner_text()
        assert said.startswith("This design does not work: xi_deg = 70 is too large for f")
        assert said.endswith("Shown is the nearest: Rows 3, Crease angle \u03be 50\u00b0.")
        assert page.evaluate(panels) == 24
        page.keyboard.press("ArrowLeft")
        settled(page)
        assert page.locator(".variant-said").is_hidden()
        assert serious_findings(page) == []
        for width in (1440, 390):
            page.set_viewport_size({"width": width, "height": 800})
            assert page.evaluate(OVERFLOW) == 0


@thorough  # its panel is the viewer's
def test_nothing_of_the_page_lies_outside(browser: Browser, path: Path) -> None:
    with watched_page(browser) as page:
        page.goto(path.as_uri())
        settled(page)
        page.locator(".variant input").nth(1).focus()
        page.keyboard.press("End")  # what does not work is said
        settled(page)
        assert outside_anywhere(page, opens=True) == {}
