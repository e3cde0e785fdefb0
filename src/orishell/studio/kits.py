"""The kit as the page shows it before it is written, and as it hands it over: in one archive."""

from __future__ import annotations

import tempfile
from typing import Final

from orishell.conventions.progress import Progress
from orishell.io.booklet_svg import dump_page
from orishell.shell.kit import booklet_of_kit, write_kit
from orishell.shell.make import Shell
from orishell.studio.api import Booklet
from orishell.studio.pages import zipped

KITS: Final = {"kit": False, "card": True}
"""Archives by their names, and whether each is that of a card model."""


def preview_booklet(shell: Shell, *, paper: bool, progress: Progress) -> Booklet:
    """The pages of the booklet in a kit, as pictures.

    Raises InputError if a setting does not fit the sheet.
    """
    pages = booklet_of_kit(shell, paper=paper, progress=progress)
    return {"pages": [{"title": page.said[0].words, "svg": dump_page(page)} for page in pages]}


def pack_kit(shell: Shell, *, paper: bool, progress: Progress) -> bytes:
    """All files of a kit in their folders, as a zip archive.

    Raises InputError if a setting does not fit the sheet.
    """
    with tempfile.TemporaryDirectory(prefix="orishell-") as directory:
        kit = write_kit(shell, directory, paper=paper, progress=progress)
        return zipped({file.relative_to(directory).as_posix(): file for file in kit.files})
