"""The studio's web server: it serves the pages and answers their requests."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncGenerator, AsyncIterator, Collection, Mapping
from contextlib import aclosing, asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, StreamingResponse
from starlette.exceptions import HTTPException

from orishell.conventions.memory import Memory
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.version import __version__
from orishell.studio.api import Refusal
from orishell.studio.guard import Guard, Key
from orishell.studio.info import Info, NamedDesign
from orishell.studio.kept import Kept
from orishell.studio.labels import (
    describe_examples,
    describe_families,
    describe_formats,
    describe_materials,
    describe_tables,
    describe_tasks,
    describe_workshop,
)
from orishell.studio.pages import Compressed, Pages
from orishell.studio.processes import MAX_VERTICES, prepared_copies
from orishell.studio.refusals import RefusalError, make_refusal
from orishell.studio.searches import describe_search
from orishell.studio.tasks import answer
from orishell.studio.workers import BusyError, FaultError, OutOfTimeError, Pool

PAGES = Path(__file__).parent / "static"
"""Where the front end is, once it is built."""


@dataclass(frozen=True, slots=True)
class Limits:
    """The largest request that the studio accepts, and how long one may take."""

    bytes: int = 20_000_000
    # seconds that a design, that a proof or a file, and that a search may take
    quick: float = 20.0
    slow: float = 120.0
    search: float = 3600.0
    receiving: float = 30.0  # seconds in which a request must have come in
    processes: int = 2  # for each of the three


LIMITS = Limits()
CLIENT_CLOSED = 499
FAILURES = (RefusalError, OutOfTimeError, BusyError, FaultError)
"""Errors with which a task may end."""
DEEPEST = 16
"""Depth of nested tables and lists in a request, at most; a design needs five."""


def make_app(
    key: Key,
    hosts: Collection[str] | None = None,
    limits: Limits = LIMITS,
    start: NamedDesign | None = None,
) -> Guard:
    """The web server of the studio; ``hosts`` are Host headers that are taken, None takes all."""
    memory = Memory()
    quick, slow, search = (
        Pool(answer, limits.processes, seconds, memory=memory)
        for seconds in (limits.quick, limits.slow, limits.search)
    )

    @asynccontextmanager
    async def life(_: FastAPI) -> AsyncIterator[None]:
        with prepared_copies():
            yield
            quick.close()
            slow.close()
            search.close()

    kept = Kept()
    app = FastAPI(lifespan=life, docs_url=None, redoc_url=None, openapi_url=None)
    app.add_middleware(Compressed)
    _handle_errors(app)

    @app.get("/api/info", response_model=None)
    def info() -> Info:
        return {
            "version": __version__,
            "units": list(MILLIMETRES),
            "families": describe_families(),
            "examples": describe_examples(),
            "formats": describe_formats(),
            "tasks": describe_tasks(),
            "workshop": describe_workshop(),
            "tables": describe_tables(),
            "materials": describe_materials(),
            "search": describe_search(),
            "limits": {"vertices": MAX_VERTICES, "bytes": limits.bytes, "seconds": limits.quick},
            "start": start,
        }

    @app.post("/api/design")
    async def design(request: Request) -> Response:
        begin = time.perf_counter()
        body = await request.body()
        view = kept.find("design", body)
        if view is None:
            view = await _run(quick, "design", request)
            kept.keep("design", body, view)
        # The page asks for several at a time where it is not the server that takes the time.
        headers = {"server-timing": f"design;dur={1e3 * (time.perf_counter() - begin):.1f}"}
        return Response(view, media_type="application/octet-stream", headers=headers)

    @app.post("/api/export")
    async def export(request: Request) -> Response:
        name, content = await _run(slow, "export", request)
        plain = f'filename="{name}"' if name.isascii() else f"filename*=utf-8''{quote(name)}"
        headers = {"content-disposition": f"attachment; {plain}"}
        return Response(content, media_type="application/octet-stream", headers=headers)

    for task in ("families", "fit", "tradeoff", "sheets", "booklet"):
        _add_stream(app, task, slow, kept)
    for task in ("verify", "mend"):
        _add_stream(app, task, slow, kept, patient=search)
    _add_stream(app, "search", search, Kept(most=0))
    _add_stream(app, "carry", search, kept)
    _add_task(app, "ranges", slow)
    for task in ("parse", "format", "curve", "surface", "mesh", "pattern", "drawing", "look"):
        _add_task(app, task, quick)

    if PAGES.is_dir():
        app.mount("/", Pages(directory=PAGES, html=True))
    return Guard(app, key, hosts, limits.bytes, limits.receiving)


def _add_stream(
    app: FastAPI, task: str, pool: Pool, kept: Kept, *, patient: Pool | None = None
) -> None:
    """A task whose progress is told while it is under way.

    patient: Answers in place of the pool where the request says that it is patient.
    """

    @app.post(f"/api/{task}")
    async def streamed(request: Request) -> Response:
        body = await request.body()
        if answer := kept.find(task, body):
            return Response(answer, media_type="application/x-ndjson")
        payload = await _payload(request)
        chosen = patient if patient is not None and payload.get("patient") else pool

        async def lines() -> AsyncIterator[bytes]:
            async with aclosing(_lines(chosen, task, payload)) as told:
                async for kind, line in told:
                    if kind == "result":
                        kept.keep(task, body, line)
                    yield line

        return StreamingResponse(lines(), media_type="application/x-ndjson")


def _add_task(app: FastAPI, task: str, pool: Pool) -> None:
    @app.post(f"/api/{task}")
    async def answered(request: Request) -> Any:
        return await _run(pool, task, request)


async def _run(pool: Pool, task: str, request: Request) -> Any:
    """The result of a task, which is stopped if the client goes away.

    Then it raises an HTTPException: nobody reads that answer.
    """
    return await result_while_awaited(pool, task, await _payload(request), request)


async def result_while_awaited(
    pool: Pool, task: str, payload: dict[str, Any], request: Request
) -> Any:
    """The result of a task on a payload, as long as the client of a request waits for it.

    Raises
    ------
    HTTPException
        If it went away; the task is stopped.
    """
    work = asyncio.create_task(pool.run(task, payload))
    gone = asyncio.create_task(_gone(request))
    try:
        await asyncio.wait({work, gone}, return_when=asyncio.FIRST_COMPLETED)
        if not work.done():
            raise HTTPException(CLIENT_CLOSED, "the client went away")
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
    """The object in a request's body: strict JSON (finite numbers, valid Unicode), not too deep."""
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
            for inner in (each.values() if isinstance(each, dict) else each)
            if isinstance(inner, dict | list)
        ]
        if not level:
            return payload
    raise RequestValidationError([f"more than {DEEPEST} levels of nested tables or lists"])


