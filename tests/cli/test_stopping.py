"""The command line is told to stop, or killed, at moments that Python's audit hooks report."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from orishell.cli.main import run
from samples import led_by

EXAMPLE = Path(__file__).parents[2] / "examples" / "figure1.toml"
SCRIPT = """
import os, signal, sys

event, place, count, number, *arguments = sys.argv[1:]
left = int(count)
# As in a terminal: what is started in the background is not told of Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)

def hook(name, values):
    global left
    if name == event and place in str(values):
        left -= 1
        if left == 0:
            os.kill(os.getpid(), signal.Signals[number])

sys.argv = ["orishell", *arguments]
from orishell.__main__ import main
sys.addaudithook(hook)
main()
"""


def stopped(
    number: str, count: int, event: str, place: str, cwd: Path
) -> subprocess.CompletedProcess[str]:
    """Design a shell, and get a signal the so manieth time that an event names a place."""
    arguments = [event, place, str(count), number, "design", str(EXAMPLE), "--out", "out"]
    return subprocess.run(
        [sys.executable, "-c", SCRIPT, *arguments, "--no-clash-test"],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


@pytest.mark.parametrize("count", [1, 10, 50, 100, 250])
def test_ctrl_c_during_imports(count: int, tmp_path: Path) -> None:
    done = stopped("SIGINT", count, "import", "", tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("number", "status"), led_by([("SIGINT", 130), ("SIGTERM", 143)]))
def test_stopped_while_files_are_written(number: str, status: int, tmp_path: Path) -> None:
    done = stopped(number, 1, "open", "overview.png", tmp_path)
    assert (done.returncode, done.stdout) == (status, "")
    said = done.stderr.splitlines()  # of the design, before its files are written
    assert all(line.startswith("orishell: warning: ") for line in said), done.stderr
    assert not list(tmp_path.iterdir())


def test_check_says_when_files_are_of_two_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    done = stopped("SIGKILL", 3, "os.rename", "out", tmp_path)
    assert done.returncode == -9
    for path in ("out", "out/shell.fold"):
        monkeypatch.setattr(sys, "argv", ["orishell", "check", str(tmp_path / path)])
        with pytest.raises(SystemExit) as ended:
            run()
        assert ended.value.code == 2
        said = capsys.readouterr().err
        assert re.search(r"broken off .* got 1 of 4 files .* run the same command again", said)
