"""A pool of processes that answer the studio's requests, each within a time limit."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncGenerator
from dataclasses import dataclass, field
from typing import Any

from orishell.conventions.memory import Memory
from orishell.studio.processes import (
    Kind,
    Payload,
    Work,
    Worker,
    readable,
    start_worker,
    stop_started,
)
from orishell.studio.refusals import RefusalError


class OutOfTimeError(Exception):
    """A request took longer than it may."""


class BusyError(Exception):
    """Too many requests are waiting already."""


class FaultError(Exception):
    """A task failed through a fault of the program."""


@dataclass(slots=True)
class Pool:
    """A few processes; a request occupies one, further requests wait in a queue."""

    work: Work  # What the processes do
    size: int  # Number of processes
    seconds: float  # Time that a request may take, without waiting
    waiting: int = 200  # Requests that may wait for a process
    # What took its processes long, and those of other pools that share it; it outlives them
    memory: Memory = field(default_factory=Memory)
    _idle: asyncio.LifoQueue[Worker | None] = field(init=False)
    _in_line: int = field(init=False, default=0)
    _workers: list[Worker] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        self._idle = asyncio.LifoQueue()
        for _ in range(self.size):
            self._idle.put_nowait(None)  # started when it is needed

    async def run(self, name: str, payload: Payload) -> Any:
        """The result of a task, by its ``name``, given its ``payload``.

        Raises RefusalError, OutOfTimeError, BusyError or FaultError if there is none.
        """
        async with contextlib.aclosing(self.stream(name, payload)) as stream:
            async for kind, value in stream:
                if kind == "result":
                    return value
        raise FaultError("a task ended without a result")

    async def stream(self, name: str, payload: Payload) -> AsyncGenerator[tuple[Kind, Any]]:
        """Progress as ("progress", (share, what)), then the result of a task as ("result", value).

        In between comes what was found so far, as ("found", value). A task whose stream is closed
        before its end is stopped.
        """
        worker = await self._take()
        try:
            end = asyncio.get_running_loop().time() + self.seconds
            # In a thread: what is larger than the pipe waits until the process has started.
            await asyncio.to_thread(worker.pipe.send, (name, payload, self.memory.all()))
            while True:
                await readable(worker.pipe, end)
                kind, value = await asyncio.to_thread(worker.pipe.recv)
                if kind == "kept":
                    self.memory.learn(value)
                elif kind in ("progress", "found"):
                    yield kind, value
                else:
                    break
        except BaseException as error:
            # Its process is in the middle of something, or gone.
            self._replace(worker)
            if isinstance(error, TimeoutError):
                raise OutOfTimeError(f"{self.seconds:g}") from None
            if isinstance(error, EOFError | OSError):
                raise FaultError(f"the process of {name} ended") from None
            raise
        self._idle.put_nowait(worker)
        if kind == "refusal":
            raise RefusalError(value)
        if kind == "fault":
            raise FaultError(value)
        yield kind, value

    def close(self) -> None:
        """Stop all processes."""
        for worker in self._workers:
            worker.stop()
        self._workers.clear()

    async def _take(self) -> Worker:
        if self._in_line >= self.waiting:
            raise BusyError
        self._in_line += 1
        try:
            worker = await self._idle.get()
        finally:
            self._in_line -= 1
        if worker is not None and not worker.process.is_alive():
            self._forget(worker)
            worker = None
        if worker is None:
            starting = asyncio.create_task(asyncio.to_thread(start_worker, self.work))
            try:
                worker = await asyncio.shield(starting)
            except BaseException as error:
                # The request is gone, but the process may be about to start.
                starting.add_done_callback(stop_started)
                self._idle.put_nowait(None)
                if isinstance(error, EOFError | OSError):
                    raise FaultError(f"no process could be started: {error}") from None
                raise
            self._workers.append(worker)
        return worker

    def _replace(self, worker: Worker) -> None:
        self._forget(worker)
        self._idle.put_nowait(None)

    def _forget(self, worker: Worker) -> None:
        worker.stop()
        with contextlib.suppress(ValueError):
            self._workers.remove(worker)
