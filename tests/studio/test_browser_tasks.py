"""Three tasks from nothing to a file, as a person does them: with mouse, keyboard and files.

How long each step takes is printed with the tests, not limited.
"""

from __future__ import annotations

import math
import time
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from ezdxf.filemanagement import readfile

from orishell.shell.make import design_shell
from studio_pages import drawn, opened, settle
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Download, Page

SHEETS = "document.querySelector('[data-testid=sheet-place]').textContent !== ''"
Record = Callable[[str, object], None]


class Steps:
    """Takes the time of the steps of a task."""

    def __init__(self, task: str, record: Record) -> None:
        self.task, self.record, self.steps = task, record, dict[str, float]()

    @contextmanager
    def step(self, what: str) -> Iterator[None]:
        begin = time.perf_counter()
        yield
        self.steps[what] = time.perf_counter() - begin

    def done(self) -> None:
        said = ", ".join(f"{what} {seconds:.1f} s" for what, seconds in self.steps.items())
        self.record(self.task, f"{said}; {sum(self.steps.values()):.0f} s in all")


def stroke(page: Page, name: str, points: list[tuple[float, float]]) -> None:
    """Draw in one go, through shares of a curve's plane from its upper left corner."""
    curve = page.get_by_test_id(f"curve-{name}")
    curve.scroll_into_view_if_needed()
    box = curve.bounding_box()
    assert box is not None
    places = [(box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in points]
    page.mouse.move(*places[0])
    page.mouse.down()
    for each in places[1:]:
        page.mouse.move(*each)
    page.mouse.up()
    await_frames(page)


def arch(count: int = 30) -> list[tuple[float, float]]:
    """An arch that stands a little open: half a wave."""
    shares = [k / count for k in range(count + 1)]
    return [(0.25 + 0.5 * share, 0.85 - 0.6 * math.sin(math.pi * share)) for share in shares]


def click_points(page: Page, name: str, points: list[tuple[float, float]]) -> None:
    for each in points:
        stroke(page, name, [each])
    page.keyboard.press("Enter")


def fill(page: Page, test_id: str, value: str) -> None:
    box = page.get_by_test_id(test_id)
    box.fill(value)
    box.press("Enter")


def export(page: Page, name: str) -> Download:
    with page.expect_download(timeout=120_000) as download:
        page.get_by_test_id(f"export-{name}").click()
    return download.value


def test_a_shelter_from_a_drawn_profile_to_cut_files(
    browser: Browser, address: str, tmp_path: Path, record_property: Record
) -> None:
    """3 x 6 m, cut from boards of 2.5 x 1.25 m."""
    steps = Steps("a shelter from a drawn profile", record_property)
    with opened(browser, address) as page:
        with steps.step("draw"):
            page.get_by_test_id("new").click()
            stroke(page, "f", arch())
            click_points(page, "g", [(0.1, 0.5), (0.9, 0.5)])
            drawn(page)
        with steps.step("size"):
            fill(page, "span-f", "3")
            fill(page, "length-g", "6")
            fill(page, "design-name", "shelter")
            settle(page)
        assert page.get_by_test_id("banner").is_hidden()
        assert "proved" in page.get_by_test_id("verify-status").inner_text()
        with steps.step("sheets"):
            page.get_by_test_id("export").click()
            fill(page, "workshop-stock-width", "2.5")
            fill(page, "workshop-stock-height", "1.25")
            wait_until(
                page, "document.querySelector('[data-testid=sheet-place]').textContent !== ''"
            )
        with steps.step("files"):
            files = export(page, "dxf")
            files.save_as(tmp_path / files.suggested_filename)
            page.keyboard.press("Escape")
            with page.expect_download() as download:
                page.keyboard.press("Control+s")
            download.value.save_as(tmp_path / "shelter.toml")
    steps.done()
    design = check_design(
        tomllib.loads((tmp_path / "shelter.toml").read_text()), tmp_path / "shelter.toml"
    )
    shell = make_shell(design)
    assert shell.report.deployed.width == pytest.approx(6, rel=0.2)
    stock = shell.report.quantities.stock
    assert stock is not None
    with zipfile.ZipFile(tmp_path / files.suggested_filename) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path)
    assert len(names) == stock.sheets + 1
    assert all(readfile(tmp_path / name).modelspace() for name in names)
