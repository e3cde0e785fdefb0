"""The list of the files that runs wrote into a directory, kept there with their hashes.

By it a file of this program that nobody changed is told from all others, which are never written
over (:mod:`orishell.io.output`). It is written before files are moved, with the hashes that they
had before, and again after it: so what a run left that was broken off in between is known too.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from orishell.conventions.errors import InputError

NAME = ".orishell.json"
LISTS = re.compile(r"\.orishell(-[a-z]+)?\.json")
"""Names of lists: each command that replaces its own files has one."""
ABOUT = (
    "The files that orishell wrote here and their SHA-256. The next run removes those of `files` "
    "that it does not write anew. It writes over no file that is not here, or that was changed."
)
MOST_BYTES = 10_000_000
"""Bytes of a list, at most: it may be anybody's."""
_HASH = re.compile("[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class Manifest:
    """Which files of a directory are this program's."""

    files: dict[str, str]  # hash of every file of the last run, by name
    # possible hashes of the files of runs before, by name, as long as the last one moves its files;
    # None when all is done
    earlier: dict[str, list[str]] | None = None
    # possible hashes of files that were written one by one, by name: no run removes them
    added: dict[str, list[str]] = field(default_factory=dict)

    @property
    def known(self) -> dict[str, list[str]]:
        """All hashes that a file of this program may have here, by name."""
        found: dict[str, list[str]] = {}
        single = {name: [digest] for name, digest in self.files.items()}
        for part in (self.earlier or {}, single, self.added):
            for name, hashes in part.items():
                found[name] = list(dict.fromkeys([*found.get(name, []), *hashes]))
        return found

    @property
    def replaceable(self) -> list[str]:
        """Names of the files that the next run is to write anew or to remove."""
        return sorted({*self.files, *(self.earlier or {})} - {*self.added})

    def replaced(self, new: dict[str, str]) -> tuple[Manifest, Manifest]:
        """The lists while the files of a run take the place of these, and when all is done."""
        added = {name: hashes for name, hashes in self.added.items() if name not in new}
        return Manifest(new, self.known, added), Manifest(new, None, added)

    def extended(self, new: dict[str, str]) -> tuple[Manifest, Manifest]:
        """The lists while files are added one by one, and when all is done."""
        known = self.known
        files = {name: digest for name, digest in self.files.items() if name not in new}
        earlier = self.earlier
        if earlier is not None:  # the run that was broken off is still to be made again
            earlier = {name: hashes for name, hashes in earlier.items() if name not in new}
        moving = {name: [digest, *known.get(name, [])] for name, digest in new.items()}
        done = {name: [digest] for name, digest in new.items()}
        return (
            Manifest(files, earlier, {**self.added, **moving}),
            Manifest(files, earlier, {**self.added, **done}),
        )

    def text(self) -> str:
        """What its file has."""
        added = {name: self.added[name] for name in sorted(self.added)}
        more = {"earlier": self.earlier} if self.earlier is not None else {}
        more |= {"added": added} if added else {}
        return json.dumps({"about": ABOUT, "files": self.files, **more}, indent=1) + "\n"


def read_manifest(directory: Path, name: str = NAME) -> Manifest | None:
    """The list of the files in a directory, by its ``name``; None if none can be used."""
    path = directory / name
    try:
        if path.is_symlink() or not path.is_file() or path.stat().st_size > MOST_BYTES:
            return None
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    files, earlier = _entries(content, "files"), _entries(content, "earlier")
    if files is None or any(len(hashes) != 1 for hashes in files.values()):
        return None
    single = {name: hashes[0] for name, hashes in files.items()}
    return Manifest(single, earlier, _entries(content, "added") or {})


def known_in(directory: Path) -> dict[str, set[str]]:
    """Hashes of the files in a directory that are on any list there, by name."""
    found: dict[str, set[str]] = {}
    if not directory.is_dir():
        return found
    for path in directory.iterdir():
        manifest = read_manifest(directory, path.name) if LISTS.fullmatch(path.name) else None
        for name, hashes in ({} if manifest is None else manifest.known).items():
            found.setdefault(name, set()).update(hashes)
    return found


def _entries(content: Any, key: str) -> dict[str, list[str]] | None:
    """Hashes by name, only of files in the directory itself."""
    entries = content.get(key) if isinstance(content, dict) else None
    if not isinstance(entries, dict):
        return None
    found = {}
    for name, value in entries.items():
        hashes = [value] if isinstance(value, str) else value
        if name in {"", ".", ".."} or LISTS.fullmatch(name) or Path(name).name != name:
            return None
        if not isinstance(hashes, list) or not all(
            isinstance(each, str) and _HASH.fullmatch(each) for each in hashes
        ):
            return None
        found[name] = hashes
    return found


def require_one_run(path: Path) -> None:
    """Refuse a file, there or not, if the last run that wrote it did not finish moving its files.

    Raises InputError then.
    """
    manifest = read_manifest(path.parent)
    if manifest is None or manifest.earlier is None or path.name not in manifest.known:
        return
    moved = sum(hash_of(path.parent / name) == each for name, each in manifest.files.items())
    raise InputError(
        "a run was broken off while it moved its files here",
        where=str(path.parent),
        got=f"{moved} of {len(manifest.files)} files of that run, the others missing or older",
        remedy="run the same command again",
    )


def hash_of(path: Path) -> str | None:
    """SHA-256 of a file in hexadecimal digits; None if it is not there, or a link."""
    try:
        if path.is_symlink() or not path.is_file():
            return None
        with path.open("rb") as stream:
            return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError:
        return None


def hashes_of(files: Iterable[Path]) -> dict[str, str]:
    """SHA-256 of files by their names, in the order of these."""
    return {file.name: hash_of(file) or "" for file in sorted(files)}
