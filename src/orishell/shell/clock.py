"""Time that the steps of the work take."""

from __future__ import annotations

import time


class Clock:
    """A clock that takes the time of every step of the work."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._last = time.perf_counter()

    def lap(self, step: str) -> None:
        """Note the time since the last step was done."""
        now = time.perf_counter()
        self.seconds[step] = now - self._last
        self._last = now
