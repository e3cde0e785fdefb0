"""The formats that are written, one file each, which ends with its entry ``FORMAT``.

Nothing else knows the name of a format: a file that is put here is found by its entry.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from orishell.conventions.errors import InputError
from orishell.conventions.meant import meant, no_such, question

if TYPE_CHECKING:
    from orishell.document import Document
    from orishell.io.format import Format

ALL = "all"
"""Stands for every format."""
_ENTRY = re.compile(r'^FORMAT = Format\(\s*"([^"]+)"', re.MULTILINE)


@cache
def format_modules() -> dict[str, str]:
    """The module of every format by its name, in alphabetical order.

    Names are read off the texts of the modules: help lists them, and does not wait for NumPy.
    """
    found = {}
    for folder in __path__:
        for file in Path(folder).glob("*.py"):
            if entry := _ENTRY.search(file.read_text(encoding="utf-8")):
                found[entry[1]] = f"{__name__}.{file.stem}"
    return dict(sorted(found.items()))


@cache
def all_formats() -> tuple[Format, ...]:
    """Every format, by name."""
    return tuple(import_module(module).FORMAT for module in format_modules().values())


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
    unknown = sorted(asked - {*format_modules(), ALL})
    if unknown:
        known = tuple(format_modules())
        said = {
            "got": ", ".join(map(repr, unknown)),
            "expected": f"some of {', '.join(known)}; or {ALL}",
        }
        raise no_such("there is no such format", unknown[0], known, **said)
    return tuple(
        each for each in all_formats() if each.name in asked or (ALL in asked and each.ready())
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
        As for :func:`find_formats`.

    Raises
    ------
    InputError
        If a name is unknown.
    """
    asked = _asked(names)
    meant = [each for each in all_formats() if each.fits(document)]
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
    endings = {ending: each for each in all_formats() for ending in each.endings}
    fitting = [each for each in endings if name.endswith(each) and len(name) > len(each)]
    if not fitting:
        raise InputError(
            "no format has this ending",
            where=str(path),
            got=path.suffix or "none",
            expected="one of " + ", ".join(endings),
            remedy=question(meant(path.suffix, endings)),
        )
    return endings[max(fitting, key=len)]
