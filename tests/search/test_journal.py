"""The journal keeps every design that was made, of one design file, and says what it is not."""

from __future__ import annotations

import json
import os
import random
import resource
import signal
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import pytest

from orishell.conventions.errors import InputError, OrishellError
from orishell.search.evaluate import FAULT, Outcome
from orishell.search.journal import NAME, open_journal
from orishell.search.run import search_designs
from orishell.search.worker_pool import Work, WorkerPool
from samples import THOROUGH
from search.problems import small_problem

SEARCHED = small_problem("orthodiagonal", minimise=["panels"])
OTHER = small_problem("orthodiagonal", minimise=["sheet_area"])

NONE = "this is not the journal of a search"
MADE = [
    Outcome({"a": 1, "b": [1.5, "x"]}, {"panels": 0.1 + 0.2}),
    Outcome({"a": 2, "b": [1.5, "x"]}, {}, "no", "no, because", 0.25),
    Outcome({"a": 3, "b": [1.5, "x"]}, {}, "no", "no, because"),
    Outcome({"a": 5, "b": [1.5, "x"]}, {}, "no", "no, because", 0.0),
]


def test_what_was_written_is_found_again(tmp_path: Path) -> None:
    for expected in (0, len(MADE)):
        with open_journal(tmp_path / NAME, SEARCHED) as journal:
            assert len(journal) == expected
            for each in MADE[expected:]:
                journal.add([each])
            assert [journal.find(each.values) for each in MADE] == MADE
            assert journal.find({"a": 4, "b": []}) is None


def test_the_order_of_keys_does_not_matter(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, SEARCHED) as journal:
        journal.add(MADE)
        assert journal.find({"b": [1.5, "x"], "a": 1}) == MADE[0]


def test_lines_are_only_added(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, SEARCHED) as journal:
        journal.add(MADE[:1])
        before = path.read_bytes()
        journal.add(MADE[1:])
    assert path.read_bytes().startswith(before)
    assert [set(json.loads(line)) for line in path.read_bytes().splitlines()] == [
        {"orishell", "design"},
        {"values", "figures"},
        {"values", "reason", "said", "excess"},
        {"values", "reason", "said"},
        {"values", "reason", "said", "excess"},
    ]


def test_a_fault_of_the_program_is_not_kept(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, SEARCHED) as journal:
        journal.add([Outcome({"a": 1}, {}, FAULT, "ZeroDivisionError"), MADE[0]])
        assert len(journal) == 2
    with open_journal(tmp_path / NAME, SEARCHED) as journal:
        assert len(journal) == 1


def test_a_journal_without_room_is_said(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, SEARCHED) as journal:
        journal.add(MADE[:1])
        limit = resource.getrlimit(resource.RLIMIT_FSIZE)
        before = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (path.stat().st_size + 9, limit[1]))
        try:
            with pytest.raises(InputError, match="the journal cannot be written") as error:
                journal.add(MADE[1:])
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limit)
            signal.signal(signal.SIGXFSZ, before)
    assert error.value.remedy.startswith("make room")
    with open_journal(path, SEARCHED) as journal:
        assert len(journal) == 1


def test_a_broken_last_line_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, SEARCHED) as journal:
        journal.add(MADE)
    whole = path.read_bytes()
    for cut in (1, 20, 40):
        path.write_bytes(whole[:-cut])
        with open_journal(path, SEARCHED) as journal:
            assert len(journal) == len(MADE) - 1
            journal.add(MADE[-1:])
        assert path.read_bytes() == whole


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b'{"orishell": "0", "design": "abc"}\n', "another version of orishell"),
        (b"no journal\n", NONE),
        (b"[1]\n", NONE),
        (b"no line", NONE),
        (b'{"note": "mine"}\n', NONE),
        (b'{"orishell": 1', NONE),
        (b"\0" * 9000, NONE),
    ],
)
@pytest.mark.parametrize("link", [False, True])
def test_what_is_no_journal_of_this_search_is_refused(
    tmp_path: Path, content: bytes, said: str, *, link: bool
) -> None:
    place = tmp_path / "notes" if link else tmp_path / NAME
    place.write_bytes(content)
    if link:
        (tmp_path / NAME).symlink_to(place)
    with (
        pytest.raises(InputError, match=said) as error,
        open_journal(tmp_path / NAME, SEARCHED),
    ):
        pass
    assert error.value.remedy.startswith("choose another directory")
    assert place.read_bytes() == content
    assert (tmp_path / NAME).is_symlink() == link


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    """A pipe is not waited for, and a link into nothing makes no file there."""
    path = tmp_path / NAME
    os.mkfifo(path)
    with pytest.raises(InputError, match=NONE), open_journal(path, SEARCHED):
        pass
    path.unlink()
    path.symlink_to(tmp_path / "nowhere")
    with (
        pytest.raises(InputError, match="the journal cannot be written"),
        open_journal(path, SEARCHED),
    ):
        pass
    path.unlink()
    path.symlink_to("/dev/null")
    with pytest.raises(InputError, match=NONE), open_journal(path, SEARCHED):
        pass
    path.unlink()
    path.mkdir()
    with pytest.raises(InputError), open_journal(path, SEARCHED):
        pass


