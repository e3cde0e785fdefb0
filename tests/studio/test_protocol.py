"""The head of a request has its time, as its body has; strangers do not take the owner's place."""

from __future__ import annotations

import asyncio
import contextlib
from typing import Any

import pytest
from uvicorn import Config
from uvicorn.server import ServerState

from apart import run_apart
from orishell.studio.guard import AT_ONCE, Guard, Key
from orishell.studio.protocol import STRANGERS, ImpatientProtocol, protocol_for

SECONDS = 0.5
PAUSE = SECONDS / 1.5
"""Between bytes: none is sent near the end of the time, when it may meet a closed connection."""
WHOLE = b"GET / HTTP/1.1\r\nHost: h\r\n\r\n"


class Quick(ImpatientProtocol):
    seconds = SECONDS


async def app(scope: Any, receive: Any, send: Any) -> None:
    await asyncio.sleep(2 * SECONDS)  # an answer may take longer than a head
    headers = [(b"content-length", b"2")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b"ok"})


async def _drip(writer: asyncio.StreamWriter, pause: float) -> None:
    """The head of a request that never ends, a byte at a time."""
    for byte in WHOLE[:-2] + b"X: " + b"x" * 100_000:
        writer.write(bytes([byte]))
        await asyncio.sleep(pause)


def answers(*begun: bytes, drip: bool) -> list[bytes]:
    """All that comes back on a connection, until it is closed, for each beginning."""

    async def scene() -> list[bytes]:
        config = Config(app, log_level="error", lifespan="off", timeout_keep_alive=30)
        config.load()
        state, loop = ServerState(), asyncio.get_running_loop()
        server = await loop.create_server(lambda: Quick(config, state, {}), "127.0.0.1", 0)
        port = server.sockets[0].getsockname()[1]
        found = []
        for each in begun:
            reader, writer = await asyncio.open_connection("127.0.0.1", port)
            writer.write(each)
            if each:  # let it be answered first
                await reader.readuntil(b"ok")
            dripping = asyncio.create_task(_drip(writer, PAUSE) if drip else asyncio.sleep(0))
            found.append(await asyncio.wait_for(reader.read(), 60))
            dripping.cancel()
            writer.close()
        server.close()
        return found

    return run_apart(scene())


def test_a_connection_that_says_nothing_is_closed() -> None:
    (answer,) = answers(b"", drip=False)
    assert answer.startswith(b"HTTP/1.1 408 ")


def test_a_head_that_drips_is_given_up_also_after_a_whole_request() -> None:
    for answer in answers(b"", WHOLE, drip=True):
        assert answer.startswith(b"HTTP/1.1 408 ")


HALF_SENT = {
    "nothing": b"",
    "half a head": b"GET /api/info HTTP/1.1\r\nHost: h\r\nX: ",
    "half a body": b"POST /api/design HTTP/1.1\r\nHost: h\r\nContent-Length: 1000\r\n\r\n{",
}


@pytest.mark.parametrize("sent", HALF_SENT.values(), ids=HALF_SENT)
def test_strangers_do_not_take_the_place_of_the_owner(sent: bytes) -> None:
    """Of 300 who send half a request the newest 50 are left, and who has the key is answered.

    So it is before them, among them and after them.
    """

    async def scene() -> tuple[list[bytes], int]:
        key = Key(8765)
        guard = Guard(answered, key, None, 1000, 30.0)
        config = Config(guard, log_level="error", lifespan="off", timeout_keep_alive=60)
        config.load()
        protocol, state = protocol_for(key), ServerState()
        loop = asyncio.get_running_loop()
        server = await loop.create_server(lambda: protocol(config, state, {}), "127.0.0.1", 0)
        port = server.sockets[0].getsockname()[1]
        request = f"GET /x?{key.query} HTTP/1.1\r\nHost: h\r\n\r\n".encode()

        async def enter() -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
            owner = await asyncio.open_connection("127.0.0.1", port)
            opened.append(owner[1])
            owner[1].write(request)
            found.append(await owner[0].readuntil(b"ok"))
            return owner

        found: list[bytes] = []
        opened: list[asyncio.StreamWriter] = []
        kept = await enter()
        for number in range(300):
            opened.append((await asyncio.open_connection("127.0.0.1", port))[1])
            opened[-1].write(sent)
            if number % 100 == 99:
                await enter()
        while len(protocol.strangers) > STRANGERS:
            await asyncio.sleep(0.05)
        left = len(protocol.strangers)
        kept[1].write(request)
        found.append(await kept[0].readuntil(b"ok"))
        for writer in opened:
            writer.close()
            with contextlib.suppress(ConnectionError):
                await writer.wait_closed()
        while state.connections:
            await asyncio.sleep(0.05)
        server.close()
        return found, left

    found, left = run_apart(scene())
    assert [each.split(b"\r\n")[0] for each in found] == [b"HTTP/1.1 200 OK"] * 5
    assert left <= STRANGERS


async def answered(scope: Any, receive: Any, send: Any) -> None:
    headers = [(b"content-length", b"2")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b"ok"})


def test_more_requests_than_are_answered_at_once_are_turned_away() -> None:
    """Of those who have the key: 150 wait for an answer, the next is told so, and then answered."""

    async def scene() -> list[int]:
        begun = asyncio.Event()

        async def waits(scope: Any, receive: Any, send: Any) -> None:
            await begun.wait()
            await answered(scope, receive, send)

        statuses: list[int] = []

        async def send(message: Any) -> None:
            if message["type"] == "http.response.start":
                statuses.append(message["status"])

        async def receive() -> dict[str, Any]:
            return {"type": "http.request", "body": b""}

        key = Key(8765)
        guard = Guard(waits, key, None, 1000, 30.0)
        scope = {"type": "http", "path": "/x", "query_string": key.query.encode(), "headers": []}
        scope["method"] = "GET"
        waiting = [asyncio.create_task(guard(scope, receive, send)) for _ in range(AT_ONCE)]
        await asyncio.sleep(0)
        await guard(scope, receive, send)
        first = [*statuses]
        begun.set()
        await asyncio.gather(*waiting)
        await guard(scope, receive, send)
        return [*first, *sorted(set(statuses[1:]))]

    assert run_apart(scene()) == [503, 200]
