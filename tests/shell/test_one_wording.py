"""Words and figures of the verdict are the same by every door: nobody words a size by himself.

Doors: terminal, ``report.json``, what the viewer's page has in it, a sheet that is converted from
FOLD, kit and booklet, and the studio's answers. What pages print of these rows is looked at in
``tests/io/formats/test_html.py``.
"""

from __future__ import annotations

import base64
import json
import re
import struct
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tomli_w
from pypdf import PdfReader

from command_line import orishell
from orishell.conventions.progress import no_progress
from orishell.conventions.quantities import SPACE, box
from orishell.conventions.row import MARKS
from orishell.design_file import check_design
from orishell.document.from_design import states_of
from orishell.io.solids import find_surface
from orishell.shell import Shell, make_shell, write_kit
from orishell.shell.steps import Step
from orishell.studio.tasks import answer
from orishell.workshop.kit.card_model import make_card_model
from orishell.workshop.kit.facts import find_facts
from samples import led_by

Rows = list[dict[str, Any]]
Design = dict[str, Any]

SIZED = ("sheet", "deployed")


def arch(**tables: Design) -> Design:
    """An arch of 3 x 2 m."""
    shell = {
        "shell": {"family": "orthodiagonal", "unit": "m"},
        "target": {
            "f": {"formula": "1.5 - 0.7*x**2", "range": [-1.5, 1.5]},
            "g": {"formula": "0.1*cos(2*pi*x)", "range": [0, 2]},
        },
        "pattern": {"rows": 5, "columns": 3, "flap": 0.2, "depth": 0.16, "heading_deg": 90},
        "motion": {"frames": 5},
    }
    return {**shell, **tables}


BOARDS = {"thickness": 0.01, "construction": "bevel", "gap": 0.002}
DESIGNS: dict[str, Design] = {
    "boards": arch(deployment={"from": "pack"}, panel=BOARDS),
    "loaded": arch(
        deployment={"from": "pack"},
        workshop={"areal_density": 12},
        structure={
            "modulus": 9e9,
            "thickness": 0.012,
            "cells": 2,
            "supports": [{"at": "feet", "kind": "pinned"}],
        },
    ),
    "bare": arch(),
    "clipped": arch(deployment={"from": "pack", "ties": "feet"}),
}
"""With flaps clipped on, of boards; under loads; as in the paper; and with flaps clipped on."""


def viewed(page: Path) -> dict[str, Any]:
    """The report that a page of the viewer has in it."""
    found = re.search(
        r'<script type="application/octet-stream" id="[^"]*">([^<]*)', page.read_text()
    )
    assert found is not None
    report: dict[str, Any] = header_of(base64.b64decode(found[1]))["report"]
    return report


def header_of(view: bytes) -> dict[str, Any]:
    (length,) = struct.unpack_from("<I", view)
    header: dict[str, Any] = json.loads(view[4 : 4 + length])
    return header


def of(rows: Rows, *subjects: str) -> dict[str, str]:
    return {row["subject"]: row["finding"] for row in rows if row["subject"] in subjects}


def printed(rows: Rows) -> list[str]:
    """As a terminal has them, whose spaces before units break."""
    lines = (f"{MARKS[row['sign']]} {row['subject']:<9} {row['finding']}" for row in rows)
    return [line.replace(SPACE, " ") for line in lines]


@cache
def shell_of(name: str) -> Shell:
    """A design, proved and with its pack."""
    skip: set[Step] = {"structure", "deviation", "verification", "remedies"}
    return make_shell(check_design(DESIGNS[name], Path("shell.toml")), skip=skip)


