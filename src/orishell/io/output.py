"""Directories that files are written into: all of a run or none, and nothing of anybody else's.

One rule for whatever writes: a file that is not on a list of this program's
(:mod:`orishell.io.manifest`), or that was changed since, is not written over unless that is asked
for, and what a run reads is never written over. Both are refused by name, before a file is moved.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import shutil
import sys
import tempfile
from collections.abc import Callable, Collection, Iterable, Iterator, Set
from dataclasses import dataclass
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.conventions.progress import cleaning_up, uninterrupted
from orishell.io.manifest import NAME, Manifest, hash_of, hashes_of, known_in, read_manifest

_DRAFT = re.compile(r"\.orishell-[0-9a-f]{16}")
"""Names of temporary directories."""


@dataclass(frozen=True, slots=True)
class OutputDirectory:
    """A directory to write several files into, all or none."""

    path: Path  # the directory; made if it does not exist, otherwise its other files stay
    # the name of the list of files in it: what one command wrote is not another's to remove
    manifest: str = NAME
    # files that the run reads: they are never written over or removed, by any of their names
    inputs: tuple[Path, ...] = ()
    # whether files that are not this program's, or were changed, may be written over
    force: bool = False

    def require_usable(self, names: Iterable[str] = (), *, replacing: bool = False) -> None:
        """Refuse, before any work is done, a path that files cannot be written to.

        Parameters
        ----------
        names
            Files that will be written there, as far as they are known.
        replacing
            Whether they take the place of those of an earlier run.

        Raises
        ------
        InputError
            If the path, or a parent of it, is a file or cannot be written to, or a file is in the
            way that may not be written over.
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
        self._require_free(set(names), replacing=replacing)

    def of_earlier_run(self) -> list[Path]:
        """The files that an earlier run wrote here, as far as they are there and unchanged."""
        manifest = read_manifest(self.path, self.manifest)
        known = {} if manifest is None else manifest.known
        return [
            self.path / name for name in sorted(known) if hash_of(self.path / name) in known[name]
        ]

    @contextlib.contextmanager
    def adding(self) -> Iterator[Path]:
        """A temporary directory whose files are moved to the path if nothing is raised.

        No later run removes them. If the path is such a directory itself, it is that one.
        """
        if _DRAFT.fullmatch(self.path.name):
            yield self.path
            return
        with self.drafting() as draft:
            yield draft
            with self._alone():
                self._plan(draft, replacing=False)()

    @contextlib.contextmanager
    def replacing(self) -> Iterator[Path]:
        """As :meth:`adding`, and files of an earlier run are removed that are not written anew."""
        with replacing_all([self]) as (draft,):
            yield draft

    def remove_list(self) -> None:
        """Remove the list of files, and the directory if nothing else is in it."""
        with contextlib.suppress(OSError):
            (self.path / self.manifest).unlink(missing_ok=True)
            self.path.rmdir()

    @property
    def _list(self) -> Manifest:
        return read_manifest(self.path, self.manifest) or Manifest({})

    @contextlib.contextmanager
    def drafting(self) -> Iterator[Path]:
        """A temporary directory beside the files, which goes; so do those of runs that are dead.

        An OSError is raised as an InputError.
        """
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

    def _plan(self, draft: Path, *, replacing: bool) -> Callable[[], None]:
        """What moves the files of a draft here; all that needs room on the disk is written before.

        Raises InputError if files are in the way.
        """
        new, before = hashes_of(draft.iterdir()), self._list
        self._require_free(new.keys(), replacing=replacing)
        gone: list[str] = []
        if replacing:
            kept = {}
            for name in before.replaceable:
                digest = None if name in new else hash_of(self.path / name)
                if digest is None or digest not in before.known[name]:
                    continue
                if self._is_read(name):
                    kept[name] = digest
                else:
                    gone.append(name)
            lists = before.replaced({**new, **kept})
        else:
            lists = before.extended(new)
        written = [draft / f"{self.manifest}.{word}" for word in ("moving", "done")]
        for file, manifest in zip(written, lists, strict=True):
            file.write_text(manifest.text(), encoding="utf-8")
        return lambda: self._move(draft, written, [*new], gone)

    def _move(self, draft: Path, lists: list[Path], names: list[str], gone: list[str]) -> None:
        """Move files of a draft here, and remove others, between its two lists."""
        moving, done = lists
        moving.replace(self.path / self.manifest)
        for name in names:
            (draft / name).replace(self.path / name)
        for name in gone:
            (self.path / name).unlink()
        done.replace(self.path / self.manifest)

    def _is_read(self, name: str) -> bool:
        """Whether a file here is one that the run reads, by this or another name."""
        for path in self.inputs:
            with contextlib.suppress(OSError):
                if os.path.samefile(path, self.path / name):
                    return True
        return False

    def _require_free(self, names: Set[str], *, replacing: bool) -> None:
        """Refuse to write files of these names where others are in the way.

        Raises InputError.
        """
        there = [name for name in sorted(names) if os.path.lexists(self.path / name)]
        for name in there:
            path = self.path / name
            if self._is_read(name):
                raise InputError(
                    "this file is read, and would be written over",
                    where=str(path),
                    remedy="write to another directory, or give the file another name or place",
                )
            if path.is_dir() and not path.is_symlink():
                raise InputError("a directory is in the way of a file", where=str(path))
        if self.force:
            return
        known = known_in(self.path)
        own = read_manifest(self.path, self.manifest)
        if own is None and os.path.lexists(self.path / self.manifest):
            there.append(self.manifest)
        if own is not None and replacing:
            paths = [
                (name, self.path / name) for name in own.replaceable if not self._is_read(name)
            ]
            there += [name for name, at in paths if os.path.lexists(at) and not at.is_dir()]
        strange = [
            name
            for name in dict.fromkeys(there)
            if hash_of(self.path / name) not in known.get(name, ())
        ]
        if strange:
            raise _in_the_way(self.path, strange, known.keys())


@contextlib.contextmanager
def replacing_all(directories: Iterable[OutputDirectory]) -> Iterator[list[Path]]:
    """As :meth:`OutputDirectory.replacing` of each, and files are moved to all of them or to none.

    Those that lie in others come after them. The temporary directories have the same order.
    """
    with contextlib.ExitStack() as held:
        drafts = [(each, held.enter_context(each.drafting())) for each in directories]
        yield [draft for _, draft in drafts]
        with contextlib.ExitStack() as alone:
            for each, _ in drafts:
                alone.enter_context(each._alone())
            for move in [each._plan(draft, replacing=True) for each, draft in drafts]:
                move()


@contextlib.contextmanager
def scratch() -> Iterator[Path]:
    """A temporary directory for what is not to stay; an OSError is raised as an InputError."""
    try:
        with tempfile.TemporaryDirectory(prefix="orishell-") as directory:
            yield Path(directory)
    except OSError as error:
        raise _unwritable(Path("temporary files"), error) from None


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


def _in_the_way(directory: Path, names: list[str], known: Collection[str]) -> InputError:
    """The error for files that may not be written over."""
    changed = names[0] in known
    return InputError(
        "this file was changed since orishell wrote it, and would be written over or be left among "
        "files of another run"
        if changed
        else "this file is not of orishell, and would be written over",
        where=str(directory / names[0]),
        got="" if len(names) == 1 else f"{len(names)} such files: {', '.join(names)}",
        remedy="write to another directory, give the file another name or place, or write over it "
        "with --force (force=True in Python)",
    )


def _unwritable(path: Path, error: OSError) -> InputError:
    return InputError(
        "the files cannot be written", where=str(path), got=error.strerror or type(error).__name__
    )
