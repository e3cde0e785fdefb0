"""What took long to find is kept by what it was found for, so that it is not sought twice."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")


class Memory:
    """The latest findings by their keys; each can be sent to another process.

    Parameters
    ----------
    most
        So many are kept.
    """

    def __init__(self, most: int = 48) -> None:
        self._most = most
        self._found: dict[str, Any] = {}

    def recall(self, key: str, find: Callable[[], T]) -> T:
        """What is known for a key, or else is found."""
        if key not in self._found:
            self.learn({key: find()})
        found: T = self._found[key]
        return found

    def learn(self, findings: Mapping[str, Any]) -> None:
        """Keep findings of another process, too."""
        for key, each in findings.items():
            self._found.pop(key, None)
            self._found[key] = each
        for key in list(self._found)[: -self._most]:
            del self._found[key]

    def all(self) -> dict[str, Any]:
        """Everything that is known, the latest last."""
        return dict(self._found)


MEMORY = Memory()
"""That of this process."""


def key_of(name: str, *parts: Any, arrays: Iterable[Any] = ()) -> str:
    """A key that differs where a name, parts with a ``repr`` of all their digits, or arrays do."""
    digest = hashlib.blake2b(digest_size=16)
    digest.update(repr((name, *parts)).encode())
    for array in arrays:
        digest.update(repr((array.dtype.str, array.shape)).encode())
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
