"""The bill of panels with a thickness, against sums by hand and sums over boards one by one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from boarded import BUILDS, boarded_document
from documents import demo_document
from orishell.design import PanelSpec
from orishell.document import Document, DocumentState
from orishell.io.format import Settings
from orishell.io.formats.tables import write_tables
from orishell.motion.boards import Boards
from orishell.motion.grid import Grid
from orishell.motion.mesh import build_mesh
from orishell.numerics.arrays import Array
from orishell.workshop import Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.board_sheets import nest_boards
from orishell.workshop.quantities import PanelBill, measure_panels


def two_panels() -> Document:
    """Two panels of 2 m by 1 m, hinged at x = 2; the second stands upright.

    The membrane is 10 mm thick. One board, 2 m by 0.8 m and 20 mm thick, lies on top of the first,
    another, 1.5 m by 1 m, on the bottom of the second.
    """
    grid = Grid(2, 3)
    flat = np.array([[0, 1], [2, 1], [4, 1], [0, 0], [2, 0], [4, 0]], dtype=float)
    folded = np.array([[0, 1, 0], [2, 1, 0], [2, 1, 2], [0, 0, 0], [2, 0, 0], [2, 0, 2]], float)

    def board(left: float, right: float, top: float, low: float, high: float) -> list[object]:
        corners = [(left, 0.0), (right, 0.0), (right, top), (left, top)]
        return [[(x, y, z) for x, y in corners] for z in (low, high)]

    outlines = [board(0, 2, 0.8, 0.005, 0.025), board(2.5, 4, 1.0, -0.025, -0.005)]
    angles = np.where(build_mesh(grid.faces_vertices(), 6, grid.edges_vertices()).crease, 90.0, 0)
    return Document(
        title="two panels",
        unit="m",
        mesh=build_mesh(grid.faces_vertices(), 6, grid.edges_vertices()),
        assignment=tuple("V" if angle else "B" for angle in angles),
        flat=flat,
        fold_angles_deg=angles,
        states=(DocumentState(folded),),
        grid_shape=(2, 3),
        curves={},
        origin=np.array([100.0, 200.0, 300.0]),
        panel=PanelSpec(thickness=0.05, membrane=0.01, density=100, membrane_density=50),
        boards=Boards(np.array([0, 1]), np.array([1, -1]), np.array(outlines, dtype=float)),
    )


def bill_of(document: Document, workshop: Workshop | None = None) -> PanelBill:
    bill = measure_panels(document, workshop or Workshop())
    assert bill is not None
    return bill


def test_two_panels_by_hand() -> None:
    bill = bill_of(two_panels())
    assert (bill.boards.top, bill.boards.bottom, bill.boards.solid) == (1, 1, 0)
    assert bill.board_area == pytest.approx(1.6 + 1.5, rel=1e-12)
    assert bill.glue_area == pytest.approx(1.6 + 1.5, rel=1e-12)
    assert bill.membrane_area == pytest.approx(4.0, rel=1e-12)
    assert bill.hinge_length == pytest.approx(1.0, rel=1e-12)
    # 20 mm at 100 kg/m3 is 2 kg/m2; 10 mm at 50 kg/m3 is 0.5 kg/m2.
    assert bill.mass_kg.boards == pytest.approx(2 * 3.1, rel=1e-12)
    assert bill.mass_kg.membrane == pytest.approx(0.5 * 4, rel=1e-12)
    assert bill.mass_kg.total == pytest.approx(8.2, rel=1e-12)
    # On the second panel, which stands upright, the bottom looks along +x.
    boards = 3.2 * np.array([1, 0.4, 0.015]) + 3.0 * np.array([2.015, 0.5, 1.25])
    membrane = np.array([1, 0.5, 0]) + np.array([2, 0.5, 1])
    centre = np.array([100, 200, 300]) + (boards + membrane) / 8.2
    assert bill.centre_of_mass == pytest.approx(centre, rel=1e-12)
    assert bill.stock_sheets is None


def test_unit() -> None:
    """The same numbers in millimetres weigh a thousand-millionth."""
    metres, millimetres = bill_of(two_panels()), bill_of(replace(two_panels(), unit="mm"))
    assert metres.mass_kg.total is not None
    assert millimetres.mass_kg.total == pytest.approx(1e-9 * metres.mass_kg.total, rel=1e-12)
    assert millimetres.centre_of_mass == pytest.approx(metres.centre_of_mass, rel=1e-12)


def test_without_a_density_there_is_no_mass() -> None:
    document = two_panels()
    assert document.panel is not None
    light = bill_of(replace(document, panel=document.panel.replace_unchecked(density=0.0)))
    assert light.mass_kg.boards is None
    assert light.mass_kg.membrane == pytest.approx(2.0)
    assert (light.mass_kg.total, light.centre_of_mass) == (None, None)


def test_panels_without_a_thickness_have_no_bill() -> None:
    assert measure_panels(demo_document(), Workshop()) is None


@pytest.mark.parametrize("construction", BUILDS)
def test_boards_one_by_one(construction: str) -> None:
    """Areas, masses and the centre of mass are those of all boards, clipped ones too."""
    document = boarded_document(construction, clipped=True)
    everything, bill = laid_flat(document), bill_of(document)
    boards, build = everything.boards, document.panel
    assert boards is not None
    assert build is not None
    assert bill.boards.top + bill.boards.bottom + bill.boards.solid == len(boards)
    assert bill.board_area == pytest.approx(boards.areas().sum(), rel=1e-12)
    assert bill.mass_kg.boards == pytest.approx(1e-9 * 650 * boards.volumes().sum(), rel=1e-12)
    membrane = everything.areas().sum() if construction == "sandwich" else 0.0
    assert bill.membrane_area == pytest.approx(membrane, rel=1e-12)
    assert bill.mass_kg.membrane == pytest.approx(1e-9 * 800 * 0.2 * membrane, rel=1e-12)
    mass, moment = 0.0, np.zeros(3)
    for piece in (document, *document.attached):
        assert piece.boards is not None
        carried = piece.boards_in(piece.shell)
        for corners, volume in zip(carried, piece.boards.volumes(), strict=True):
            mass += 650 * volume
            moment += 650 * volume * middle_of(corners)
        if construction == "sandwich":
            for quad, area in zip(piece.mesh.faces, piece.areas(), strict=True):
                mass += 800 * 0.2 * area
                moment += 800 * 0.2 * area * middle_of(piece.shell.positions[quad][None])
    assert bill.centre_of_mass == pytest.approx(document.in_world(moment / mass), abs=1e-9)


def middle_of(levels: Array) -> Array:
    """Centroid of what lies between outlines (H, K, 3), or of a single one (1, K, 3).

    Sections' areas times their centroids are cubic in the height: three Gauss points are exact.
    """
    places, weights = np.polynomial.legendre.leggauss(3)
    share = 0.5 * (1 + places)[None, :, None, None]
    slices = (1 - share) * levels[:-1, None] + share * levels[1:, None]
    square = np.cross(levels[0, 1] - levels[0, 0], levels[0, 2] - levels[0, 0])
    height = (levels[1:, 0] - levels[:-1, 0]) @ square
    if len(levels) == 1:
        slices, weights, height = levels[None], np.ones(1), np.ones(1)
    start, one, two = slices[..., :1, :], slices[..., 1:-1, :], slices[..., 2:, :]
    areas = np.linalg.norm(np.cross(one - start, two - start), axis=-1)
    areas *= weights[:, None] * height[:, None, None]
    thirds = (start + one + two) / 3
    return np.asarray((thirds * areas[..., None]).sum(axis=(0, 1, 2)) / areas.sum())


def test_stock_and_table(tmp_path: Path) -> None:
    """The table lists every board with its mass and its sheet of stock."""
    document = boarded_document(clipped=True)
    workshop = Workshop(stock=(250.0, 180.0), margin=5.0, spacing=1.0)
    bill = bill_of(document, workshop)
    write_tables(tmp_path / "panels.csv", document, Settings(workshop=workshop))
    head, *rows = (tmp_path / "boards.csv").read_text().splitlines()
    assert head == "part,panel,side,area_mm2,volume_mm3,mass_kg,sheet"
    cells = [row.replace('"', "").rsplit(",", 5) for row in rows]
    assert len(cells) == bill.boards.top + bill.boards.bottom
    assert len({row.split('",')[0] for row in rows}) == len(rows)
    assert sum(float(cell[2]) for cell in cells) == pytest.approx(bill.board_area, rel=1e-12)
    assert sum(float(cell[4]) for cell in cells) == pytest.approx(bill.mass_kg.boards, rel=1e-12)
    sheets = [int(cell[5]) for cell in cells]
    assert sheets == [1 + placement.sheet for placement in nest_boards(document, workshop)]
    assert max(sheets) == bill.stock_sheets
    assert measure_panels(document, workshop, nested=False) == replace(bill, stock_sheets=None)
