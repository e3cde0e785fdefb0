"""The built pages as they are served: text compressed, files of hashed names kept for ever."""

from __future__ import annotations

from typing import Any, Final

from fastapi import Response
from fastapi.staticfiles import StaticFiles
from starlette.middleware.gzip import GZipMiddleware
from starlette.types import Receive, Scope, Send

HASHED: Final = "assets/"
"""Where files are whose names change with their content."""
PLAIN: Final = {"/api/verify", "/api/tradeoff", "/api/sheets", "/api/design", "/api/export"}
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
