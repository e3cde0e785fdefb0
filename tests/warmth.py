"""Work for a pool of processes that says how warm they are: a module, so that they find it."""

from __future__ import annotations

import os
import threading
from typing import Any

from orishell.conventions.progress import Progress

done: list[str] = []
"""The tasks that this process was given."""


def notes_warmth(name: str, _: dict[str, Any], progress: Progress) -> tuple[int, bool]:
    """Work that says in which process it is done, and whether that has warmed up before."""
    done.append(name)
    if name == "stay":
        progress(0.0, "staying")
        threading.Event().wait()
    return os.getpid(), done[0] == "warm_up" and done[-1] != done[0]
