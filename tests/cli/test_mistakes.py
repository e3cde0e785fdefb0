"""Mistakes of people who begin: the first message is enough to go on, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import orishell
from mistakes import OURS, THEIRS, Mistake

MISTAKES = OURS | THEIRS
SLOW = ("a tolerance that nothing meets",)


def test_there_are_sixty() -> None:
    assert len(OURS) == len(THEIRS) == 30
    assert len(MISTAKES) == 60


@pytest.mark.parametrize(
    "mistake",
    [
        pytest.param(mistake, id=name, marks=[pytest.mark.slow] * (name in SLOW))
        for name, mistake in MISTAKES.items()
    ],
)
def test_the_first_message_is_enough_to_go_on(mistake: Mistake, tmp_path: Path) -> None:
    files = {"shell.toml": mistake.text.encode(mistake.encoding)}
    files |= {name: text.encode() for name, text in mistake.beside.items()}
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    done = orishell(*mistake.command, cwd=tmp_path)
    assert done.returncode == mistake.status
    assert done.stdout == ""
    said = done.stderr.split("\nshell.toml: ")[0]  # further faults of the file begin a line
    for words in mistake.says:
        assert words in said
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == files
