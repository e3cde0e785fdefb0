"""A part that no module knows: it is in files, drawings, bill, kit, structure and proof."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest

from documents import EXAMPLES, demo_document, thick_document
from orishell.clash.bodies import Apartness, Bodies
from orishell.clash.body_path import find_first_body_contact
from orishell.deployment import Site
from orishell.deployment.feet import find_feet
from orishell.design import PanelSpec
from orishell.design_file import read_design_file
from orishell.document import SHELL, Document
from orishell.document.from_design import document_of_design
from orishell.io.fold import write_fold
from orishell.io.fold_reader import read_fold
from orishell.io.format import Settings
from orishell.io.formats.dxf import write_dxf
from orishell.io.formats.gltf import write_gltf
from orishell.io.formats.stl import write_stl
from orishell.io.formats.tables import write_tables
from orishell.io.solids import find_surface
from orishell.locking.boards import prove_boards
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.boards import Boards, join_boards
from orishell.motion.layout import Layout, points_of
from orishell.structure.masses import point_masses
from orishell.structure.model import Model
from orishell.structure.settings import LoadCase, Structure, Support
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import board_parts
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.quantities import measure_quantities
from toy_part import DENSITY, gusset, rib

AT = (2, 2)
PLACES = (AT, (3, 2))


@pytest.fixture(scope="module")
def bare() -> Document:
    """Boards that are in one piece, those of flaps clipped on, all of 500 kg/m3."""
    document = thick_document("orthodiagonal", "bevel", size=(5, 5))
    assert document.panel is not None
    panel = document.panel.replace_unchecked(density=500.0)
    attached = tuple(replace(part, panel=panel) for part in document.attached)
    return replace(document, panel=panel, attached=attached)


@pytest.fixture(scope="module")
def document(bare: Document) -> Document:
    """The same with two gussets."""
    gussets = (gusset(bare, at) for at in PLACES)
    return replace(bare, attached=(*bare.attached, *gussets))


def test_files_of_the_target_have_it(document: Document, bare: Document, tmp_path: Path) -> None:
    for state, more in ((SHELL, len(PLACES)), ("flat", 0)):
        sizes = []
        for each in (document, bare):
            path = tmp_path / "shell.stl"
            write_stl(path, each, Settings(state=state))
            sizes.append((path.stat().st_size - 84) // 50)
        # A triangle that is a board with three levels has two ends and two bands of three sides.
        assert sizes[0] - sizes[1] == more * (2 + 2 * 3 * 2)
    points, _ = find_surface(document, SHELL)
    inside = document.attached[-1].shell.positions
    low, high = inside.min(axis=0), inside.max(axis=0)
    assert (points[-9:] > low - 1).all()
    assert (points[-9:] < high + 1).all()


def test_drawings_have_it(document: Document, tmp_path: Path) -> None:
    write_dxf(tmp_path / "pattern.dxf", document, Settings())
    boards = ezdxf.readfile(tmp_path / "pattern-panels.dxf")
    words = {text.dxf.text for text in boards.modelspace().query("TEXT")}
    assert {f"gusset {row},{column}" for row, column in PLACES} <= words
    assert [part.name for part in board_parts(document)][-len(PLACES) :] == [
        f"gusset {row},{column}" for row, column in PLACES
    ]


def test_bill_and_masses_have_it(document: Document, bare: Document, tmp_path: Path) -> None:
    with_it, without = (measure_quantities(each, Workshop()) for each in (document, bare))
    added = document.attached[len(bare.attached) :]
    area = sum(float(part.areas().sum()) for part in added)
    assert with_it.area == pytest.approx(without.area + area, rel=1e-12)
    assert with_it.panels == without.panels + len(added)
    volume = sum(float(part.boards.volumes().sum()) for part in added if part.boards is not None)
    assert with_it.built is not None
    assert without.built is not None
    before, now = without.built.mass_kg.boards, with_it.built.mass_kg.boards
    assert before is not None
    assert now == pytest.approx(before + DENSITY * volume, rel=1e-12)
    centre, there = without.built.centre_of_mass, with_it.built.centre_of_mass
    assert centre is not None
    assert there is not None
    assert now is not None
    moved = np.subtract(there, centre) * now
    middles = [part.corners(part.shell).mean(axis=0) for part in added]
    each = [DENSITY * float(part.boards.volumes().sum()) for part in added if part.boards]
    arms = np.subtract(middles, centre)
    np.testing.assert_allclose(moved, np.array(each) @ arms, rtol=0, atol=1e-9 * now)
    write_tables(tmp_path / "panels.csv", document, Settings())
    rows = (tmp_path / "boards.csv").read_text().splitlines()
    mass = float(rows[-1].split(",")[-2])
    assert rows[-1].startswith('"gusset 3,2"')
    assert mass == pytest.approx(each[-1], rel=1e-12)


def test_kit_has_it(document: Document, bare: Document) -> None:
    parts = kit_parts(document, Workshop(), find_facts(document))
    found = {part.name: part.count for part in parts}
    assert found["gusset"] == len(PLACES)
    assert found["flap"] == len(bare.attached)
    steps = [step.name for step in kit_steps(document, Workshop(), find_facts(document), parts)]
    assert steps.count("clip") == steps.count("fit_gusset") == 1


def test_paper_sheets_have_it(tmp_path: Path) -> None:
    """Without boards it is a part of the flat pattern, cut and numbered as others are."""
    sheet = demo_document("orthodiagonal", size=(5, 5))
    document = replace(sheet, attached=(gusset(sheet, AT),))
    stock = Workshop(stock=(1.5, 1.5))
    parts = {part.name: part for part in kit_parts(document, stock, find_facts(document))}
    assert parts["gusset"].values["cut"] == "1"
    write_dxf(tmp_path / "pattern.dxf", document, Settings(workshop=stock))
    numbers = {
        text.dxf.text
        for path in tmp_path.glob("pattern-*.dxf")
        for text in ezdxf.readfile(path).modelspace().query("TEXT")
    }
    assert parts["gusset"].values["last"] in numbers


def test_what_moves_is_in_files_of_the_motion(tmp_path: Path) -> None:
    """A gusset is not: it is there in one state."""
    sheet = demo_document("orthodiagonal", size=(5, 5))
    document = replace(sheet, attached=(gusset(sheet, AT), rib(sheet, 7, 0.1)))
    write_fold(tmp_path / "shell.fold", document)
    file = read_fold(tmp_path / "shell.fold")
    first = sheet.mesh.vertex_count
    assert len(file.mesh.faces) == len(sheet.mesh.faces) + 1
    frames = [frame for frame in file.frames if "creasePattern" not in frame.classes]
    assert len(frames) == len(sheet.states)
    for frame, state in zip(frames, sheet.states, strict=True):
        np.testing.assert_array_equal(frame.positions[:first], state.positions)
        quad = state.positions[sheet.mesh.faces[7]]
        foot = frame.positions[first]
        np.testing.assert_allclose(foot, quad.mean(axis=0), rtol=0, atol=1e-12)
    write_gltf(tmp_path / "shell.glb", document, Settings())
    data = (tmp_path / "shell.glb").read_bytes()
    content = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    names = [node["name"] for node in content["nodes"]]
    assert names[-1] == f"panel {document.attached[1].panel_name(0)}"
    assert not any("gusset" in name for name in names)
    moved = {channel["target"]["node"] for channel in content["animations"][0]["channels"]}
    assert len(names) - 1 in moved


def test_a_structure_bears_it() -> None:
    """Its mass is where it is borne; that it stiffens the shell is not asked here."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = file.pattern.model_copy(update={"rows": 5, "columns": 5}).design(file.f, file.g)
    part = gusset(document_of_design(design, "m", frames=2), AT)
    structure = Structure(
        modulus=8e9,
        thickness=0.02,
        supports=(Support(at="feet", kind="pinned"),),
        cases=(LoadCase(name="dead", self_weight=True),),
    )
    site = Site("m", find_feet(design), (), 6.0)
    bare, bearing = (
        Model(each, structure, site, 2) for each in (design, replace(design, attached=(part,)))
    )
    more = point_masses(bearing.exposure) - point_masses(bare.exposure)
    mass = 6.0 * float(part.areas().sum())
    assert more.sum() == pytest.approx(mass, rel=1e-9)
    assert part.borne_at is not None
    rows, columns = part.borne_at.T
    nodes = bare.grid.vertices()[rows, columns - bare.before]
    np.testing.assert_allclose(more[nodes], mass / 3, rtol=1e-9)


