"""Answers that were given are kept: what is undone or opened again is there at once, proof and all.

An answer depends on its request alone, which holds the whole design.
"""

from __future__ import annotations

import hashlib

MOST_BYTES = 64_000_000
"""Bytes of answers that are kept, the latest."""


class Kept:
    """The latest answers by what was asked.

    Parameters
    ----------
    most
        So many bytes are kept.
    """

    def __init__(self, most: int = MOST_BYTES) -> None:
        self._most = most
        self._size = 0
        self._answers: dict[bytes, bytes] = {}

    def find(self, task: str, body: bytes) -> bytes | None:
        """The answer that a request was given before, if it is still kept."""
        return self._answers.get(_key(task, body))

    def keep(self, task: str, body: bytes, answer: bytes) -> None:
        """Keep the answer that a request was given; the oldest make room for it."""
        key = _key(task, body)
        self._size += len(answer) - len(self._answers.pop(key, b""))
        self._answers[key] = answer
        while self._size > self._most:
            oldest = next(iter(self._answers))
            self._size -= len(self._answers.pop(oldest))


def _key(task: str, body: bytes) -> bytes:
    """What tells a request from others; bodies may be of many megabytes."""
    return hashlib.blake2b(body, digest_size=16, person=task.encode()).digest()
