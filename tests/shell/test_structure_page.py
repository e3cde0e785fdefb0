"""The page and the picture of a shell as a structure: what an engineer needs is in them."""

from __future__ import annotations

import base64
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

from analysed import STRUCTURE, analysed
from documents import demo_document
from orishell.document import Document
from orishell.document.loaded import LoadedCase, LoadedShell
from orishell.structure.load_path import LoadPath
from orishell.structure.pages.files import structure_page, write_structure_files
from orishell.structure.pages.sections import PATHS
from orishell.structure.results import Analysis
from outside import outside_anywhere

if TYPE_CHECKING:
    from playwright.sync_api import Browser

HOSTILE = "</title><script>alert(1)</script> \"'& α"
PNG = b"\x89PNG, not really"


def report() -> Analysis:
    return analysed()


def page(found: Analysis | None = None, title: str = "tent", unit: str = "m") -> str:
    return structure_page(found or report(), title=title, unit=unit, png=PNG)


def words(text: str) -> str:
    """What is read on a page: spaces that do not break are spaces."""
    inner = "|".join(ElementTree.fromstring(text).itertext())
    return re.sub(r"\s+", " ", inner.replace("\u202f", "").replace("\u00a0", " "))


def tables(text: str) -> dict[str, list[list[str]]]:
    """Cells of all tables that have a caption."""
    return {
        caption.text or "": [
            ["".join(cell.itertext()).replace("\u202f", "") for cell in row]
            for row in found.iter("tr")
        ]
        for found in ElementTree.fromstring(text).iter("table")
        if (caption := found.find("caption")) is not None
    }


def test_it_is_one_well_formed_file_that_asks_for_nothing_else() -> None:
    root = ElementTree.fromstring(page(title=HOSTILE))
    assert root.findtext("head/title") == f"Structure: {HOSTILE}"
    assert root.findtext("body/h1") == f"Structure: {HOSTILE}"
    assert not list(root.iter("script"))
    assert not list(root.iter("link"))
    (image,) = root.iter("img")
    assert image.attrib["src"] == f"data:image/png;base64,{base64.b64encode(PNG).decode()}"
    assert not re.search(r"https?:|url\(|@import|src=\"(?!data:)", page())
    assert page() == page()


def test_all_cases_and_what_governs_are_in_it() -> None:
    found = report()
    text = words(page(found))
    for case in found.cases:
        assert f"|{found.name_of(case)}|" in text
    # The second tie pulls 4 kN of the 5 kN that it bears: see tests/analysed.py.
    assert (
        "The force in a tie governs, 80 % of what can be borne, under wind, free creases." in text
    )
    assert "The largest displacement is 150 mm" in text
    assert (
        "Does it carry its loads? No: 1 of 4 cases fail; under both, free creases it opens" in text
    )
    assert "The shell opens under its loads" in text
    assert "buckling 40 %" in text  # 1/2.5
    assert "3, 4, 7 Hz" in text
    for warning in (*found.warnings, *found.not_covered):
        assert warning in text


def test_sections_can_be_calculated_by_hand() -> None:
    """E t/(1 - nu^2) and E t^3/12/(1 - nu^2) with E = 270 MPa, t = 10 mm, nu = 0.3."""
    text = words(page())
    plane = 270e6 * 0.01 / (1 - 0.3**2)
    assert f"{plane / 1e3:.4g} kN/m in its plane" in text
    assert f"{plane * 0.01**2 / 12:.4g} N m in bending" in text
    changed = "displacements changed by 2 %, stress by 5 %, buckling factors by 1 %"
    assert f"from the next coarser mesh {changed}" in text


def last(row: list[str]) -> float:
    return float(row[-1].replace("\u2212", "-"))


def test_loads_add_up_to_what_the_supports_bear() -> None:
    """Snow of 500 Pa, mu_3 = 2, on 4 m by 3 m; dead load of 32.24 kg; a force of 80 N: factored."""
    rows = tables(page())["both"]
    named = {row[0]: row[1:] for row in rows}
    snow, point = -1.5 * 500 * 0.8 * 12, -1.5 * 80
    assert [
        float(named[each][-1].replace("−", "-"))
        for each in ("snow: snow", "snow: forces at points")
    ] == [snow, point]
    assert named["snow: snow"][0] == "0.5\u00a0kN/m²"
    assert "mu = 0.8" in named["snow: snow"][1]
    total = last(named["all loads"])
    parts = [last(row) for row in rows[1:4]]
    assert total == pytest.approx(sum(parts), rel=1e-3)
    assert last(named["reactions, rigid creases"]) == -total
    assert named["reactions, rigid creases"][1] == "missing: 1·10⁻¹² of the loads"
    assert named["reactions, free creases"][1] == "none: nothing holds it"
    # Those of the last case, wind, two vertices in every row.
    _, *reactions = tables(page())["Reactions of supports; their sum is above, under the loads"]
    borne = sum(float(row[k]) for row in reactions for k in (3, 7))
    assert borne == pytest.approx(float(tables(page())["wind"][-1][-1]), rel=1e-3)


