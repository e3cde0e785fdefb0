"""Files that are read: only what is a file, no larger than it may be."""

from __future__ import annotations

from pathlib import Path

from orishell.conventions.errors import InputError


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
        raise InputError(f"the {what} does not exist", remedy=remedy) from None
    except (OSError, ValueError) as error:  # a name with a zero in it is a ValueError
        raise _unreadable(what, error) from None
    if size > most:
        raise InputError(
            f"the {what} is too large",
            got=f"{size} bytes",
            expected=f"at most {most} bytes",
            remedy="copy what is meant into a file of its own",
        )


def _kind(path: Path) -> str:
    kinds = {"a directory": path.is_dir, "a pipe": path.is_fifo, "a socket": path.is_socket}
    return next((name for name, holds in kinds.items() if holds()), "a device")


def _unreadable(what: str, error: OSError | ValueError) -> InputError:
    said = (error.strerror if isinstance(error, OSError) else None) or str(error)
    return InputError(f"the {what} cannot be read", got=said)
