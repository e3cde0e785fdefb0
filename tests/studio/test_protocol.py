"""The head of a request has its time, as its body has."""

from __future__ import annotations

import asyncio
from typing import Any

from uvicorn import Config
from uvicorn.server import ServerState

from apart import run_apart
from orishell.studio.protocol import ImpatientProtocol

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
