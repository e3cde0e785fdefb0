"""uvicorn's HTTP protocol, with a time for the head of a request and a share for strangers.

Whoever can reach the studio can open connections to it. Those that have not shown its key have a
share of their own: where there are more, the oldest are closed, and who has the key is let in.
"""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Any, ClassVar, cast

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

from orishell.studio.app import LIMITS
from orishell.studio.guard import Key

TOO_LATE = b"HTTP/1.1 408 Request Timeout\r\nConnection: close\r\nContent-Length: 0\r\n\r\n"


STRANGERS = 50
"""Connections that have not shown the key, at most."""
PATIENCE = 0.1
"""Seconds in which a request that is there already is read, before one is closed for others."""


class ImpatientProtocol(H11Protocol):
    """A connection that is closed when the head of a request takes too long to arrive.

    Or when it has not shown the key, and too many others that have not are newer.
    """

    key: ClassVar[Key | None] = None  # without one nobody is a stranger
    strangers: ClassVar[dict[ImpatientProtocol, None]]
    """Connections of all that have not shown the key, the oldest first."""
    seconds = LIMITS.receiving
    """Time that a head may take, from the first moment of a connection or its first byte."""

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self._waiting: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Start the timer for the first head."""
        # uvicorn narrows the transport that asyncio declares.
        super().connection_made(cast("asyncio.Transport", transport))
        self._wait()
        if self.key is not None:
            self.strangers[self] = None
            if len(self.strangers) == STRANGERS + 1:
                self.loop.call_later(PATIENCE, self._make_room)

    def data_received(self, data: bytes) -> None:
        """Stop the timer when a head is complete, start it when the next begins."""
        super().data_received(data)
        if self.conn.their_state is not h11.IDLE:
            self._stop_waiting()
        elif self._waiting is None and self.conn.trailing_data[0]:
            self._wait()
        if self.key is not None and self in self.strangers:
            # uvicorn has none before the first head is whole
            scope = cast("Mapping[str, Any] | None", self.scope)
            if scope is not None and self.key.opens(scope):
                del self.strangers[self]

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop the timer."""
        self._stop_waiting()
        if self.key is not None:
            self.strangers.pop(self, None)
        super().connection_lost(exc)

    def _wait(self) -> None:
        self._waiting = self.loop.call_later(self.seconds, self._give_up)

    def _stop_waiting(self) -> None:
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None

    def _make_room(self) -> None:
        for each in [*self.strangers][:-STRANGERS]:
            del self.strangers[each]
            each.transport.abort()  # what it was sent need not be read

    def _give_up(self) -> None:
        if not self.transport.is_closing():
            self.transport.write(TOO_LATE)
            self.transport.close()


def protocol_for(key: Key) -> type[ImpatientProtocol]:
    """The protocol of a server that has a key."""

    class WithKey(ImpatientProtocol):
        strangers = {}  # noqa: RUF012 -- one for all connections of a server

    WithKey.key = key
    return WithKey