def test_lengths_are_read_in_the_design_s_unit_and_stresses_in_megapascals() -> None:
    """The same numbers in millimetres are newtons per square millimetre."""
    in_mm = words(page(unit="mm"))
    assert "The largest displacement is 0.15 mm" in in_mm
    assert "|2.7·10⁸ MPa|" in in_mm


def test_it_is_as_wide_as_a4_and_dark_where_pages_are(browser: Browser, tmp_path: Path) -> None:
    """186 mm between the margins, 96 pixels to an inch; on paper it is never dark."""
    (tmp_path / "structure.html").write_text(page(), encoding="utf-8")
    width = int(186 / 25.4 * 96)
    shown = browser.new_page(viewport={"width": width, "height": 800}, color_scheme="dark")
    shown.goto((tmp_path / "structure.html").as_uri())
    light = []
    for media in ("screen", "print"):
        shown.emulate_media(media=media)
        assert shown.evaluate("document.documentElement.scrollWidth") <= width
        colour = shown.evaluate("getComputedStyle(document.body).backgroundColor")
        light.append(sum(map(int, re.findall(r"\d+", colour)[:3])) > 3 * 128)
    shown.emulate_media(media="screen")
    found = outside_anywhere(shown)
    shown.close()
    assert light == [False, True]
    assert found == {}


def test_without_strengths_it_says_that_nothing_is_said_of_them() -> None:
    plain = STRUCTURE.replace_unchecked(
        strength=None, crease_strength=None, line_strength=None, tie_strength=None
    )
    text = words(page(analysed(plain)))
    assert "of panels and creases and crease lines and ties no strength is given" in text
    assert "Buckling governs" in text


def loaded() -> Document:
    found = analysed()
    mesh = found.model.mesh
    count, triangles = len(mesh.facets.points), mesh.facets.triangles
    down = np.outer(np.arange(count) / count, [0, 0, -0.1])
    cases = tuple(
        LoadedCase(f"case {k}", case.sign, case.motion is None, down, down, np.ones(len(triangles)))
        for k, case in enumerate(found.cases)
    )
    some = np.ones(len(triangles))
    shell = LoadedShell(
        points=mesh.facets.points,
        triangles=triangles,
        panels=mesh.panels,
        membrane=some,
        bending=some,
        poisson=0.3,
        areal_mass=some,
        restrained=np.array([[0, 0], [0, 1], [0, 2], [4, 2]]),
        ties=np.array([[0, 4], [1, 5], [2, 4]]),
        tie_stiffness=1e6,
        cases=cases,
    )
    return replace(demo_document(), loaded=shell)


def test_files_are_the_same_each_time_and_hold_each_other(tmp_path: Path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        write_structure_files(tmp_path / name, loaded(), analysed())
    one, two = ((tmp_path / name / "structure.html").read_bytes() for name in ("one", "two"))
    png = (tmp_path / "one" / "structure.png").read_bytes()
    assert one == two
    assert base64.b64encode(png) in one
    with Image.open(tmp_path / "one" / "structure.png") as picture:
        assert picture.width == 2600


def test_large_displacements_have_a_picture_of_load_against_displacement(tmp_path: Path) -> None:
    """With all points of the paths, and linear theory beside them; without them there is none."""
    way = LoadPath("carries", 1.0, (0.0, 0.5, 1.0), (0.0, 0.01, 0.03), 0.02, 1.4)
    followed = analysed(STRUCTURE.replace_unchecked(nonlinear=True))
    cases = tuple(
        each
        if each.equilibrium is None
        else replace(each, equilibrium=replace(each.equilibrium, path=way))
        for each in followed.cases
    )
    followed = replace(followed, cases=cases)
    pages = []
    for name, each in (("linear", analysed()), ("followed", followed)):
        (tmp_path / name).mkdir()
        write_structure_files(tmp_path / name, loaded(), each)
        pages.append((tmp_path / name / "structure.html").read_text(encoding="utf-8"))
    assert [text.count("data:image/png;base64,") for text in pages] == [1, 2]
    assert [PATHS in text for text in pages] == [False, True]
    assert "nonlinear: it is in balance under all loads, large displacements followed" in words(
        pages[1]
    )