async def _lines(
    pool: Pool, task: str, payload: dict[str, Any]
) -> AsyncGenerator[tuple[str, bytes]]:
    """Lines of JSON and their kinds: progress and what is found, then the result or the error."""
    try:
        # Closed with the response, so that its process stops when the page is gone.
        async with aclosing(pool.stream(task, payload)) as stream:
            async for kind, value in stream:
                if kind == "progress":
                    share, what = value
                    yield kind, _line({"progress": share, "what": what})
                else:
                    yield kind, _line({kind: value})
    except FAILURES as error:
        yield "error", _line(describe_failure(error)[1])


def _line(message: Mapping[str, Any]) -> bytes:
    import orjson

    return orjson.dumps(message, option=orjson.OPT_APPEND_NEWLINE)


def describe_failure(error: Exception) -> tuple[int, Refusal]:
    """Status and body of the answer to a request that failed."""
    match error:
        case RefusalError():
            return 422, error.body
        case OutOfTimeError():
            return 504, make_refusal(
                "time",
                f"this takes longer than the {error} s that the studio waits: "
                "try fewer panels, or the command line",
            )
        case BusyError():
            return 503, make_refusal(
                "limit", "too many requests are waiting: try again in a moment"
            )
        case RequestValidationError():
            return 400, make_refusal(
                "input", f"the request is not JSON as expected: {error.errors()[0]}"
            )
        case HTTPException():
            return error.status_code, make_refusal("input", f"this is not served: {error.detail}")
        case _:
            return 500, make_refusal("fault", f"a fault of the program, please report it: {error}")


def _handle_errors(app: FastAPI) -> None:
    async def explain(_: Request, error: Exception) -> JSONResponse:
        status, body = describe_failure(error)
        return JSONResponse(body, status)

    for kind in (*FAILURES, RequestValidationError, HTTPException):
        app.add_exception_handler(kind, explain)