def test_the_proof_sees_what_moves_along() -> None:
    """Boards alone are apart all the way; with a mast on one, it is what meets another first."""
    file = read_design_file(EXAMPLES / "figure2.toml")
    design = replace(file.pattern.design(file.f, file.g).with_clipped_flaps(), clipped=None)
    design = replace(design, panel=PanelSpec(thickness=0.01, membrane=0.001))
    mechanism = design.mechanism.least_turning
    end, lying = mechanism.target_drive, panels_laid_flat(mechanism)
    tolerance, faces = 1e-6, Layout.of(mechanism).faces
    built, path = prove_boards(design, end, tolerance)
    assert path.contact is None

    panel = 34  # under one leg of the arch
    quad = lying[panel]
    foot = quad.mean(axis=0) + 0.05 * (quad - quad.mean(axis=0))
    levels = np.stack([np.column_stack([foot, np.full(4, z)]) for z in (-1.0, -0.006)])
    mast = Boards(np.array([panel]), np.array([-1]), levels[None])
    tall = Bodies(join_boards([built.boards, mast]).in_order(), faces, lying)

    contact = find_first_body_contact(
        mechanism, end, tolerance, tall, settled=built.settled()
    ).contact
    assert contact is not None
    assert contact.bodies is not None
    drive, pair = contact.drive, contact.bodies
    assert min(tall.low[list(pair)]) == -1.0
    assert drive < end
    pairs = np.array([pair[0]]), np.array([pair[1]])
    gaps = []
    for at in (0.98 * drive, drive):
        state = tall.carried(points_of(mechanism, at))
        gaps.append(float(Apartness.of((state, state), pairs).gaps[0, 0]))
    assert gaps[0] > tolerance >= gaps[1]
