"""All formats that can be written, and how one is found by its name or a file's ending."""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.document import Document
from orishell.io.format import Format
from orishell.io.registry import ALL, MODULES

FORMATS: tuple[Format, ...] = tuple(import_module(module).FORMAT for module in MODULES.values())

FOLD = FORMATS[0]


def find_formats(names: Iterable[str]) -> tuple[Format, ...]:
    """Formats by their names, in the order of the list; "all" means every one that is available.

    Parameters
    ----------
    names
        Names of formats, in any order.

    Raises
    ------
    InputError
        If a name is unknown.
    """
    asked = _asked(names)
    unknown = sorted(asked - {format_.name for format_ in FORMATS} - {ALL})
    if unknown:
        raise InputError(
            "there is no such format",
            got=", ".join(map(repr, unknown)),
            expected="some of " + ", ".join(format_.name for format_ in FORMATS) + f"; or {ALL}",
        )
    return tuple(
        format_
        for format_ in FORMATS
        if format_.name in asked or (ALL in asked and format_.ready())
    )


def formats_for(
    names: Iterable[str], document: Document
) -> tuple[tuple[Format, ...], tuple[Format, ...]]:
    """The formats to write a document in, and those that "all" leaves out for want of something.

    "all" means formats of solids only where panels have a thickness, and those of a structure only
    where it was analysed.

    Parameters
    ----------
    names
        Names of formats, in any order.

    Raises
    ------
    InputError
        If a name is unknown.
    """
    asked = _asked(names)
    meant = [each for each in FORMATS if each.fits(document)]
    chosen = [each for each in find_formats(asked) if each.name in asked or each in meant]
    missing = [each for each in meant if ALL in asked and each not in chosen]
    return tuple(chosen), tuple(missing)


def _asked(names: Iterable[str]) -> set[str]:
    return {name.strip().lower() for name in names if name.strip()}


def format_of(path: Path) -> Format:
    """The format that a file's name asks for by its ending, the longest that fits.

    Raises
    ------
    InputError
        If no format has that ending.
    """
    name = path.name.lower()
    fitting = [
        (len(ending), format_)
        for format_ in FORMATS
        for ending in format_.endings
        if name.endswith(ending) and len(name) > len(ending)
    ]
    if not fitting:
        raise InputError(
            "no format has this ending",
            where=str(path),
            got=path.suffix or "none",
            expected="one of "
            + ", ".join(ending for format_ in FORMATS for ending in format_.endings),
        )
    return max(fitting, key=lambda found: found[0])[1]
