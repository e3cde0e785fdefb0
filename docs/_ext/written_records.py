"""Has records written at once, so that autodoc finds the ``__init__`` of each with its kinds.

A command makes records of few kinds, and writes each when its first is made
(``orishell.conventions.record``). Import this before any module that has records.
"""

from __future__ import annotations

from typing import Any, TypeVar

from orishell.conventions import record as of_records

T = TypeVar("T")
_when_needed = of_records.record


def _at_once(kind: type[T]) -> type[T]:
    made: Any = _when_needed(kind)
    made.__init__ = of_records._initialiser(made)
    del made.__signature__
    return made


of_records.record = _at_once
