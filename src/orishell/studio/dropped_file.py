"""Files that are dropped onto the page, as long as they are read."""

from __future__ import annotations

import base64
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path

from orishell.conventions.errors import InputError
from orishell.io.output import scratch


@contextmanager
def dropped_file(name: str, content: str, endings: Collection[str], what: str) -> Iterator[Path]:
    """Hold a file by its content, which is in base64; errors name it as the page does.

    Raises InputError if it has none of the endings of ``what``, or no such content.
    """
    ending = Path(name).suffix.lower()
    if ending not in endings:
        expected = ", ".join(endings)
        raise InputError(f"this is not a file of {what}", where=name, got=ending, expected=expected)
    try:
        data = base64.b64decode(content, validate=True)
    except ValueError:
        raise InputError("the content is not base64", where=name) from None
    with scratch() as directory:
        path = directory / f"dropped{ending}"
        path.write_bytes(data)
        try:
            yield path
        except InputError as error:
            for field, text in vars(error).items():
                if isinstance(text, str):
                    setattr(error, field, text.replace(str(path), name))
            raise
