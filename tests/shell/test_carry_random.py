"""Random shelters, canopies and domes that fail: what is found carries, or what was tried is said.

What is offered is typed into the file and made anew, contact on the way included.
"""

from __future__ import annotations

import time
from itertools import count

import pytest

from failing_shells import failing_file
from orishell.conventions.errors import OrishellError
from orishell.design_file import DesignFile
from orishell.shell.carry import OFFERED, find_carrying
from orishell.shell.carry_found import CarrySearch
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from samples import led_by

SHELLS, QUICK = 20, 0  # one of an arch: tests/shell/test_carry.py
SECONDS, PANELS = 180.0, 170
"""Processor time that a search may take for so many panels."""
Told = list[tuple[float, str]]


def searched(number: int) -> tuple[DesignFile, CarrySearch, Told, float]:
    """One of the random shells, drawn again where there is none, or where it carries."""
    for seed in count(number, 100):
        told: Told = []
        begun = time.process_time()
        try:
            file = failing_file(seed)
            found = find_carrying(file, lambda share, what: told.append((share, what)))  # noqa: B023
        except OrishellError:
            continue
        if not found.carries:
            return file, found, told, time.process_time() - begun
    raise AssertionError


@pytest.mark.slow
@pytest.mark.parametrize("number", led_by([6, 0, *range(1, 6), *range(7, SHELLS)], QUICK))
def test_what_is_found_carries_or_what_was_tried_is_said(number: int) -> None:
    file, search, told, seconds = searched(number)
    assert seconds < SECONDS * max(1.0, file.panel_count / PANELS)
    # Nothing ends in silence; each trial is told of before it begins, but what is refused unread.
    assert search.tried
    assert all(": " in each for each in search.tried)
    assert bool(search.found) != bool(search.near)
    names = {what.removeprefix("trying ") for _, what in told}
    aside = (": cannot be made", " is not given: ")
    made = [each for each in search.tried if not any(words in each for words in aside)]
    assert all(any(each.startswith(f"{name}: ") for name in names) for each in made)
    assert [share for share, _ in told] == sorted(share for share, _ in told)
    assert len(search.found) <= OFFERED
    skip = ("remedies", "verification", "stock", *MEASURES)
    for each in search.found:
        shell = make_shell(file.changed(each.changes), skip=skip)
        assert shell.analysis is not None
        assert shell.analysis.carries is True, each.words
        assert shell.analysis.model.mass == pytest.approx(each.mass or 0.0)
        assert shell.analysis.governing_in_words().startswith(each.governs)
