"""The canvas as the plane of the curves: from New to a shell, by mouse, keys and fingers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

from page_checks import MISPLACED, serious_findings
from samples import thorough
from studio_pages import SIZES, choose, drawn, in_bar, opened
from viewer_pages import await_frames, keep_picture

if TYPE_CHECKING:
    from playwright.sync_api import Browser, FloatRect, Page

DESIGN = "window.__orishell.store.design.value"
EXTENTS = """() => {
    const { f, g } = window.__orishell.store.curves.value;
    const extent = (points, axis) => {
        const values = points.map((each) => each[axis]);
        return Math.max(...values) - Math.min(...values);
    };
    return [extent(g, 0), extent(f, 0), extent(f, 1)];
}"""
COUNT = """() => {
    window.presses = 0;
    addEventListener("pointerdown", () => window.presses++, { capture: true });
}"""


def box(page: Page, test_id: str) -> FloatRect:
    found = page.get_by_test_id(test_id).bounding_box()
    assert found is not None
    return found


def places(page: Page, name: str, *shares: tuple[float, float]) -> list[tuple[float, float]]:
    """Places at shares of a curve's plane, from its upper left corner."""
    plane = box(page, f"curve-{name}")
    return [(plane["x"] + x * plane["width"], plane["y"] + y * plane["height"]) for x, y in shares]


def stroke(page: Page, *track: tuple[float, float]) -> None:
    page.mouse.move(*track[0])
    page.mouse.down()
    for each in track:
        page.mouse.move(*each)
    page.mouse.up()
    await_frames(page)


def test_from_an_empty_studio_to_an_arch_for_a_person(page: Page) -> None:
    """Of 6 x 3.3 x 2.4 m, in five presses: the small planes beside the shell took eight."""
    choose(page, "orthodiagonal")
    page.evaluate(COUNT)
    page.get_by_test_id("new").click()
    await_frames(page)
    step = page.get_by_test_id("sketch-step")
    assert step.inner_text() == "1 of 2: draw the profile f, seen from the front"
    assert box(page, "curve-f")["width"] > 0.45 * 1280
    assert box(page, "curve-f")["height"] > 0.6 * 720
    # The ground and a person on it are there before there is a curve.
    assert page.locator("[data-curve=f] .plot-person").count() == 1
    assert page.get_by_test_id("sketch-finish").get_attribute("aria-disabled") == "true"
    keep_picture(page, "studio-new")
    half = [math.pi * k / 30 for k in range(31)]
    stroke(
        page,
        *places(page, "f", *((0.5 - 0.2 * math.cos(t), 0.75 - 0.45 * math.sin(t)) for t in half)),
    )
    # Its sizes stand on it, ready to be typed.
    page.keyboard.type("3.3")
    page.keyboard.press("Tab")
    page.keyboard.type("2.4")
    await_frames(page)
    span, height, curve = (
        page.locator(each).first.bounding_box()
        for each in (
            ".dimension:has([data-testid=span-f])",
            ".dimension:has([data-testid=height-f])",
            "[data-curve=f] .plot-line",
        )
    )
    assert span is not None
    assert height is not None
    assert curve is not None
    assert span["y"] > curve["y"] + curve["height"]
    assert height["x"] > curve["x"] + 0.5 * curve["width"]
    page.keyboard.press("Enter")
    assert step.inner_text() == "2 of 2: draw the path g, seen from above"
    for each in places(page, "g", (0.2, 0.5), (0.8, 0.5)):
        page.mouse.click(*each)
        await_frames(page)
    page.keyboard.press("Enter")
    page.keyboard.type("6")
    page.get_by_test_id("sketch-finish").click()
    assert page.get_by_test_id("sketch").is_hidden()
    assert page.evaluate("document.activeElement.matches('.scene canvas')")
    drawn(page)
    assert page.evaluate(EXTENTS) == pytest.approx([6, 3.3, 2.4], abs=5e-3)
    assert page.evaluate("window.presses") == 5
    # The sketches are back beside the shell, in which there is a person.
    assert box(page, "curve-f")["width"] < 320
    assert page.get_by_test_id("person").is_checked()
    assert page.get_by_test_id("person").is_visible()


