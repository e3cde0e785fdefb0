"""Sizes of the built shell, typed beside its target, in a real browser."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from node_tools import PACKAGES, lacking
from samples import led_by, thorough
from studio_pages import SIZES, choose, drag, drawn, opened, settle
from viewer_pages import await_frames

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

TARGET = "window.__orishell.store.design.value.target"


def target(page: Page) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate(TARGET)
    return found


def ask(page: Page, key: str, value: str) -> None:
    """Type a size, and leave the box."""
    box = page.get_by_test_id(f"fit-{key}")
    box.fill(value)
    box.press("Enter")


def unfold(page: Page) -> None:
    """Open the fields, if they are not."""
    if not page.get_by_test_id("fit-width").is_visible():
        page.get_by_test_id("built-sizes").click()


def measured(page: Page, key: str) -> str:
    return page.get_by_test_id(f"fit-{key}-measured").inner_text()


def test_a_size_is_asked_for_met_and_taken_back(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    before = target(page)
    unfold(page)
    box = page.evaluate("window.__orishell.report.deployed")
    assert measured(page, "width") == f"is {box['width']:.4g} m"
    ask(page, "width", "20")
    drawn(page)
    assert target(page)["fit"] == {"width": 20}
    # Whether or not it is proved, the shell has that size, and the curves are those of the file.
    assert page.evaluate("window.__orishell.report.fitted.found.width") == pytest.approx(
        20, abs=1e-3
    )
    assert measured(page, "width") == "is 20 m"
    said = page.get_by_test_id("scaled-g").inner_text()
    assert said.startswith("For its sizes the shell follows g scaled by 0.")
    ends = page.evaluate("window.__orishell.store.curves.value.g")
    assert max(x for x, _ in ends) == pytest.approx(before["g"]["range"][1], abs=1e-6)
    ask(page, "width", "")
    drawn(page)
    assert target(page) == before
    assert not page.get_by_test_id("scaled-g").is_visible()


def test_a_size_is_typed_at_the_shell(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    before = target(page)
    box = page.get_by_test_id("size-width")
    wide = page.evaluate("window.__orishell.report.deployed.width")
    assert float(box.input_value()) == pytest.approx(wide, rel=1e-3)
    box.fill("450 cm")
    box.press("Enter")
    drawn(page)
    assert target(page)["fit"] == {"width": 4.5}
    assert page.get_by_test_id("fit-width").input_value() == "4.5"
    # Headroom is a size of the room inside, which takes the place of those outside.
    settle(page)
    room = page.get_by_test_id("size-headroom")
    room.fill(str(round(1.01 * float(room.input_value()), 2)))
    room.press("Enter")
    drawn(page)
    assert target(page)["fit"].keys() == {"height", "of"}
    assert "in place of sizes outside" in page.get_by_test_id("said").inner_text()
    page.get_by_test_id("undo").click()
    drawn(page)
    # Escape leaves it as it is; emptied it is asked for no longer.
    box.fill("7")
    box.press("Escape")
    assert target(page)["fit"] == {"width": 4.5}
    box.fill("")
    box.press("Enter")
    drawn(page)
    assert target(page) == before
    page.get_by_test_id("sizes").click()
    await_frames(page)
    assert box.is_hidden()
    page.get_by_test_id("sizes").click()


@thorough
def test_sizes_inside_are_refused_at_their_field_and_mended(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    unfold(page)
    page.locator("label:has([data-testid=fit-inside])").click()
    assert "fit" not in target(page)  # no size is asked for
    assert [measured(page, key) for key in ("width", "depth")] == ["none", "none"]  # below 2 m
    assert not page.get_by_test_id("fit-head_height").is_visible()
    ask(page, "depth", "1.2")
    settle(page)
    assert target(page)["fit"] == {"depth": 1.2, "of": "inside"}
    section = page.locator(".built-sizes")
    assert "leaves no clear depth up to the head height" in section.inner_text()
    assert section.locator(".faulty [data-testid=fit-depth]").count() == 1
    ask(page, "head_height", "0.5")
    settle(page)
    assert target(page)["fit"]["head_height"] == 0.5
    assert measured(page, "depth") == "is 1.2 m"
    assert section.locator(".faulty").count() == 0
    assert "up to 0.5 m" in section.inner_text()
    # Outside there is no head height; a size of nothing is refused.
    page.locator("label:has([data-testid=fit-outside])").click()
    assert target(page)["fit"] == {"depth": 1.2}
    ask(page, "depth", "0")
    settle(page)
    assert section.locator(".faulty [data-testid=fit-depth]").count() == 1
    page.get_by_test_id("undo").click()
    settle(page)
    assert page.get_by_test_id("fit-depth").input_value() == "1.2"
    # Sizes that were tried are offered in the words of these controls.
    ask(page, "height", "9")
    settle(page)
    page.get_by_test_id("use-nearest").click()
    settle(page)
    height = target(page)["fit"]["height"]
    assert height < 9
    said, shown, unit = measured(page, "height").split()
    assert (said, unit) == ("is", "m")
    assert float(shown) == pytest.approx(height, abs=6e-4)  # both in four digits
    assert section.locator(".faulty").count() == 0


@thorough
def test_curves_are_dragged_with_sizes_as_without(page: Page) -> None:
    ends = []
    for sizes in (False, True):
        choose(page, "orthodiagonal")
        if sizes:
            unfold(page)
            ask(page, "width", "4.5")
            settle(page)
        page.get_by_test_id("mode-g-spline").check(force=True)
        drawn(page)
        drag(page, "point-g-1", 0, -12)
        settle(page)
        ends.append(target(page)["g"]["points"])
        if sizes:
            assert page.evaluate("window.__orishell.report.fitted.found.width") == pytest.approx(
                4.5, abs=1e-3
            )
    # Handles are where the file has the points, not where the scaled target would have them.
    assert ends[1] == [pytest.approx(point, rel=1e-6) for point in ends[0]]


@thorough
@pytest.mark.parametrize("size", led_by(SIZES, 1))
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_fields_are_within_their_column_and_readable(
    browser: Browser, address: str, size: str, theme: str
) -> None:
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    with opened(browser, address, bypass_csp=True, **SIZES[size]) as page:
        choose(page, "orthodiagonal")
        page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
        unfold(page)
        page.locator("label:has([data-testid=fit-inside])").click()
        ask(page, "height", "0.95")
        settle(page)
        section = page.locator(".built-sizes")
        section.scroll_into_view_if_needed()
        assert section.evaluate("each => each.scrollWidth <= each.clientWidth")
        page.add_script_tag(path=str(axe))
        found = page.evaluate(
            "axe.run('.built-sizes').then((result) => result.violations.filter("
            "({ impact }) => ['serious', 'critical'].includes(impact)).map(({ id }) => id))"
        )
        assert found == []
