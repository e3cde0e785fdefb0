"""Coroutines beside the browser of the tests, whose event loop has the main thread."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

Found = TypeVar("Found")


def run_apart(scene: Coroutine[Any, Any, Found]) -> Found:
    """Run a coroutine in a thread of its own to its end; return what it returns."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(asyncio.run, scene).result()
