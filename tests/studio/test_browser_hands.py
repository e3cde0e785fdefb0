"""What people do most, by the mouse and by keys alone: with presses and seconds.

An arch drawn on an empty plane, the first of these tasks, is in test_browser_sketch.
"""

from __future__ import annotations

import time
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from samples import thorough
from studio_pages import choose, opened, settle
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

FARTHEST = 250
"""Tabs to any control of the page, at most."""
COUNT = "addEventListener('pointerdown', () => window.presses++, true)"
STATE = "document.querySelector('[data-testid=search]').dataset.state"


@dataclass
class Hands:
    """One who uses the page by its mouse, or by its keys."""

    page: Page
    keys: bool
    presses: int = 0

    def _at(self, selector: str) -> bool:
        found: bool = self.page.evaluate("(at) => document.activeElement.matches(at)", selector)
        return found

    def _go(self, selector: str) -> None:
        """Tab to a control; along a choice of a few by its arrows."""
        name = self.page.locator(selector).first.get_attribute("name") or ""
        for _ in range(FARTHEST):
            if self._at(selector):
                return
            beside = name and self._at(f"input[type=radio][name='{name}']")
            self.page.keyboard.press("ArrowRight" if beside else "Tab")
        raise AssertionError(f"{selector} is out of reach")

    def press(self, selector: str) -> None:
        """A button, a choice or a section's head."""
        self.presses += 1
        control = self.page.locator(selector).first
        radio = control.get_attribute("type") == "radio"
        if not self.keys:
            where = self.page.locator(f"label:has({selector})") if radio else control
            where.first.click()
            return
        self._go(selector)
        if not radio:
            self.page.keyboard.press("Enter")

    def type(self, selector: str, text: str) -> None:
        """A text into a box."""
        self.presses += 1
        if self.keys:
            self._go(selector)
        else:
            self.page.locator(selector).click()
        self.page.keyboard.press("Control+A")
        self.page.keyboard.type(text)
        await_frames(self.page)

    def take(self, selector: str, text: str) -> None:
        """One of a list."""
        self.presses += 1
        if self.keys:
            self._go(selector)
            self.page.keyboard.type(text)
        else:
            self.page.locator(selector).select_option(text)
        await_frames(self.page)


def at(name: str) -> str:
    return f"[data-testid={name}]"


def from_pack_to_target(hands: Hands) -> None:
    hands.press(at("pack"))
    wait_until(hands.page, "window.__orishell.fold === 0")
    hands.press(at("target"))
    wait_until(hands.page, "window.__orishell.fold > 0.3")


def boards_and_their_drawings(hands: Hands) -> None:
    hands.type(at("panel-thickness"), "0.01")
    settle(hands.page)
    hands.press(at("export"))
    await_frames(hands.page)
    with hands.page.expect_download(timeout=120_000) as download:
        hands.press(at("export-write"))
    with zipfile.ZipFile(BytesIO(Path(download.value.path()).read_bytes())) as files:
        assert any(name.endswith(".dxf") for name in files.namelist())
    panel = hands.page.evaluate("window.__orishell.report.panel")
    assert panel["thickness"] == 0.01
    assert panel["boards"] > 0


def snow_and_a_verdict(hands: Hands) -> None:
    hands.take(at("structure-material"), "birch plywood")
    hands.type(at("structure-snow"), "0.4")
    settle(hands.page)
    rows = hands.page.evaluate("window.__orishell.report.verdict")
    stands = next(each for each in rows if each["subject"] == "stands")
    verdict = hands.page.get_by_test_id("structure-verdict")
    assert f"Stands {stands['finding']}" in verdict.inner_text()


def a_search_and_a_pick(hands: Hands) -> None:
    before = hands.page.evaluate("window.__orishell.store.design.value.pattern")
    hands.press(f"{at('search')} > summary")
    for name, value in (("low", "3"), ("high", "5")):
        hands.type(at(f"'search-{name}-pattern.rows'"), value)
        hands.type(at(f"'search-{name}-pattern.columns'"), value)
    hands.press(at("search-go"))
    wait_until(hands.page, f"['done', 'failed'].includes({STATE})", 120)
    await_frames(hands.page)
    hands.press("[data-testid^=searched-]")
    settle(hands.page)
    after = hands.page.evaluate("window.__orishell.store.design.value.pattern")
    assert {after["rows"], after["columns"]} <= {3, 4, 5}
    assert after != before


TASKS: dict[str, tuple[Callable[[Hands], None], int]] = {
    "pack to target": (from_pack_to_target, 2),
    "boards and DXF": (boards_and_their_drawings, 3),
    "snow and verdict": (snow_and_a_verdict, 2),
    "search and pick": (a_search_and_a_pick, 7),
}
"""Each with its presses: of a button, a box that is typed into, a list."""


@pytest.fixture
def studio_page(browser: Browser, address: str) -> Iterator[Page]:
    """A page of its own with the shelter, or the parallel starter, whose search is quick."""
    with opened(browser, address) as page:
        page.evaluate(COUNT)
        yield page


@thorough
@pytest.mark.parametrize("keys", [False, True], ids=["mouse", "keys"])
@pytest.mark.parametrize("task", TASKS)
def test_a_task(
    studio_page: Page, task: str, keys: bool, record_property: Callable[[str, object], None]
) -> None:
    if task == "search and pick":
        choose(studio_page, "parallel-repeating")
    settle(studio_page)
    does, presses = TASKS[task]
    studio_page.evaluate("window.presses = 0")
    hands, begin = Hands(studio_page, keys), time.perf_counter()
    does(hands)
    took = time.perf_counter() - begin
    assert hands.presses == presses
    if keys:
        assert studio_page.evaluate("window.presses") == 0
    record_property(f"{task}, {'keys' if keys else 'mouse'}", f"{presses} presses, {took:.1f} s")
