"""Holes of bolts in pages and solids: where drawings have them, as wide, through every board."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from cad_tools import require_build123d
from design_tables import Tables, formula, tables
from orishell.design_file import check_design
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.pdf import write_pdf
from orishell.io.formats.step import write_step
from orishell.numerics.arrays import Array
from orishell.shell.make import make_shell
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import board_layers

HOLE = 0.006
PANELS = {
    "bevel": {"construction": "bevel", "thickness": 0.006, "gap": 0.004},
    "sandwich": {"thickness": 0.008, "membrane": 0.0005, "gap": 0.004},
}


@cache
def bolted(construction: str) -> Document:
    """An arch with gussets that are bolted on, of solid boards or of two with a membrane."""
    f, g = formula("-x**2", -1, 1), formula("0.1*cos(2*pi*x)", 0, 1.5)
    pattern = {"rows": 3, "columns": 4, "flap": 0, "heading_deg": 90, "spacing": "equal"}
    design: Tables = {
        **tables("orthodiagonal", f, g, **pattern),
        "panel": PANELS[construction],
        "stiffeners": {"kind": "gussets", "bolts": {"hole": HOLE, "spacing": 0.06}},
    }
    file = check_design(design, Path("x.toml"))
    document = make_shell(file, clash="unexamined", skip=("remedies", "verification")).document
    assert sum(len(part.holes) for part in document.attached if part.holes is not None) > 10
    return document


@pytest.mark.parametrize("construction", PANELS)
def test_axes_are_upright_in_boards(construction: str) -> None:
    """From one face to the other, square to both, as far from every corner in all states."""
    for part in bolted(construction).attached:
        assert part.holes is not None
        assert part.boards is not None
        board, axes, diameters = part.holes.through(
            part.boards, part.mesh.faces, part.require_flat(), part.shell.positions
        )
        assert len(board) == len(part.holes) * len(part.boards)
        np.testing.assert_array_equal(diameters, HOLE)
        corners = part.boards_in(part.shell)
        flat = part.boards.outlines
        for number, axis in zip(board, axes, strict=True):
            way = axis[1] - axis[0]
            low, high = corners[number, 0], corners[number, -1]
            for end, face in zip(axis, (low, high), strict=True):
                around = np.roll(face, -1, axis=0) - face
                assert np.abs(around @ way).max() < 1e-12
                assert np.abs((face - end) @ way).max() < 1e-12
            thick = flat[number, -1, 0, 2] - flat[number, 0, 0, 2]
            assert np.linalg.norm(way) == pytest.approx(thick, rel=1e-12)
        away = np.linalg.norm(corners[board, 0] - axes[:, :1], axis=-1)
        lying = np.linalg.norm(
            flat[board, 0, :, :2] - np.resize(part.holes.middles, (len(board), 2))[:, None], axis=-1
        )
        np.testing.assert_allclose(away, lying, rtol=0, atol=1e-12)


@pytest.mark.parametrize("construction", PANELS)
def test_solids_have_them(construction: str, tmp_path: Path) -> None:
    """As many cylinders as holes, in every board, and so much less of it."""
    require_build123d()
    from build123d import GeomType, import_step

    document = bolted(construction)
    write_step(tmp_path / "shell-target.step", document, Settings())
    whole = [
        (part.board_name(board), volume, 0 if part.holes is None else len(part.holes), thick)
        for part in document.parts
        if part.boards is not None
        for board, volume, thick in zip(
            range(len(part.boards)),
            1e9 * part.boards.volumes(),
            1e3 * np.ptp(part.boards.outlines[:, :, 0, 2], axis=1),
            strict=True,
        )
    ]
    for name in ("target", "flat"):
        shape = import_step(tmp_path / f"shell-{name}.step")
        assert len(shape.children) == len(whole)
        for solid, (called, volume, count, thick) in zip(shape.children, whole, strict=True):
            assert solid.label.replace("_", " ") == called
            assert solid.is_valid
            round_ = [face for face in solid.faces() if face.geom_type == GeomType.CYLINDER]
            assert len(round_) == count
            less = count * np.pi * (500 * HOLE) ** 2 * thick
            assert solid.volume == pytest.approx(volume - less, rel=1e-6)


MM = 72 / 25.4


def circles(file: Path) -> Array:
    """Middles and radii (N, 3) of circles in a PDF (mm): they begin at the right."""
    drawn = re.findall(
        r"n\n(\S+) (\S+) m\n((?:(?:\S+ ){6}c\n){4})S", file.read_bytes().decode("latin-1")
    )
    found = []
    for x, y, curves in drawn:
        ends = np.array([line.split()[4:6] for line in curves.splitlines()], float)
        middle = 0.5 * (ends[0] + ends[2])[[0, 1]]
        assert np.ptp(np.linalg.norm(ends - [ends[0, 0], float(y)], axis=1)) < 1e-2
        found.append([ends[0, 0], float(y), float(x) - middle[0]])
    return np.array(found) / MM


@pytest.mark.parametrize("construction", PANELS)
def test_pages_have_them(construction: str, tmp_path: Path) -> None:
    """As wide as the scale makes them, at the same places from each other as in the drawings."""
    document, scale = bolted(construction), 0.04
    workshop = Workshop(paper_scale=scale, paper="A3")
    write_pdf(tmp_path / "x.pdf", document, Settings(workshop=workshop))
    layers = [layer for layer in board_layers(document, workshop) if layer.content[1]]
    assert layers
    for layer in layers:
        found = circles(tmp_path / f"x-{layer.ending}.pdf")
        np.testing.assert_allclose(found[:, 2], 0.5 * scale * 1e3 * HOLE, rtol=2e-3)
        wanted = 1e3 * scale * np.array([[each.x, each.y] for each in layer.content[1]])
        moved = found[:, :2] + wanted[0] - found[0, :2]
        assert len(found) == len(wanted)
        np.testing.assert_allclose(moved, wanted, rtol=0, atol=2e-3)
