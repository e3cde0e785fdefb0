"""The journal keeps every design that was made, of one design file, and says what it is not."""

from __future__ import annotations

import json
import resource
import signal
from pathlib import Path

import pytest

from orishell.errors import InputError
from orishell.search.evaluate import FAULT, Outcome
from orishell.search.journal import NAME, open_journal

MADE = [
    Outcome({"a": 1, "b": [1.5, "x"]}, {"mass": 0.1 + 0.2}),
    Outcome({"a": 2, "b": [1.5, "x"]}, {}, "no", "no, because", 0.25),
    Outcome({"a": 3, "b": [1.5, "x"]}, {}, "no", "no, because"),
    Outcome({"a": 5, "b": [1.5, "x"]}, {}, "no", "no, because", 0.0),
]


def test_what_was_written_is_found_again(tmp_path: Path) -> None:
    for expected in (0, len(MADE)):
        with open_journal(tmp_path / NAME, "abc") as journal:
            assert len(journal) == expected
            for each in MADE[expected:]:
                journal.add([each])
            assert [journal.find(each.values) for each in MADE] == MADE
            assert journal.find({"a": 4, "b": []}) is None


def test_the_order_of_keys_does_not_matter(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, "abc") as journal:
        journal.add(MADE)
        assert journal.find({"b": [1.5, "x"], "a": 1}) == MADE[0]


def test_lines_are_only_added(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, "abc") as journal:
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
    with open_journal(tmp_path / NAME, "abc") as journal:
        journal.add([Outcome({"a": 1}, {}, FAULT, "ZeroDivisionError"), MADE[0]])
        assert len(journal) == 2
    with open_journal(tmp_path / NAME, "abc") as journal:
        assert len(journal) == 1


def test_a_journal_without_room_is_said(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, "abc") as journal:
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
    with open_journal(path, "abc") as journal:
        assert len(journal) == 1


def test_a_broken_last_line_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, "abc") as journal:
        journal.add(MADE)
    whole = path.read_bytes()
    for cut in (1, 20, 40):
        path.write_bytes(whole[:-cut])
        with open_journal(path, "abc") as journal:
            assert len(journal) == len(MADE) - 1
            journal.add(MADE[-1:])
        assert path.read_bytes() == whole


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b'{"orishell": "0", "design": "abc"}\n', "another version of orishell"),
        (b"no journal\n", "line 1: this is not the journal of a search"),
        (b"[1]\n", "line 1: this is not the journal of a search"),
    ],
)
def test_what_is_no_journal_of_this_search_is_refused(
    tmp_path: Path, content: bytes, said: str
) -> None:
    (tmp_path / NAME).write_bytes(content)
    with (
        pytest.raises(InputError, match=said) as error,
        open_journal(tmp_path / NAME, "abc"),
    ):
        pass
    assert error.value.remedy.startswith("choose another directory")
    assert (tmp_path / NAME).read_bytes() == content


def test_the_journal_of_another_design_is_refused(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, "abc") as journal:
        journal.add(MADE)
    with (
        pytest.raises(InputError, match="the journal here is of a design or figures that differ"),
        open_journal(tmp_path / NAME, "abd"),
    ):
        pass


def test_a_bad_line_in_the_middle_is_said(tmp_path: Path) -> None:
    with open_journal(tmp_path / NAME, "abc") as journal:
        journal.add(MADE)
    lines = (tmp_path / NAME).read_bytes().splitlines(keepends=True)
    (tmp_path / NAME).write_bytes(b"".join([*lines[:2], b'{"valuse": 3}\n', *lines[2:]]))
    with (
        pytest.raises(InputError, match="line 3: this is not the journal"),
        open_journal(tmp_path / NAME, "abc"),
    ):
        pass


def test_a_journal_to_which_nothing_came_leaves_nothing(tmp_path: Path) -> None:
    path = tmp_path / "new" / "out" / NAME
    with open_journal(path, "abc"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_a_first_line_that_was_broken_off_is_written_again(tmp_path: Path) -> None:
    path = tmp_path / NAME
    with open_journal(path, "abc") as journal:
        journal.add(MADE)
    whole = path.read_bytes()
    path.write_bytes(whole[:15])
    with open_journal(path, "abc") as journal:
        journal.add(MADE)
    assert path.read_bytes() == whole
