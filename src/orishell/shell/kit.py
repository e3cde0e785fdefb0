"""A kit: what a builder needs of a shell, in folders by trade, or of a card model of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from fnmatch import fnmatchcase
from pathlib import Path
from shutil import move
from typing import Final

from orishell.conventions.arguments import path_of
from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, followed, no_progress, stretch
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.design_file import DesignFile
from orishell.document import Document
from orishell.document.from_design import states_of
from orishell.io import OutputDirectory
from orishell.io.booklet_pages import BookletPage, booklet_pages
from orishell.io.format import Settings
from orishell.io.formats import find_formats
from orishell.io.formats.booklet import FORMAT as BOOKLET
from orishell.io.manifest import read_manifest
from orishell.io.output import replacing_all
from orishell.shell.export import require_shell, write_document
from orishell.shell.make import Shell
from orishell.workshop import Workshop
from orishell.workshop.kit.card_model import make_card_model, narrowest_panel
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.steps import carried
from orishell.workshop.kit.words import load_words

FORMATS: Final = ("dxf", "pdf", "csv", "booklet")
"""What a kit is written in."""
CARD: Final = ("dxf", "pdf", "booklet")
"""What the kit of a card model is written in."""
MANIFEST: Final = ".orishell-kit.json"
"""The list of a kit's files in each of its folders."""
README: Final = "README.md"
ORDER: Final = "order.csv"
LEFT_OUT: Final = None
WRITING, STATES = "writing the kit", 0.1
"""What its progress is called, and the share of it that states take."""
SHEET: Final = ("", "sandwich")
"""Constructions whose pattern is a sheet that is cut; of others it is a plan of assembly."""

FOLDERS: Final[tuple[tuple[str, str | None], ...]] = (
    ("pattern-boards-*", "cut"),
    ("pattern-panels*", "cut"),
    ("pattern-gussets*", "cut"),
    ("pattern-top.*", "cut"),
    ("pattern-bottom.*", "cut"),
    ("pattern-arms.*", "cut"),
    ("boards.csv", "cut"),
    ("arms.csv", "cut"),
    ("pattern*", "fabric"),
    ("creases.csv", "hinges"),
    ("schedule.csv", "hinges"),
    ("hinges.csv", "hinges"),
    ("joints.csv", "hinges"),
    ("lines.csv", "hinges"),
    ("ties.csv", "ground"),
    ("ground*", "ground"),
    ("booklet*.pdf", "booklet"),
    (ORDER, ""),
    ("panels.csv", LEFT_OUT),
)
"""Which files go to which folder, the first row that fits; the kit's own is ""."""
PLAN: Final = ("pattern.*", "hinges")
"""Where the plan of assembly goes, if panels are solid."""
TRADES: Final = {
    "": "what to order",
    "cut": "boards and arms, to be cut",
    "fabric": "the sheet or membrane, to be cut and creased",
    "hinges": "creases, hinges and joints, and where they are",
    "ground": "ties and feet",
    "booklet": "parts, tools and steps",
}
"""What is in each folder."""


@record
class Kit:
    """A kit that was written."""

    files: tuple[Path, ...]  # where they are now
    scale: float  # size of the model relative to the shell; 1 for the shell itself
    unused: tuple[str, ...] = ()  # keys of the design file that nothing has asked for
    narrowest: float | None = None  # how narrow a panel of a card model is (mm); else None


def folder_of(name: str, construction: str) -> str | None:
    """The folder that a file goes to, "" for the kit's own; None if it is no part of a kit.

    Parameters
    ----------
    name
        The name of the file.
    construction
        As in ``[panel]``; empty where panels have no thickness.

    Raises
    ------
    KeyError
        If no row of :data:`FOLDERS` names it.
    """
    rows = FOLDERS if construction in SHEET else (PLAN, *FOLDERS)
    for pattern, folder in rows:
        if fnmatchcase(name, pattern):
            return folder
    raise KeyError(name)


def write_kit(
    shell: Shell,
    directory: str | Path,
    *,
    paper: bool = False,
    progress: Progress = no_progress,
    force: bool = False,
) -> Kit:
    """Write the kit of a shell: drawings, tables, booklet, and ``README.md``.

    Parameters
    ----------
    directory
        Where to; made if needed. Files of an earlier kit that this one does not write are removed
        from its folders; all others stay. Files are moved there when all are whole, or none is.
    paper
        Whether it is the kit of a card model: at ``paper_scale``, or the largest scale at which the
        sheet fits a page of ``paper``.
    force
        Whether files that are not of an earlier kit, or were changed, may be written over; what the
        design was read from never is.

    Raises
    ------
    InputError
        If the directory cannot be written to, a file is in the way there, or a setting does not fit
        the sheet.
    """
    directory = path_of(directory, "write_kit: directory")
    require_shell(shell)
    require_kit_place(shell.file, directory, paper=paper, force=force)
    keys, workshop = shell.file.keys, shell.file.workshop
    if paper:  # what the shell itself has asked for is not for the model
        keys = keys.forgetting("workshop")
        workshop = workshop.noting(keys.asked)
    begun = stretch(progress, 0.0, STATES)
    document, workshop, scale = _subject(shell, workshop, paper, begun, WRITING)
    construction = document.panel.construction if document.panel else ""
    settings = Settings(workshop=workshop, ground=not paper)
    with OutputDirectory(directory).drafting() as made:
        formats, told = find_formats(CARD if paper else FORMATS), stretch(progress, STATES, 1.0)
        for format_ in followed(formats, len(formats), told, WRITING):
            path = made / format_.file
            write_document(format_, path, document, settings, str(shell.file.path))
        folders: dict[str, list[Path]] = {}
        for file in sorted(made.iterdir()):
            folder = folder_of(file.name, construction)
            if folder is not LEFT_OUT:
                folders.setdefault(folder, []).append(file)
        readme = made / README
        readme.write_text("\n".join(_readme(document, workshop, folders)) + "\n", encoding="utf-8")
        folders.setdefault("", []).append(readme)
        written = tuple(_put(folders, _places(shell.file, directory, force=force)))
    narrowest = narrowest_panel(document) if paper else None
    return Kit(written, scale, keys.unused(beside=("search",)), narrowest)


