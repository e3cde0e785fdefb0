"""Box girders: sleeves over rows of a folding sheet, and how far it moves with them.

From a state on the way to the target, where sleeves are joined to the sheet, to as far as the sheet
closes: the path is proved from the target to both sides.

Limit: box girders lie on the flat sheet, and with boards they have no room there. The motion is
proved from half of the target's drive on, where they are joined to the sheet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from orishell.clash import PathContact, PathResult, find_first_contact
from orishell.clash.bodies import Bodies
from orishell.clash.complex_path import find_first_contact_of_parts
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees, rounded_down
from orishell.conventions.progress import Progress, no_progress
from orishell.design import Design
from orishell.design.boxes import Box
from orishell.design.stiffeners import Stiffeners
from orishell.locking.boards import prove_boards
from orishell.locking.box_flaps import Called, called, flap_contact
from orishell.locking.box_rows import box_columns, require_one_side
from orishell.locking.fold_rows import fold_rows
from orishell.locking.result import BoxMotion, Contact, Lock
from orishell.locking.sheet import SHORT_OF_END
from orishell.motion import corrugation_depth, diagonal
from orishell.motion.complex import Complex
from orishell.motion.convex import require_convex
from orishell.motion.layout import points_of
from orishell.motion.sleeves import Sleeve, SleeveForms
from orishell.numerics.bisection import largest_below
from orishell.solids import build_panels
from orishell.solids.sleeves import closes_to, moving_boards, sleeve_design

LARGEST = 0.9
""""auto" goes so far out along edges of columns at the most."""
NARROWEST = 0.15
"""No side of a strip is narrower than this share of the crease that it lies beside."""
JOINED_AT = 0.5
"""Sleeves are joined to the sheet at this share of the target's drive."""
LATE, NARROW = 1 - 1e-3, 1e-4
"""In this last part of the way to shut creases panels are near: as for the sheet, a contact there
counts with this share of the tolerance only."""
THINNER = (0.75, 0.5, 0.25)
"""Panels that are offered are so much thinner."""
SMALLEST, FINE = 0.1, 0.02
"""The smallest share of the largest that "auto" tries, and to which share it is found."""


def with_boxes(
    design: Design,
    lock: Lock,
    asked: Stiffeners | None,
    tolerance: float,
    *,
    examined: bool = True,
    progress: Progress = no_progress,
) -> tuple[Design, Lock]:
    """The design with the box girders that are asked for, and how its motion ends then.

    lock: How the motion of the sheet ends, with its boards.
    tolerance: Distance at which panels touch, relative to the flat sheet's diagonal.
    examined: Whether contact is looked for.

    Raises InputError if there are no such rows, or panels are whole boards.
    Raises DesignError if there is no room for them.
    """
    if asked is None or asked.kind != "boxes":
        return design, lock
    place = BoxPlace(design, lock, asked, tolerance, examined=examined)
    narrow = place.narrowest()
    most = narrow.largest(NARROWEST)
    if asked.share == "auto":
        share = place.widest(LARGEST, progress)
    elif asked.share > most:
        raise DesignError(
            "strips of box girders would be narrower than they may be, as columns run together",
            place=f"at row {narrow.row}",
            keys=("stiffeners.share",),
            size=f"shares up to {most:.4g} leave {NARROWEST:g} of the width of a crease",
            candidates=[
                Remedy({"stiffeners.share": each}) for each in (rounded_down(most), "auto")
            ],
            excess=asked.share / most - 1,
        )
    else:
        share = asked.share
    boxes, motion = place.moved(share, progress)
    if motion.joined_from >= design.mechanism.target_drive:
        raise place.refused(share, progress)
    if motion.closing is not None:
        lock = replace(
            lock,
            drive=motion.closing.drive,
            cause="unproved" if motion.closing.apart is not None else "clash",
            first_contact=motion.closing,
        )
    elif motion.closes_to < lock.closes_to:
        lock = replace(lock, drive=motion.closes_to, cause="boards", first_contact=None)
    return replace(design, boxes=boxes), replace(lock, boxes=motion)


