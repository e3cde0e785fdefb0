"""What each family makes of a target, where the design file leaves the family open."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import Row


@record
class FamilyTrial:
    """What a family makes of the target."""

    family: str
    # the largest distance between shell and surface, both ways (length); None if there is no shell
    distance: float | None = None
    panels: int | None = None  # number of panels
    sheet_area: float | None = None  # area of its flat sheet, or of all of its strips
    packs_flat: bool | None = None  # whether its motion ends with all panels in one plane
    # whether anything in it stops it closing at the target, in all of its motions
    locks: bool | None = None
    # how many motions its sheet has; None if that is not known, or there is no shell
    degrees_of_freedom: int | None = None
    why_not: str = ""  # why there is no shell
    in_strips: bool = False  # whether it is no one sheet, but made in strips that are joined

    def in_words(self, unit: str) -> str:
        """The line of a table."""
        if self.distance is None or self.panels is None or self.sheet_area is None:
            return f"{self.family}: none; {self.why_not}"
        return (
            f"{self.family}: within {plain(self.distance)} {unit}, {self.panels} panels, "
            f"{plain(self.sheet_area)} {unit}2 of {'strips' if self.in_strips else 'sheet'}, "
            f"{'packs flat' if self.packs_flat else 'does not pack flat'}, "
            f"{'locks' if self.locks else 'does not lock'}{self._motions()}"
        )

    def _motions(self) -> str:
        count = self.degrees_of_freedom
        if count == 1:
            return ""
        return f", {'an unknown number of' if count is None else count} degrees of freedom"


@record
class FamilyChoice:
    """The families that were tried, and the one that was taken."""

    family: str  # that was taken
    rule: str  # by which it was taken
    tried: tuple[FamilyTrial, ...]

    def rows(self, unit: str) -> Iterator[Row]:
        """A row of the verdict for each family."""
        for each in self.tried:
            yield Row("says", "family", each.in_words(unit) + self._taken(each))

    def _taken(self, trial: FamilyTrial) -> str:
        """Why a family was taken, or why not although it is the nearest."""
        if trial.family == self.family:
            if trial.in_strips:
                return " (taken: no one sheet makes a shell)"
            return " (taken: nearest that locks)" if trial.locks else " (taken: none locks)"
        made = [each.distance for each in self.tried if each.distance is not None]
        if trial.in_strips and trial.distance is not None and trial.distance == min(made):
            return f" (nearest, but made in strips: family {trial.family} takes it)"
        return ""
