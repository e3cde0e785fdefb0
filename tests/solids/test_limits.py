"""How thick boards may be, and how far they fold."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError
from orishell.design import PanelSpec, Setback
from orishell.design_file import read_design_file
from orishell.motion import largest_fold
from orishell.motion.grid import CreaseValues, Grid
from orishell.motion.layout import Layout
from orishell.numerics.arrays import Array
from orishell.shell.make import Shell, make_shell
from orishell.solids import drive_for_height, find_thickness_limit, largest_folds, thickness_between
from orishell.solids.setbacks import bare_faces
from orishell.solids.sides import SideFolds
from samples import THOROUGH, examples, thorough
from strategies import Request, orthodiagonal_requests, requests

SHELTER = Path(__file__).parents[2] / "examples" / "shelter.toml"


def shelter(thickness: float) -> Shell:
    file = read_design_file(SHELTER)
    thick = {"panel.thickness": thickness, "panel.membrane": 0.02 * thickness}
    return make_shell(
        file.changed(thick) if thickness else file,
        skip=("deviation", "weight", "stock", "structure"),
    )


THIN = PanelSpec()


def panels(gap: float = 0.0, *, share: float = 0.5, length: float | None = None) -> PanelSpec:
    setback = Setback(share=share, length=length)
    return PanelSpec(thickness=1.0, membrane=0.5, gap=gap, largest_setback=setback)


def thick(height: float) -> PanelSpec:
    """Panels that stand so high over their hinge plane."""
    return PanelSpec(thickness=2 * height, membrane=height)


def largest_height(flat: Array, grid: Grid, folds: CreaseValues, build: PanelSpec = THIN) -> float:
    """How high boards on both faces may stand."""
    return 0.5 * thickness_between(flat, grid, folds, build)


def test_boards_on_one_face_have_the_room_of_both() -> None:
    """The strip below: a mountain takes nothing from upper boards, but for half the membrane.

    With a membrane of 2 mm its face without boards takes 1 mm times tan 60 degrees.
    """
    grid = Grid(3, 2)
    x, y = np.meshgrid(np.arange(2.0), -np.arange(3.0))
    flat, turn = np.stack([x, y, 0 * x], axis=-1), np.deg2rad(120)
    whole = PanelSpec(membrane=0.002, thickness=0.1)
    thin = PanelSpec(membrane=0.01, thickness=0.1, largest_setback=Setback(length=0.005))
    for sign, closing, other in ((1, "top", "bottom"), (-1, "bottom", "top")):
        fold = CreaseValues(row=np.array([[sign * turn]]), column=np.zeros((2, 0)))
        within, outside, narrow = (
            whole.model_copy(update={"sides": closing}),
            whole.model_copy(update={"sides": other}),
            thin.model_copy(update={"sides": other}),
        )
        most = thickness_between(flat, grid, fold, within)
        assert most == pytest.approx(0.5 / np.sqrt(3) + 0.001)
        assert within.board == pytest.approx(0.098)
        assert thickness_between(flat, grid, fold, outside) == np.inf
        # The membrane asks for 5 mm times sqrt(3), and has 5: all of it is as much thinner.
        assert thickness_between(flat, grid, fold, narrow) == pytest.approx(0.1 / np.sqrt(3))


def test_a_strip_of_squares_by_hand() -> None:
    """Squares of side 1 whose creases fold by 120 degrees: tan 60 degrees = sqrt(3).

    Valleys take from the upper boards of both neighbours, mountains from the lower ones.
    """
    grid = Grid(4, 2)
    x, y = np.meshgrid(np.arange(2.0), -np.arange(4.0))
    flat = np.stack([x, y, 0 * x], axis=-1)
    turn = np.deg2rad(120)
    pleats = CreaseValues(row=np.array([[turn], [-turn]]), column=np.zeros((3, 0)))
    assert largest_height(flat, grid, pleats) == pytest.approx(0.5 / np.sqrt(3))
    roll = CreaseValues(row=np.array([[turn], [turn]]), column=np.zeros((3, 0)))
    assert largest_height(flat, grid, roll) == pytest.approx(0.25 / np.sqrt(3))
    assert largest_height(flat, grid, roll, panels(share=0.2)) == pytest.approx(0.1 / np.sqrt(3))
    # Set-backs of at most 0.1; a gap of 0.3 leaves 0.35 to the other side, and is one in itself.
    assert largest_height(flat, grid, roll, panels(length=0.1)) == pytest.approx(0.1 / np.sqrt(3))
    assert largest_height(flat, grid, pleats, panels(0.3)) == pytest.approx(0.35 / np.sqrt(3))
    assert largest_height(flat, grid, roll, panels(0.3)) == pytest.approx(0.25 / np.sqrt(3))
    assert largest_height(flat, grid, roll, panels(0.3, length=0.1)) == 0
    assert largest_height(flat, grid, pleats, panels(0.6)) == 0
    still = CreaseValues(row=np.zeros((2, 1)), column=np.zeros((3, 0)))
    assert largest_height(flat, grid, still) == np.inf


@settings(max_examples=examples(30))
@given(st.one_of(requests(), orthodiagonal_requests()), st.floats(0.2, 0.9))
def test_the_drive_for_a_height_is_the_last_that_leaves_enough(
    request: Request, share: float
) -> None:
    mechanism = request.feasible().mechanism.without_flaps()
    flat, grid = mechanism.positions(0.0), mechanism.grid

    def most(drive: float) -> float:
        return largest_height(flat, grid, largest_folds(mechanism, drive))

    height = most(share * mechanism.end_drive)
    drive = drive_for_height(mechanism, thick(height * (1 - 1e-6)))
    assert drive >= share * mechanism.end_drive * (1 - 1e-3)
    for before in np.linspace(0, drive, 60)[1:]:
        assert largest_height(flat, grid, mechanism.fold_angles(before)) >= height * (1 - 2e-6)


@thorough
def test_boards_end_the_motion_of_the_shelter() -> None:
    """10 mm boards fold to 177 degrees: set-backs take half of the narrowest panel."""
    shell = shelter(0.01)
    mechanism, deployment = shell.design.mechanism, shell.report.deployment
    assert shell.lock.cause == "boards"
    widest = np.rad2deg(largest_fold(mechanism, np.array([shell.lock.closes_to]))[0])
    assert 177.0 < widest < 177.3
    folds = largest_folds(mechanism, shell.lock.closes_to)
    assert largest_height(mechanism.positions(0.0), mechanism.grid, folds) == pytest.approx(0.005)
    assert deployment.packed is not None
    bare = shelter(0.0).report.deployment.packed
    assert bare is not None
    # Much thicker than 72 boards: they do not lie flat on each other yet.
    assert 72 * 0.01 < deployment.packed.height < 1.0
    assert bare.height < 1e-3
    assert deployment.packed.length == pytest.approx(bare.length, abs=0.02)
    assert shell.report.panel is not None
    assert shell.report.panel.path is not None
    assert np.rad2deg(shell.report.panel.set_back_for) == np.rad2deg(deployment.end_drive)


@thorough
def test_thicker_boards_pack_larger() -> None:
    sizes = []
    for thickness in (0.004, 0.01, 0.02, 0.04) if THOROUGH else (0.004, 0.02):
        packed = shelter(thickness).report.deployment.packed
        assert packed is not None
        sizes.append(packed.length * packed.width * packed.height)
    assert sizes == sorted(sizes)


@thorough
def test_boards_too_thick_for_the_target() -> None:
    with pytest.raises(
        DesignError, match=r"room for 0\.2101 at most, and panels are 0\.5 thick"
    ) as refused:
        shelter(0.5)
    (remedy,) = refused.value.remedies
    thickness = remedy.changes["panel.thickness"]
    assert isinstance(thickness, float)
    assert shelter(thickness).lock.cause == "boards"


def test_a_crease_that_folds_flat_leaves_no_height() -> None:
    """Of the upper boards beside a valley; only flaps may go without them."""
    grid = Grid(4, 2)
    x, y = np.meshgrid(np.arange(2.0), -np.arange(4.0))
    flat = np.stack([x, y, 0 * x], axis=-1)
    folds = CreaseValues(row=np.array([[np.pi], [-1.0]]), column=np.zeros((3, 0)))
    assert largest_height(flat, grid, folds) == 0
    sides, columns = SideFolds.of(Layout.of_grid(grid), folds), np.zeros(3)
    assert bare_faces(sides, np.isin(columns, [0])).tolist() == [[True, True, False], [False] * 3]
    assert not bare_faces(sides, np.isin(columns, [])).any()


@pytest.mark.parametrize("figure", [1, 2])
def test_flaps_that_fold_flat_limit_nothing(figure: int) -> None:
    """They carry no boards where they close; what limits the motion is what does without them."""
    file = read_design_file(SHELTER.with_name(f"figure{figure}.toml"))
    sheet = file.pattern.design(file.f, file.g).mechanism
    build = PanelSpec(thickness=0.01, membrane=1e-3)
    limit = find_thickness_limit(sheet, build)
    without = find_thickness_limit(sheet.without_flaps(), build)
    assert not limit.on_flap
    assert 0 < limit.thickness <= without.thickness * (1 + 1e-12)
    assert drive_for_height(sheet, thick(0.49 * limit.thickness)) == sheet.end_drive
    assert drive_for_height(sheet, thick(0.6 * limit.thickness)) < sheet.end_drive
    with_boards = find_thickness_limit(sheet.with_stop(np.deg2rad(0.1)), build)
    assert with_boards.on_flap
    assert with_boards.thickness < 0.01
