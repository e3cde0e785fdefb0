"""Five tasks from nothing to a file, as a person does them: with a mouse, and with keys alone.

How long each step takes, and with how many clicks and keys, is printed with the tests; of clicks
from a drawn arch to a shell that carries there are eight at most.
"""

from __future__ import annotations

import json
import math
import zipfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import pytest
from ezdxf.filemanagement import readfile

from command_line import orishell
from orishell.shell.make import design_shell
from samples import led_by, thorough
from studio_pages import IDLE, drawn, opened, settle
from studio_person import BOTH, By, Person
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

EXAMPLES = Path(__file__).parents[2] / "examples"
SHEETS = "document.querySelector('[data-testid=sheet-preview]').dataset.state === 'shown'"
TRADEOFF = "document.querySelector('[data-testid=tradeoff]').dataset.state === 'found'"
CARRIES = "window.__orishell.store.report.value?.structure?.carries"
FOUND = "['found', 'failed'].includes(document.querySelector('[data-testid=carry]').dataset.state)"
CLICKS = 8
"""From the drawn arch to a shell that is said to carry."""
SEARCH = 300.0
"""Seconds in which designs that carry are found."""
STRAIGHT = [(0.1, 0.5), (0.9, 0.5)]
BENT = [(0.1, 0.6), (0.5, 0.5), (0.9, 0.6)]
"""Paths, as shares of their plane from its upper left corner."""
Places = Sequence[tuple[float, float]]
Begin = Callable[["Page", By], Person]


@pytest.fixture
def begin(
    request: pytest.FixtureRequest, record_property: Callable[[str, object], None]
) -> Iterator[Begin]:
    """Someone whose steps are counted from now on, and told at the end."""
    people: list[Person] = []

    def began(page: Page, by: By) -> Person:
        people.append(Person(page, by))
        people[0].begin()
        return people[0]

    yield began
    for each in people:
        record_property(request.node.name.removeprefix("test_").replace("_", " "), str(each))


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
    """An arch in one go, and a path point by point, in the planes of a new design."""
    shares = [k / 30 for k in range(31)]
    stroke(page, "f", [(0.25 + 0.5 * s, 0.8 - 0.5 * math.sin(math.pi * s)) for s in shares])
    page.get_by_test_id("sketch-finish").click()
    for each in path:
        stroke(page, "g", [each])
    page.keyboard.press("Enter")
    page.get_by_test_id("sketch-finish").click()
    drawn(page)


def draw_by_keys(someone: Person, path: Places) -> None:
    """A profile of three points, and a path: steps of the cross from one point to the next."""
    across, up, put, end = ["ArrowRight"] * 6, ["ArrowUp"] * 8, ["Space"], ["Enter"] * 2
    someone.keys(["ArrowLeft"] * 6, put, across, up, put, across, ["ArrowDown"] * 8, put, end)
    at = (0.5, 0.5)
    for x, y in path:
        for share, (less, more) in (
            (x - at[0], ("ArrowLeft", "ArrowRight")),
            (y - at[1], ("ArrowUp", "ArrowDown")),
        ):
            someone.keys([more if share > 0 else less] * round(abs(30 * share)))
        someone.keys(put)
        at = (x, y)
    someone.keys(end)
    drawn(someone.page)


def begin_a_drawing(someone: Person, path: Places, *, back: bool = False) -> None:
    someone.press("new", back=back)
    if someone.by == "mouse":
        draw(someone.page, path)
    else:
        draw_by_keys(someone, path)


def require_proved(page: Page) -> None:
    settle(page)
    assert page.get_by_test_id("banner").is_hidden(), page.get_by_test_id("banner").inner_text()
    assert "proved" in page.get_by_test_id("verify-status").inner_text()


def save(someone: Person, directory: Path) -> Path:
    page = someone.page
    page.keyboard.press("Escape")
    with page.expect_download() as download:
        page.keyboard.press("Control+s")
    path = directory / download.value.suggested_filename
    download.value.save_as(path)
    return path


