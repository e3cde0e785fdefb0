"""The list of the files that a run wrote into a directory, kept there with their hashes.

It is written before they are moved there, with those of the runs before, and again after it: a run
that was broken off in between is known by it, and no file is removed that somebody changed.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import secrets
import shutil
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from orishell.conventions.errors import InputError
from orishell.conventions.progress import cleaning_up, uninterrupted

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
    """Which files of a directory are this program's."""

    files: dict[str, str]  # hash of every file of the last run, by name
    # possible hashes of the files of runs before, by name, as long as the last one moves its files;
    # None when all is done
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
        """What its file has."""
        moving = {} if self.earlier is None else {"earlier": self.earlier}
        return json.dumps({"about": ABOUT, "files": self.files, **moving}, indent=1) + "\n"


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
        remedy="run orishell design again",
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


_DRAFT = re.compile(r"\.orishell-[0-9a-f]{16}")
"""Names of temporary directories."""


@dataclass(frozen=True, slots=True)
class OutputDirectory:
    """A directory to write several files into, all or none."""

    path: Path  # the directory; made if it does not exist, otherwise its other files stay
    # the name of the list of files in it: what one command wrote is not another's to remove
    manifest: str = NAME

    def require_usable(self) -> None:
        """Refuse, before any work is done, a path that files cannot be written to.

        Raises
        ------
        InputError
            If the path, or a parent of it, is a file or cannot be written to.
        """
        try:
            existing = self.path
            while not existing.exists() and existing != existing.parent:
                existing = existing.parent
            for name in self.path.parts[len(existing.parts) :]:
                (existing / name).exists()  # raises for a name that no directory can have
            usable = existing.is_dir()
        except OSError as error:  # a name that is too long, for instance
            raise _unwritable(self.path, error) from None
        if not usable:
            raise InputError(
                "the output directory cannot be made",
                where=str(self.path),
                got=f"{existing} is a file",
                remedy="choose another directory",
            )
        if not os.access(existing, os.W_OK | os.X_OK):
            raise InputError("the output directory cannot be written to", where=str(self.path))

    def of_earlier_run(self) -> list[Path]:
        """The files that an earlier run wrote here, as far as they are there and unchanged."""
        manifest = read_manifest(self.path, self.manifest)
        known = {} if manifest is None else manifest.known
        return [
            self.path / name for name in sorted(known) if hash_of(self.path / name) in known[name]
        ]

    @contextlib.contextmanager
    def adding(self) -> Iterator[Path]:
        """A temporary directory whose files are moved to the path if nothing is raised."""
        with self._drafting() as draft:
            yield draft
            with self._alone():
                self._require_free(draft)
                self._move(draft)

    @contextlib.contextmanager
    def replacing(self) -> Iterator[Path]:
        """As :meth:`adding`, and files of an earlier run are removed, unless they were changed."""
        with replacing_all([self]) as (draft,):
            yield draft

    def remove_list(self) -> None:
        """Remove the list of files, and the directory if nothing else is in it."""
        with contextlib.suppress(OSError):
            (self.path / self.manifest).unlink(missing_ok=True)
            self.path.rmdir()

    @contextlib.contextmanager
    def _drafting(self) -> Iterator[Path]:
        """A temporary directory beside the files; those of runs that are dead are removed."""
        draft = self.path / f".orishell-{secrets.token_hex(8)}"
        made: list[Path] = []

        def discard() -> None:
            shutil.rmtree(draft, ignore_errors=True)
            for path in made:  # only empty ones go
                with contextlib.suppress(OSError):
                    path.rmdir()

        try:
            made += (path for path in (self.path, *self.path.parents) if not path.exists())
            with cleaning_up(discard), contextlib.ExitStack() as held:
                self.path.mkdir(parents=True, exist_ok=True)
                with _locked(self.path):
                    self._remove_dead()
                    draft.mkdir()
                    held.enter_context(_locked(draft))
                yield draft
        except OSError as error:
            raise _unwritable(self.path, error) from None

    @contextlib.contextmanager
    def _alone(self) -> Iterator[None]:
        """While this lasts, no other run moves its files here, and this one is not stopped."""
        with _locked(self.path), uninterrupted():
            yield

    def _remove_dead(self) -> None:
        for path in self.path.iterdir():
            if _DRAFT.fullmatch(path.name) and path.is_dir() and not path.is_symlink():
                with _locked(path, wait=False) as free:
                    if free:
                        shutil.rmtree(path, ignore_errors=True)

    def _replace(self, draft: Path) -> None:
        """Move the files of a draft here, and remove those of an earlier run."""
        new = Manifest({file.name: hash_of(file) or "" for file in sorted(draft.iterdir())})
        before = read_manifest(self.path, self.manifest) or Manifest({})
        (draft / self.manifest).write_text(Manifest(new.files, before.known).text())
        self._move(draft, first=self.manifest)
        for name in before.known.keys() - new.files.keys():
            if hash_of(self.path / name) in before.known[name]:
                (self.path / name).unlink()
        (draft / self.manifest).write_text(new.text())
        self._move(draft)

    def _require_free(self, draft: Path) -> None:
        for file in sorted(draft.iterdir()):
            if (self.path / file.name).is_dir():
                raise InputError(
                    "a directory is in the way of a file", where=str(self.path / file.name)
                )

    def _move(self, draft: Path, first: str = "") -> None:
        files = sorted(draft.iterdir(), key=lambda file: (file.name != first, file.name))
        for file in files:
            file.replace(self.path / file.name)


@contextlib.contextmanager
def replacing_all(directories: Iterable[OutputDirectory]) -> Iterator[list[Path]]:
    """As :meth:`OutputDirectory.replacing` of each, and files are moved to all of them or to none.

    Those that lie in others come after them. The temporary directories have the same order.
    """
    with contextlib.ExitStack() as held:
        drafts = [(each, held.enter_context(each._drafting())) for each in directories]
        yield [draft for _, draft in drafts]
        with contextlib.ExitStack() as alone:
            for each, draft in drafts:
                alone.enter_context(each._alone())
                each._require_free(draft)
            for each, draft in drafts:
                each._replace(draft)


@contextlib.contextmanager
def _locked(directory: Path, *, wait: bool = True) -> Iterator[bool]:
    """Lock a directory, if it can be; the system unlocks it when the process ends, however."""
    if sys.platform == "win32":
        yield False
        return
    import fcntl

    descriptor = os.open(directory, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            held = True
        except OSError:  # held by another, or the file system has no locks
            held = False
        yield held
    finally:
        os.close(descriptor)


def _unwritable(path: Path, error: OSError) -> InputError:
    return InputError(
        "the files cannot be written", where=str(path), got=error.strerror or type(error).__name__
    )
