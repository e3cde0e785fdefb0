"""From a designed shell, or a FOLD file, to files in any format."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from pathlib import Path
from typing import Final

from orishell.conventions.arguments import checked, path_of
from orishell.conventions.errors import InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.conventions.quantities import Unit
from orishell.conventions.record import as_table
from orishell.design import Design
from orishell.document import Document
from orishell.document.from_design import states_of
from orishell.io import OutputDirectory, document_of_fold, read_fold
from orishell.io.format import DEFAULT_SETTINGS, Format, Settings
from orishell.io.formats import find_formats, format_of
from orishell.io.formats.fold import FORMAT as FOLD
from orishell.shell.make import Shell
from orishell.shell.pictures import draw_pictures, lay_surface
from orishell.shell.steps import Clock
from orishell.structure.pages.files import write_structure_files

ALWAYS: Final = ("shell.fold", "report.json", "overview.png")
"""Files that are written of every shell."""


def write_shell(
    shell: Shell,
    directory: str | Path,
    formats: Sequence[Format | str] = (),
    settings: Settings | None = None,
    progress: Progress = no_progress,
    *,
    force: bool = False,
) -> list[Path]:
    """Write ``shell.fold``, ``report.json``, the pictures and more formats: all of them or none.

    Parameters
    ----------
    directory
        Where to; made if needed. Files of an earlier run that this one does not write are removed;
        all others stay.
    formats
        What to write beside ``shell.fold``, by names ("glb") or as formats.
    settings
        Choices for the formats; None for those of the design file.
    force
        Whether files that are not of an earlier run, or were changed, may be written over; what the
        design was read from never is.

    Raises
    ------
    InputError
        If the directory cannot be written to, a file is in the way there, or a setting does not fit
        the sheet.
    """
    require_shell(shell)
    chosen = _chosen(formats)
    directory = path_of(directory, "write_shell: directory")
    clock = Clock()
    if settings is None:
        settings = Settings(workshop=shell.file.workshop)
    output = OutputDirectory(directory, inputs=shell.file.inputs, force=force)
    with output.replacing() as draft:
        (draft / "report.json").write_text(
            json.dumps(shell.report.as_dict(), indent=2, allow_nan=False) + "\n"
        )
        draw_pictures(
            draft,
            shell.file,
            shell.design,
            shell.motion,
            shell.document,
            lock=shell.lock,
            deviation=shell.deviation,
            choice=shell.choice,
            report=shell.report,
        )
        _write_structure(shell, draft)
        if shell.design.by_curves:
            _write_curves(shell, draft)
        for format_ in dict.fromkeys((FOLD, *chosen)):
            write_format(shell, format_, draft, settings, progress)
        names = sorted(file.name for file in draft.iterdir())
    clock.lap("write")
    shell.seconds.update(clock.seconds)
    return [directory / name for name in names]


def _chosen(formats: Sequence[Format | str]) -> list[Format]:
    """Formats that are named, or are given themselves."""
    if isinstance(formats, str):
        formats = [formats]
    chosen: list[Format] = []
    for each in formats:
        if isinstance(each, str):
            chosen += find_formats([each])
        elif isinstance(each, Format):
            chosen.append(each)
        else:
            raise InputError(
                "this is no format",
                where="write_shell: formats",
                got=repr(each)[:60],
                expected='names of formats, as ["glb", "dxf"]',
            )
    return chosen


def _write_curves(shell: Shell, draft: Path) -> None:
    """Write ``f-and-g.toml``: the tables that ask for the shell by f and g, not by its surface."""
    tables = groupby(shell.design.by_curves.items(), lambda each: each[0].rpartition(".")[0])
    written = {
        table: [f"{key.rpartition('.')[2]} = {json.dumps(value)}" for key, value in keys]
        for table, keys in tables
        if table != "target"
    }
    lines = ["# In place of [target.surface] in the design file:", ""]
    for table, keys in written.items():
        lines += [f"[{table}]", *keys, ""]
    (draft / "f-and-g.toml").write_text("\n".join(lines))


def write_structure(shell: Shell, directory: str | Path, *, force: bool = False) -> list[Path]:
    """Write what was found of a shell as a structure: report, page and picture, or none of them.

    Parameters
    ----------
    directory
        Where to; made if needed.
    force
        As in :func:`write_shell`.

    Raises
    ------
    InputError
        If the shell was not analysed, the directory cannot be written to, or a file is in the way
        there.
    """
    require_shell(shell)
    if shell.analysis is None:
        raise InputError(
            "the shell was not analysed",
            file=shell.file.path,
            keys=("structure",),
            remedy="add the table [structure]",
        )
    directory = path_of(directory, "write_structure: directory")
    with OutputDirectory(directory, inputs=shell.file.inputs, force=force).adding() as draft:
        text = json.dumps(as_table(shell.analysis), indent=2, allow_nan=False)
        (draft / "structure.json").write_text(text + "\n")
        _write_structure(shell, draft)
        names = sorted(file.name for file in draft.iterdir())
    return [directory / name for name in names]


def _write_structure(shell: Shell, draft: Path) -> None:
    """Write the page, the picture and the tables of an analysed shell."""
    if shell.analysis is not None:
        write_structure_files(draft, shell.document, shell.analysis)


def write_format(
    shell: Shell,
    format_: Format,
    directory: str | Path,
    settings: Settings,
    progress: Progress = no_progress,
    *,
    force: bool = False,
) -> list[Path]:
    """Write a shell in one format: all files of it or none.

    Parameters
    ----------
    format_
        The format; its files have the names that they have for a designed shell.
    directory
        Where to; made if needed.
    force
        As in :func:`write_shell`.

    Raises
    ------
    InputError
        If the directory cannot be written to, a file is in the way there, or a setting does not fit
        the sheet.
    """
    require_shell(shell)
    directory = path_of(directory, "write_format: directory")
    with OutputDirectory(directory, inputs=shell.file.inputs, force=force).adding() as draft:
        states = states_of(shell.motion, progress, f"writing {format_.file}")
        document = replace(shell.document, states=states)
        if format_.lays_surface:
            document = lay_surface(document, shell.design)
        write_document(format_, draft / format_.file, document, settings, str(shell.file.path))
        names = sorted(file.name for file in draft.iterdir())
    return [directory / name for name in names]


def require_shell(shell: object) -> None:
    """Refuse what is no shell, as notebooks may have it.

    Raises InputError.
    """
    if not isinstance(shell, Shell):
        remedy = "make_shell(read_design_file(path)) makes one"
        if isinstance(shell, Design):
            remedy += (
                ', and write_shell(shell, directory, formats=["glb"]) writes it; a design by '
                "itself is written as FOLD: orishell.io.write_fold(path, "
                "orishell.document.from_design.document_of_design(design, unit))"
            )
        raise InputError(
            "only a shell has a report and pictures",
            got=type(shell).__name__,
            expected="a Shell, which design_shell makes from a design file",
            remedy=remedy,
        )


@checked()
def convert_fold(
    source: str | Path,
    target: str | Path,
    settings: Settings = DEFAULT_SETTINGS,
    unit: Unit | None = None,
    *,
    force: bool = False,
) -> list[Path]:
    """Write a FOLD file in another format, which the ending of ``target`` names.

    Parameters
    ----------
    source
        The FOLD file, by any program, of quadrilateral panels.
    target
        The file to write; a format may write others beside it, whose names begin like its own.
    unit
        Unit of length, where the source names none or a wrong one.
    force
        Whether files that orishell did not write, or that were changed, may be written over; the
        source never is.

    Raises
    ------
    InputError
        If the source cannot be read, the ending is unknown, the target cannot be written, or a file
        is in the way there.
    """
    source, target = Path(source), Path(target)
    format_ = format_of(target)
    output = OutputDirectory(target.parent, inputs=(source,), force=force)
    output.require_usable([target.name])
    document = document_of_fold(read_fold(source), unit)
    if not format_.fits(document):
        raise _lacking(format_, source)
    with output.adding() as draft:
        write_document(format_, draft / target.name, document, settings, str(source))
        names = sorted(file.name for file in draft.iterdir())
    return [target.parent / name for name in names]


def _lacking(format_: Format, source: Path) -> InputError:
    """The error for a format that shows what a FOLD file never has."""
    what, table = "how it is built, tied and carried", ""
    if format_.solid:
        what, table = "how thick its panels are", "[panel]"
    elif format_.analysed:
        what, table = "what the shell bears", "[structure]"
    having = f", where the design file has the table {table}" if table else ""
    return InputError(
        f"a FOLD file does not say {what}, which {format_.name} shows",
        where=str(source),
        remedy=f"write it with the design: orishell design FILE --out DIRECTORY --write "
        f"{format_.name}{having}",
    )


def write_document(
    format_: Format, path: Path, document: Document, settings: Settings, source: str
) -> None:
    """Write a document in a format; errors name its ``source``.

    Raises InputError if a setting does not fit the sheet.
    """
    try:
        format_.write(path, document if format_.joined else document.as_cut(), settings)
    except InputError as error:
        raise error.located(f"{source}: {format_.name}:") from None
