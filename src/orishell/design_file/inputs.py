"""The files that a design is read from."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any


def input_files(path: Path, tables: Any) -> tuple[Path, ...]:
    """A design file, and every file that is named anywhere in its tables.

    Each text in them that is the name of a file counts, whatever its key: so no key is forgotten.
    """
    named = (path.parent / text for text in dict.fromkeys(_texts(tables)))
    return (path, *(file for file in named if os.path.isfile(file)))


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict | list):
        for each in value.values() if isinstance(value, dict) else value:
            yield from _texts(each)
