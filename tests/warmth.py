"""Work for a pool of processes that says how warm they are: a module, so that they find it."""

from __future__ import annotations

import os
import sys
import threading
from typing import Any

from orishell.conventions.progress import Progress

warm = "orishell.studio.warm" in sys.modules
"""Whether the process had imported what answers need when it began."""


def notes_warmth(
    name: str, _payload: dict[str, Any], progress: Progress, _send: object
) -> tuple[int, bool]:
    """Work that says in which process it is done, and whether that was warm from the first."""
    if name == "stay":
        progress(float(os.getpid()), "warm" if warm else "cold")
        threading.Event().wait()
    return os.getpid(), warm
