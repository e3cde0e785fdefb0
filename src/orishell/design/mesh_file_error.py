"""What is wrong in a file of a mesh."""

from __future__ import annotations

from orishell.conventions.errors import printable


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
