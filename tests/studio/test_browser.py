"""The studio as a person uses it, in a real browser: state and pixels."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from command_line import orishell
from orishell.design_file import starter_file
from samples import led_by, thorough
from studio_pages import (
    TOUCHING,
    all_formats,
    choose,
    drag,
    drawn,
    figures,
    fold,
    opened,
    settle,
    type_into,
)
from viewer_pages import (
    await_frames,
    keep_picture,
    pixels,
    require_apart,
    wait_until,
    watched_page,
)

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page


@pytest.mark.parametrize("family", led_by(["parallel-repeating", "orthodiagonal"]))
def test_from_an_example_to_the_locked_shell(page: Page, family: str) -> None:
    choose(page, family)
    assert page.evaluate("window.__orishell.report.family") == family
    assert "panels" in figures(page).lower()
    fold(page, 1.0)
    locked = pixels(page, ".scene canvas")
    assert np.ptp(locked) > 0.3  # not an empty canvas
    fold(page, 0.0)
    flat = pixels(page, ".scene canvas")
    assert (np.abs(flat - locked).max(axis=2) > 0.1).mean() > 0.01
    for share in (0.013, 0.5, 0.987):  # between the states that were sent
        fold(page, share)
        assert page.evaluate("window.__orishell.shell3d.maxPanelStrain()") < 1e-5


def test_dragging_a_point_changes_the_shell(page: Page) -> None:
    choose(page, "orthodiagonal")
    switch_to_points(page)
    before = page.evaluate("window.__orishell.report.sheet.area")
    words = figures(page)
    drag(page, "point-f-2", 0, 18)
    drawn(page)
    assert page.evaluate("window.__orishell.report.sheet.area") != before
    assert figures(page) != words
    # Undo brings the very shell back, redo takes it away.
    page.get_by_test_id("undo").click()
    drawn(page)
    assert page.evaluate("window.__orishell.report.sheet.area") == before
    page.get_by_test_id("redo").click()
    drawn(page)
    assert page.evaluate("window.__orishell.report.sheet.area") != before


def switch_to_points(page: Page) -> None:
    """Turn f's formula into a spline, whose points can be dragged."""
    if page.get_by_test_id("point-f-0").count() == 0:
        page.get_by_test_id("mode-f-spline").click()
        drawn(page)
    assert page.get_by_test_id("point-f-2").count() == 1


def test_a_parameter_that_does_not_work_is_said_in_words(page: Page) -> None:
    choose(page, "parallel-repeating")
    area = page.evaluate("window.__orishell.report.sheet.area")
    box = page.get_by_test_id("param-xi_deg")
    box.fill("120")
    box.press("Enter")
    drawn(page)
    assert "too large" in page.get_by_test_id("banner").inner_text()
    # The last good shell stays.
    assert page.evaluate("window.__orishell.report.sheet.area") == area
    box.fill("45")
    box.press("Enter")
    drawn(page)
    assert page.evaluate("window.__orishell.report.sheet.area") != area


