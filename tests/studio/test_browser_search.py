"""A search on the open design, in a real browser."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from node_tools import PACKAGES, lacking
from samples import led_by, thorough
from studio_pages import SIZES, choose, drawn, opened, settle
from viewer_pages import await_frames, keep_picture, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

DESIGN = "window.__orishell.store.design.value"
STATE = "document.querySelector('[data-testid=search]').dataset.state"
POINTS = "document.querySelectorAll('.search .point').length"
DOTS = "(document.querySelector('.search .beaten')?.getAttribute('d') ?? '').split('M').length - 1"
MADE = f"{POINTS} + {DOTS}"
SIZE_RANGES = {"rows": (3, 7), "columns": (4, 7)}
SHARE = {"pattern.rows": {"low": 3, "high": 7, "step": 2}, "pattern.columns": {"low": 4, "high": 7}}


def design(page: Page) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate(DESIGN)
    return found


def open_section(page: Page) -> None:
    """Open the section, if it is not: the page keeps what another test has opened."""
    if not page.evaluate("document.querySelector('[data-testid=search]').open"):
        page.locator("[data-testid=search] summary").click()


def ask(page: Page) -> None:
    """Open the section, and ask for twelve designs."""
    open_section(page)
    for name, ends in SIZE_RANGES.items():
        for end, value in zip(("low", "high"), ends, strict=True):
            page.get_by_test_id(f"search-{end}-pattern.{name}").fill(str(value))


def await_end(page: Page) -> None:
    wait_until(page, f"['done', 'failed'].includes({STATE})", 120)
    await_frames(page)


def test_the_front_grows_and_a_point_of_it_is_the_open_design(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    before = design(page)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url.rsplit("/", 1)[-1]))
    page.locator("[data-testid=search] summary").click()
    assert "search" not in design(page)  # looking changes nothing
    assert page.get_by_test_id("search-small-panels").is_checked()
    assert page.get_by_test_id("search-small-deviation").is_checked()
    assert page.get_by_test_id("search-small-deflection").count() == 0  # there is no structure
    page.locator("[data-testid=search] summary").click()
    ask(page)
    assert design(page)["search"] == {
        "variables": SHARE,
        "minimise": ["panels", "deviation"],
        "evaluations": 100,
    }
    assert "12 such designs" in page.get_by_test_id("search-count").inner_text()
    page.get_by_test_id("search-go").click()
    wait_until(page, f"{POINTS} > 0")
    assert page.evaluate(STATE) == "running"
    few = page.evaluate(MADE)
    wait_until(page, f"{MADE} > {few}")
    assert " of 12 designs" in page.get_by_test_id("search-work").inner_text()
    await_end(page)
    assert page.evaluate(STATE) == "done"
    assert page.evaluate(MADE) == 12
    assert "12 designs tried" in page.get_by_test_id("search-note").inner_text()
    assert asked == ["search"]  # what is searched for asks for no other shell

    page.get_by_test_id("searched-0").locator(".dot").click()
    drawn(page)
    picked = design(page)
    assert picked["pattern"] | {"rows": 3, "columns": 4} == picked["pattern"]
    assert page.get_by_test_id("searched-0").get_attribute("aria-selected") == "true"
    assert page.evaluate("window.__orishell.report.columns") == 4
    assert "Against the knee" in page.get_by_test_id("search-facts").inner_text()
    page.get_by_test_id("undo").click()
    drawn(page)
    assert design(page)["pattern"] == before["pattern"]  # one step
    assert page.locator(".search .point[aria-selected=true]").count() == 0

    # By keys: the point that was looked at keeps the focus's place.
    page.get_by_test_id("searched-0").focus()
    page.keyboard.press("ArrowRight")
    assert design(page)["pattern"] == before["pattern"]  # walking picks nothing
    page.keyboard.press("Enter")
    settle(page)
    assert page.get_by_test_id("searched-1").get_attribute("aria-selected") == "true"
    assert design(page)["pattern"] != before["pattern"]
    page.get_by_test_id("search-facts").scroll_into_view_if_needed()
    keep_picture(page, "studio-search")

    page.get_by_test_id("unit").select_option("mm")
    settle(page)
    assert page.get_by_test_id("search-facts").count() == 1


def test_a_search_is_stopped_and_keeps_what_there_is(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    open_section(page)
    page.get_by_test_id("search-go").click()
    wait_until(page, f"{POINTS} > 0")
    page.get_by_test_id("search-work-stop").click()
    assert page.evaluate(STATE) == "stopped"
    made = page.evaluate(MADE)
    assert 0 < made < 35
    assert "Stopped" in page.get_by_test_id("search-note").inner_text()
    page.wait_for_timeout(1500)
    assert page.evaluate(MADE) == made
    page.get_by_test_id("searched-0").locator(".dot").click()
    drawn(page)
    assert page.evaluate("window.__orishell.report.rows") == design(page)["pattern"]["rows"]


@thorough
def test_what_may_change_is_added_turned_and_removed(page: Page) -> None:
    choose(page, "orthodiagonal")
    settle(page)
    open_section(page)
    page.get_by_test_id("search-add").select_option("pattern.heading_deg")
    page.get_by_test_id("search-add").select_option("pattern.placement")
    table = design(page)["search"]
    low, high = (table["variables"]["pattern.heading_deg"][end] for end in ("low", "high"))
    assert low < 90 < high
    assert table["variables"]["pattern.placement"] == ["inscribed", "balanced"]
    page.get_by_test_id("search-turn-pattern.heading_deg").click()
    page.get_by_test_id("search-values-pattern.heading_deg").fill("80, 90")
    page.get_by_test_id("search-most-panels").fill("1")
    page.get_by_test_id("search-evaluations").fill("5")
    for key in ("rows", "columns", "placement"):
        page.get_by_test_id(f"search-remove-pattern.{key}").click()
    assert design(page)["search"] == {
        "variables": {"pattern.heading_deg": [80, 90]},
        "minimise": ["panels", "deviation"],
        "subject_to": {"panels": {"most": 1}},
        "evaluations": 5,
    }
    page.get_by_test_id("search-go").click()
    await_end(page)
    assert page.evaluate(STATE) == "failed"
    said = page.get_by_test_id("search-note").inner_text()
    assert "No design was found" in said
    assert "above 1" in said

    # What is not whole is in no file, and cannot be searched for.
    page.get_by_test_id("search-small-panels").uncheck()
    page.get_by_test_id("search-small-deviation").uncheck()
    assert "search" not in design(page)
    assert "at least one figure" in page.get_by_test_id("search-count").inner_text()
    assert page.get_by_test_id("search-go").get_attribute("aria-disabled") == "true"
    page.get_by_test_id("search-small-sheet_area").check()
    page.get_by_test_id("search-most-panels").fill("")
    assert "subject_to" not in design(page)["search"]
    page.get_by_test_id("search-go").click()
    await_end(page)
    assert page.evaluate(POINTS) == 1  # one figure: one design is the best


@thorough
def test_axes_are_chosen_among_three_figures(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    open_section(page)
    page.get_by_test_id("search-high-pattern.columns").fill("9")
    page.get_by_test_id("search-high-pattern.rows").fill("7")
    page.get_by_test_id("search-small-cut_length").check()
    page.get_by_test_id("search-go").click()
    await_end(page)
    across = page.get_by_test_id("search-axis-across")
    places = "[...document.querySelectorAll('.search .ring')].map((ring) => ring.cx.baseVal.value)"
    first = page.evaluate(places)
    across.select_option("cut_length")
    assert page.evaluate(places) != first
    assert "Cut length (m)" in page.get_by_test_id("search-facts").inner_text()


@thorough
@pytest.mark.parametrize("size", led_by(SIZES, 2))
def test_the_section_lies_within_the_page(browser: Browser, address: str, size: str) -> None:
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    with opened(browser, address, bypass_csp=True, **SIZES[size]) as page:
        choose(page, "parallel-repeating")
        page.add_script_tag(path=str(axe))
        ask(page)
        page.get_by_test_id("search-go").click()
        wait_until(page, f"{POINTS} > 1")
        page.get_by_test_id("search-work-stop").click()
        page.get_by_test_id("search-facts").scroll_into_view_if_needed()
        for theme in ("light", "dark"):
            page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
            found = page.evaluate(
                "axe.run('.search').then((result) => result.violations.filter("
                "({ impact }) => ['serious', 'critical'].includes(impact)).map(({ id }) => id))"
            )
            assert found == []
        section = page.get_by_test_id("search")
        assert section.evaluate("part => part.scrollWidth <= part.clientWidth")
        box = section.bounding_box()
        assert box is not None
        assert box["x"] + box["width"] <= SIZES[size]["width"]
