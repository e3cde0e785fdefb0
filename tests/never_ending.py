"""Answers of the studio, and one that never comes: a module, so that processes find it."""

from __future__ import annotations

import threading
from typing import Any

from orishell.conventions.progress import Progress
from orishell.studio.tasks import answer


def answer_or_never(name: str, payload: dict[str, Any], progress: Progress, send: Any) -> Any:
    """The answer to a request; to "never" none, but that it is under way."""
    if name == "never":
        progress(0.5, "under way")
        threading.Event().wait()
    return answer(name, payload, progress, send)
