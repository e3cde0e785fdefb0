"""A pool of processes that answer the studio's requests, each within a time limit."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncGenerator
from dataclasses import dataclass, field
from typing import Any

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
    """A few processes; a request occupies one, further requests wait in a queue.

    Parameters
    ----------
    work
        What the processes do.
    size
        Number of requests that are worked on at a time.
    seconds
        Time that a request may take, without waiting.
    waiting
        Requests that may wait for a process.
    spare
        Processes that wait for requests, so that none waits for a process to start; with 0 they
        are started when they are needed.
    warming
        Name of a task that every process does first, with nothing as its payload: what it imports
        is there when a request comes.
    """

    work: Work
    size: int
    seconds: float
    waiting: int = 200
    spare: int = 0
    warming: str = ""
    _places: asyncio.Semaphore = field(init=False)
    _ready: asyncio.LifoQueue[Worker | Exception] = field(init=False)
    _starting: set[asyncio.Task[None]] = field(init=False, default_factory=set)
    _in_line: int = field(init=False, default=0)
    _wanted: int = field(init=False, default=0)
    _workers: list[Worker] = field(init=False, default_factory=list)
    _closed: bool = field(init=False, default=False)

    def __post_init__(self) -> None:
        self._places = asyncio.Semaphore(self.size)
        self._ready = asyncio.LifoQueue()

    async def get_ready(self) -> None:
        """Start the spare processes, and wait until they are ready."""
        self._restock()
        await asyncio.gather(*self._starting)

    async def run(self, name: str, payload: Payload) -> Any:
        """The result of a task, by its ``name``, given its ``payload``.

        Raises
        ------
        RefusalError, OutOfTimeError, BusyError, FaultError
            If there is none.
        """
        async with contextlib.aclosing(self.stream(name, payload)) as stream:
            async for kind, value in stream:
                if kind == "result":
                    return value
        raise FaultError("a task ended without a result")

    async def stream(self, name: str, payload: Payload) -> AsyncGenerator[tuple[Kind, Any]]:
        """Progress as ("progress", (share, what)), then the result of a task as ("result", value).

        The task is found by its ``name`` and given its ``payload``. A task whose stream is closed
        before its end is stopped.
        """
        worker = await self._take()
        try:
            end = asyncio.get_running_loop().time() + self.seconds
            # In a thread: what is larger than the pipe waits until the process has started.
            await asyncio.to_thread(worker.pipe.send, (name, payload))
            while True:
                await readable(worker.pipe, end)
                kind, value = await asyncio.to_thread(worker.pipe.recv)
                if kind != "progress":
                    break
                yield kind, value
        except BaseException as error:
            # Its process is in the middle of something, or gone.
            self._stop(worker)
            self._places.release()
            self._restock()
            if isinstance(error, TimeoutError):
                raise OutOfTimeError(f"{self.seconds:g}") from None
            if isinstance(error, EOFError | OSError):
                raise FaultError(f"the process of {name} ended") from None
            raise
        self._ready.put_nowait(worker)
        self._places.release()
        if kind == "refusal":
            raise RefusalError(value)
        if kind == "fault":
            raise FaultError(value)
        yield kind, value

    def close(self) -> None:
        """Stop all processes."""
        self._closed = True
        for task in self._starting:
            task.cancel()
        for worker in self._workers:
            worker.stop()
        self._workers.clear()

    async def _take(self) -> Worker:
        """A process that is ready, once one of the places is free; it is occupied with it."""
        if self._in_line >= self.waiting:
            raise BusyError
        self._in_line += 1
        try:
            await self._places.acquire()
        finally:
            self._in_line -= 1
        try:
            while True:
                found = await self._next()
                if found.process.is_alive():
                    break
                self._stop(found)
        except BaseException:
            self._places.release()
            raise
        self._restock()
        return found

    async def _next(self) -> Worker:
        """The process that is ready, or the first that gets ready.

        Raises
        ------
        FaultError
            If none does.
        """
        self._wanted += 1
        try:
            self._restock()
            found = await self._ready.get()
        finally:
            self._wanted -= 1
        if isinstance(found, Exception):
            raise FaultError(f"no process could be started: {found}")
        return found

    def _restock(self) -> None:
        """Start processes until as many are ready, or about to be, as are wanted and spare."""
        lacking = self._wanted + self.spare - self._ready.qsize() - len(self._starting)
        room = self.size + self.spare - len(self._workers) - len(self._starting)
        for _ in range(0 if self._closed else min(lacking, room)):
            task = asyncio.create_task(self._begin())
            self._starting.add(task)
            task.add_done_callback(self._starting.discard)

    async def _begin(self) -> None:
        """Start a process, and put it among those that are ready; or the reason why not."""
        starting = asyncio.create_task(asyncio.to_thread(start_worker, self.work))
        try:
            worker = await asyncio.shield(starting)
        except OSError as error:
            self._ready.put_nowait(error)
            return
        except asyncio.CancelledError:
            starting.add_done_callback(stop_started)
            raise
        try:
            await self._warm(worker)
        except BaseException as error:
            worker.stop()
            if not isinstance(error, EOFError | OSError | FaultError):
                raise
            self._ready.put_nowait(error)
            return
        self._workers.append(worker)
        self._ready.put_nowait(worker)

    async def _warm(self, worker: Worker) -> None:
        """Have a process do its first task.

        Raises
        ------
        FaultError, EOFError, OSError
            If it cannot.
        """
        if not self.warming:
            return
        await asyncio.to_thread(worker.pipe.send, (self.warming, {}))
        kind: Kind = "progress"
        while kind == "progress":
            await readable(worker.pipe, None)
            kind, value = await asyncio.to_thread(worker.pipe.recv)
        if kind != "result":
            raise FaultError(str(value))

    def _stop(self, worker: Worker) -> None:
        worker.stop()
        with contextlib.suppress(ValueError):
            self._workers.remove(worker)
