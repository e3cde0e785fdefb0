"""Searches by ``orishell search`` as processes of their own, which tests stop and kill."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

from orishell.design_file import starter_file
from orishell.search.journal import NAME
from viewer_pages import require_viewer

SEARCH = """
[search]
minimise = ["panels", "sheet_area"]
population = 5
evaluations = 20
seed = 5

[search.variables]
pattern.rows = [3, 5]
pattern.columns = { low = 3, high = 4 }
pattern.xi_deg = { low = 35, high = 60 }
"""


def design(directory: Path) -> Path:
    """A design file with a search of 20 small shells."""
    path = directory / "small.toml"
    text = starter_file("parallel-repeating").replace("frames = 25", "frames = 2")
    path.write_text(text + SEARCH, encoding="utf-8")
    return path


def searching(file: Path, out: Path, *options: str) -> subprocess.Popen[str]:
    """A search that runs; it would not begin without its page."""
    require_viewer()
    # As in a terminal: what is started in the background is not told of Ctrl-C.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        return subprocess.Popen(
            [sys.executable, "-m", "orishell", "search", str(file), "--out", str(out), *options],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
    finally:
        signal.signal(signal.SIGINT, before)


def searched(file: Path, out: Path, *options: str) -> str:
    """What a search prints that comes to its end."""
    printed, errors = searching(file, out, *options).communicate(timeout=300)
    assert printed, errors
    return printed


def written(out: Path) -> dict[str, bytes]:
    """The files of a search, but the journal, whose lines come as designs are ready."""
    return {path.name: path.read_bytes() for path in out.iterdir() if path.name != NAME}


def lines(out: Path) -> int:
    """Lines of the journal."""
    path = out / NAME
    return path.read_bytes().count(b"\n") if path.exists() else 0


def wait_for_lines(running: subprocess.Popen[str], out: Path, count: int) -> None:
    """Wait until the journal has so many lines, or the search has ended."""
    end = time.monotonic() + 120
    while lines(out) < count and running.poll() is None:
        assert time.monotonic() < end
        time.sleep(0.01)
