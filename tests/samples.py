"""What only ``make thorough`` runs: what takes long and rarely fails, and most random examples.

``make test`` keeps a quick member of each kind, and an eighth of the examples, or fewer where they
are dear. Hypothesis draws fewer of them, not the first ones of all: an eighth that passes says
nothing of the rest, so ``make thorough`` before a release, and after a change of the core.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

import pytest

THOROUGH = os.environ.get("ORISHELL_THOROUGH") == "1"
LEAST = 6
LEFT_OUT = "only make thorough runs it"

thorough = pytest.mark.skipif(not THOROUGH, reason=LEFT_OUT)
"""Decorates a test, or marks a parameter, whose kind has a quicker member."""


def examples(count: int) -> int:
    """Of so many in all."""
    return count if THOROUGH else min(count, max(count // 8, LEAST))


def led_by(values: Iterable[Any], count: int = 1) -> list[Any]:
    """Parameters of a test: the first few run always, the others only in ``make thorough``."""
    return [
        value if number < count else pytest.param(*as_tuple(value), marks=thorough)
        for number, value in enumerate(values)
    ]


def as_tuple(value: Any) -> tuple[Any, ...]:
    return value if isinstance(value, tuple) else (value,)
