"""A design file to begin with: the tables of the family, then those that every family has."""

from __future__ import annotations

from pathlib import Path

from orishell.families.registry import FAMILIES, require_family

WORKSHOP = Path(__file__).with_name("starter_workshop.toml")


def starter_file(family: str) -> str:
    """Text of a design file to begin with.

    Parameters
    ----------
    family
        The family's name.

    Raises
    ------
    InputError
        If there is no such family.
    """
    return "".join(
        path.read_text(encoding="utf-8")
        for path in (FAMILIES[require_family(family, where="family")].starter, WORKSHOP)
    )
