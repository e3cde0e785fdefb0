"""A second skin under a sheet: its walls, and how far the shell moves with it.

Limit: only shells of the parallel repeating and the T-hedral family have a second skin, below their
sheet. That of the first is there from half of the target's drive on, where it is joined to the
sheet. That of the second is the sheet's image, straight below it: it follows no curve of its own,
and its panels have no thickness.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from orishell.clash.separation import corners_of, nearest
from orishell.clash.state import near_panels
from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design.skin import skin_parts
from orishell.design.stiffeners import Stiffeners
from orishell.locking.carrier import Carrier
from orishell.locking.result import CarriedMotion, Lock, SkinMotion
from orishell.motion.complex import Complex
from orishell.motion.lattice import OnLattice
from orishell.motion.layout import points_of
from orishell.motion.second_skin import INNER, OUTER, SecondSkin, Skinned, Wall
from orishell.motion.skins import Skin
from orishell.numerics.bisection import largest_below

SMALLEST, FINE = 1e-3, 0.01
"""The smallest gap that is offered, by what is asked for, and to which share it is found."""
OTHERS = 0.75, 0.5, 0.25
"""Gaps that are offered where panels meet, by what is asked for."""
MOVED = Remedy({"target.inner": None})
"""A second skin that is the sheet, moved."""


class SkinPlace(Carrier):
    """A sheet with a second skin under it."""

    what = "walls of a second skin"
    strips = "a second skin and its walls"
    key = "stiffeners.gap"

    def __init__(
        self, design: Design, lock: Lock, asked: Stiffeners, tolerance: float, **how: Any
    ) -> None:
        if not isinstance(design.mechanism, Skinned):
            raise InputError(
                "a second skin needs a sheet whose columns are images of one another",
                keys=("stiffeners.kind", "shell.family"),
                expected='family = "parallel-repeating" or "t-hedral"',
                remedy='such a family, or kind = "boxes" without gap and walls',
            )
        super().__init__(design, lock, asked, tolerance, **how)
        if self.inner is None:
            gap = None if asked.gap == "auto" else asked.gap
            self.skin: SecondSkin = design.mechanism.second_skin(self.columns, gap)
        else:
            skin = Skin.along(design.mechanism, self.columns, self.inner.places)
            _require_below(skin)
            self.skin = skin
        if not isinstance(design.mechanism, OnLattice):
            _require_no_boards(design)
        self.walls = chosen_walls(self.skin, asked)
        self.path.start = self.skin.joined_at * design.mechanism.target_drive

    def carried(self, progress: Progress = no_progress) -> tuple[Design, Lock]:
        """The design with its second skin, and how its motion ends then.

        Raises DesignError if there is no room for it.
        """
        design, skin, path = self.design, self.skin, self.path
        parts, motion = path.moved(skin_parts(skin, self.walls), progress)
        if motion.joined_from >= design.mechanism.target_drive:
            # Boards of walls meet those that go on beside them where flaps are shut.
            bare = [Remedy({"pattern.flap": 0})] if design.mechanism.flap_columns else []
            keys = ("stiffeners.gap", "stiffeners.walls")
            if self.inner is not None:
                raise path.refusal(motion, ("target.inner", keys[1]), [*bare, MOVED])
            least, _ = skin.distances()
            smaller = [Remedy({"stiffeners.gap": rounded_down(k * least)}) for k in OTHERS]
            raise path.refusal(motion, keys, [*bare, *smaller])
        made = replace(design, carried=parts)
        return made, replace(path.ended(motion), skin=self._found(made, motion))

    def _found(self, design: Design, motion: CarriedMotion) -> SkinMotion:
        """What is said of a second skin at the target."""
        skin = self.skin
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
            off=None if self.inner is None else self.inner.distance,
            walls=tuple(wall.row for wall in self.walls),
            cells=len(cells),
            volume=float(sum(each.volumes(points).sum() for each in cells)),
        )


def _require_below(skin: Skin) -> None:
    """Refuse a curve whose staircase meets the sheet's, or is above it."""
    if skin.shift > 0 and len(skin.parallel):
        return
    if not len(skin.parallel):
        problem, size = "no part of the curve of a second skin is between the ends of f", ""
    else:
        problem = "the staircase of a second skin is not below that of f everywhere"
        size = f"it is beyond it by {-skin.shift:.4g} along both directions of edges"
    raise DesignError(
        problem,
        place="at its target",
        keys=("target.inner",),
        size=size,
        candidates=[MOVED],
    )


def _require_no_boards(design: Design) -> None:
    """Refuse panels with a thickness where walls are upright."""
    if design.panel is not None:
        raise DesignError(
            "panels of a second skin straight below its sheet have no thickness",
            place="of all panels",
            keys=("panel", "stiffeners.kind"),
            candidates=[Remedy({"panel": None}), Remedy({"stiffeners": None})],
        )


def chosen_walls(skin: SecondSkin, asked: Stiffeners) -> tuple[Wall, ...]:
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


def _no_room(skin: SecondSkin) -> DesignError:
    """Why no wall has room, and the largest gap at which one has."""
    sheet, columns = skin.sheet, skin.columns
    gap, _ = skin.distances()
    if not skin.moved or not isinstance(sheet, Skinned):
        return DesignError(
            "no panel of a second skin faces one of the sheet over a fifth of its edge",
            place="between all rows of panels",
            keys=("target.inner", "pattern.rows"),
            candidates=[MOVED],
        )

    def works(gap: float) -> bool:
        return bool(sheet.second_skin(columns, gap).walls())

    most = largest_below(works, gap, smallest=SMALLEST, relative=FINE)
    return DesignError(
        "a second skin would be so far from the sheet that no two of their panels face each other",
        place="between all rows of panels",
        keys=("stiffeners.gap", "pattern.rows"),
        size=skin.too_far,
        candidates=[] if most is None else [Remedy({"stiffeners.gap": rounded_down(most)})],
        excess=None if most is None else gap / most - 1,
    )


def _apart(design: Design, skin: SecondSkin) -> float:
    """The smallest distance of panels of both skins at the target, of flaps as well."""
    whole = design.moving
    assert isinstance(whole, Complex)
    points, faces = points_of(whole, whole.target_drive), whole.layout.faces
    # At the target some are as near as panels that face each other are: these are looked at first.
    reach = 2 * skin.distances()[0]
    while True:
        pairs = np.stack(near_panels(points, faces, reach))
        of = np.sort(whole.part_of[pairs], axis=0)
        first, second = pairs[:, (of[0] == OUTER) & (of[1] == INNER)]
        corners = corners_of(points, faces[first]), corners_of(points, faces[second])
        found = float(nearest(*corners)[0].min(initial=np.inf))
        if found <= reach:
            return found
        reach = min(found, 2 * reach)
