"""The studio's server: pages and answers, on this machine, to this machine."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator, Collection
from contextlib import aclosing, asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, StreamingResponse
from fastapi.staticfiles import StaticFiles
from starlette.exceptions import HTTPException

from orishell._version import __version__
from orishell.io.registry import FORMATS
from orishell.studio.guard import Guard
from orishell.studio.knobs import describe_examples, describe_families
from orishell.studio.tasks import MAX_VERTICES
from orishell.studio.workers import (
    BusyError,
    FaultError,
    OutOfTimeError,
    Pool,
    RefusalError,
)
from orishell.units import MILLIMETRES

PAGES = Path(__file__).parent / "static"
"""Where the front end is, once it is built."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What the studio takes.

    Parameters
    ----------
    bytes
        Size of a request.
    quick, slow
        Seconds that a design, and that a proof or a file may take.
    receiving
        Seconds in which a request must have come in.
    processes
        Processes for each of both.
    """

    bytes: int = 5_000_000
    quick: float = 20.0
    slow: float = 120.0
    receiving: float = 30.0
    processes: int = 2


LIMITS = Limits()
CLIENT_CLOSED = 499
DEEPEST = 16
"""Tables and lists within each other in a request, at most; a design has five."""


def make_app(
    hosts: Collection[str] | None = None,
    limits: Limits = LIMITS,
    start: dict[str, Any] | None = None,
) -> Guard:
    """The server.

    Parameters
    ----------
    hosts
        Host headers that are taken; None takes all.
    limits
        What it takes.
    start
        Name and tables of the design to begin with.
    """
    quick = Pool(limits.processes, limits.quick)
    slow = Pool(limits.processes, limits.slow)

    @asynccontextmanager
    async def life(_: FastAPI) -> AsyncIterator[None]:
        yield
        quick.close()
        slow.close()

    app = FastAPI(lifespan=life, docs_url=None, redoc_url=None, openapi_url=None)
    _handle_errors(app)

    @app.get("/api/info")
    def info() -> dict[str, Any]:
        return {
            "version": __version__,
            "units": list(MILLIMETRES),
            "families": describe_families(),
            "examples": describe_examples(),
            "formats": [
                {"name": each.name, "file": each.file, "what": each.what} for each in FORMATS
            ],
            "limits": {"vertices": MAX_VERTICES, "bytes": limits.bytes, "seconds": limits.quick},
            "start": start,
        }

    @app.post("/api/design")
    async def design(request: Request) -> Response:
        view = await _run(quick, "design", request)
        return Response(view, media_type="application/octet-stream")

    @app.post("/api/export")
    async def export(request: Request) -> Response:
        name, content = await _run(slow, "export", request)
        headers = {"content-disposition": f'attachment; filename="{name}"'}
        return Response(content, media_type="application/octet-stream", headers=headers)

    @app.post("/api/verify")
    async def verify(request: Request) -> Response:
        payload = await _payload(request)
        return StreamingResponse(_lines(slow, "verify", payload), media_type="application/x-ndjson")

    for task, pool in (("ranges", slow), ("parse", quick), ("format", quick), ("curve", quick)):
        _add_task(app, task, pool)

    if PAGES.is_dir():
        app.mount("/", StaticFiles(directory=PAGES, html=True))
    return Guard(app, hosts, limits.bytes, limits.receiving)


def _add_task(app: FastAPI, task: str, pool: Pool) -> None:
    @app.post(f"/api/{task}")
    async def answer(request: Request) -> Any:
        return await _run(pool, task, request)


async def _run(pool: Pool, task: str, request: Request) -> Any:
    """The result of a task, which is stopped if nobody waits for it any longer.

    Raises
    ------
    HTTPException
        If the client went away: nobody reads that answer.
    """
    work = asyncio.create_task(pool.run(task, await _payload(request)))
    gone = asyncio.create_task(_gone(request))
    try:
        await asyncio.wait({work, gone}, return_when=asyncio.FIRST_COMPLETED)
        if not work.done():
            raise HTTPException(CLIENT_CLOSED, "nobody waits for it")
        return await work
    finally:
        work.cancel()
        gone.cancel()


async def _gone(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass


async def _payload(request: Request) -> dict[str, Any]:
    # In a thread: large ones would hold up everybody else.
    return await asyncio.to_thread(_parsed, await request.body())


def _parsed(body: bytes) -> dict[str, Any]:
    """The object in a body: strict JSON (finite numbers, sound Unicode), not too deep."""
    import orjson

    try:
        payload = orjson.loads(body)
    except ValueError as error:
        raise RequestValidationError([str(error)]) from None
    if not isinstance(payload, dict):
        raise RequestValidationError(["an object is expected"])
    level: list[Any] = [payload]
    for _ in range(DEEPEST):
        level = [
            inner
            for each in level
            if isinstance(each, dict | list)
            for inner in (each.values() if isinstance(each, dict) else each)
        ]
        if not level:
            return payload
    raise RequestValidationError([f"more than {DEEPEST} tables or lists within each other"])


async def _lines(pool: Pool, task: str, payload: dict[str, Any]) -> AsyncIterator[str]:
    """Progress, then the result or what is wrong, a line of JSON each."""
    try:
        # Closed with the response, so that its process stops when the page is gone.
        async with aclosing(pool.stream(task, payload)) as stream:
            async for kind, value in stream:
                if kind == "progress":
                    share, what = value
                    yield json.dumps({"progress": share, "what": what}) + "\n"
                else:
                    yield json.dumps({"result": value}) + "\n"
    except (RefusalError, OutOfTimeError, BusyError, FaultError) as error:
        yield json.dumps(_describe(error)[1]) + "\n"


def _describe(error: Exception) -> tuple[int, dict[str, Any]]:
    """Status and body of the answer to a request that failed."""
    match error:
        case RefusalError():
            return 422, error.error
        case OutOfTimeError():
            return 504, _body(
                "time",
                f"this takes longer than the {error} s that the studio waits: "
                "try fewer panels, or the command line",
            )
        case BusyError():
            return 503, _body("limit", "too many requests are waiting: try again in a moment")
        case RequestValidationError():
            return 400, _body("input", f"the request is not JSON as expected: {error.errors()[0]}")
        case HTTPException():
            return error.status_code, _body("input", f"this is not served: {error.detail}")
        case _:
            return 500, _body("fault", f"a fault of the program, please report it: {error}")


def _body(kind: str, message: str) -> dict[str, Any]:
    return {"error": {"kind": kind, "what": message, "message": message}}


def _handle_errors(app: FastAPI) -> None:
    async def answer(_: Request, error: Exception) -> JSONResponse:
        status, body = _describe(error)
        return JSONResponse(body, status)

    known = (RefusalError, OutOfTimeError, BusyError, FaultError)
    for kind in (*known, RequestValidationError, HTTPException):
        app.add_exception_handler(kind, answer)
