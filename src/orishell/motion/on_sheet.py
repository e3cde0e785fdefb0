"""What folds with a sheet: some rows of it, strips that it carries, the sheet with all of these."""

from __future__ import annotations

from dataclasses import replace
from typing import Self, cast

from orishell.conventions.record import record
from orishell.motion.mechanism import Mechanism, mechanism_in_one_line


@record
class OnSheet:
    """A mechanism with the drives of a sheet, and its columns if nothing else is said."""

    sheet: Mechanism

    def __repr__(self) -> str:
        return mechanism_in_one_line(cast("Mechanism", self))  # as what inherits from it is

    def on(self, sheet: Mechanism) -> Self:
        """It on a sheet of the same panels, which stands or ends otherwise."""
        return replace(self, sheet=sheet)

    @property
    def inner_columns(self) -> slice:
        """Those of the sheet."""
        return self.sheet.inner_columns

    @property
    def flap_columns(self) -> tuple[int, ...]:
        """Those of the sheet."""
        return self.sheet.flap_columns

    def without_flaps(self) -> Self:
        """Itself: it has none of its own."""
        return self

    def with_stop(self, stop: float) -> Self:
        """Itself: it has no flaps of its own."""
        return self

    @property
    def least_turning(self) -> Self:
        """It on the sheet that turns as little as possible."""
        return self.on(self.sheet.least_turning)

    @property
    def target_drive(self) -> float:
        """That of the sheet."""
        return self.sheet.target_drive

    @property
    def end_drive(self) -> float:
        """That of the sheet."""
        return self.sheet.end_drive