def write(someone: Person, name: str, directory: Path, *, back: bool = False) -> Path:
    """A file of the window of files."""
    file = someone.receive(name, back=back)
    path = directory / file.suggested_filename
    file.save_as(path)
    return path


@pytest.mark.parametrize("by", led_by(BOTH))
def test_a_shelter_from_a_drawn_profile_to_cut_files(
    browser: Browser, address: str, tmp_path: Path, begin: Begin, by: By
) -> None:
    """3 x 6 m, cut from boards of 2.5 x 1.25 m."""
    with opened(browser, address) as page:
        someone = begin(page, by)
        with someone.step("draw"):
            begin_a_drawing(someone, STRAIGHT)
        with someone.step("size"):
            someone.write("span-f", "3", back=True)
            someone.write("length-g", "6")
            someone.write("design-name", "shelter", back=True)
            require_proved(page)
        with someone.step("sheets"):
            someone.press("export")
            someone.write("workshop-stock-width", "2.5")
            someone.write("workshop-stock-height", "1.25")
            settle(page)
            wait_until(page, SHEETS)
        with someone.step("files"):
            files = write(someone, "export-write", tmp_path)
            design = save(someone, tmp_path)
    assert design.name == "shelter.toml"
    shell = design_shell(design)
    assert shell.report.deployed.width == pytest.approx(6, rel=0.1)
    assert shell.report.quantities.stock is not None
    with zipfile.ZipFile(files) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path)
    assert len(names) == shell.report.quantities.stock.sheets + 1
    assert all(len(readfile(tmp_path / name).modelspace()) for name in names)
    assert someone.done["clicks"] <= (20 if by == "mouse" else 0)


@thorough
@pytest.mark.parametrize("by", BOTH)
def test_a_canopy_over_a_mesh_file_with_a_tolerance(
    browser: Browser, address: str, tmp_path: Path, begin: Begin, by: By
) -> None:
    """The curves of the mesh, in a family that sweeps, then as near as they can be followed."""
    with opened(browser, address) as page:
        someone = begin(page, by)
        with someone.step("mesh"):
            someone.press("examples")
            someone.press("example-orthodiagonal")
            drawn(page)
            someone.take("aim-surface")
            someone.bring("file-surface", EXAMPLES / "roof.obj")
            wait_until(page, "!!window.__orishell.store.design.value.target.surface?.triangles")
            someone.pick("mesh-unit", "mm")
            settle(page)
        with someone.step("curves"):
            if by == "mouse":
                page.get_by_test_id("families-more").click()
            someone.take("family-orthodiagonal", back=True)
            settle(page)
            someone.press("by-curves")
            require_proved(page)
        with someone.step("tolerance"):
            someone.take("mode-tolerance")
            wait_until(page, TRADEOFF, 120)
            someone.press("choose")
            require_proved(page)
        with someone.step("files"):
            someone.press("export", back=True)
            someone.take("task-all")
            table = write(someone, "export-fold", tmp_path)
            design = save(someone, tmp_path)
    done = orishell("design", design, "--out", tmp_path / "out", "--json")
    report = json.loads(done.stdout)
    assert report["deviation"]["surface"]["max"] <= report["chosen"]["tolerance"] < 1
    assert report["deployed"]["width"] == pytest.approx(8, rel=0.1)
    assert len(json.loads(table.read_text())["faces_vertices"]) == report["quantities"]["panels"]
    assert someone.done["clicks"] <= (14 if by == "mouse" else 0)


