"""Files as the page hands them over, and the booklet of a kit as it shows that before."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress
from orishell.document.from_design import states_of
from orishell.io import Settings
from orishell.io.booklet_pages import booklet_pages
from orishell.io.booklet_svg import dump_page
from orishell.io.format import Format
from orishell.io.formats import find_formats
from orishell.io.output import scratch
from orishell.shell.export import write_format
from orishell.shell.kit import booklet_of_kit, write_kit
from orishell.shell.make import Shell
from orishell.studio.api import Booklet
from orishell.studio.pages import file_name, zipped

KITS: Final = {"kit": False, "card": True}
"""Archives of kits by their names, and whether each is that of a card model."""


def preview_booklet(shell: Shell, kit: str, progress: Progress) -> Booklet:
    """The pages of the booklet in a kit, or of the one that is written alone, as pictures.

    Raises InputError if a setting does not fit the sheet.
    """
    if kit in KITS:
        pages = booklet_of_kit(shell, paper=KITS[kit], progress=progress)
    else:
        states = states_of(shell.motion, progress, "drawing the booklet")
        document = replace(shell.document, states=states)
        pages = booklet_pages(document, shell.file.workshop, ground=False)
    return {"pages": [{"title": page.said[0].words, "svg": dump_page(page)} for page in pages]}


def require_exported(payload: Mapping[str, Any]) -> None:
    """Refuse a format, or a state of its files, that there is not, before a shell is proved.

    Raises InputError.
    """
    name, state = str(payload.get("format")), payload.get("state")
    if name not in KITS and len(find_formats([name])) != 1:
        raise InputError("exactly one format must be named", where="format", got=repr(name))
    if state is not None and (not isinstance(state, int | str) or isinstance(state, bool)):
        raise InputError("there is no such state", where="state", got=repr(state))


def export_shell(
    shell: Shell, payload: Mapping[str, Any], name: str, progress: Progress
) -> tuple[str, bytes]:
    """Name and bytes of a shell in one format or as a kit: a file, or a zip archive of several.

    Files are called ``name``. Raises InputError if a setting does not fit the sheet.
    """
    asked = str(payload["format"])
    with scratch() as place:
        if asked in KITS:
            kit = write_kit(shell, place, paper=KITS[asked], progress=progress)
            files = {file.relative_to(place).as_posix(): file for file in kit.files}
            return f"{name}-{asked}.zip", zipped(files)
        (format_,) = find_formats([asked])
        return _exported(shell, format_, place, payload.get("state"), name)


def _exported(
    shell: Shell, format_: Format, place: Path, state: int | str | None, name: str
) -> tuple[str, bytes]:
    paths = write_format(shell, format_, place, Settings.showing(state, shell.file.workshop))
    if len(paths) == 1:
        return file_name(paths[0].name, name), paths[0].read_bytes()
    # Drawings have the design's name; other files may name each other.
    names = [
        file_name(path.name, name) if path.stem.startswith("pattern") else path.name
        for path in paths
    ]
    return f"{name}-{format_.name}.zip", zipped(dict(zip(names, paths, strict=True)))
