"""Where each worker begins to read the tests, so that no two compile the same file.

Pytest rewrites the assertions of a file when it is first imported, and keeps the result beside it.
In a fresh clone that takes longer than all else there is to read. Workers that read in the same
order would all do it at the same time; if each begins elsewhere, it is done once.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

import pytest

TESTS = Path(__file__).parent


def read_apart(config: pytest.Config) -> None:
    """A worker that is to read all tests reads them file by file, from its own place on."""
    count = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    number = os.environ.get("PYTEST_XDIST_WORKER", "gw0").removeprefix("gw")
    whole = next((each for each in config.args if Path(each).resolve() == TESTS), None)
    if count > 1 and number.isdigit() and whole is not None:
        files = sorted(TESTS.rglob("test_*.py"))
        first = len(files) * int(number) // count
        at = config.args.index(whole)
        config.args[at : at + 1] = map(str, files[first:] + files[:first])


def in_one_order(items: Iterable[pytest.Item]) -> list[pytest.Item]:
    """By their files, as xdist expects of all workers; in a file as they were read."""
    return sorted(items, key=lambda item: str(item.path))
