"""Nothing of the studio lies outside its box, at four widths, in two themes: parts and windows."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

import pytest

from outside import OPEN_ALL, outside_anywhere
from samples import led_by
from studio.test_browser_inspect import PANEL
from studio.test_browser_verdict import SNOW
from studio_pages import choose, drop_file, in_bar, opened, settle
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

LONG = "A name as long as those of people who keep every version of a design by its date"
SHEETS = "document.querySelector('[data-testid=sheet-preview]').dataset.state"
SEARCH = "document.querySelector('[data-testid=search]').dataset.state"
Views = Iterator[str]
"""Brings one thing after another to the page, and names it."""


def loaded(page: Page) -> Views:
    """An arch that fails under its snow: all sections and all rows of the verdict are open."""
    page.evaluate("design => window.__orishell.store.change(design, 'snow')", SNOW)
    page.get_by_test_id("design-name").fill(LONG)
    page.get_by_test_id("design-name").press("Enter")
    settle(page)
    yield "verdict"
    page.evaluate(OPEN_ALL)
    yield "all sections"


def refused(page: Page) -> Views:
    """What is wrong, and what would work."""
    choose(page, "parallel-repeating")
    page.evaluate("window.__orishell.store.setPattern('xi_deg', 120)")
    settle(page)
    yield "banner"


def export(page: Page) -> Views:
    """Files for every task, with the sheets that are cut."""
    for _ in loaded(page):
        pass
    page.get_by_test_id("export").click()
    wait_until(page, f"['shown', 'refused'].includes({SHEETS})")
    for each in page.locator("label:has([data-testid^=task-])").all():
        each.click()
        wait_until(page, f"{SHEETS} !== 'waiting'")
        yield each.inner_text()


def cards(page: Page) -> Views:
    """A panel's card, a distance, a pinned design and those of before."""
    choose(page, "parallel-repeating")
    settle(page)
    for name in ("pin", "past"):
        page.get_by_test_id(name).click()
    page.evaluate("window.__orishell.store.setPattern('columns', 12)")
    settle(page)
    page.mouse.click(*page.evaluate(PANEL))
    page.get_by_test_id("inspect-close").wait_for()
    page.get_by_test_id("measure").click()
    yield "cards"


def searched(page: Page) -> Views:
    """The front of a search, a point of it chosen."""
    choose(page, "parallel-repeating")
    settle(page)
    page.evaluate(OPEN_ALL)
    for name, low, high in (("rows", 3, 5), ("columns", 4, 5)):
        page.get_by_test_id(f"search-low-pattern.{name}").fill(str(low))
        page.get_by_test_id(f"search-high-pattern.{name}").fill(str(high))
    page.get_by_test_id("search-go").click()
    wait_until(page, f"['done', 'failed'].includes({SEARCH})")
    page.get_by_test_id("searched-0").locator(".dot").click()
    settle(page)
    yield "front"


def tolerant(page: Page) -> Views:
    """A distance in place of rows and columns."""
    choose(page, "longitudinal-linear-repeating")
    settle(page)
    page.get_by_test_id("mode-tolerance").check(force=True)
    state = "document.querySelector('[data-testid=tradeoff]').dataset.state"
    wait_until(page, f"{state} === 'found'")
    yield "trade-off"


def surface(page: Page) -> Views:
    """A surface is the target, which is fitted or drawn."""
    choose(page, "flat-foldable")
    settle(page)
    page.evaluate(OPEN_ALL)
    yield "surface"


def pattern(page: Page) -> Views:
    """A sheet that somebody has drawn."""
    choose(page, "pattern")
    settle(page)
    page.evaluate(OPEN_ALL)
    yield "drawing"


def dropped(page: Page) -> Views:
    """A drawing was dropped: which curve is it?"""
    choose(page, "orthodiagonal")
    drop_file(page, f"{LONG}.csv", "x,y\n-2,0\n-1,1.2\n0,1.6\n1,1.2\n2,0\n")
    page.get_by_test_id("drop-choice").wait_for()
    yield "question"


def windows(page: Page) -> Views:
    """What lies over the page, and the blank plane."""
    page.keyboard.press("?")
    yield "help"
    page.keyboard.press("Escape")
    in_bar(page, "examples").click()
    yield "examples"
    page.keyboard.press("Escape")
    in_bar(page, "new").click()
    yield "new"


def menu(page: Page) -> Views:
    """The menu that a narrow page has."""
    page.set_viewport_size({"width": 390, "height": 844})
    page.get_by_test_id("toolbar-more").click()
    yield "menu"


VIEWS: tuple[Callable[[Page], Views], ...] = (
    loaded, refused, export, cards, searched, tolerant, surface, pattern, dropped, windows, menu,
)  # fmt: skip


@pytest.mark.parametrize("views", led_by(VIEWS), ids=lambda views: views.__name__)
def test_nothing_of_the_studio_lies_outside(
    browser: Browser, address: str, views: Callable[[Page], Views]
) -> None:
    with opened(browser, address, width=1440, height=900) as page:
        for name in views(page):
            assert outside_anywhere(page) == {}, name
            page.set_viewport_size({"width": 1440, "height": 900})
