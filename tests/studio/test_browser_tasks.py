"""Five tasks from nothing to a file, as a person does them: with mouse, keyboard and files.

How long each step takes, and with how many clicks and keys, is printed with the tests; of clicks
from a drawn arch to a shell that carries there are eight at most.
"""

from __future__ import annotations

import base64
import json
import math
import time
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import pytest
from ezdxf.filemanagement import new, readfile

from command_line import orishell
from orishell.shell.make import design_shell
from samples import led_by, thorough
from studio_pages import IDLE, all_formats, choose, drawn, opened, settle
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PATTERN = Path(__file__).parents[2] / "examples" / "arch_pattern.svg"
SHEETS = "document.querySelector('[data-testid=sheet-preview]').dataset.state === 'shown'"
TRADEOFF = "document.querySelector('[data-testid=tradeoff]').dataset.state === 'found'"
DROP = """([content, name]) => {
    const bytes = Uint8Array.from(atob(content), (each) => each.charCodeAt(0));
    const brought = new DataTransfer();
    brought.items.add(new File([bytes], name));
    const drop = new DragEvent("drop", { dataTransfer: brought, bubbles: true, cancelable: true });
    document.querySelector("[data-curve=f] .plot").dispatchEvent(drop);
}"""
COUNT = """() => {
    window.done = { clicks: 0, keys: 0 };
    // A choice in a list is opened and taken.
    const lists = ({ target }) => target instanceof HTMLSelectElement && (window.done.clicks += 2);
    const listen = (name, act) => addEventListener(name, act, { capture: true });
    listen("pointerdown", () => window.done.clicks++);
    listen("change", lists);
    listen("keydown", () => window.done.keys++);
}"""
"""Counts clicks and strokes of a pointer, and keys that are pressed; text that is typed is none."""
Places = list[tuple[float, float]]


class Steps:
    """Takes the time of the steps of a task, and counts what was clicked and pressed."""

    def __init__(self) -> None:
        self.steps: dict[str, float] = {}
        self.page: Page | None = None
        self.done = {"clicks": 0, "keys": 0}

    def watch(self, page: Page) -> None:
        """Count from now on."""
        self.page = page
        page.evaluate(COUNT)

    @contextmanager
    def step(self, what: str) -> Iterator[None]:
        begin = time.perf_counter()
        yield
        self.steps[what] = time.perf_counter() - begin
        if self.page is not None:
            self.done = self.page.evaluate("window.done")

    def __str__(self) -> str:
        said = ", ".join(f"{what} {seconds:.1f} s" for what, seconds in self.steps.items())
        pressed = f"{self.done['clicks']} clicks, {self.done['keys']} keys"
        return f"{said}; {sum(self.steps.values()):.0f} s in all, {pressed}"


@pytest.fixture
def steps(
    request: pytest.FixtureRequest, record_property: Callable[[str, object], None]
) -> Iterator[Steps]:
    taken = Steps()
    yield taken
    record_property(request.node.name.removeprefix("test_").replace("_", " "), str(taken))


def stroke(page: Page, name: str, places: Places) -> None:
    """Draw in one go, or click, at shares of a curve's plane from its upper left corner."""
    curve = page.get_by_test_id(f"curve-{name}")
    curve.scroll_into_view_if_needed()
    box = curve.bounding_box()
    assert box is not None
    (first, *others) = [
        (box["x"] + x * box["width"], box["y"] + y * box["height"]) for x, y in places
    ]
    page.mouse.move(*first)
    page.mouse.down()
    for each in others:
        page.mouse.move(*each)
    page.mouse.up()
    await_frames(page)


def draw(page: Page, path: Places) -> None:
    """A new design: an arch in one go, half a wave that stands a little open, and a path."""
    page.get_by_test_id("new").click()
    shares = [k / 30 for k in range(31)]
    stroke(page, "f", [(0.25 + 0.5 * s, 0.8 - 0.5 * math.sin(math.pi * s)) for s in shares])
    page.get_by_test_id("sketch-finish").click()
    for each in path:
        stroke(page, "g", [each])
    page.keyboard.press("Enter")
    page.get_by_test_id("sketch-finish").click()
    drawn(page)


def fill(page: Page, test_id: str, value: str) -> None:
    box = page.get_by_test_id(test_id)
    box.fill(value)
    box.press("Enter")


def require_proved(page: Page) -> None:
    settle(page)
    assert page.get_by_test_id("banner").is_hidden(), page.get_by_test_id("banner").inner_text()
    assert "proved" in page.get_by_test_id("verify-status").inner_text()


def export(page: Page, name: str, directory: Path) -> Path:
    all_formats(page)
    with page.expect_download(timeout=120_000) as download:
        page.get_by_test_id(f"export-{name}").click()
    path = directory / download.value.suggested_filename
    download.value.save_as(path)
    return path


def save(page: Page, directory: Path) -> Path:
    page.keyboard.press("Escape")
    with page.expect_download() as download:
        page.keyboard.press("Control+s")
    path = directory / download.value.suggested_filename
    download.value.save_as(path)
    return path


