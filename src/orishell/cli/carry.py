"""``orishell structure --make-it-carry``: designs that carry, as a table and as design files."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any

import typer

from orishell.cli.files import bar, lines_of, say
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import SPACE

if TYPE_CHECKING:
    from orishell.design_file import DesignFile
    from orishell.shell.carry_found import Carrying, CarrySearch

HEAD = ("design", "kg", "parts", "pack", "used", "governs")
NAME = "carries-{}.toml"
WIDTH = 100
"""Columns of a terminal that lines keep to."""


def make_it_carry(asked: DesignFile, out: Path | None, *, json_report: bool, force: bool) -> None:
    """Find designs that carry, print them, and write those that are asked for.

    Ends with status 1 if there is none.
    """
    from orishell.io import OutputDirectory
    from orishell.shell.carry import OFFERED, find_carrying

    output = None
    if out is not None:
        _require_writer()
        output = OutputDirectory(out, inputs=asked.inputs, force=force)
        output.require_usable([NAME.format(number) for number in range(1, OFFERED + 1)])
    with bar() as progress:
        found = find_carrying(asked, progress)
    written = [] if output is None else _write(asked, found, output)
    if json_report:
        import json

        from orishell.conventions.record import as_table

        say(json.dumps(as_table(found), indent=2, allow_nan=False))
    else:
        say("\n".join(_summary(found, written, asked.unit)))
    if not found.found and not found.begun.carries:
        raise typer.Exit(1)


def _require_writer() -> None:
    from importlib.util import find_spec

    if find_spec("tomlkit") is None:
        raise InputError(
            "tomlkit must be installed to write design files",
            where="--out",
            remedy="pip install orishell[search]",
        )


def _write(asked: DesignFile, found: CarrySearch, output: Any) -> list[Path]:
    """Design files of what was found, in the order of the table."""
    from orishell.design_file.rewritten import rewritten
    from orishell.search.problem import files_named

    moved = {
        key: Path(os.path.relpath(asked.path.parent / name, output.path)).as_posix()
        for key, name in files_named(asked.tables, asked.path.parent).items()
        if not Path(name).is_absolute()
    }
    text = asked.path.read_text(encoding="utf-8")
    written = []
    with output.adding() as draft:
        for number, each in enumerate(found.found, start=1):
            name = NAME.format(number)
            content = rewritten(text, asked.tables, {**each.changes, **moved})
            (draft / name).write_text(content, encoding="utf-8")
            written.append(output.path / name)
    return written


def _summary(found: CarrySearch, written: list[Path], unit: str) -> Iterator[str]:
    from orishell.conventions.row import Row
    from orishell.io.sections import Section, Table, section_lines

    begun = found.begun
    yield from lines_of(Row(begun.sign, "stands", begun.in_words()))
    if begun.carries:
        yield "It carries as it is: nothing is to be changed."
        return
    if found.found:
        names = [each.name for each in written] or [str(k + 1) for k in range(len(found.found))]
        rows = [(name, *_cells(each, unit)) for name, each in zip(names, found.found, strict=True)]
        table = Table(HEAD, rows, numbers=0)
        yield from section_lines([Section("Designs that carry, the lightest first", (table,))])
        yield "What is changed"
        for name, each in zip(names, found.found, strict=True):
            yield from _wrapped("; ".join(filter(None, (f"{name}: {each.words}", each.left))))
    else:
        yield "No design was found that carries."
        yield from _wrapped(f"Nearest came {found.near}", "") if found.near else []
    tried = list(found.tried)
    if found.ended:
        tried.append("more would have taken too long")
    yield "What was tried, with few cells (6 = 2 + ties: trial 6 is trial 2 with ties)"
    yield from chain.from_iterable(map(_wrapped, tried))
    yield from (f"wrote     {each}" for each in written)


def _wrapped(text: str, indent: str = "  ") -> list[str]:
    """Lines of a terminal; units stay beside their numbers."""
    return wrap(
        text.replace(" %", f"{SPACE}%"),
        WIDTH,
        initial_indent=indent,
        subsequent_indent=f"{indent}    ",
        break_long_words=False,
        break_on_hyphens=False,
    )


def _cells(each: Carrying, unit: str) -> tuple[str, ...]:
    from orishell.conventions.quantities import plain

    pack = "-" if each.pack is None else " x ".join(plain(side, 3) for side in each.pack)
    return (
        plain(each.mass, 3) if each.mass else "-",
        str(each.parts),
        f"{pack} {unit}" if each.pack else pack,
        "-" if each.used is None else f"{plain(100 * each.used, 3)} %",
        each.governs or "-",
    )
