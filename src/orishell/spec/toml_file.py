"""TOML files as they stand: tables of values, not yet checked."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from orishell.errors import InputError

MAX_BYTES = 1_000_000


def read_toml(path: Path) -> dict[str, Any]:
    """The tables of a TOML file.

    Raises
    ------
    InputError
        If it does not exist, cannot be read or is not TOML.
    """
    try:
        if path.exists() and not path.is_file():
            raise InputError("this is not a file", where=str(path))
        if path.stat().st_size > MAX_BYTES:
            raise InputError("this is too large for a design file", where=str(path))
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except FileNotFoundError:
        raise InputError(
            "the design file does not exist",
            where=str(path),
            remedy="orishell new parallel-repeating writes one to begin with",
        ) from None
    except tomllib.TOMLDecodeError as error:
        raise InputError("this is not TOML", where=str(path), got=str(error)) from None
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(
            "the design file cannot be read", where=str(path), got=str(error)
        ) from None