def test_cancel_brings_back_what_was_there(page: Page) -> None:
    choose(page, "orthodiagonal")
    before: Any = page.evaluate(DESIGN)
    sketch = page.get_by_test_id("sketch")
    page.get_by_test_id("new").click()
    page.keyboard.press("Escape")
    assert sketch.is_hidden()
    assert page.evaluate(DESIGN) == before
    # A curve that is drawn anew, and taken back click by click, or at once.
    page.get_by_test_id("draw-g").click()
    for each in places(page, "g", (0.2, 0.6), (0.5, 0.4), (0.8, 0.6)):
        page.mouse.click(*each)
        await_frames(page)
    page.get_by_test_id("sketch-undo").click()
    assert len(page.evaluate(DESIGN)["target"]["g"]["points"]) == 2
    page.get_by_test_id("sketch-cancel").click()
    assert page.evaluate(DESIGN) == before
    page.get_by_test_id("redo").click()
    assert len(page.evaluate(DESIGN)["target"]["g"]["points"]) == 1
    # A curve that is missing is said where the shell would be, and drawn from there.
    drawn_anew = page.get_by_test_id("draw-missing")
    assert "path g" in page.get_by_test_id("blank").inner_text()
    drawn_anew.click()
    assert page.get_by_test_id("sketch-step").inner_text() == "Draw the path g, seen from above"
    # Another design, or another target, ends it.
    page.locator("label:has([data-testid=aim-surface])").click()
    assert sketch.is_hidden()
    page.keyboard.press("Control+z")
    page.get_by_test_id("draw-f").click()
    choose(page, "orthodiagonal")
    assert sketch.is_hidden()
    assert box(page, "curve-f")["width"] < 320


def test_all_of_it_by_keys(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("new").press("Enter")
    for presses in (
        ["ArrowLeft"] * 6 + ["Space"],
        ["ArrowRight"] * 6 + ["ArrowUp"] * 8 + ["Space"],
        ["ArrowRight"] * 6 + ["ArrowDown"] * 8 + ["Space"],
        ["Enter", "Enter"],
        ["ArrowLeft"] * 12 + ["Space"],
        ["ArrowRight"] * 24 + ["Space"],
        ["Enter", "Enter"],
    ):
        for key in presses:
            page.keyboard.press(key)
    assert page.get_by_test_id("sketch").is_hidden()
    target = page.evaluate(DESIGN)["target"]
    assert [len(target[name]["points"]) for name in "fg"] == [3, 2]
    drawn(page)
    assert page.get_by_test_id("banner").is_hidden()


@thorough
def test_with_a_finger_on_a_phone(browser: Browser, address: str) -> None:
    with opened(browser, address, **SIZES["phone"], bypass_csp=True, color_scheme="dark") as page:
        in_bar(page, "new").tap()
        await_frames(page)
        sketch = box(page, "sketch")
        assert (sketch["x"], sketch["y"]) == (0, 0)
        assert (sketch["width"], sketch["height"]) == (390, 844)
        for name, shares in (
            ("f", [(0.25, 0.75), (0.5, 0.45), (0.75, 0.75)]),
            ("g", [(0.2, 0.5), (0.8, 0.5)]),
        ):
            still = box(page, f"curve-{name}")
            for each in places(page, name, *shares):
                page.touchscreen.tap(*each)
            await_frames(page)
            assert box(page, f"curve-{name}") == still  # nothing moves under who draws
            assert serious_findings(page) == []
            assert page.evaluate(MISPLACED) == []
            for test_id in ("sketch-finish", "sketch-cancel", "sketch-undo"):
                assert box(page, test_id)["height"] >= 44
            page.get_by_test_id("sketch-finish").tap()
        assert page.get_by_test_id("sketch").is_hidden()
        drawn(page)
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
