"""How many random examples: a quarter in ``make test``, all in ``make thorough``.

Examples are the same in every run, and the quarter is the first of all.
"""

from __future__ import annotations

import os

THOROUGH = os.environ.get("ORISHELL_THOROUGH") == "1"
LEAST = 10


def examples(count: int) -> int:
    """Of so many in all."""
    return count if THOROUGH else min(count, max(count // 4, LEAST))