def test_the_lock_is_proved_while_one_looks(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    status = page.get_by_test_id("verify-status").inner_text().lower()
    assert "proved" in status


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command line writes of an example."""
    place = tmp_path_factory.mktemp("written")
    (place / "orthodiagonal.toml").write_text(starter_file("orthodiagonal"))
    command = ("design", "orthodiagonal.toml", "--out", ".", "--write", "dxf,html")
    assert orishell(*command, cwd=place).returncode == 0
    return place


@thorough  # the bytes that are sent: test_app
def test_export_is_the_command_lines_file(page: Page, written: Path, tmp_path: Path) -> None:
    choose(page, "orthodiagonal")
    page.get_by_test_id("export").click()
    with page.expect_download() as download:
        page.get_by_test_id("export-write").click()
    assert download.value.suggested_filename == "orthodiagonal.dxf"
    download.value.save_as(tmp_path / "there.dxf")
    ours = (written / "pattern.dxf").read_bytes()
    assert (tmp_path / "there.dxf").read_bytes() == ours
    page.keyboard.press("Escape")


def test_save_is_the_same_design(page: Page, tmp_path: Path) -> None:
    choose(page, "longitudinal-linear-repeating")
    area = page.evaluate("window.__orishell.report.sheet.area")
    with page.expect_download() as download:
        page.get_by_test_id("save").click()
    download.value.save_as(tmp_path / "mine.toml")
    done = orishell("design", "mine.toml", "--out", "out", "--json", cwd=tmp_path)
    assert json.loads(done.stdout)["sheet"]["area"] == pytest.approx(area, rel=1e-12)


@thorough
def test_latency_of_a_drag(page: Page, record_property: Callable[[str, object], None]) -> None:
    """Reported, not asserted tightly: other work may be going on."""
    choose(page, "parallel-repeating")
    for key, value in (("rows", "29"), ("columns", "30")):
        box = page.get_by_test_id(f"param-{key}")
        box.fill(value)
        box.press("Enter")
    settle(page)
    first = len(page.evaluate("window.__orishell.latencies"))
    page.locator("summary[data-testid=more]").click()
    slider = page.get_by_test_id("slider-plane_deg")
    slider.focus()
    for _ in range(40):
        slider.press("ArrowRight")
        page.wait_for_timeout(120)
    drawn(page)
    times = page.evaluate("window.__orishell.latencies")[first:]
    median, slowest = np.median(times), max(times)
    record_property("latency of 30 x 30", f"median {median:.0f} ms, slowest {slowest:.0f} ms")
    assert len(times) >= 3
    assert median < 2000


@thorough  # those that are too thick are shown likewise
def test_panels_that_meet_too_early_are_shown_with_what_helps(page: Page) -> None:
    choose(page, "parallel-repeating")
    page.evaluate(TOUCHING)
    settle(page)
    card = page.get_by_test_id("verify-status")
    assert "short of the target" in card.inner_text()
    assert "Nearest found that works" in card.inner_text()
    assert page.get_by_test_id("contact").is_visible()
    card.get_by_test_id("use-nearest").click()
    settle(page)
    low, high = page.evaluate("window.__orishell.store.design.value.target.g.range")
    assert 0 == low < 6 < high < 2 * np.pi
    assert "proved" in card.inner_text()
    assert page.get_by_test_id("refusal").is_hidden()


@thorough
def test_a_shell_that_is_opened_from_its_pack(page: Page) -> None:
    choose(page, "parallel-repeating")
    assert page.get_by_test_id("pack").count() == 0
    assert page.get_by_test_id("target").inner_text() == "Locked"
    page.locator("label:has([data-testid=deployment-from-pack])").click()
    settle(page)
    assert page.get_by_test_id("target").inner_text() == "Target"
    assert page.get_by_test_id("deployment-flap_attachment-folded").is_disabled()
    assert "beyond the target" in page.get_by_test_id("verify-status").inner_text()
    # The slider begins where the pack is proved, and stands at the target.
    drives, named, deployment = page.evaluate(
        "(({ header }) => [header.drives_deg, header.named, header.report.deployment])"
        "(window.__orishell.store.view.value)"
    )
    assert drives[0] == deployment["end_drive_deg"] < 180
    target = page.evaluate("window.__orishell.fold")
    assert target == pytest.approx(1 - drives[named["target"]] / drives[0], rel=1e-12)
    for name, share in (("pack", 0), ("flat", 1), ("target", target)):
        page.get_by_test_id(name).click()
        assert page.evaluate("window.__orishell.fold") == share
        assert page.get_by_test_id("drive").inner_text() == f"{drives[named[name]]:.1f}\u00b0"
    page.get_by_test_id("pack").click()
    page.get_by_test_id("play").click()
    wait_until(page, f"window.__orishell.fold === {target}")
    wait_until(page, "window.__orishell.fold === 1")
    for width in (1280, 760, 390):
        page.set_viewport_size({"width": width, "height": 720})
        require_apart(page, page.locator(".fold-bar :is(button, output)").all(), width)
        assert page.get_by_test_id("target-mark").is_visible()
    page.set_viewport_size({"width": 1280, "height": 720})
    page.get_by_test_id("export").click()
    all_formats(page)
    assert page.locator("label:has([data-testid=state-pack])").is_visible()
    page.keyboard.press("Escape")
    # Folded up from the flat sheet again, flaps end the motion at its last state.
    page.locator("label:has([data-testid=deployment-from-flat])").click()
    settle(page)
    assert "deployment" not in page.evaluate("window.__orishell.store.design.value")
    page.get_by_test_id("target").click()
    assert page.evaluate("window.__orishell.fold") == 1


@thorough  # those that are too thick are the quicker member
def test_panels_with_a_thickness(page: Page) -> None:
    """Their table is edited, and boards are shown where the view has them."""
    choose(page, "parallel-repeating")
    switch = page.locator("label:has([data-testid=thickness])")
    assert switch.is_hidden()
    assert page.get_by_test_id("panel-membrane").is_hidden()
    page.locator("label:has([data-testid=deployment-flap_attachment-clipped])").click()
    table = "window.__orishell.store.design.value.panel"
    box = page.get_by_test_id("panel-thickness")
    type_into(page, "panel-thickness", "0.1")
    assert page.evaluate(table) == {"thickness": 0.1, "membrane": 0.005}
    assert page.get_by_test_id("refusal").is_hidden()
    assert "flaps clipped on stop it" in page.get_by_test_id("verify-status").inner_text()
    assert switch.is_visible()
    on = pixels(page, ".scene canvas")
    switch.click()
    await_frames(page)
    assert (np.abs(on - pixels(page, ".scene canvas")).max(axis=2) > 0.1).mean() > 5e-3
    switch.click()
    type_into(page, "panel-membrane", "0.003")
    assert page.evaluate(table) == {"thickness": 0.1, "membrane": 0.003}
    boards = page.evaluate("window.__orishell.report.panel.boards")
    type_into(page, "panel-thickness", "0.05")
    page.locator("label:has([data-testid=panel-sides-top])").click()
    settle(page)
    assert page.evaluate(table) == {"thickness": 0.05, "membrane": 0.003, "sides": "top"}
    assert 2 * page.evaluate("window.__orishell.report.panel.boards") == boards
    type_into(page, "panel-thickness", "0.1")
    page.locator("label:has([data-testid=panel-construction-bevel])").click()
    settle(page)
    assert page.evaluate(table) == {"thickness": 0.1, "construction": "bevel", "gap": 0.005}
    assert page.get_by_test_id("panel-membrane").is_hidden()
    type_into(page, "panel-gap", "0.002")
    assert page.evaluate("window.__orishell.report.panel.gap") == 0.002
    assert page.evaluate("window.__orishell.report.panel.construction") == "bevel"
    assert page.get_by_test_id("banner").is_hidden()
    # Whole boards on hinges are a choice, and why they are not to be had here is the refusal.
    page.locator("label:has([data-testid=panel-construction-hinged])").click()
    page.get_by_test_id("banner").wait_for()
    assert page.evaluate(table) == {"thickness": 0.1, "construction": "hinged", "gap": 0.002}
    assert "flaps" in page.get_by_test_id("banner").inner_text()
    assert page.get_by_test_id("panel-largest_arm").is_visible()
    box.fill("0")
    drawn(page)
    assert page.evaluate(table) is None
    assert switch.is_hidden()


@thorough
def test_boards_are_drawn_as_they_are_cut(page: Page) -> None:
    """The proof finds corners of boards that would meet, and its view is drawn, not the first."""
    choose(page, "orthodiagonal")
    page.locator("label:has([data-testid=deployment-flap_attachment-clipped])").click()
    settle(page)
    solids = "window.__orishell.shell3d.sheet.boards.solids.geometry"
    page.get_by_test_id("panel-thickness").fill("0.05")
    drawn(page)
    whole = page.evaluate(f"{solids}.attributes.point.count")
    settle(page)
    assert page.evaluate("window.__orishell.report.panel.corners_cut") > 0
    assert page.evaluate(f"{solids}.attributes.point.count") > whole > 0


@thorough
def test_clipped_flaps_are_drawn_at_the_target(page: Page) -> None:
    choose(page, "parallel-repeating")
    page.locator("label:has([data-testid=deployment-flap_attachment-clipped])").click()
    settle(page)
    drawn_there = "window.__orishell.shell3d.clipped.solids.children.some((each) => each.visible)"
    assert page.evaluate("window.__orishell.store.view.value.clipped.length") == 2
    for share in (1, 0.998, 0, 1):
        fold(page, share)
        assert page.evaluate(drawn_there) == (share == 1)
    shown = pixels(page, ".scene canvas")
    page.evaluate("window.__orishell.shell3d.clipped.solids.clear()")
    page.get_by_test_id("fit").click()
    await_frames(page)
    assert (np.abs(shown - pixels(page, ".scene canvas")).max(axis=2) > 0.1).mean() > 1e-3


@thorough  # what is refused and offered: tests/shell/test_panels
def test_panels_that_are_too_thick_are_refused_with_what_works(page: Page) -> None:
    choose(page, "parallel-repeating")
    page.locator("label:has([data-testid=deployment-flap_attachment-clipped])").click()
    type_into(page, "panel-thickness", "5")
    banner = page.get_by_test_id("banner")
    assert "too far" in banner.inner_text()
    assert "Nearest found that works" in banner.inner_text()
    # The membrane of 0.25 that came with the thickness is thicker than panels may be.
    banner.get_by_test_id("use-nearest").click()
    settle(page)
    assert banner.is_hidden()
    table = page.evaluate("window.__orishell.store.design.value.panel")
    assert 0 < 10 * table["membrane"] < table["thickness"] < 0.25
    assert "proved" in page.get_by_test_id("verify-status").inner_text()
    report = page.evaluate("window.__orishell.report.panel")
    assert report["thickness"] == table["thickness"]
    assert page.locator("label:has([data-testid=thickness])").is_visible()


@thorough
def test_ends_of_a_range_are_numbers_or_formulas_of_constants(page: Page) -> None:
    choose(page, "orthodiagonal")
    for typed, kept in (("5*pi/4", "5*pi/4"), ("3.5", 3.5)):
        box = page.get_by_test_id("range-g-high")
        box.fill(typed)
        box.press("Enter")
        settle(page)
        assert page.evaluate("window.__orishell.store.design.value.target.g.range") == [0, kept]
        assert page.get_by_test_id("refusal").is_hidden()
    page.get_by_test_id("formula-g").focus()
    page.evaluate("window.__orishell.store.undo()")
    settle(page)
    assert page.get_by_test_id("range-g-high").input_value() == "5*pi/4"


@thorough
def test_picture_of_the_studio(browser: Browser, address: str) -> None:
    with opened(browser, address, color_scheme="light") as page:
        choose(page, "orthodiagonal")
        page.locator("label:has([data-testid=colour-signs])").click()
        settle(page)
        fold(page, 0.5)
        keep_picture(page, "studio")
        picture = pixels(page, ".scene canvas")
        red = (picture[..., 0] > picture[..., 2] + 0.3).mean()
        blue = (picture[..., 2] > picture[..., 0] + 0.3).mean()
        assert min(red, blue) > 5e-4  # mountains and valleys


def test_the_viewers_page_opens_from_disk(browser: Browser, written: Path) -> None:
    with watched_page(browser, color_scheme="light") as page:
        page.goto((written / "viewer.html").as_uri())
        wait_until(page, "window.orishell !== undefined")
        page.evaluate("orishell.player.set(0.5)")
        assert page.evaluate("orishell.shell.maxPanelStrain()") < 1e-5
        page.get_by_text("Mountain, valley", exact=True).click()
        keep_picture(page, "viewer")
        assert np.ptp(pixels(page, ".orishell-scene canvas")) > 0.3
