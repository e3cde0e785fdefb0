"""The families by name.

A further family is a folder here, with a ``pattern`` whose ``design`` returns a
:class:`~orishell.design.Design` and its :class:`~orishell.motion.Mechanism`, and a line in FOLDERS.
``tests/toy_family.py`` is the smallest one.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from orishell.conventions.meant import no_such
from orishell.families.pattern import AnyPattern, Family, Pattern

FOLDERS = (
    "parallel_repeating",
    "orthodiagonal",
    "longitudinal_linear_repeating",
    "flat_foldable",
    "drawn",
    "t_hedral",
)
"""Each has a module ``pattern`` with its FAMILY."""


FAMILIES: dict[str, Family] = {
    family.name: family
    for folder in FOLDERS
    for family in [import_module(f"{__package__}.{folder}.pattern").FAMILY]
}


TRIED = tuple(
    name
    for name, each in sorted(FAMILIES.items(), key=lambda item: item[1].in_strips)
    if {"curves", "surface"} & {*each.pattern.aims()}
)
"""Those that can follow curves or a surface, and are tried where the family is to be chosen: first
those of one flat sheet."""

AUTO = "auto"
"""What a design file calls the family that is to be chosen."""


def pattern_of(name: str, **place: Any) -> type[Pattern]:
    """The table [pattern] of a family, or what all have in common if it is to be chosen.

    Parameters
    ----------
    name
        Its name, or "auto".
    place
        Where it stands.

    Raises
    ------
    InputError
        If there is none: with the names of all.
    """
    return AnyPattern if name == AUTO else FAMILIES[require_family(name, **place)].pattern


def require_family(name: str, **place: Any) -> str:
    """Return the name of a family, and refuse one that is unknown.

    Parameters
    ----------
    name
        The name.
    place
        Where it stands, as :class:`~orishell.conventions.errors.InputError` takes it.

    Raises
    ------
    InputError
        If there is none: with the names of all.
    """
    if name not in FAMILIES:
        raise no_such("unknown family", name, FAMILIES, **place)
    return name