def test_the_journal_of_another_design_is_refused(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, SEARCHED) as journal:
        journal.add(MADE)
    with (
        pytest.raises(InputError, match="the journal here is of a design or figures that differ"),
        open_journal(tmp_path / NAME, OTHER),
    ):
        pass


def test_a_bad_line_in_the_middle_is_said(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, SEARCHED) as journal:
        journal.add(MADE)
    lines = (tmp_path / NAME).read_bytes().splitlines(keepends=True)
    (tmp_path / NAME).write_bytes(b"".join([*lines[:2], b'{"valuse": 3}\n', *lines[2:]]))
    with (
        pytest.raises(InputError, match="line 3: this line of the journal cannot be read"),
        open_journal(tmp_path / NAME, SEARCHED),
    ):
        pass


def test_a_journal_to_which_nothing_came_leaves_nothing(tmp_path: Path) -> None:
    path = tmp_path / "new" / "out" / NAME
    with open_journal(path, SEARCHED):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_first_line_that_was_broken_off_is_written_again(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, SEARCHED) as journal:
        journal.add(MADE)
    whole = path.read_bytes()
    path.write_bytes(whole[:15])
    with open_journal(path, SEARCHED) as journal:
        journal.add(MADE)
    assert path.read_bytes() == whole


JUNK = [
    *("null", "true", "[]", "{}", '""', '"x"', "-1", "0", "1e999", "NaN", "-Infinity", "1" * 5000),
    *("1" + "0" * 400, "[" * 5000 + "]" * 5000, "[" * 100_000, '"\\ud800"', '"\\u0000\\u001b[2J"'),
]
"""What may stand in the place of a value."""


def mangled(whole: bytes, moments: random.Random) -> bytes:
    """A journal in which something was changed: bytes, lines, values, names of keys."""
    lines = whole.splitlines(keepends=True)
    at, line = moments.randrange(len(whole)), moments.randrange(len(lines))
    match moments.randrange(9):
        case 0:
            return whole[:at] + bytes([moments.randrange(256)]) + whole[at + 1 :]
        case 1:
            return whole[:at] + whole[at + moments.randrange(1, 40) :]
        case 2:
            return whole[:at] + moments.randbytes(moments.randrange(1, 40)) + whole[at:]
        case 3:
            moments.shuffle(lines)
        case 4:
            lines[line] = lines[moments.randrange(len(lines))]
        case 5 | 6 | 7:
            entry = json.loads(lines[line])
            table = moments.choice(
                [each for each in entry.values() if isinstance(each, dict)] or [entry]
            )
            table = moments.choice([table, entry])
            key = moments.choice([*table, "another"])
            table[key] = "JUNK"
            text = json.dumps(entry).replace('"JUNK"', moments.choice(JUNK))
            lines[line] = text.encode() + b"\n"
        case _:
            entry = json.loads(lines[line])
            key = moments.choice([*entry])
            lines[line] = json.dumps({**entry, key + "s": entry.pop(key)}).encode() + b"\n"
    return b"".join(lines)


class Quick:
    """A place where designs have figures at once, or cannot be made."""

    died: tuple[type[BaseException], ...] = ()

    def submit(self, _: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        """Panels by rows and columns; deep ones cannot be made."""
        future: Future[list[Any]] = Future()
        future.set_result([quickly(values) for values in chunk])
        return future

    def renew(self) -> None:
        """Nobody dies."""


def quickly(values: dict[str, Any]) -> Outcome:
    if values.get("pattern.depth", 0.0) > 0.1:
        return Outcome(values, {}, "too deep", "too deep: by a half", 0.5)
    return Outcome(values, {"panels": float(values.get("pattern.columns", 1))})


def test_a_mangled_journal_is_refused_in_one_line_or_does_no_harm(tmp_path: Path) -> None:
    """What is refused stays as it is; otherwise the search comes to its end."""
    path = tmp_path / NAME
    pool = WorkerPool([Quick()])

    def searched() -> str:
        try:
            with open_journal(path, SEARCHED) as journal:
                return "" if search_designs(SEARCHED, pool, journal).whole else "not whole"
        except OrishellError as error:
            return str(error)

    assert searched() == ""
    whole = path.read_bytes()
    said = []
    for seed in range(800 if THOROUGH else 200):
        content = mangled(whole, random.Random(seed))
        path.write_bytes(content)
        said.append(searched())
        assert not said[-1] or path.read_bytes() == content
    refused = [each for each in said if each]
    assert 100 < len(refused) < len(said)
    assert all(each.startswith(str(path)) and "\n" not in each for each in refused)
