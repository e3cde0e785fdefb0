"""The entry of a file format, and the settings for files that are written."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Self
from uuid import UUID

from orishell.conventions.errors import InputError
from orishell.document import FLAT, SHELL, Document
from orishell.workshop import DEFAULT, Workshop


@dataclass(frozen=True, slots=True)
class Settings:
    """The state that is shown and the workshop's settings, for all formats."""

    state: int | str = SHELL  # the state that formats with one state show, by name or number
    print_state: int | str = FLAT  # the state in which solids are printed, by name or number
    workshop: Workshop = DEFAULT  # how the flat sheet is drawn and cut
    ground: bool = False  # whether drawings have the plan of the ground beside them

    @classmethod
    def showing(cls, state: int | str | None, workshop: Workshop = DEFAULT) -> Self:
        """Settings with one state for all formats; None for the one that each shows by itself."""
        if state is None:
            return cls(workshop=workshop)
        return cls(state, state, workshop)


DEFAULT_SETTINGS = Settings()
_FIRST_ID = UUID("6f1c2c1e-3d55-8c7e-9c38-0e1a00000000")


def numbered_ids() -> Iterator[UUID]:
    """Ids by their order, for libraries that would make random ones."""
    return (UUID(int=_FIRST_ID.int + number) for number in count(1))


def plain_line(text: str) -> str:
    """A line of text with a blank for every control character.

    Parameters
    ----------
    text
        The line.
    """
    return "".join(each if each.isprintable() else " " for each in text)


@dataclass(frozen=True, slots=True)
class Format:
    """A format in which a document can be written."""

    name: str  # what the command line calls it
    file: str  # the file that is written for a designed shell; others may be written beside it
    endings: tuple[str, ...]  # endings of file names that mean this format
    what: str  # what is in it, in a few words
    # writes a document to a path, and what belongs to it beside the path; refuses a document that
    # lacks what it shows: a state of that name, a flat sheet, boards, a unit
    write: Callable[[Path, Document, Settings], None]
    # whether it shows the surface that the shell follows, if the document has it
    lays_surface: bool = False
    ready: Callable[[], bool] = lambda: True  # whether what it needs is there
    # what is not there otherwise, in a sentence, and what to do
    missing: str = ""
    remedy: str = ""
    solid: bool = False  # whether it shows nothing but boards, so that panels must have a thickness
    # whether it shows the shell as a structure, so that it must have been analysed
    analysed: bool = False
    # whether it says what is known of a designed shell only: ties, pack, feet
    designed: bool = False
    # whether strips of a sheet that is no flat one are joined in it, as they fold; else they are as
    # they are cut
    joined: bool = False
    # what one writes it for: "cut", "paper", "kit", "cad" or "analysis"; empty for none of these
    task: str = ""

    def fits(self, document: Document) -> bool:
        """Whether a document has what it shows."""
        lacking_boards = self.solid and document.boards is None
        lacking_analysis = self.analysed and document.loaded is None
        lacking_design = self.designed and not document.report
        return not (lacking_boards or lacking_analysis or lacking_design)

    @property
    def fits_all(self) -> bool:
        """Whether every document has what it shows."""
        return not (self.solid or self.analysed or self.designed)

    def require_ready(self) -> None:
        """Refuse to go on where what it needs is missing.

        Raises
        ------
        InputError
            If it is.
        """
        if not self.ready():
            raise InputError(self.missing, remedy=self.remedy)
