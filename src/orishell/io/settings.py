"""Settings for the files that are written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from orishell.document import FLAT, SHELL
from orishell.workshop import DEFAULT, Workshop


@dataclass(frozen=True, slots=True)
class Settings:
    """The state that is shown and the workshop's settings, for all formats.

    Parameters
    ----------
    state
        The state that formats with one state show, by name or number.
    print_state
        The state in which solids are printed, by name or number.
    workshop
        How the flat sheet is drawn and cut.
    """

    state: int | str = SHELL
    print_state: int | str = FLAT
    workshop: Workshop = DEFAULT

    @classmethod
    def showing(cls, state: int | str | None, workshop: Workshop = DEFAULT) -> Self:
        """Settings with one state for all formats; None for the one that each shows by itself."""
        if state is None:
            return cls(workshop=workshop)
        return cls(state, state, workshop)


DEFAULT_SETTINGS = Settings()
