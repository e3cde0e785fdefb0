"""Refusals of meshes: a fault in a file, and a mesh that is no surface."""

from __future__ import annotations

from orishell.conventions.errors import InputError, printable
from orishell.numerics.arrays import Array


class MeshFileError(Exception):
    """A value that does not fit: its place in the file, what stands there, what should."""

    def __init__(self, where: str, got: object, expected: str) -> None:
        super().__init__(where)
        self.where = where
        self.got = printable(got if isinstance(got, str) else repr(got))[:60]
        self.expected = expected


def text_of(data: bytes) -> str:
    """The text of a file in UTF-8, or else in Latin 1: names and remarks may be in any."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


ELSE_PART = ", or name a rectangle in plan without that place (x and y, or centre and size)"
"""What else may be done about a fault."""


def place_in_words(place: Array) -> str:
    """A place (3,) in a message."""
    return "({:.4g}, {:.4g}, {:.4g})".format(*place)


def refused_mesh(what: str, got: str, expected: str, remedy: str = "") -> InputError:
    """The refusal of a mesh."""
    return InputError(what, keys=("mesh",), where="mesh", got=got, expected=expected, remedy=remedy)
