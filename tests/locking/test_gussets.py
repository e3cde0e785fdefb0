"""Gussets: where they are, that they fix the motion, and that they meet nothing at the target."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from documents import design_of
from orishell.conventions.errors import DesignError, InputError
from orishell.design import Design, PanelSpec
from orishell.design.stiffeners import Bolts, Stiffeners
from orishell.families.flat_foldable import FlatFoldablePattern, design_flat_foldable
from orishell.locking import find_lock
from orishell.locking.gussets import with_gussets
from orishell.locking.result import Lock
from orishell.motion import diagonal, find_assignment
from orishell.motion.layout import mesh_of, points_of
from orishell.numerics.arrays import Array
from orishell.solids.gussets import Gussets
from orishell.solids.plates import stand_off
from overlaps import solids
from rigid_rank import freedoms_with_plates

TOLERANCE = 1e-9
FAMILIES = ("orthodiagonal", "parallel-repeating", "flat-foldable")


def bare(family: str) -> Design:
    """A design without flaps and without a thickness."""
    if family == "flat-foldable":
        design = design_flat_foldable(FlatFoldablePattern(rows=5, columns=4))
    else:
        design = design_of(family, (5, 5)).with_clipped_flaps()
    return replace(design, clipped=None)


def thick(family: str, share: float, **build: Any) -> tuple[Design, Lock]:
    """The same with panels of so much of the sheet's size, and how it folds to its target."""
    design = bare(family)
    size = float(diagonal(design.mechanism.positions(0.0)))
    sizes = {key: each * share * size for key, each in build.items() if key != "construction"}
    panel = PanelSpec(
        thickness=share * size, construction=build.get("construction", "sandwich"), **sizes
    )
    design = replace(design, panel=panel)
    return design, find_lock(design, beyond=False)


def asked(**values: Any) -> Stiffeners:
    return Stiffeners.model_validate({"kind": "gussets", **values})


def put_in(design: Design, **values: Any) -> Design:
    return with_gussets(design, find_lock(design, beyond=False), asked(**values), TOLERANCE)


@pytest.mark.parametrize("family", FAMILIES)
def test_one_gusset_leaves_no_motion(family: str) -> None:
    """Rank of rigid bodies on hinges, by the tests' own count: one motion less, whichever it is."""
    design = put_in(bare(family))
    mechanism = design.mechanism
    assert freedoms_with_plates(mechanism, []) == 1
    assert design.fixed_by == "any"
    for part in design.plates:
        assert part.plate is not None
        assert freedoms_with_plates(mechanism, [part.plate.corner]) == 0


@pytest.mark.parametrize("family", FAMILIES)
def test_they_go_along_edges_of_columns(family: str) -> None:
    """Corners at the vertex and 0.6 of the way to those above and below; rows whose creases are
    valleys."""
    design = put_in(bare(family), share=0.6)
    mechanism = design.mechanism
    points = mechanism.positions(mechanism.target_drive)
    valleys = (find_assignment(mechanism).row > 0).all(axis=1)
    rows = 1 + np.flatnonzero(valleys)
    assert [part.plate.corner for part in design.plates if part.plate is not None] == [
        (row, column) for row in rows.tolist() for column in range(mechanism.grid.columns)
    ]
    for part in design.plates:
        assert part.plate is not None
        row, column = part.plate.corner
        x, up, down = (points[row + step, column] for step in (0, -1, 1))
        q, r = x + 0.6 * (up - x), x + 0.6 * (down - x)
        wanted = np.stack([x, q, 0.5 * (q + r), r])
        np.testing.assert_allclose(part.shell.positions, wanted, rtol=0, atol=1e-12)
        flat, sides = part.require_flat(), [np.linalg.norm(each - x) for each in (q, r)]
        np.testing.assert_allclose(
            np.linalg.norm(flat - flat[0], axis=1)[[1, 3]], sides, rtol=1e-12
        )


@pytest.mark.parametrize(
    "build",
    [
        {"construction": "bevel", "gap": 0.2},
        {"construction": "sandwich", "membrane": 0.1},
    ],
    ids=["bevel", "sandwich"],
)
@pytest.mark.parametrize("family", FAMILIES)
def test_boards_have_nothing_in_common(family: str, build: dict[str, Any]) -> None:
    """Of gussets that are not refused, manifold3d finds no volume in others, or in panels."""
    design, lock = thick(family, 5e-4, **build)
    found = with_gussets(design, lock, asked(columns=2), TOLERANCE)
    assert lock.built is not None
    mechanism = design.mechanism
    flat, points = points_of(mechanism, 0.0)[:, :2], points_of(mechanism, mechanism.target_drive)
    boards = lock.built.boards
    sheet = solids(boards.carried(mesh_of(mechanism).faces, flat, points), boards)
    total = float(boards.volumes().sum())
    others = list(sheet)
    for part in found.plates:
        assert part.boards is not None
        own = solids(part.boards_in(part.shell), part.boards)
        assert max((a ^ b).volume() for a in own for b in others) < 1e-12 * total
        others += own


