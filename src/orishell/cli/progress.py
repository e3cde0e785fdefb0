"""The progress bar of a command, on standard error."""

from __future__ import annotations

import contextlib
import sys
import time
from collections.abc import Iterator

from orishell.conventions.progress import Progress, no_progress

WAIT = 1.0
"""Work that takes less time than this shows no bar (seconds)."""


@contextlib.contextmanager
def bar() -> Iterator[Progress]:
    """A progress bar on a terminal, for whatever takes longer than a second."""
    if not sys.stderr.isatty():
        yield no_progress
        return
    from rich.console import Console
    from rich.progress import Progress as Bars

    bars = Bars(console=Console(stderr=True), transient=True)
    task = bars.add_task("", total=1.0)
    begin: dict[str, float] = {}

    def progress(share: float, what: str) -> None:
        begin.setdefault(what, time.monotonic())
        if time.monotonic() - begin[what] > WAIT and not bars.live.is_started:
            bars.start()
        bars.update(task, completed=share, description=what)
        if share == 1.0:
            begin.pop(what)
            bars.stop()

    try:
        yield progress
    finally:
        bars.stop()
