"""A design file to begin with: the tables of the family, then those that every family has."""

from __future__ import annotations

import re
from pathlib import Path

from orishell.families.registry import FAMILIES, require_family

OF_DRAWINGS = "# pattern.fold_deg = { low = 60, high = 120 }"
"""What a search varies of a sheet that has its rows and columns."""
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
    found = FAMILIES[require_family(family, where="family")]
    text, common = (path.read_text(encoding="utf-8") for path in (found.starter, WORKSHOP))
    if "rows" not in found.pattern.knobs():
        common = re.sub("(# pattern.rows = .*\n# pattern.columns = .*)", OF_DRAWINGS, common)
    return text + common
