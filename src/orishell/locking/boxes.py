"""Box girders: sleeves over rows of a folding sheet, and how far it moves with them.

From a state on the way to the target, where sleeves are joined to the sheet, to as far as the sheet
closes: the path is proved from the target to both sides.

Limit: box girders lie on the flat sheet, and with boards they have no room there. The motion is
proved from half of the target's drive on, where they are joined to the sheet.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import rounded_down
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design.boxes import Box
from orishell.design.carried import CarriedPart
from orishell.design.stiffeners import Stiffeners
from orishell.locking.box_rows import require_one_side
from orishell.locking.carrier import Carrier
from orishell.locking.fold_rows import fold_rows
from orishell.locking.result import BoxMotion, Lock
from orishell.motion.sleeves import Sleeve, SleeveForms
from orishell.numerics.bisection import largest_below

LARGEST = 0.9
""""auto" goes so far out along edges of columns at the most."""
NARROWEST = 0.15
"""No side of a strip is narrower than this share of the crease that it lies beside."""
SMALLEST, FINE = 0.1, 0.02
"""The smallest share of the largest that "auto" tries, and to which share it is found."""


class BoxPlace(Carrier):
    """A sheet whose rows are closed to box girders."""

    what = strips = "box girders"
    key = "stiffeners.share"

    def __init__(
        self, design: Design, lock: Lock, asked: Stiffeners, tolerance: float, **how: Any
    ) -> None:
        super().__init__(design, lock, asked, tolerance, **how)
        mechanism = design.mechanism
        self.rows = fold_rows(mechanism, asked.rows, self.columns, "box girder")
        require_one_side(design, self.rows, self.columns)
        self.forms = [SleeveForms.of(mechanism, row, self.columns) for row in self.rows]

    def carried(self, progress: Progress = no_progress) -> tuple[Design, Lock]:
        """The design with its box girders, and how its motion ends then.

        Raises DesignError if there is no room for them.
        """
        share = self._share(progress)
        boxes, motion = self.moved(share, progress)
        if motion.joined_from >= self.design.mechanism.target_drive:
            raise self.refused(share, progress)
        return replace(self.design, carried=boxes), replace(self.path.ended(motion), boxes=motion)

    def _share(self, progress: Progress) -> float:
        """The share that is asked for, or the largest that leaves the motion free."""
        narrow, share = self.narrowest(), self.asked.share
        if share == "auto":
            return self.widest(LARGEST, progress)
        most = narrow.largest(NARROWEST)
        if share <= most:
            return share
        raise DesignError(
            "strips of box girders would be narrower than they may be, as columns run together",
            place=f"at row {narrow.row}",
            keys=("stiffeners.share",),
            size=f"shares up to {most:.4g} leave {NARROWEST:g} of the width of a crease",
            candidates=[
                Remedy({"stiffeners.share": each}) for each in (rounded_down(most), "auto")
            ],
            excess=share / most - 1,
        )

    def narrowest(self) -> SleeveForms:
        """The sleeve whose strips are wide enough up to the smallest share."""
        return min(self.forms, key=lambda each: each.largest(NARROWEST))

    def sleeves(self, share: float) -> list[Sleeve]:
        """The sleeves of a share, in each row no more than it has room for."""
        shares = [min(share, each.largest(NARROWEST)) for each in self.forms]
        both = zip(self.forms, shares, strict=True)
        return [Sleeve.over(self.design.mechanism, *each) for each in both]

    def widest(self, most: float, progress: Progress) -> float:
        """The largest share with which the sheet closes as far as without, or to its target.

        Raises DesignError if there is none.
        """

        def closes(share: float) -> bool:
            motion = self._tried(share, progress)
            return motion is not None and motion.opening is None and motion.closing is None

        def stands(share: float) -> bool:
            motion = self._tried(share, progress)
            return motion is not None and motion.joined_from < self.lock.target_drive

        for works in (closes, stands):
            if works(most):
                return most
            found = largest_below(works, most, smallest=SMALLEST, relative=FINE)
            if found is not None:
                return rounded_down(found)
        raise self.refused(most, progress)

    def moved(self, share: float, progress: Progress) -> tuple[tuple[CarriedPart, ...], BoxMotion]:
        """Box girders of a share with their boards, and how far the shell moves with them.

        Raises DesignError if nothing is left of a panel.
        """
        sleeves = self.sleeves(share)
        boxes = [Box.of(each) for each in sleeves]
        made, found = self.path.moved(boxes, progress)
        return made, BoxMotion(
            found.joined_from,
            found.closes_to,
            found.opening,
            found.closing,
            found.proofs,
            tuple(self.rows),
            tuple(each.share for each in sleeves),
        )

    def _tried(self, share: float, progress: Progress) -> BoxMotion | None:
        """How far the shell moves with sleeves of a share; None if nothing is left of a panel."""
        try:
            return self.moved(share, progress)[1]
        except DesignError:
            return None

    def _others(self) -> list[Remedy]:
        """What may be free where this is not."""
        asked = self.asked
        share = [] if asked.share == "auto" else [Remedy({"stiffeners.share": "auto"})]
        rows = [each for each in ("valleys", "crests") if each != asked.rows]
        return [*share, *(Remedy({"stiffeners.rows": each}) for each in rows)]

    def refused(self, share: float, progress: Progress) -> DesignError:
        """Why there is no room for box girders of a share at the target."""
        try:
            _, motion = self.moved(share, progress)
        except DesignError as error:
            return error
        keys = "stiffeners.share", "stiffeners.rows"
        return self.path.refusal(motion, keys, self._others())
