"""The schedule of joints: every crease once, as long as it is in the flat sheet."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from boarded import BUILDS, boarded_document
from documents import EXAMPLES, demo_document, loaded_document, slit_document
from orishell.conventions.errors import InputError
from orishell.design_file import check_design, read_design_file
from orishell.document import Document, DocumentTie
from orishell.document.loaded import LoadedCreases
from orishell.io.format import Settings
from orishell.io.formats.tables import write_tables
from orishell.shell.make import make_shell
from orishell.shell.steps import Step
from orishell.workshop import Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.schedule import find_schedule
from samples import led_by

HINGED = {
    "shell": {"family": "flat-foldable", "unit": "m"},
    "pattern": {"rows": 3, "columns": 4, "sheet": "miura"},
    "panel": {"construction": "hinged", "thickness": 0.02, "gap": 0.002, "density": 500},
    "motion": {"frames": 7},
    "deployment": {"from": "pack"},
}
SKIPPED: tuple[Step, ...] = ("verification", "weight", "deviation", "remedies", "stock")


def hinged_document() -> Document:
    return make_shell(check_design(HINGED, Path("shell.toml")), skip=SKIPPED).document


def documents() -> dict[str, Document]:
    return {
        "sheet": demo_document(),
        "slit": slit_document(),
        **{name: boarded_document(name, clipped=True) for name in BUILDS},
    }


def table(document: Document, path: Path, workshop: Workshop | None = None) -> list[dict[str, str]]:
    write_tables(path / "panels.csv", document, Settings(workshop=workshop or Workshop()))
    return list(csv.DictReader((path / "schedule.csv").read_text().splitlines()))


@pytest.mark.parametrize("name", ["sheet", "slit", *BUILDS])
def test_every_crease_is_there_once_with_its_length(name: str, tmp_path: Path) -> None:
    """Every pair of panels that share two vertices; lengths from their coordinates, to rounding."""
    document = documents()[name]
    everything = laid_flat(document)
    rows = table(document, tmp_path)
    pairs = [frozenset({int(row["panel_1"]), int(row["panel_2"])}) for row in rows]
    faces = [set(loop[loop >= 0].tolist()) for loop in everything.mesh.loops]
    beside: dict[frozenset[int], set[int]] = {}
    for face, corners in enumerate(faces):
        for other in range(face):
            if len(common := corners & faces[other]) > 1:
                beside[frozenset({face, other})] = common
    assert len(pairs) == len(set(pairs))
    assert set(pairs) == set(beside)
    flat = everything.require_flat()
    for row, pair in zip(rows, pairs, strict=True):
        ends = flat[sorted(beside[pair])]
        long = np.hypot(*(ends[:, None] - ends).T).max()
        assert float(row[f"length_{document.unit}"]) == pytest.approx(long, rel=1e-12)


def test_row_and_column_creases_are_those_of_the_grid() -> None:
    """Of m + 2 by n + 2 vertices there are m (n + 1) row creases and n (m + 1) column creases."""
    document = demo_document()
    assert document.grid_shape is not None
    rows, columns = document.grid_shape
    found = find_schedule(document, Workshop())
    assert (found.directions == "row").sum() == (rows - 2) * (columns - 1)
    assert (found.directions == "column").sum() == (columns - 2) * (rows - 1)
    ends = document.mesh.edges[found.edges]
    along = ends[:, 0] // columns == ends[:, 1] // columns
    assert ((found.directions == "row") == along).all()


def test_kinds_follow_the_construction_or_the_user() -> None:
    sheet = find_schedule(demo_document(), Workshop(creases="dashes"))
    assert set(sheet.kinds) == {"dashes"}
    assert set(find_schedule(boarded_document("sandwich"), Workshop()).kinds) == {"membrane"}
    assert "hinge" in find_schedule(boarded_document("bevel"), Workshop()).kinds
    asked = Workshop(row_hinge="piano hinge", column_hinge="tape")
    found = find_schedule(boarded_document("sandwich"), asked)
    assert set(zip(found.directions, found.kinds, strict=True)) == {
        ("row", "piano hinge"),
        ("column", "tape"),
    }
    assert found.hinge_lengths == pytest.approx(found.lengths)


def test_whole_boards_have_hinges_and_screws(tmp_path: Path) -> None:
    """Lengths and holes are those of hinges.csv; fold angles in the pack are the last state's."""
    document = hinged_document()
    rows = table(document, tmp_path, Workshop(hinge_stock=2.0))
    hinges = list(csv.DictReader((tmp_path / "hinges.csv").read_text().splitlines()))
    by_crease = {row["crease"]: row for row in rows}
    assert {each["crease"] for each in hinges} == {
        row["crease"] for row in rows if row["kind"] == "hinge"
    }
    pack = document.state("pack").fold_angles_deg
    assert pack is not None
    for each in hinges:
        row = by_crease[each["crease"]]
        assert row["hinge_length_m"] == each["length_m"]
        assert int(row["screws"]) == 2 * int(each["holes"])
        assert float(row["fold_angle_in_pack_deg"]) == pack[int(row["crease"])]
        assert int(row["bar"]) >= 1


@pytest.mark.parametrize("name", led_by(["shelter.toml", "shelter_hinged.toml"], 0))
def test_examples_have_every_crease_once(name: str, tmp_path: Path) -> None:
    """As many as the sheet and its clipped flaps have inner edges."""
    file = read_design_file(EXAMPLES / name)
    document = make_shell(file, clash="unexamined", skip=SKIPPED).document
    rows = table(document, tmp_path)
    assert len(rows) == int(laid_flat(document).mesh.crease.sum())
    assert len({row["crease"] for row in rows}) == len(rows)


def test_ties_are_listed_as_they_are_cut(tmp_path: Path) -> None:
    """Lengths by hand: 0.1 on either end; coils of 5 hold one of 3 and one of 1.5 with ends."""
    ties = tuple(DocumentTie(((0, k), (4, k)), size) for k, size in enumerate([3.0, 1.5, 3.0]))
    document = replace(demo_document(), ties=ties)
    workshop = Workshop(tie_stock=5.0, tie_end=0.1)
    table(document, tmp_path, workshop)
    rows = list(csv.DictReader((tmp_path / "ties.csv").read_text().splitlines()))
    assert [float(row["cut_length_m"]) for row in rows] == pytest.approx([3.2, 1.7, 3.2])
    assert [float(row["length_m"]) for row in rows] == [3.0, 1.5, 3.0]
    assert [row["coil"] for row in rows] == ["1", "1", "2"]
    with pytest.raises(InputError, match=r"tie_stock: a tie is longer .* at least 3.2"):
        table(document, tmp_path, workshop.replace_unchecked(tie_stock=3.0))


def test_forces_are_matched_by_their_panels(tmp_path: Path) -> None:
    """A force that is said of panels in the other order stands at their crease, with its case."""
    document = demo_document()
    found = find_schedule(document, Workshop())
    panels = found.panels[::-1, ::-1]
    sizes = np.arange(len(panels), dtype=float)
    names = tuple(f"case {k}" for k in range(len(panels)))
    loaded = LoadedCreases(panels, sizes, ("pull",) * len(panels), names)
    shell = loaded_document().loaded
    assert shell is not None
    rows = table(replace(document, loaded=replace(shell, creases=loaded)), tmp_path)
    assert [float(row["force_N_per_m"]) for row in rows] == sizes[::-1].tolist()
    assert [row["case"] for row in rows] == list(names[::-1])
