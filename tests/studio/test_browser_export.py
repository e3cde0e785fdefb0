"""Tolerances from a plot, the workshop's settings and its sheets, in a real browser."""

from __future__ import annotations

import re
import tomllib
import zipfile
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from node_tools import PACKAGES, lacking
from samples import led_by, thorough
from studio_pages import SIZES, choose, drawn, opened, settle
from viewer_pages import await_frames, keep_picture, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

DESIGN = "window.__orishell.store.design.value"
SHEETS = "document.querySelector('[data-testid=sheet-preview]').dataset.state"
TRADEOFF = "document.querySelector('[data-testid=tradeoff]').dataset.state"


def design(page: Page) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate(DESIGN)
    return found


def say(page: Page, key: str, value: str) -> None:
    """Type a setting of the workshop, and leave the box."""
    box = page.get_by_test_id(f"workshop-{key}")
    box.fill(value)
    box.press("Enter")


def await_sheets(page: Page, state: str = "shown") -> None:
    wait_until(page, f"{SHEETS} === '{state}'")
    await_frames(page)


@thorough
def test_a_tolerance_begins_where_a_shell_is_and_is_chosen_on_a_plot(page: Page) -> None:
    choose(page, "longitudinal-linear-repeating")
    settle(page)
    sizes = design(page)["pattern"]
    page.get_by_test_id("mode-tolerance").check(force=True)
    wait_until(page, f"{TRADEOFF} === 'running'")
    work = page.get_by_test_id("tradeoff-work")
    wait_until(page, "document.querySelector('[data-testid=tradeoff-work] progress').value > 0")
    assert "rows and columns" in work.inner_text().lower()
    wait_until(page, f"{TRADEOFF} === 'found'")
    assert not work.is_visible()

    # What is offered is what a sheet of about as many panels keeps.
    offered = design(page)["tolerance"]["surface"]
    assert f"Allow {offered} m" in page.get_by_test_id("take-tolerance").inner_text()
    assert page.get_by_test_id("tolerance-surface").input_value() == str(offered)
    page.get_by_test_id("choose").click()
    settle(page)
    assert page.evaluate("window.__orishell.report.deviation.surface.max") <= offered
    page.get_by_test_id("undo").click()
    assert design(page)["pattern"] == sizes  # one step

    page.get_by_test_id("redo").click()
    page.get_by_test_id("front-0").hover()
    wait_until(page, "document.querySelector('.stage').dataset.preview === 'true'")
    legend = page.locator(".orishell-legend")
    assert "pointed at" in legend.inner_text()  # as a ghost
    page.mouse.move(1, 1)
    wait_until(page, "document.querySelector('.stage').dataset.preview === 'false'")
    page.get_by_test_id("front-0").click()
    most = page.get_by_test_id("tradeoff-facts").inner_text()
    page.keyboard.press("ArrowRight")
    assert page.get_by_test_id("front-1").get_attribute("aria-selected") == "true"
    assert page.get_by_test_id("tradeoff-facts").inner_text() != most
    page.get_by_test_id("take-tolerance").click()
    assert design(page)["tolerance"]["surface"] != offered
    page.keyboard.press("Tab")
    page.get_by_test_id("front-1").focus()
    page.keyboard.press("End")
    keep_picture(page, "studio-tolerance")
    page.get_by_test_id("take-sizes").click()
    drawn(page)
    taken = design(page)
    assert "tolerance" not in taken
    said = page.get_by_test_id("tradeoff-facts").text_content() or ""
    assert f"{taken['pattern']['rows']} × {taken['pattern']['columns']}" in said
    assert page.evaluate("window.__orishell.report.rows") == taken["pattern"]["rows"]


@thorough
def test_a_search_for_sizes_is_stopped_and_says_why_it_fails(page: Page) -> None:
    choose(page, "orthodiagonal")  # whose sizes no test has sought before
    page.route("**/api/tradeoff", lambda _: None)  # it takes as long as one likes
    page.get_by_test_id("mode-tolerance").check(force=True)
    page.get_by_test_id("tradeoff-work-stop").click()
    page.unroute("**/api/tradeoff")
    assert page.evaluate(TRADEOFF) == "none"
    assert "Stopped" in page.get_by_test_id("tradeoff").inner_text()
    page.get_by_test_id("tolerance-panel_min").fill("50")
    page.get_by_test_id("find-tradeoff").click()
    wait_until(page, f"{TRADEOFF} === 'refused'")
    assert "panel edges from 50" in page.get_by_test_id("tradeoff").inner_text()