class BoxPlace:
    """A sheet whose rows are closed to box girders."""

    def __init__(
        self,
        design: Design,
        lock: Lock,
        asked: Stiffeners,
        tolerance: float,
        *,
        examined: bool = True,
    ) -> None:
        self.design, self.lock, self.examined = design, lock, examined
        self.asked = asked
        mechanism = design.mechanism
        self.columns = box_columns(design)
        require_convex(mechanism, "box girders")
        self.rows = fold_rows(mechanism, asked.rows, self.columns, "box girder")
        require_one_side(design, self.rows, self.columns)
        self.forms = [SleeveForms.of(mechanism, row, self.columns) for row in self.rows]
        self.tolerance = tolerance * diagonal(mechanism.positions(0.0))
        self.start = JOINED_AT * mechanism.target_drive

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

    def _tried(self, share: float, progress: Progress) -> BoxMotion | None:
        """How far the shell moves with sleeves of a share; None if nothing is left of a panel."""
        try:
            return self.moved(share, progress)[1]
        except DesignError:
            return None

    def moved(self, share: float, progress: Progress) -> tuple[tuple[Box, ...], BoxMotion]:
        """Sleeves of a share with their boards, and how far the shell moves with them.

        Raises DesignError if nothing is left of a panel.
        """
        sleeves, lock = self.sleeves(share), self.lock
        target, end = lock.target_drive, lock.closes_to
        boxes, end, within = self._built(sleeves, end, progress)
        whole = Complex(self.design.mechanism, tuple(sleeves)).least_turning
        bodies = self._bodies(whole, boxes)

        def path(stop: float, tolerance: float) -> PathResult:
            if bodies is None:
                return find_first_contact(
                    whole, stop, tolerance, only=whole.part_of > 0, start=target, progress=progress
                )
            return find_first_contact_of_parts(whole, (target, stop), tolerance, bodies, progress)

        proofs = []
        found: list[Contact | None] = []
        for stop in (self.start, end):
            if stop == target or not self.examined:
                found.append(None)
                continue
            result = path(stop, self.tolerance)
            shut = stop >= LATE * whole.end_drive
            if shut and result.contact is not None and result.contact.drive > LATE * stop:
                result = path(stop * (1 - SHORT_OF_END), NARROW * self.tolerance)
            proofs.append(result.proof)
            met = result.contact
            found.append(None if met is None else self._contact(met, whole, boxes))
        opening, closing = found
        if self.examined and (opening is None or opening.drive < target):
            opening = self._at_flaps(boxes) or opening
        joined = self.start if opening is None else opening.clear_until
        boxes = tuple(replace(box, joined_from=joined) for box in boxes)
        shares = tuple(each.share for each in sleeves)
        return boxes, BoxMotion(
            tuple(self.rows), shares, joined, end, opening, closing or within, tuple(proofs)
        )

    def _built(
        self, sleeves: Sequence[Sleeve], end: float, progress: Progress
    ) -> tuple[tuple[Box, ...], float, Contact | None]:
        """Sleeves with their boards, and as far as boards of each do not meet each other."""
        build = self.design.panel
        if build is None:
            return tuple(Box(each) for each in sleeves), end, None
        boxes, first = [], None
        end = min(closes_to(each, self.start, end, build) for each in sleeves)
        if end < self.lock.target_drive:
            thinner = [rounded_down(each * build.thickness, 2) for each in THINNER]
            raise DesignError(
                "boards of box girders would stand so far off the panels that they hang on that "
                "too little is left of them",
                place="at the target",
                keys=("stiffeners.share", "panel.thickness"),
                candidates=[Remedy({"panel.thickness": thickness}) for thickness in thinner],
            )
        for sleeve in sleeves:
            alone = sleeve_design(self.design, sleeve, self.start, end)
            if not self.examined:
                boxes.append(Box(sleeve, build_panels(alone, end).boards))
                continue
            built, path = prove_boards(alone, end, self.tolerance, progress)
            box = Box(sleeve, built.boards)
            boxes.append(box)
            if path.contact is not None and (first is None or path.contact.drive < first.drive):
                one, other = (called(box)[panel] for panel in path.contact.panels)
                first = self._met(path.contact, (one, other))
        return tuple(boxes), end if first is None else min(end, first.clear_until), first

    def _bodies(self, whole: Complex, boxes: Sequence[Box]) -> Bodies | None:
        """All boards on the panels of the complex; None if panels have no thickness."""
        built = self.lock.built
        if built is None:
            return None
        every = moving_boards(built.boards, whole, boxes)
        return Bodies(every, whole.layout.faces, points_of(whole, 0.0))

    def _at_flaps(self, boxes: Sequence[Box]) -> Contact | None:
        """What flaps that are clipped on meet at the target; None if nothing."""
        met = flap_contact(self.design, self.lock.built, boxes, self.tolerance)
        if met is None:
            return None
        target = self.lock.target_drive
        return self._met(PathContact(target, target, (0, 0)), met)

    def _contact(self, found: PathContact, whole: Complex, boxes: Sequence[Box]) -> Contact:
        """What meets, of the sheet and its sleeves."""
        panels = whole.layout.names[: whole.grid.panel_count].tolist()
        every = [(f"panel {[row, column]}", (row, column)) for row, column in panels]
        every += [each for box in boxes for each in called(box)]
        first, second = sorted(found.panels)
        return self._met(found, (every[first], every[second]))

    def _met(self, found: PathContact, both: tuple[Called, Called]) -> Contact:
        (name, panel), (other, beside) = both
        return Contact(
            found.drive,
            found.clear_until,
            (panel, beside),
            "boards" if self.design.panel is not None else "distant panels",
            corrugation_depth(self.design.mechanism.positions(found.drive)),
            apart=found.apart,
            called=(name, other),
        )

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
        met, target = motion.opening or motion.closing, self.lock.target_drive
        assert met is not None
        first, second = met.names
        return DesignError(
            f"{first} and {second} meet",
            place=f"at drive {in_degrees(met.drive)} of {in_degrees(target)} degrees",
            keys=("stiffeners.share", "stiffeners.rows"),
            candidates=self._others(),
            excess=1.0,
        )
