"""The journal of a search: one line for each design that was made, so that none is made twice.

A search that is broken off at any moment goes on from here. Lines are in the order in which designs
were ready; what a search finds does not depend on it.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import sys
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from io import FileIO
from pathlib import Path
from typing import Any

from orishell.conventions.version import __version__
from orishell.design_file.values import Values
from orishell.errors import InputError
from orishell.search.evaluate import FAULT, Outcome
from orishell.search.space import key_of

NAME = "journal.jsonl"
_ABSENT: tuple[object, ...] = (None, "", {})


@dataclass(slots=True)
class Journal:
    """Designs that were made.

    Parameters
    ----------
    head
        Its first line: what it is of.
    stream
        Where lines are added; None for a journal in memory.
    """

    head: dict[str, str]
    stream: FileIO | None
    _known: dict[str, Outcome]

    def find(self, values: Values) -> Outcome | None:
        """What became of the variant that has these values; None if it was not made."""
        return self._known.get(key_of(values))

    def __len__(self) -> int:
        return len(self._known)

    def add(self, outcomes: Iterable[Outcome]) -> None:
        """Add the outcomes of some variants.

        Raises
        ------
        InputError
            If there is no room for them.
        """
        lines = [] if self.stream is None or self.stream.tell() else [_line(self.head)]
        for outcome in outcomes:
            self._known[key_of(outcome.values)] = outcome
            if outcome.reason != FAULT:  # another time it may be made
                entry = asdict(outcome).items()
                lines.append(_line({k: v for k, v in entry if k == "values" or v not in _ABSENT}))
        if self.stream is not None:
            _write(self.stream, b"".join(lines))


def journal_in_memory() -> Journal:
    """A journal that is forgotten with its search."""
    return Journal({}, None, {})


@contextlib.contextmanager
def open_journal(path: Path, fingerprint: str) -> Iterator[Journal]:
    """Read a journal, and add to it while this lasts; it is made if needed.

    Parameters
    ----------
    path
        Its file.
    fingerprint
        What tells the design and its figures from others.

    Raises
    ------
    InputError
        If it is of other designs, of another version, held by another search, or no journal.
    """
    made = [each for each in path.parents if not each.exists()]
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        stream = path.open("a+b", buffering=0)
    except OSError as error:
        raise InputError(
            "the journal cannot be written", where=str(path), got=error.strerror or str(error)
        ) from None
    with stream:
        _require_alone(stream, path)
        head = {"orishell": __version__, "design": fingerprint}
        journal = Journal(head, stream, {})
        stream.seek(0)
        content = stream.read()
        whole = content[: content.rfind(b"\n") + 1]
        if len(whole) < len(content):  # a line that was broken off
            stream.truncate(len(whole))
            stream.seek(len(whole))
        for number, line in enumerate(whole.splitlines()):
            entry = _entry(line, path, number)
            if number == 0:
                _require_same(entry, head, path)
                continue
            outcome = _outcome(entry, path, number)
            journal._known[key_of(outcome.values)] = outcome
        try:
            yield journal
        finally:
            if stream.tell() == 0:  # nothing came of it
                path.unlink()
                for each in made:
                    with contextlib.suppress(OSError):  # it is in use meanwhile
                        each.rmdir()


def _line(entry: dict[str, Any]) -> bytes:
    return json.dumps(entry, allow_nan=False).encode() + b"\n"


def _write(stream: FileIO, lines: bytes) -> None:
    try:
        why = "" if stream.write(lines) == len(lines) else os.strerror(errno.ENOSPC)
    except OSError as error:
        why = error.strerror or str(error)
    if why:
        raise InputError(
            "the journal cannot be written",
            where=str(stream.name),
            got=why,
            remedy="make room; the same command goes on where this one was",
        )


def _entry(line: bytes, path: Path, number: int) -> dict[str, Any]:
    try:
        entry = json.loads(line)
    except ValueError:
        entry = None
    if not isinstance(entry, dict):
        raise _unreadable(path, number)
    return entry


def _outcome(entry: dict[str, Any], path: Path, number: int) -> Outcome:
    try:
        return Outcome(**{"figures": {}, **entry})
    except TypeError:
        raise _unreadable(path, number) from None


def _unreadable(path: Path, number: int) -> InputError:
    return InputError(
        "this is not the journal of a search",
        where=f"{path}, line {number + 1}",
        remedy="choose another directory, or remove the file and search from the beginning",
    )


def _require_same(found: dict[str, Any], head: dict[str, str], path: Path) -> None:
    if found == head:
        return
    other = found.get("orishell") == head["orishell"]
    what = "a design or figures that differ" if other else "another version of orishell"
    raise InputError(
        f"the journal here is of {what}",
        where=str(path),
        remedy="choose another directory, or remove the file and search from the beginning",
    )


def _require_alone(stream: FileIO, path: Path) -> None:
    """Hold the journal as long as this process lives; raises InputError if another one does."""
    if sys.platform == "win32":
        return
    import fcntl

    try:
        fcntl.flock(stream.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(
            "another search writes here", where=str(path), remedy="choose another directory"
        ) from None
    except OSError:
        os.fstat(stream.fileno())  # a file system without locks
