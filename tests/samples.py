"""How many random examples: a quarter in ``make test``, all in ``make thorough``.

Hypothesis draws fewer examples, not the first ones of all: a quarter that passes says nothing of
the rest, so ``make thorough`` before a release, and after a change of the core.
"""

from __future__ import annotations

import os

THOROUGH = os.environ.get("ORISHELL_THOROUGH") == "1"
LEAST = 10


def examples(count: int) -> int:
    """Of so many in all."""
    return count if THOROUGH else min(count, max(count // 4, LEAST))
