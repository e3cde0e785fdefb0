"""Files that are read: only what is a file, no larger than it may be."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.conventions.meant import question, spelt_nearly

MOST = 5000
"""Files beside it that are looked at for what was meant by a name."""


def read_source_file(path: Path, what: str, most: int, remedy: str = "") -> bytes:
    """The bytes of a file; the error does not name it.

    Parameters
    ----------
    path
        The file, or a link to one. Pipes, devices and directories are refused before they are
        opened, since some of them never end.
    what
        What messages call it.
    most
        Bytes that it may have.
    remedy
        What to do if it does not exist.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    require_source_file(path, what, most, remedy)
    try:
        return path.read_bytes()
    except OSError as error:
        raise _unreadable(what, error) from None


def require_source_file(path: Path, what: str, most: int, remedy: str = "") -> None:
    """Refuse what is no file, or too large; as :func:`read_source_file`, without reading it."""
    try:
        if path.exists() and not path.is_file():
            raise InputError("this is not a file", got=_kind(path))
        size = path.stat().st_size
    except FileNotFoundError:
        raise InputError(f"the {what} does not exist", remedy=_meant(path) or remedy) from None
    except (OSError, ValueError) as error:  # a name with a zero in it is a ValueError
        raise _unreadable(what, error) from None
    if size > most:
        raise InputError(
            f"the {what} is too large",
            got=f"{size} bytes",
            expected=f"at most {most} bytes",
            remedy="copy what is meant into a file of its own",
        )


def _meant(path: Path) -> str:
    """What may be meant by the name of a file that there is not."""
    name = str(path)
    if not name.isprintable():  # "C:\temp" has a tab in it
        return (
            "a backslash in double quotes has a meaning of its own: write the path in single "
            "quotes, or with /"
        )
    try:
        there = [each.name for each in islice(path.parent.iterdir(), MOST) if each.is_file()]
    except OSError:
        return ""
    ending = [each for each in there if each.startswith(f"{path.name}.")]
    return question((ending or spelt_nearly(path.name, there))[:1])


def _kind(path: Path) -> str:
    kinds = {"a directory": path.is_dir, "a pipe": path.is_fifo, "a socket": path.is_socket}
    return next((name for name, holds in kinds.items() if holds()), "a device")


def _unreadable(what: str, error: OSError | ValueError) -> InputError:
    said = (error.strerror if isinstance(error, OSError) else None) or str(error)
    return InputError(f"the {what} cannot be read", got=said)