def by_keys(page: Page, test_id: str, *, key: str = "Tab", most: int = 80) -> None:
    """Press Tab, forwards or backwards, until something has the focus."""
    focused = "document.activeElement?.dataset.testid"
    for _ in range(most):
        if page.evaluate(focused) == test_id:
            return
        page.keyboard.press(key)
    raise AssertionError(f"{test_id} is not reached: {page.evaluate(focused)} is")


def test_a_shelter_from_a_drawn_profile_to_cut_files(
    browser: Browser, address: str, tmp_path: Path, steps: Steps
) -> None:
    """3 x 6 m, cut from boards of 2.5 x 1.25 m."""
    with opened(browser, address) as page:
        steps.watch(page)
        with steps.step("draw"):
            draw(page, [(0.1, 0.5), (0.9, 0.5)])
        with steps.step("size"):
            fill(page, "span-f", "3")
            fill(page, "length-g", "6")
            fill(page, "design-name", "shelter")
            require_proved(page)
        with steps.step("sheets"):
            page.get_by_test_id("export").click()
            fill(page, "workshop-stock-width", "2.5")
            fill(page, "workshop-stock-height", "1.25")
            settle(page)
            wait_until(page, SHEETS)
        with steps.step("files"):
            files = export(page, "dxf", tmp_path)
            design = save(page, tmp_path)
    assert design.name == "shelter.toml"
    shell = design_shell(design)
    assert shell.report.deployed.width == pytest.approx(6, rel=0.1)
    assert shell.report.quantities.stock is not None
    with zipfile.ZipFile(files) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path)
    assert len(names) == shell.report.quantities.stock.sheets + 1
    assert all(len(readfile(tmp_path / name).modelspace()) for name in names)


@thorough  # the same by mouse is the quicker member
def test_a_shelter_by_keys_alone(
    browser: Browser, address: str, tmp_path: Path, steps: Steps
) -> None:
    """The same: a profile of three points, a straight path, sizes and boards typed."""
    with opened(browser, address) as page:
        steps.watch(page)
        with steps.step("draw"):
            by_keys(page, "new")
            for presses in (
                ["Enter"] + ["ArrowLeft"] * 6 + ["Space"],
                ["ArrowRight"] * 6 + ["ArrowUp"] * 8 + ["Space"],
                ["ArrowRight"] * 6 + ["ArrowDown"] * 8 + ["Space", "Enter", "Enter"],
                ["ArrowLeft"] * 12 + ["Space"],
                ["ArrowRight"] * 24 + ["Space", "Enter", "Enter"],
            ):
                for each in presses:
                    page.keyboard.press(each)
            drawn(page)
        with steps.step("size"):
            for test_id, size in (("span-f", "3"), ("length-g", "6")):
                by_keys(page, test_id)
                page.keyboard.insert_text(size)
                page.keyboard.press("Enter")
            require_proved(page)
        with steps.step("sheets"):
            by_keys(page, "export", key="Shift+Tab")
            page.keyboard.press("Enter")
            for side, size in (("width", "2.5"), ("height", "1.25")):
                by_keys(page, f"workshop-stock-{side}")
                page.keyboard.insert_text(size)
            page.keyboard.press("Enter")
            settle(page)
            wait_until(page, SHEETS)
        with steps.step("files"):
            by_keys(page, "export-write")
            with page.expect_download(timeout=120_000) as download:
                page.keyboard.press("Enter")
        download.value.save_as(tmp_path / "files.zip")
    with zipfile.ZipFile(tmp_path / "files.zip") as archive:
        assert any(name.endswith(".dxf") for name in archive.namelist())
    assert steps.done["clicks"] == 0


@thorough
def test_a_canopy_from_a_dropped_drawing_with_a_tolerance(
    browser: Browser, address: str, tmp_path: Path, steps: Steps
) -> None:
    """A flat arc of a DXF drawing, as near as its size allows."""
    drawing = new("R2000", units=6)
    drawing.modelspace().add_arc((0, 0), 3, 30, 150)
    drawing.saveas(tmp_path / "canopy.dxf")
    content = base64.b64encode((tmp_path / "canopy.dxf").read_bytes()).decode()
    with opened(browser, address) as page:
        steps.watch(page)
        with steps.step("drop"):
            choose(page, "orthodiagonal")
            page.evaluate(DROP, [content, "canopy.dxf"])
            wait_until(page, "!!window.__orishell.store.design.value.target.f.path")
            require_proved(page)
        with steps.step("tolerance"):
            page.get_by_test_id("mode-tolerance").check(force=True)
            wait_until(page, TRADEOFF, 120)
            page.get_by_test_id("choose").click()
            require_proved(page)
        with steps.step("files"):
            page.get_by_test_id("export").click()
            table = export(page, "fold", tmp_path)
            design = save(page, tmp_path)
    done = orishell("design", design, "--out", tmp_path / "out", "--json")
    report = json.loads(done.stdout)
    assert report["deviation"]["surface"]["max"] <= report["chosen"]["tolerance"] < 1
    assert len(json.loads(table.read_text())["faces_vertices"]) == report["quantities"]["panels"]


