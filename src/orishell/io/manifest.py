"""The list of the files that a run wrote into a directory, kept there with their hashes.

It is written before they are moved there, with those of the runs before, and again after it: a run
that was broken off in between is known by it, and no file is removed that somebody changed.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from orishell.conventions.errors import InputError

NAME = ".orishell.json"
ABOUT = (
    "The files that orishell wrote here and their SHA-256. The next run removes those of them that "
    "it does not write anew and that nobody has changed."
)
LARGEST = 10_000_000
"""Bytes of a list, at most: it may be anybody's."""
_HASH = re.compile("[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class Manifest:
    """Which files of a directory are this program's.

    Parameters
    ----------
    files
        Hash of every file of the last run, by name.
    earlier
        Possible hashes of the files of runs before, by name, as long as the last one moves its
        files; None when all is done.
    """

    files: dict[str, str]
    earlier: dict[str, list[str]] | None = None

    @property
    def known(self) -> dict[str, list[str]]:
        """All hashes that a file of this program may have here, by name."""
        earlier = self.earlier or {}
        found = {name: list(hashes) for name, hashes in earlier.items()}
        for name, digest in self.files.items():
            if digest not in found.setdefault(name, []):
                found[name].append(digest)
        return found

    def text(self) -> str:
        """The text of the list, as it is written to its file."""
        moving = {} if self.earlier is None else {"earlier": self.earlier}
        return json.dumps({"about": ABOUT, "files": self.files, **moving}, indent=1) + "\n"

    @classmethod
    def of(cls, files: Iterable[Path]) -> Self:
        """The list of some files."""
        return cls({file.name: hash_of(file) or "" for file in files})


def read_manifest(directory: Path, name: str = NAME) -> Manifest | None:
    """The list of the files in a directory, by its ``name``; None if none can be used."""
    path = directory / name
    try:
        if not path.is_file() or path.stat().st_size > LARGEST:
            return None
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    files, earlier = _entries(content, "files"), _entries(content, "earlier")
    if files is None or any(len(hashes) != 1 for hashes in files.values()):
        return None
    return Manifest({name: hashes[0] for name, hashes in files.items()}, earlier)


def _entries(content: Any, key: str) -> dict[str, list[str]] | None:
    """Hashes by name, only of files in the directory itself."""
    entries = content.get(key) if isinstance(content, dict) else None
    if not isinstance(entries, dict):
        return None
    found = {}
    for name, value in entries.items():
        hashes = [value] if isinstance(value, str) else value
        if name in {"", ".", "..", NAME} or Path(name).name != name:
            return None
        if not isinstance(hashes, list) or not all(
            isinstance(each, str) and _HASH.fullmatch(each) for each in hashes
        ):
            return None
        found[name] = hashes
    return found


def require_one_run(path: Path) -> None:
    """Refuse a file that lies among those of two runs, because one was broken off.

    Parameters
    ----------
    path
        The file, whether it is there or not.

    Raises
    ------
    InputError
        If the last run that wrote it did not finish moving its files.
    """
    manifest = read_manifest(path.parent)
    if manifest is None or manifest.earlier is None or path.name not in manifest.known:
        return
    moved = sum(hash_of(path.parent / name) == each for name, each in manifest.files.items())
    raise InputError(
        "a run was broken off while it moved its files here",
        where=str(path.parent),
        got=f"{moved} of {len(manifest.files)} files of that run, the others missing or older",
        remedy="run orishell design again",
    )


def hash_of(path: Path) -> str | None:
    """SHA-256 of a file, in hexadecimal digits; None if there is no such file, or it is a link."""
    try:
        if path.is_symlink() or not path.is_file():
            return None
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError:
        return None