def booklet_of_kit(
    shell: Shell, *, paper: bool = False, progress: Progress = no_progress
) -> tuple[BookletPage, ...]:
    """The pages of the booklet in the kit that :func:`write_kit` writes.

    Parameters
    ----------
    paper
        Whether it is the kit of a card model.

    Raises
    ------
    InputError
        If a setting does not fit the sheet.
    """
    told = (progress, "drawing the booklet")
    document, workshop, _ = _subject(shell, shell.file.workshop, paper, *told)
    return booklet_pages(document, workshop, ground=not paper)


def _subject(
    shell: Shell, workshop: Workshop, paper: bool, progress: Progress, what: str
) -> tuple[Document, Workshop, float]:
    """What a kit is of: the shell, or a card model of it; and its size relative to the shell.

    Its states are made for ``what`` the progress is told.
    """
    require_shell(shell)
    document = replace(shell.document, states=states_of(shell.motion, progress, what))
    if not paper:
        return document, workshop, 1.0
    try:
        model = make_card_model(document, workshop)
    except InputError as error:
        raise error.located(f"{shell.file.path}:") from None
    return model.document, model.workshop, model.scale


def require_kit_place(
    file: DesignFile, directory: Path, *, paper: bool = False, force: bool = False
) -> None:
    """Refuse, before any work is done, a directory that a kit cannot be written to.

    Raises
    ------
    InputError
        If it or one of its folders is a file or cannot be written to, or a file is in the way.
    """
    sure = {"": [README] if paper else [README, ORDER], "booklet": [BOOKLET.file]}
    for folder, place in _places(file, directory, force=force).items():
        place.require_usable(sure.get(folder, ()), replacing=True)


def _places(file: DesignFile, directory: Path, *, force: bool) -> dict[str, OutputDirectory]:
    """The kit's own folder and those in it, by their names in :data:`TRADES`.

    What other commands wrote there is not the kit's to remove.
    """
    return {
        folder: OutputDirectory(directory / folder, MANIFEST, inputs=file.inputs, force=force)
        for folder in sorted(TRADES)
    }


def _put(folders: dict[str, list[Path]], everywhere: dict[str, OutputDirectory]) -> Iterator[Path]:
    """Put files into their folders; those of an earlier kit go, and folders that are then empty."""
    places = {
        folder: place
        for folder, place in everywhere.items()
        if folder in folders or read_manifest(place.path, MANIFEST) is not None
    }
    with replacing_all(places.values()) as drafts:
        for folder, draft in zip(places, drafts, strict=True):
            for file in folders.get(folder, []):
                move(file, draft / file.name)
    for folder, place in places.items():
        if folder not in folders:
            place.remove_list()
        yield from (place.path / file.name for file in folders.get(folder, []))


def _readme(
    document: Document, workshop: Workshop, folders: dict[str, list[Path]]
) -> Iterator[str]:
    """What is where, with counts and sizes."""
    document = document.as_cut()
    facts, unit = find_facts(document), document.unit
    words = load_words("en")
    yield f"# {document.title}"
    yield ""
    if document.model_scale is not None:
        yield f"A card model, 1:{plain(1 / document.model_scale)}. All sizes are the model's."
    else:
        yield "DXF files are 1:1 in the unit that they declare, PDF files as each says."
    yield ""
    yield f"- Opened: {facts.opened_in_words(unit)}"
    yield from (f"- {line}" for line in carried(facts, unit, words))
    if facts.freedoms is not None:
        kind, count = facts.freedoms
        yield f"- Motion: {words.say(f'more.several_{kind}', freedoms=count)}"
    yield ""
    yield "| part | count |"
    yield "|---|---|"
    for part in kit_parts(document, workshop, facts):
        yield f"| {words.say(f'parts.{part.name}').lower()} | {part.count} |"
    yield ""
    yield "| folder | what is in it | files |"
    yield "|---|---|---|"
    for folder, what in TRADES.items():
        files = folders.get(folder, [])
        if files:
            names = _named(file.name for file in files)
            yield f"| {folder + '/' if folder else 'here'} | {what} | {names} |"


def _named(names: Iterable[str]) -> str:
    """Names of files, those that are numbered once with their numbers."""
    groups: dict[str, list[int]] = {}
    for name in names:
        stem, dot, ending = name.rpartition(".")
        head, _, number = stem.rpartition("-")
        if number.isdecimal():
            groups.setdefault(f"{head}-N{dot}{ending}", []).append(int(number))
        else:
            groups[name] = []
    return ", ".join(
        f"{group} (N = {min(each)} to {max(each)})"
        if len(each) > 1
        else group.replace("-N.", f"-{each[0]}.")
        if each
        else group
        for group, each in groups.items()
    )