@pytest.mark.parametrize("thickness", [2e-3, 6e-3])
def test_what_has_no_room_is_refused_and_what_is_offered_fits(thickness: float) -> None:
    """Boards so thick that gussets meet others, or have no way left along their edges."""
    design, lock = thick("orthodiagonal", thickness, construction="sandwich", membrane=0.1)
    with pytest.raises(DesignError) as refused:
        with_gussets(design, lock, asked(), TOLERANCE)
    assert refused.value.keys == ("stiffeners.share",)
    for remedy in refused.value.candidates:
        values = {key.split(".")[1]: value for key, value in remedy.changes.items()}
        assert with_gussets(design, lock, asked(**values), TOLERANCE).plates


def test_how_far_a_plate_stands_off() -> None:
    """By hand: h (1 + |cos|)/sin off a board that stands across, h tan off one that ends before."""
    sine, tangent = np.sin(np.pi / 3), np.tan(np.deg2rad(1.0))
    wanted = [2.0, 2 * 1.5 / sine, 2 * 1.5 / sine, 2 * tangent]
    found = stand_off(np.deg2rad([90.0, 60.0, 120.0, 179.0]), 2.0, 2.0)
    np.testing.assert_allclose(found, wanted, rtol=1e-12)
    assert np.isinf(stand_off(np.zeros(1), 1.0, 1.0)[0])


@pytest.mark.parametrize("family", FAMILIES)
def test_bolts_are_off_the_edges_and_so_far_apart(family: str) -> None:
    """Along both edges of the column, as many as there is room for, none nearer to any edge."""
    design, _ = thick(family, 5e-4, construction="bevel", gap=0.2)
    at = np.array([[1, 1], [3, 2]])
    found = Gussets.of(design, at, 0.7)
    corners = found.cut()
    shortest = float(np.linalg.norm(corners[:, 1:] - corners[:, :1], axis=-1).min())
    bolts = Bolts(hole=0.005 * shortest, spacing=0.07 * shortest)
    for holes, (x, u, v) in zip(found.holes(bolts), corners, strict=True):
        off = np.stack([_away(holes.middles, *side) for side in ((x, u), (u, v), (v, x))])
        assert off.min() > bolts.off * (1 - 1e-9)
        on_first, on_second = np.isclose(off[[0, 2]], bolts.off, rtol=1e-9)
        assert (on_first ^ on_second).all()
        for on, end, other in ((on_first, u, (v, x)), (on_second, v, (x, u))):
            along = (end - x) / np.linalg.norm(end - x)
            row = np.sort(holes.middles[on] @ along)
            np.testing.assert_allclose(np.diff(row), bolts.spacing, rtol=1e-9)
            assert holes.lengths[on].sum() == pytest.approx(np.linalg.norm(end - x), rel=1e-12)
            # With one more in the middle between them, both ends would be too near to a side.
            middles = holes.middles[on][np.argsort(holes.middles[on] @ along)]
            inner, outer = middles[[0, -1]] + 0.5 * bolts.spacing * np.outer([-1, 1], along)
            assert _away(inner, *other) < 2 * bolts.off
            assert _away(outer, u, v) < bolts.off
        apart = np.linalg.norm(holes.middles[:, None] - holes.middles, axis=-1)
        assert apart[~np.eye(len(holes), dtype=bool)].min() >= bolts.off * (1 - 1e-9)


def _away(points: Array, start: Array, end: Array) -> Array:
    """How far points (..., 2) are to the left of a line."""
    x, y = (end - start) / np.linalg.norm(end - start)
    return np.asarray((points - start) @ np.array([-y, x]))


def test_a_plate_of_another_thickness_stands_off_by_both() -> None:
    """A plate of 6 and a panel of 4: clear by hand, and not a hair nearer, at the worst corner."""
    angles = np.deg2rad([30.0, 90.0, 110.0, 150.0, 179.0])
    half, panel = 3.0, 2.0
    sine, cosine = np.sin(angles), np.cos(angles)
    off = stand_off(angles, half, panel)
    corners = np.stack([off * sine - side * half * cosine for side in (-1, 1)])
    over, before = corners.min(axis=0) - panel, -(off * cosine + half * sine)
    np.testing.assert_allclose(np.maximum(over, before), 0, atol=1e-12)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"rows": [0]}, "numbers from 1 to 5"),
        ({"rows": []}, "no row is named"),
        ({"columns": [9]}, "numbers from 0 to 4"),
    ],
)
def test_places_that_are_not_there_are_refused(values: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        put_in(bare("orthodiagonal"), **values)


def test_every_third_column_has_the_last_too() -> None:
    design = put_in(bare("orthodiagonal"), columns=3)
    columns = {part.plate.corner[1] for part in design.plates if part.plate is not None}
    assert columns == {0, 3, 4}


def test_flaps_take_the_place_of_gussets_at_their_sides() -> None:
    """Folded or clipped on: the first and the last column between flaps have none."""
    design = design_of("orthodiagonal", (5, 5))
    inner = design.mechanism.inner_columns
    for each in (design, design.with_clipped_flaps()):
        columns = {part.plate.corner[1] for part in put_in(each).plates if part.plate is not None}
        start = each.mechanism.inner_columns.start
        assert columns == set(range(start + 1, start + inner.stop - inner.start - 1))


def test_whole_boards_have_none() -> None:
    design = replace(bare("orthodiagonal"), panel=PanelSpec(thickness=0.01, construction="hinged"))
    lock = find_lock(bare("orthodiagonal"), beyond=False)
    with pytest.raises(InputError, match="beside"):
        with_gussets(design, lock, asked(), TOLERANCE)