@thorough
def test_the_workshop_is_set_and_seen_beside_the_files(page: Page, tmp_path: Path) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("export").click()
    await_sheets(page)
    assert "workshop" not in design(page)
    assert not page.get_by_test_id("workshop-margin").is_visible()  # there is no stock
    say(page, "stock-width", "2.5")
    assert "workshop" not in design(page)  # half a size is none
    say(page, "stock-height", "2.5")
    page.get_by_test_id("workshop-palette").select_option("shop")
    say(page, "margin", "0.05")
    page.get_by_test_id("workshop-title_block").uncheck()
    table = {"stock": [2.5, 2.5], "palette": "shop", "margin": 0.05, "title_block": False}
    assert design(page)["workshop"] == table
    await_sheets(page)
    facts = page.get_by_test_id("sheet-facts").inner_text().split()
    assert facts[facts.index("cut") + 1] == "4"
    place = page.get_by_test_id("sheet-place")
    assert place.inner_text() == "1 of 5: orthodiagonal"
    page.get_by_test_id("sheet-next").click()
    assert place.inner_text() == "2 of 5: orthodiagonal-1"
    picture = page.get_by_test_id("sheet-picture")
    picture.locator("..").press("ArrowRight")
    assert place.inner_text() == "3 of 5: orthodiagonal-2"
    wait_until(page, "document.querySelector('[data-testid=sheet-picture]').naturalWidth > 0")
    assert (picture.get_attribute("src") or "").startswith("blob:")
    keep_picture(page, "studio-export")

    say(page, "stock-height", "0.3")
    await_sheets(page, "refused")
    words = page.get_by_test_id("sheet-note").inner_text()
    assert "do not fit the stock" in words
    assert "Remedy: larger stock" in words
    page.keyboard.press("Escape")
    # The window opens all the same: that is where it is mended.
    page.get_by_test_id("export").click()
    wait_until(page, "document.querySelector('[data-testid=export-write]').disabled")
    say(page, "stock-height", "2.5")
    await_sheets(page)
    page.get_by_test_id("export-close").click()
    with page.expect_download() as download:
        page.get_by_test_id("save").click()
    download.value.save_as(tmp_path / "mine.toml")
    assert tomllib.loads((tmp_path / "mine.toml").read_text())["workshop"] == table

    # What says nothing new is not in the file.
    page.get_by_test_id("export").click()
    page.get_by_test_id("workshop-palette").select_option("plain")
    page.get_by_test_id("workshop-title_block").check()
    say(page, "margin", "0")
    for side in ("width", "height"):
        say(page, f"stock-{side}", "")
    assert "workshop" not in design(page)
    page.keyboard.press("Escape")


@thorough
def test_half_a_size_is_not_another_designs(page: Page) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("export").click()
    say(page, "stock-width", "2.5")
    page.keyboard.press("Escape")
    choose(page, "parallel-repeating")
    page.get_by_test_id("export").click()
    assert page.get_by_test_id("workshop-stock-width").input_value() == ""
    page.keyboard.press("Escape")


def test_files_by_what_they_are_for(page: Page) -> None:
    """By keys alone: each task with its formats, the settings that matter there, one button."""
    choose(page, "orthodiagonal")
    page.get_by_test_id("export").press("Enter")
    await_frames(page)
    write = page.get_by_test_id("export-write")
    for said, format_, setting, other in (
        ("Write DXF", "svg", "stock-width", "paper"),
        ("Write PDF", "pdf", "paper", "stock-width"),
        ("Write KIT", "booklet", "language", "paper"),
        ("Write 3DM", "obj", None, "paper"),
        ("Write CSV", "vtu", "areal_density", "paper"),
    ):
        assert write.inner_text() == said
        assert page.get_by_test_id(f"format-{format_}").is_visible()
        if setting:
            assert page.get_by_test_id(f"workshop-{setting}").is_visible()
        assert not page.get_by_test_id(f"workshop-{other}").is_visible()
        assert page.locator(".export-window .button.primary:visible").count() == 1
        page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowLeft")
    # What the design has nothing for says what it lacks.
    assert page.get_by_test_id("format-inp").is_disabled()
    assert "needs supports" in page.locator("label:has([data-testid=format-inp])").inner_text()
    canvas = page.get_by_test_id("export-shell").locator("canvas")
    colours = "c => new Set(c.getContext('2d').getImageData(0, 0, 560, 400).data).size"
    assert canvas.evaluate(colours) > 20  # the shell is on it
    page.keyboard.press("ArrowRight")
    assert page.locator(".export-window button.format:visible").count() == 17
    assert not write.is_visible()
    page.keyboard.press("ArrowRight")  # round to the first
    page.keyboard.press("Escape")


