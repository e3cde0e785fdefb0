"""The key of the components: in the path of their addresses, since Hops keeps no cookies.

A Grasshopper definition keeps the addresses of its components. So the key is made once and stays,
in a file that only its user can read.
"""

from __future__ import annotations

import hmac
import os
import re
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Final

from orishell.conventions.errors import InputError
from orishell.studio.guard import Key

NAME: Final = ".orishell-hops-key"
"""The file in the home folder that has it."""
WORD: Final = re.compile(r"[A-Za-z0-9_-]{43}")


@dataclass(frozen=True, slots=True)
class PathKey(Key):
    """What lets one in, as the first part of an address's path."""

    LOCKED: ClassVar[str] = (
        "the key is missing or another: take the address that `orishell hops` printed at its start"
    )
    word: str = field(default="", repr=False)

    def enters(self, scope: Mapping[str, Any]) -> bool:
        """Nobody is given a cookie."""
        return False

    def opens(self, scope: Mapping[str, Any]) -> bool:
        """Whether the path begins with the key."""
        first = scope["path"].encode("utf-8", "replace").removeprefix(b"/").partition(b"/")[0]
        return hmac.compare_digest(first, self.word.encode())


def kept_word(place: Path, *, new: bool = False) -> str:
    """The key in a file, the ``place``; it is made where there is none, or if ``new``.

    Raises
    ------
    InputError
        If the file cannot be read or made, others can read it, or it has no key.
    """
    what, got = "this is no key of the components", ""
    try:
        if new:
            place.unlink(missing_ok=True)
        if not place.exists():
            entry = os.open(place, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600)
            with os.fdopen(entry, "w", encoding="ascii") as file:
                file.write(secrets.token_urlsafe(32))
        word = place.read_text(encoding="ascii").strip()
        open_to_all = os.name == "posix" and bool(place.stat().st_mode & 0o077)
        if WORD.fullmatch(word) and not open_to_all:
            return word
        what = "others can read the key of the components" if open_to_all else what
    except (OSError, UnicodeDecodeError) as error:
        got = str(getattr(error, "strerror", None) or error)
    raise InputError(what, file=place, got=got, remedy="make another with --new-key")
