"""The words with which meshes are refused."""

from __future__ import annotations

from orishell.conventions.errors import InputError
from orishell.numerics.arrays import Array

ELSE_PART = ", or name a rectangle in plan without that place (x and y, or centre and size)"
"""What else may be done about a fault."""


def place_in_words(place: Array) -> str:
    """A place (3,) in a message."""
    return "({:.4g}, {:.4g}, {:.4g})".format(*place)


def refused_mesh(what: str, got: str, expected: str, remedy: str = "") -> InputError:
    """The refusal of a mesh."""
    return InputError(what, keys=("mesh",), where="mesh", got=got, expected=expected, remedy=remedy)
