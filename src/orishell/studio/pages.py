"""What the studio serves: built pages, archives, and names of designs."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

from fastapi import Response
from fastapi.staticfiles import StaticFiles
from starlette.middleware.gzip import GZipMiddleware
from starlette.types import Receive, Scope, Send

from orishell.studio.api import NAME

LONGEST_NAME = 200
"""Bytes of a name; files and their endings may have 255."""


def design_name(said: str) -> str:
    """What a design is called, in letters that every system has in names of files."""
    kept = "".join(each if each.isalnum() or each in "-_" else " " for each in said)
    short = " ".join(kept.split()).encode()[:LONGEST_NAME].decode("utf-8", "ignore")
    return short.strip() or NAME


def file_name(file: str, name: str) -> str:
    """A file of the command line's with the name of its design, as in pattern.dxf, panels.csv."""
    for stem in ("shell", "pattern"):
        if file.startswith(stem):
            return name + file.removeprefix(stem)
    return f"{name}-{file}"


ZIP_DATE = (1980, 1, 1, 0, 0, 0)


def zipped(files: Mapping[str, Path]) -> bytes:
    """A zip archive of files by their names in it, the same bytes at any time."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as packed:
        for name, path in files.items():
            packed.writestr(
                zipfile.ZipInfo(name, ZIP_DATE), path.read_bytes(), zipfile.ZIP_DEFLATED
            )
    return archive.getvalue()


HASHED: Final = "assets/"
"""Where files are whose names change with their content."""
PLAIN: Final = {
    "/api/verify",
    "/api/tradeoff",
    "/api/sheets",
    "/api/booklet",
    "/api/design",
    "/api/export",
}
"""Answers that are not compressed: lines that would wait for each other, numbers that would not
become smaller."""
LEVEL: Final = 6


class Pages(StaticFiles):
    """The front end's files; a browser asks again only for those whose names stay."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The answer to a request for a file."""
        answer = await super().get_response(path, scope)
        kept = path.replace("\\", "/").startswith(HASHED) and answer.status_code in (200, 304)
        answer.headers["cache-control"] = (
            "public, max-age=31536000, immutable" if kept else "no-cache"
        )
        return answer


class Compressed(GZipMiddleware):
    """Compresses pages and JSON for browsers that take it."""

    def __init__(self, app: Any) -> None:
        super().__init__(app, compresslevel=LEVEL)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request."""
        answer = self.app if scope.get("path") in PLAIN else super().__call__
        await answer(scope, receive, send)
