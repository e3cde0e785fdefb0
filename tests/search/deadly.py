"""Work for processes that one item kills."""

from __future__ import annotations

import os
import signal
from collections.abc import Sequence

DEADLY = 7


def doubled(chunk: Sequence[int]) -> list[int]:
    """Twice each number; the process dies at one of them."""
    if DEADLY in chunk:
        os.kill(os.getpid(), signal.SIGKILL)
    return [2 * each for each in chunk]


def process(_: Sequence[int]) -> list[int]:
    """The number of the process that does the work."""
    return [os.getpid()]
