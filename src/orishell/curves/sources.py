"""Files that curves come from: bounded, and with one message for what cannot be read."""

from __future__ import annotations

from pathlib import Path

from orishell.errors import InputError

MAX_BYTES = 20_000_000


def read_source(path: Path, kind: str) -> bytes:
    """The bytes of a file.

    Parameters
    ----------
    path
        The file.
    kind
        What messages call it, as in "SVG file".

    Raises
    ------
    InputError
        If it is missing, no file, too large, or cannot be read; without its name.
    """
    try:
        if path.exists() and not path.is_file():
            raise InputError("this is not a file")
        if path.stat().st_size > MAX_BYTES:
            raise InputError(f"the {kind} is too large", expected=f"at most {MAX_BYTES} bytes")
        return path.read_bytes()
    except FileNotFoundError:
        raise InputError(
            f"the {kind} does not exist", remedy="the path is read relative to the design file"
        ) from None
    except (OSError, ValueError) as error:
        raise InputError(f"the {kind} cannot be read", got=str(error)) from None