@thorough
def test_a_lampshade_of_card_with_its_printed_model(
    browser: Browser, address: str, tmp_path: Path, steps: Steps
) -> None:
    """In millimetres, of card 2 mm thick, with flaps that are clipped on."""
    with opened(browser, address) as page:
        steps.watch(page)
        with steps.step("draw"):
            page.get_by_test_id("unit").select_option("mm")
            draw(page, [(0.1, 0.6), (0.5, 0.5), (0.9, 0.6)])
        with steps.step("size"):
            fill(page, "span-f", "240")
            fill(page, "length-g", "400")
            fill(page, "param-rows", "5")
            fill(page, "param-columns", "6")
            require_proved(page)
        with steps.step("card"):
            page.locator("label:has([data-testid=deployment-flap_attachment-clipped])").click()
            fill(page, "panel-thickness", "2")
            fill(page, "design-name", "lampshade")
            require_proved(page)
        with steps.step("files"):
            page.get_by_test_id("export").click()
            pattern = export(page, "pdf", tmp_path)
            printed = export(page, "3mf", tmp_path)
    with zipfile.ZipFile(pattern) as archive:
        assert "lampshade.pdf" in archive.namelist()  # beside those of the boards
    with zipfile.ZipFile(printed) as archive:
        (model,) = [name for name in archive.namelist() if name.endswith(".model")]
        root = ElementTree.fromstring(archive.read(model))
    assert root.get("unit") == "millimeter"
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    assert len(root.findall(f".//{space}object")) >= 6 * 5  # of every panel a board


CARRIES = "window.__orishell.store.report.value?.structure?.carries"
FOUND = "['found', 'failed'].includes(document.querySelector('[data-testid=carry]').dataset.state)"
CLICKS = 8
"""From the drawn arch to a shell that is said to carry."""
SEARCH = 300.0
"""Seconds in which designs that carry are found."""


@thorough  # a search of minutes
@pytest.mark.parametrize("by", ["mouse", "keys"])
def test_a_drawn_arch_carries_snow_and_wind(
    browser: Browser, address: str, steps: Steps, by: str
) -> None:
    with opened(browser, address) as page:
        draw(page, [(0.1, 0.5), (0.3, 0.56), (0.5, 0.44), (0.7, 0.56), (0.9, 0.5)])
        fill(page, "span-f", "3")
        fill(page, "length-g", "6")
        settle(page)
        page.evaluate("document.activeElement.blur(); scrollTo(0, 0)")
        steps.watch(page)
        with steps.step("loads"):
            if by == "mouse":
                page.get_by_test_id("structure-begin").click()
            else:
                page.locator(".skip", has_text="To the loads").focus()
                page.keyboard.press("Enter")
                page.keyboard.press("Enter")
            # What is known is told before it is tried what would help.
            page.get_by_test_id("make-it-carry").wait_for(timeout=1000 * SEARCH)
        assert page.evaluate(CARRIES) is not True
        with steps.step("search"):
            if by == "mouse":
                page.get_by_test_id("make-it-carry").click()
            else:
                by_keys(page, "make-it-carry")
                page.keyboard.press("Enter")
            wait_until(page, FOUND, SEARCH)
        with steps.step("open"):
            if by == "mouse":
                page.get_by_test_id("carry-open-0").click()
            else:
                assert page.evaluate("document.activeElement.dataset.testid") == "carry-open-0"
                page.keyboard.press("Enter")
            wait_until(page, f"{CARRIES} === true", SEARCH)
            wait_until(page, IDLE, SEARCH)
        assert page.get_by_test_id("structure-verdict").get_attribute("data-tone") == "holds"
    assert steps.done["clicks"] <= (CLICKS if by == "mouse" else 0)


@pytest.mark.parametrize("by", led_by(["mouse", "keys"]))
def test_a_pattern_of_another_program_is_folded_and_shared(
    page: Page, steps: Steps, by: str
) -> None:
    """An SVG in pixels, as wide as somebody says, as one file for a friend."""
    page.evaluate("document.activeElement.blur()")
    steps.watch(page)
    with steps.step("open"):
        with page.expect_file_chooser() as chooser:
            if by == "mouse":
                page.get_by_test_id("open").click()
            else:
                page.keyboard.press("Control+o")
        chooser.value.set_files(PATTERN)
        wait_until(page, "document.activeElement?.dataset.testid === 'drawing-width'")
    with steps.step("size"):
        # The question has the focus, and what is typed is the answer.
        page.keyboard.insert_text("2.4 m")
        settle(page)
        assert page.evaluate("window.__orishell.report.sheet.width") == pytest.approx(2.4)
    with steps.step("share"):
        with page.expect_download(timeout=60_000) as download:
            if by == "mouse":
                page.get_by_test_id("share").click()
            else:
                by_keys(page, "share", key="Shift+Tab")
                page.keyboard.press("Enter")
        text = download.value.path().read_text("utf-8")
    assert download.value.suggested_filename == "arch_pattern-viewer.html"
    assert page.url.partition("?")[0] not in text
    assert steps.done["clicks"] <= (2 if by == "mouse" else 0)
