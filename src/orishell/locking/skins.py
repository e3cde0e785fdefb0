"""A second skin under a sheet on a lattice: its walls, and how far the shell moves with it.

Limit: only shells of the parallel repeating family have a second skin, below their sheet. It is not
analysed under loads, and it is there from half of the target's drive on, where it is joined to the
sheet.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.clash.separation import corners_of, nearest
from orishell.clash.state import near_panels
from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design.skin import skin_parts
from orishell.design.stiffeners import Stiffeners
from orishell.locking.box_rows import box_columns
from orishell.locking.carried import CarriedPath
from orishell.locking.result import CarriedMotion, Lock, SkinMotion
from orishell.motion.complex import Complex
from orishell.motion.convex import require_convex
from orishell.motion.lattice import OnLattice
from orishell.motion.layout import points_of
from orishell.motion.skins import INNER, OUTER, Skin, Wall
from orishell.numerics.bisection import largest_below

WHAT = "walls of a second skin"
SMALLEST, FINE = 1e-3, 0.01
"""The smallest gap that is offered, by what is asked for, and to which share it is found."""
OTHERS = 0.75, 0.5, 0.25
"""Gaps that are offered where panels meet, by what is asked for."""


def with_skin(
    design: Design,
    lock: Lock,
    asked: Stiffeners | None,
    tolerance: float,
    *,
    examined: bool = True,
    progress: Progress = no_progress,
) -> tuple[Design, Lock]:
    """The design with the second skin that is asked for, and how its motion ends then.

    lock: How the motion of the sheet ends, with its boards.
    tolerance: Distance at which panels touch, relative to the flat sheet's diagonal.
    examined: Whether contact is looked for.

    Raises InputError if the sheet is on no lattice, there are no such walls, or panels are whole
    boards.
    Raises DesignError if there is no room for it.
    """
    if asked is None or asked.kind != "skin":
        return design, lock
    if not isinstance(design.mechanism, OnLattice):
        raise InputError(
            "a second skin needs a sheet whose columns are staircases of two directions",
            keys=("stiffeners.kind", "shell.family"),
            expected='family = "parallel-repeating"',
            remedy='that family, or kind = "boxes" without gap and walls',
        )
    columns = box_columns(design, WHAT)
    require_convex(design.mechanism, WHAT)
    gap = None if asked.gap == "auto" else asked.gap
    skin = Skin.under(design.mechanism, columns, gap)
    walls = chosen_walls(skin, asked)
    path = CarriedPath(
        design,
        lock,
        tolerance,
        examined=examined,
        what="a second skin and its walls",
        key="stiffeners.gap",
    )
    parts, motion = path.moved(skin_parts(skin, walls), progress)
    if motion.joined_from >= design.mechanism.target_drive:
        least, _ = skin.distances()
        smaller = [Remedy({"stiffeners.gap": rounded_down(k * least)}) for k in OTHERS]
        # Boards of walls meet those that go on beside them where flaps are shut.
        bare = [Remedy({"pattern.flap": 0})] if design.mechanism.flap_columns else []
        raise path.refusal(motion, ("stiffeners.gap", "stiffeners.walls"), [*bare, *smaller])
    made = replace(design, carried=parts)
    return made, replace(path.ended(motion), skin=_found(made, skin, walls, motion))


def chosen_walls(skin: Skin, asked: Stiffeners) -> tuple[Wall, ...]:
    """The walls that are asked for.

    Raises InputError if one of a list has no room, and DesignError if none has.
    """
    there = {wall.row: wall for wall in skin.walls()}
    if not there:
        raise _no_room(skin)
    rows = list(there)
    if asked.walls == "all":
        return tuple(there.values())
    if isinstance(asked.walls, int):
        return tuple(there[row] for row in sorted({*rows[:: asked.walls], rows[-1]}))
    wrong = [row for row in asked.walls if row not in there]
    if wrong or not asked.walls:
        raise InputError(
            "there is no room for a wall between panels of this row"
            if wrong
            else "no row is named",
            keys=("stiffeners.walls",),
            got=str(wrong[0]) if wrong else "[]",
            expected="rows of panels " + ", ".join(map(str, rows)),
        )
    return tuple(there[row] for row in sorted(set(asked.walls)))


def _no_room(skin: Skin) -> DesignError:
    """Why no wall has room, and the largest gap at which one has."""
    sheet, columns = skin.sheet, skin.columns
    gap, _ = skin.distances()

    def works(gap: float) -> bool:
        return bool(Skin.under(sheet, columns, gap).walls())

    most = largest_below(works, gap, smallest=SMALLEST, relative=FINE)
    return DesignError(
        "a second skin would be so far from the sheet that no two of their panels face each other",
        place="between all rows of panels",
        keys=("stiffeners.gap", "pattern.rows"),
        size=f"it is {skin.shift:.4g} along edges of {skin.lattice.lengths.max():.4g} at the most",
        candidates=[] if most is None else [Remedy({"stiffeners.gap": rounded_down(most)})],
        excess=None if most is None else gap / most - 1,
    )


def _found(
    design: Design, skin: Skin, walls: tuple[Wall, ...], motion: CarriedMotion
) -> SkinMotion:
    """What is said of a second skin at the target."""
    points = skin.sheet.positions(skin.sheet.target_drive)
    cells = [cell for part in design.carried for cell in part.strips.cells]
    return SkinMotion(
        motion.joined_from,
        motion.closes_to,
        motion.opening,
        motion.closing,
        motion.proofs,
        gap=_apart(design, skin),
        largest_gap=skin.distances()[1],
        walls=tuple(wall.row for wall in walls),
        cells=len(cells),
        volume=float(sum(each.volumes(points).sum() for each in cells)),
    )


def _apart(design: Design, skin: Skin) -> float:
    """The smallest distance of panels of both skins at the target, of flaps as well."""
    whole = design.moving
    assert isinstance(whole, Complex)
    points, faces = points_of(whole, whole.target_drive), whole.layout.faces
    # Some are as near as panels that face each other are.
    pairs = np.stack(near_panels(points, faces, 2 * skin.distances()[0]))
    of = np.sort(whole.part_of[pairs], axis=0)
    first, second = pairs[:, (of[0] == OUTER) & (of[1] == INNER)]
    return float(
        nearest(corners_of(points, faces[first]), corners_of(points, faces[second]))[0].min()
    )
