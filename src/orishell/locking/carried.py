"""How far a sheet moves with strips that it carries, proved from its target to both sides.

From a state on the way to the target, where they are joined to the sheet, to as far as the sheet
closes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from orishell.clash import PathContact, PathResult, find_first_contact
from orishell.clash.bodies import Bodies
from orishell.clash.complex_path import find_first_contact_of_parts
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.formatting import in_degrees, rounded_down
from orishell.conventions.progress import Progress
from orishell.design import Design
from orishell.design.carried import CarriedPart
from orishell.locking.boards import prove_boards
from orishell.locking.carried_flaps import Called, called, flap_contact
from orishell.locking.result import CarriedMotion, Contact, Lock
from orishell.locking.sheet import SHORT_OF_END
from orishell.motion import corrugation_depth, diagonal
from orishell.motion.as_made import panels_laid_flat
from orishell.motion.complex import Complex
from orishell.solids import build_panels
from orishell.solids.carried import carried_design, closes_to, moving_boards

JOINED_AT = 0.5
"""Strips are joined to the sheet at this share of the target's drive."""
LATE, NARROW = 1 - 1e-3, 1e-4
"""In this last part of the way to shut creases panels are near: as for the sheet, a contact there
counts with this share of the tolerance only."""
THINNER = (0.75, 0.5, 0.25)
"""Panels that are offered are so much thinner."""


class CarriedPath:
    """A sheet, and the way over which it is asked to carry strips.

    what: What its strips are, in words.
    key: What asks how large they are.
    """

    def __init__(
        self,
        design: Design,
        lock: Lock,
        tolerance: float,
        *,
        examined: bool,
        what: str,
        key: str,
    ) -> None:
        self.design, self.lock, self.examined = design, lock, examined
        self.what, self.key = what, key
        self.tolerance = tolerance * diagonal(design.mechanism.positions(0.0))
        self.start = JOINED_AT * design.mechanism.target_drive

    def moved(
        self, parts: Sequence[CarriedPart], progress: Progress
    ) -> tuple[tuple[CarriedPart, ...], CarriedMotion]:
        """Parts with their boards, and how far the shell moves with them.

        Raises DesignError if nothing is left of a panel.
        """
        lock = self.lock
        target, end = lock.target_drive, lock.closes_to
        carried, end, within = self._built(parts, end, progress)
        strips = tuple(each.strips for each in carried)
        made = Complex(self.design.mechanism, strips)
        bodies, whole = self._bodies(made, carried), made.least_turning

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
            found.append(None if met is None else self._contact(met, whole, carried))
        opening, closing = found
        if self.examined and (opening is None or opening.drive < target):
            opening = self._at_flaps(carried) or opening
        joined = self.start if opening is None else opening.clear_until
        carried = tuple(replace(each, joined_from=joined) for each in carried)
        return carried, CarriedMotion(joined, end, opening, closing or within, tuple(proofs))

    def _built(
        self, parts: Sequence[CarriedPart], end: float, progress: Progress
    ) -> tuple[tuple[CarriedPart, ...], float, Contact | None]:
        """Parts with their boards, and as far as boards of each do not meet each other."""
        build = self.design.panel
        if build is None:
            return tuple(parts), end, None
        made, first = [], None
        end = min(closes_to(each.strips, self.start, end, build) for each in parts)
        if end < self.lock.target_drive:
            thinner = [rounded_down(each * build.thickness, 2) for each in THINNER]
            raise DesignError(
                f"boards of {self.what} would stand so far off the panels that they hang on, or "
                "back from creases, that too little is left of them",
                place="at the target",
                keys=(self.key, "panel.thickness"),
                candidates=[Remedy({"panel.thickness": thickness}) for thickness in thinner],
            )
        for part in parts:
            alone = carried_design(self.design, part.strips, self.start, end)
            if not self.examined:
                made.append(replace(part, boards=build_panels(alone, end).boards))
                continue
            built, path = prove_boards(alone, end, self.tolerance, progress)
            made.append(replace(part, boards=built.boards))
            if path.contact is not None and (first is None or path.contact.drive < first.drive):
                one, other = (called(part)[panel] for panel in path.contact.panels)
                first = self._met(path.contact, (one, other))
        return tuple(made), end if first is None else min(end, first.clear_until), first

    def _bodies(self, whole: Complex, carried: Sequence[CarriedPart]) -> Bodies | None:
        """All boards on the panels of the complex, drawn flat; None if they have no thickness."""
        built = self.lock.built
        if built is None:
            return None
        every = moving_boards(built.boards, whole, carried)
        return Bodies(every, whole.layout.faces, panels_laid_flat(whole))

    def _at_flaps(self, carried: Sequence[CarriedPart]) -> Contact | None:
        """What flaps that are clipped on meet at the target; None if nothing."""
        met = flap_contact(self.design, self.lock.built, carried, self.tolerance)
        if met is None:
            return None
        target = self.lock.target_drive
        return self._met(PathContact(target, target, (0, 0)), met)

    def _contact(
        self, found: PathContact, whole: Complex, carried: Sequence[CarriedPart]
    ) -> Contact:
        """What meets, of the sheet and what it carries."""
        panels = whole.layout.names[: whole.grid.panel_count].tolist()
        every = [(f"panel {[row, column]}", (row, column)) for row, column in panels]
        every += [each for part in carried for each in called(part)]
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

    def refusal(
        self, motion: CarriedMotion, keys: tuple[str, ...], others: list[Remedy]
    ) -> DesignError:
        """Why there is no room for what it would carry at the target.

        keys: What asks for it.
        others: What may be free.
        """
        met = motion.opening or motion.closing
        assert met is not None
        first, second = met.names
        met_target = self.lock.target_drive
        return DesignError(
            f"{first} and {second} meet",
            place=f"at drive {in_degrees(met.drive)} of {in_degrees(met_target)} degrees",
            keys=keys,
            candidates=others,
            excess=1.0,
        )

    def ended(self, motion: CarriedMotion) -> Lock:
        """How the motion of the sheet ends with what it carries."""
        lock = self.lock
        if motion.closing is not None:
            return replace(
                lock,
                drive=motion.closing.drive,
                cause="unproved" if motion.closing.apart is not None else "clash",
                first_contact=motion.closing,
            )
        if motion.closes_to < lock.closes_to:
            return replace(lock, drive=motion.closes_to, cause="boards", first_contact=None)
        return lock