@thorough
@pytest.mark.parametrize("by", BOTH)
def test_a_lampshade_of_card_with_its_printed_model(
    browser: Browser, address: str, tmp_path: Path, begin: Begin, by: By
) -> None:
    """In millimetres, of card 2 mm thick, with flaps that are clipped on."""
    with opened(browser, address) as page:
        someone = begin(page, by)
        with someone.step("draw"):
            someone.pick("unit", "mm")
            begin_a_drawing(someone, BENT, back=True)
        with someone.step("size"):
            someone.write("span-f", "240", back=True)
            someone.write("length-g", "400")
            someone.write("param-rows", "5")
            someone.write("param-columns", "6")
            require_proved(page)
        with someone.step("card"):
            someone.write("panel-thickness", "2")
            someone.take("deployment-flap_attachment-clipped")
            someone.write("design-name", "lampshade", back=True)
            require_proved(page)
        with someone.step("files"):
            someone.press("export")
            someone.take("task-all")
            pattern = write(someone, "export-pdf", tmp_path)
            printed = write(someone, "export-3mf", tmp_path, back=True)
    with zipfile.ZipFile(pattern) as archive:
        assert "lampshade.pdf" in archive.namelist()  # beside those of the boards
    with zipfile.ZipFile(printed) as archive:
        (model,) = [name for name in archive.namelist() if name.endswith(".model")]
        root = ElementTree.fromstring(archive.read(model))
    assert root.get("unit") == "millimeter"
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    assert len(root.findall(f".//{space}object")) >= 6 * 5  # of every panel a board
    assert someone.done["clicks"] <= (20 if by == "mouse" else 0)


@thorough  # a search of minutes
@pytest.mark.parametrize("by", BOTH)
def test_a_drawn_arch_carries_snow_and_wind(
    browser: Browser, address: str, begin: Begin, by: By
) -> None:
    with opened(browser, address) as page:
        page.get_by_test_id("new").click()
        draw(page, [(0.1, 0.5), (0.3, 0.56), (0.5, 0.44), (0.7, 0.56), (0.9, 0.5)])
        for name, size in (("span-f", "3"), ("length-g", "6")):
            page.get_by_test_id(name).fill(size)
        settle(page)
        page.evaluate("scrollTo(0, 0)")
        someone = begin(page, by)
        with someone.step("loads"):
            if by == "mouse":
                someone.press("structure-begin")
            else:
                page.locator(".skip", has_text="To the loads").focus()
                someone.keys(["Enter"] * 2)
            # What is known is told before it is tried what would help.
            page.get_by_test_id("make-it-carry").wait_for(timeout=1000 * SEARCH)
        assert page.evaluate(CARRIES) is not True
        with someone.step("search"):
            someone.press("make-it-carry")
            wait_until(page, FOUND, SEARCH)
        with someone.step("open"):
            if by == "keys":
                assert page.evaluate("document.activeElement.dataset.testid") == "carry-open-0"
            someone.press("carry-open-0")
            wait_until(page, f"{CARRIES} === true", SEARCH)
            wait_until(page, IDLE, SEARCH)
        assert page.get_by_test_id("structure-verdict").get_attribute("data-tone") == "holds"
    assert someone.done["clicks"] <= (CLICKS if by == "mouse" else 0)


@pytest.mark.parametrize("by", led_by(BOTH))
def test_a_pattern_of_another_program_is_folded_and_shared(
    page: Page, begin: Begin, by: By
) -> None:
    """An SVG in pixels, as wide as somebody says, as one file for a friend."""
    someone = begin(page, by)
    with someone.step("open"):
        someone.bring("open", EXAMPLES / "arch_pattern.svg")
        wait_until(page, "document.activeElement?.dataset.testid === 'drawing-width'")
    with someone.step("size"):
        # The question has the focus, and what is typed is the answer.
        page.keyboard.insert_text("2.4 m")
        settle(page)
        assert page.evaluate("window.__orishell.report.sheet.width") == pytest.approx(2.4)
    with someone.step("share"):
        download = someone.receive("share", back=True)
        text = download.path().read_text("utf-8")
    assert download.suggested_filename == "arch_pattern-viewer.html"
    assert page.url.partition("?")[0] not in text
    assert someone.done["clicks"] <= (2 if by == "mouse" else 0)