@pytest.fixture(scope="module", params=led_by(DESIGNS))
def doors(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A design, the folder that it was written to, and what the terminal said."""
    design, folder = DESIGNS[request.param], tmp_path_factory.mktemp(request.param)
    (folder / "shell.toml").write_text(tomli_w.dumps(design))
    ran = orishell("design", "shell.toml", "--out", "out", "--write", "html", cwd=folder)
    assert ran.returncode == 0, ran.stderr
    return request.param, design, folder, ran.stdout


def test_a_row_is_the_same_by_every_door(doors: Any) -> None:
    _, design, folder, said = doors
    report = json.loads((folder / "out" / "report.json").read_text())
    rows = report["verdict"]
    lines = [line for line in said.split("\n") if not line.startswith("            ->")]
    assert lines[1 : 1 + len(rows)] == printed(rows)
    bill = report["quantities"]
    assert f" {bill['panels']} panels" in lines[0]
    assert (f", {bill['clipped']} of them clipped on" in lines[0]) == bool(bill["clipped"])
    assert viewed(folder / "out" / "viewer.html")["verdict"] == rows
    verified = answer("verify", {"design": design, "name": "shell"}, no_progress)
    assert json.loads(json.dumps(verified["report"]["verdict"])) == rows
    outside = [report["outside"][key] for key in ("width", "depth", "height")]
    assert [*verified["sizes"]["outside"].values()] == pytest.approx(outside, rel=1e-9)
    # What the studio draws before anything is proved has the same sizes.
    early = header_of(answer("design", {"design": design}, no_progress))["report"]["verdict"]
    assert of(early, *SIZED, "feet") == of(rows, *SIZED, "feet")
    if "structure" in design:
        loads = orishell("structure", "shell.toml", cwd=folder).stdout
        (stands,) = [line for line in printed(rows) if line[2:].startswith("stands ")]
        assert stands in loads.split("\n")


def test_a_converted_sheet_has_the_words_of_its_panels(doors: Any) -> None:
    """FOLD has the panels alone: their sizes are said of panels without a thickness."""
    _, design, folder, _ = doors
    ran = orishell("convert", "out/shell.fold", "bare.html", cwd=folder)
    assert ran.returncode == 0, ran.stderr
    rows = viewed(folder / "bare.html")["verdict"]
    report = json.loads((folder / "out" / "report.json").read_text())
    told = of(report["verdict"], *SIZED)
    assert of(rows, "sheet") == of(report["verdict"], "sheet")
    assert [row["subject"] for row in rows] == [*SIZED]
    converted = of(rows, "deployed")["deployed"]
    assert converted.endswith(" of panels without a thickness")
    first, *clipped = told["deployed"].split("; ")
    if "panel" in design:
        assert first.endswith(" of its boards")
    else:
        assert converted == first
    assert bool(clipped) == bool(report["quantities"]["clipped"])
    assert all(text.endswith(" with clipped parts") for text in clipped)


def test_sizes_are_those_of_the_written_shell(doors: Any) -> None:
    """Both boxes, about vertices that a mesh of the target has, with clipped parts or without."""
    shell = shell_of(doors[0])
    document, report = shell.document, shell.report
    opened = np.ptp(find_surface(document, document.named["target"])[0], axis=0)
    clipped = [find_surface(each, "target")[0] for each in document.attached]
    if document.boards is None:
        everything = [document.shell.positions, *clipped]
        whole = np.ptp(np.concatenate(everything), axis=0)
        assert astuple(report.deployed) == pytest.approx(opened, rel=1e-12)
    else:
        whole = opened  # boards that are clipped on are among them
    assert astuple(report.outside) == pytest.approx(whole, rel=1e-12)
    assert (report.outside == report.deployed) == (not document.attached)


def astuple(of: Any) -> tuple[float, float, float]:
    return of.width, of.depth, of.height


def test_kit_and_booklet_have_the_words_and_figures_of_the_verdict(doors: Any) -> None:
    name, _, folder, _ = doors
    write_kit(shell_of(name), folder / "kit")
    report = json.loads((folder / "out" / "report.json").read_text())
    rows, unit = report["verdict"], report["unit"]
    readme = (folder / "kit" / "README.md").read_text()
    told = of(rows, *SIZED, "packs")
    assert f"- Opened: {told['deployed']}\n" in readme
    assert told["sheet"].startswith(re.findall(r"- Flat sheet: (.*)\n", readme)[0] + ", ")
    packs = [each.partition(", ")[0] for each in re.findall(r"- Packed: (.*)\n", readme)]
    assert len(packs) == ("packs" in told)
    assert all(told["packs"].startswith(f"{each} at ") for each in packs)
    pages = PdfReader(folder / "kit" / "booklet" / "booklet.pdf").pages
    text = " ".join(" ".join(page.extract_text().split()) for page in pages)
    outside = box(report["outside"].values(), unit)
    opened = "Opened, with clipped parts" if report["quantities"]["clipped"] else "Opened"
    assert f"{opened}: {outside} (" in text
    assert f"measures {box(report['deployed'].values(), unit)}" in text
    assert all(f"Packed: {each}" in text for each in packs)
    assert f"Panels: {report['quantities']['panels']}" in text


def test_a_model_has_its_own_sizes() -> None:
    """Of panels of card, to its scale, whatever boards the shell has."""
    shell = shell_of("boards")
    document = replace(shell.document, states=states_of(shell.motion))
    model = make_card_model(document, shell.file.workshop)
    facts = find_facts(model.document)
    words = facts.opened_in_words("mm")
    sides = model.scale * 1000 * np.ptp(document.shell.positions, axis=0)
    assert words.startswith(f"{box(sides, 'mm')} of panels without a thickness; ")