@thorough
def test_a_booklet_is_leafed_through_and_its_kit_is_one_download(
    page: Page, tmp_path: Path
) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("export").click()
    page.locator("label:has([data-testid=task-kit])").click()
    await_sheets(page)
    place, picture = page.get_by_test_id("sheet-place"), page.get_by_test_id("sheet-picture")
    first, last = re.findall(r"\d+", place.inner_text())
    assert first == "1"
    assert picture.get_attribute("alt") == "Page of the booklet: orthodiagonal"
    page.get_by_test_id("sheet-next").click()
    picture.locator("..").press("ArrowRight")
    assert place.inner_text() == f"Page 3 of {last}"
    wait_until(page, "document.querySelector('[data-testid=sheet-picture]').naturalWidth > 0")
    # On white paper, whatever the page's own colours are, in letters that can be read.
    page.evaluate("document.documentElement.dataset.theme = 'dark'")
    assert (
        picture.evaluate("each => getComputedStyle(each).backgroundColor") == "rgb(255, 255, 255)"
    )
    page.evaluate("delete document.documentElement.dataset.theme")
    assert picture.evaluate("each => each.clientWidth") >= 520
    said = picture.get_attribute("alt")
    page.get_by_test_id("workshop-language").select_option("de")
    wait_until(page, f"{SHEETS} !== 'shown'")
    await_sheets(page)
    assert place.inner_text() == f"Page 3 of {last}"  # the same one
    assert picture.get_attribute("alt") != said

    page.locator("label:has([data-testid=format-card])").click()
    assert page.get_by_test_id("workshop-paper").is_visible()
    await_sheets(page)
    say(page, "paper_scale", "10")
    await_sheets(page, "refused")
    assert "Needed: a value of at most 1" in page.get_by_test_id("sheet-note").inner_text()
    say(page, "paper_scale", "")
    await_sheets(page)
    page.locator("label:has([data-testid=format-kit])").click()
    for name, table in (("kit", True), ("card", False)):
        page.locator(f"label:has([data-testid=format-{name}])").click()
        with page.expect_download() as download:
            page.get_by_test_id("export-write").click()
        assert download.value.suggested_filename == f"orthodiagonal-{name}.zip"
        download.value.save_as(tmp_path / "kit.zip")
        with zipfile.ZipFile(tmp_path / "kit.zip") as archive:
            names = set(archive.namelist())
        assert {"README.md", "booklet/booklet.pdf", "fabric/pattern.dxf"} <= names
        assert ("hinges/creases.csv" in names) is table
    page.get_by_test_id("workshop-language").select_option("en")
    page.keyboard.press("Escape")


@thorough
@pytest.mark.parametrize("size", led_by(SIZES, 2))
def test_the_window_lies_within_the_page(browser: Browser, address: str, size: str) -> None:
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    shape = SIZES[size]
    with opened(browser, address, bypass_csp=True, **shape) as page:
        choose(page, "parallel-repeating")
        page.add_script_tag(path=str(axe))
        page.get_by_test_id("export").click()
        await_sheets(page)
        page.get_by_test_id("workshop-labels").scroll_into_view_if_needed()
        window = page.get_by_role("dialog", name="Export")
        box = window.bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["y"] >= 0
        assert box["x"] + box["width"] <= shape["width"]
        assert box["y"] + box["height"] <= shape["height"]
        assert window.evaluate("window => window.scrollWidth <= window.clientWidth")
        # However far it is scrolled, it can be closed.
        assert page.get_by_test_id("export-close").is_visible()
        for task, theme in product(("cut", "paper", "kit", "cad", "all"), ("light", "dark")):
            page.locator(f"label:has([data-testid=task-{task}])").click()
            if task == "kit":
                await_sheets(page)
                assert window.evaluate("window => window.scrollWidth <= window.clientWidth")
            page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
            found = page.evaluate(
                "axe.run('.export-window').then((result) => result.violations.filter("
                "({ impact }) => ['serious', 'critical'].includes(impact)).map(({ id }) => id))"
            )
            assert found == []
        page.get_by_test_id("export-close").click()
        assert not window.is_visible()
