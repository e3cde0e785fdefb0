"""Times that hold on every machine, and beside whatever else it does.

A test waits for an event; or it compares with another time of the same run, with room for ten; or
it asks whether something hangs, for which a minute is the bound. It knows no other clock.
"""

from __future__ import annotations

import time
from collections.abc import Callable

HANGS = 60.0
"""What takes so long hangs (seconds)."""
ROOM = 10.0
"""By this a time may differ from what another one of the same run lets expect."""


def seconds(work: Callable[[], object], times: int = 3) -> float:
    """The processor time of work, the least of several."""
    taken = []
    for _ in range(times):
        begin = time.process_time()
        work()
        taken.append(time.process_time() - begin)
    return min(taken)
