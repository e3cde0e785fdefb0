"""The entry of a file format, and the settings for files that are written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from orishell.conventions.errors import InputError
from orishell.document import FLAT, SHELL, Document
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


@dataclass(frozen=True, slots=True)
class Format:
    """A format in which a document can be written.

    Parameters
    ----------
    name
        What the command line calls it.
    file
        The file that is written for a designed shell; others may be written beside it.
    endings
        Endings of file names that mean this format.
    what
        What is in it, in a few words.
    write
        Writes a document to a path, and whatever belongs to it beside the path.
    lays_surface
        Whether it shows the surface that the shell follows, if the document has it.
    ready
        Whether what it needs is there.
    missing, remedy
        What is not there otherwise, in a sentence, and what to do.
    solid
        Whether it shows nothing but boards, so that panels must have a thickness.
    analysed
        Whether it shows the shell as a structure, so that it must have been analysed.
    """

    name: str
    file: str
    endings: tuple[str, ...]
    what: str
    write: Callable[[Path, Document, Settings], None]
    lays_surface: bool = False
    ready: Callable[[], bool] = lambda: True
    missing: str = ""
    remedy: str = ""
    solid: bool = False
    analysed: bool = False

    def fits(self, document: Document) -> bool:
        """Whether a document has what it shows."""
        lacking_boards = self.solid and document.boards is None
        lacking_analysis = self.analysed and document.loaded is None
        return not (lacking_boards or lacking_analysis)

    def require_ready(self) -> None:
        """Refuse to go on where what it needs is missing.

        Raises
        ------
        InputError
            If it is.
        """
        if not self.ready():
            raise InputError(self.missing, remedy=self.remedy)
