"""The journal of a search: one line for each design that was made, so that none is made twice.

A search that is broken off at any moment goes on from here. Lines are in the order in which designs
were ready; what a search finds does not depend on it.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import stat
import sys
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from io import FileIO
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, JsonValue

from orishell.conventions.errors import InputError
from orishell.conventions.table import Number, Table
from orishell.conventions.version import __version__
from orishell.design_file.tables import Values
from orishell.search.evaluate import FAULT, Outcome
from orishell.search.problem import Problem
from orishell.search.space import key_of

NAME = "journal.jsonl"
LONGEST_HEAD = 4096
"""Bytes that are read of a file before it is known to be a journal."""
BEGINNING = b'{"values": '
"""Of each line but the head."""
_ABSENT: tuple[object, ...] = (None, "", {})


@dataclass(slots=True)
class Journal:
    """Designs that were made."""

    head: dict[str, str]  # its first line: what it is of
    stream: FileIO | None  # where lines are added; None for a journal in memory
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
def open_journal(path: Path, problem: Problem) -> Iterator[Journal]:
    """Read a journal, and add to it while this lasts; it is made if needed.

    Nothing is changed of a file that is not the journal of this search.

    Raises
    ------
    InputError
        If it is of other designs, of another version, held by another search, or no journal.
    """
    head = {"orishell": __version__, "design": problem.fingerprint()}
    parents = [each for each in path.parents if not each.exists()]
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        stream, new = _opened(path, head)
    except OSError as error:
        raise InputError(
            "the journal cannot be written", where=str(path), got=error.strerror or str(error)
        ) from None
    with stream:
        _require_alone(stream, path)
        journal = Journal(head, stream, _read(stream, path, head, {*problem.figures}))
        try:
            yield journal
        finally:
            if new and stream.tell() == 0:  # nothing came of it
                path.unlink()
                for each in parents:
                    with contextlib.suppress(OSError):  # it is in use meanwhile
                        each.rmdir()


def _opened(path: Path, head: dict[str, str]) -> tuple[FileIO, bool]:
    """A journal to add to, and whether it was made; none is opened so whose head is another's."""

    def adding(name: str, flags: int) -> int:
        return os.open(name, flags | os.O_APPEND, 0o666)

    def not_waiting(name: str, flags: int) -> int:  # for who writes into a pipe
        return os.open(name, flags | getattr(os, "O_NONBLOCK", 0))

    try:
        return open(path, "x+b", buffering=0, opener=adding), True
    except FileExistsError:
        pass
    with open(path, "rb", buffering=0, opener=not_waiting) as there:
        if not stat.S_ISREG(os.fstat(there.fileno()).st_mode):
            raise _foreign(path)
        _require_same(there.read(LONGEST_HEAD), head, path)
    return open(path, "r+b", buffering=0, opener=adding), False


def _read(
    stream: FileIO, path: Path, head: dict[str, str], figures: set[str]
) -> dict[str, Outcome]:
    """The designs in a journal; a line that was broken off at its end is taken away."""
    stream.seek(0)
    content = stream.read()
    _require_same(content[:LONGEST_HEAD], head, path)
    *lines, rest = content.split(b"\n")
    known: dict[str, Outcome] = {}
    for number, line in enumerate(lines[1:], 2):
        try:
            outcome = _outcome(line, figures)
            known[key_of(outcome.values)] = outcome
        except (ValueError, RecursionError):
            raise _unreadable(path, number) from None
    if lines and rest and not (rest.startswith(BEGINNING) or BEGINNING.startswith(rest)):
        raise _unreadable(path, len(lines) + 1)
    if rest:
        stream.truncate(len(content) - len(rest))
        stream.seek(0, os.SEEK_END)
    return known


class _Line(Table):
    """A line of a journal behind its head."""

    values: dict[str, JsonValue]
    figures: dict[str, Number] = Field(default_factory=dict)
    reason: str = ""
    said: str = ""
    excess: Annotated[Number, Field(ge=0)] | None = None


def _outcome(line: bytes, figures: set[str]) -> Outcome:
    """What a line says; raises ValueError or RecursionError if it is none of a journal."""
    found = _Line.model_validate(json.loads(line))
    if {*found.figures} != (set() if found.reason else figures):
        raise ValueError(line)
    return Outcome(found.values, found.figures, found.reason, found.said, found.excess)


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


def _require_same(begins: bytes, head: dict[str, str], path: Path) -> None:
    """Refuse what a file begins with, if it is no head, or not this one or what is left of it."""
    line, newline, _ = begins.partition(b"\n")
    if not newline and _line(head).startswith(line):  # it was broken off
        return
    try:
        found = json.loads(line) if newline else None
    except (ValueError, RecursionError):
        found = None
    if not isinstance(found, dict) or found.keys() != head.keys():
        raise _foreign(path)
    if found != head:
        other = found["orishell"] == head["orishell"]
        what = "a design or figures that differ" if other else "another version of orishell"
        raise InputError(
            f"the journal here is of {what}",
            where=str(path),
            remedy="choose another directory, or remove the file and search from the beginning",
        )


def _foreign(path: Path) -> InputError:
    return InputError(
        "this is not the journal of a search",
        where=str(path),
        remedy="choose another directory: a search keeps its journal in a file of this name",
    )


def _unreadable(path: Path, number: int) -> InputError:
    return InputError(
        "this line of the journal cannot be read",
        where=f"{path}, line {number}",
        remedy="remove the line: its design is made again; or choose another directory",
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
