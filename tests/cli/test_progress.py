"""The bar of commands that take long: on a terminal only, and only after a while."""

from __future__ import annotations

import sys

import pytest

from orishell.cli import files as progress
from orishell.conventions.progress import no_progress


def test_nothing_is_shown_where_there_is_no_terminal() -> None:
    with progress.bar() as told:
        assert told is no_progress


@pytest.mark.parametrize(("wait", "shown"), [(-1.0, True), (60.0, False)])
def test_what_takes_long_is_named_one_after_the_other(
    wait: float, shown: bool, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(progress, "WAIT", wait)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    with progress.bar() as told:
        for what in ("looking for contact", "verifying", "verifying"):
            for share in (0.0, 0.5, 1.0):
                told(share, what)
    out, err = capsys.readouterr()
    assert not out
    assert all((what in err) == shown for what in ("looking for contact", "verifying"))
