"""A pool of processes that answer the studio's requests, each within a time limit."""

from __future__ import annotations

import asyncio
import contextlib
import multiprocessing
import os
import shutil
import tempfile
from collections.abc import AsyncGenerator, Callable
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from typing import Any, Literal

from orishell.conventions.progress import Progress
from orishell.conventions.stopping import cleaning_up
from orishell.errors import OrishellError
from orishell.studio.api import RefusalError, describe_error

Payload = dict[str, Any]
Work = Callable[[str, Payload, Progress], Any]
"""Does a task by its name, given a payload and whom to tell how far it is; raises OrishellError
for bad input. A function of a module, so that every process finds it."""

Kind = Literal["progress", "result", "refusal", "fault"]
STEP = 0.01
"""Progress is passed on when it grew by this share."""


class OutOfTimeError(Exception):
    """A request took longer than it may."""


class BusyError(Exception):
    """Too many requests are waiting already."""


class FaultError(Exception):
    """A task failed through a fault of the program."""


@dataclass(slots=True)
class _Worker:
    """One process, the pipe to it, and what ends it and removes its files."""

    process: SpawnProcess
    pipe: Connection
    life: contextlib.ExitStack

    def stop(self) -> None:
        self.life.close()


@dataclass(slots=True)
class Pool:
    """A few processes; a request occupies one, further requests wait in a queue.

    Parameters
    ----------
    work
        What the processes do.
    size
        Number of processes.
    seconds
        Time that a request may take, without waiting.
    waiting
        Requests that may wait for a process.
    """

    work: Work
    size: int
    seconds: float
    waiting: int = 200
    _idle: asyncio.LifoQueue[_Worker | None] = field(init=False)
    _in_line: int = field(init=False, default=0)
    _workers: list[_Worker] = field(init=False, default_factory=list)

    def __post_init__(self) -> None:
        self._idle = asyncio.LifoQueue()
        for _ in range(self.size):
            self._idle.put_nowait(None)  # started when it is needed

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
                await _readable(worker.pipe, end)
                kind, value = await asyncio.to_thread(worker.pipe.recv)
                if kind != "progress":
                    break
                yield kind, value
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

    async def _take(self) -> _Worker:
        if self._in_line >= self.waiting:
            raise BusyError
        self._in_line += 1
        try:
            worker = await self._idle.get()
        finally:
            self._in_line -= 1
        if worker is None or not worker.process.is_alive():
            starting = asyncio.create_task(asyncio.to_thread(_start, self.work))
            try:
                worker = await asyncio.shield(starting)
            except BaseException:
                # The request is gone, but the process may be about to start.
                starting.add_done_callback(_stop_started)
                self._idle.put_nowait(None)
                raise
            self._workers.append(worker)
        return worker

    def _replace(self, worker: _Worker) -> None:
        worker.stop()
        with contextlib.suppress(ValueError):
            self._workers.remove(worker)
        self._idle.put_nowait(None)


def _start(work: Work) -> _Worker:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    files = tempfile.mkdtemp(prefix="orishell-")
    process = context.Process(target=_serve, args=(work, theirs, files), daemon=True)

    def end() -> None:
        if process.pid is not None:
            process.kill()
            process.join()
        ours.close()
        shutil.rmtree(files, ignore_errors=True)

    with contextlib.ExitStack() as starting:
        starting.enter_context(cleaning_up(end))
        process.start()
        theirs.close()
        return _Worker(process, ours, starting.pop_all())


def _stop_started(starting: asyncio.Task[_Worker]) -> None:
    if not starting.cancelled() and starting.exception() is None:
        starting.result().stop()


async def _readable(pipe: Connection, end: float) -> None:
    """Wait until there is something to read.

    Raises
    ------
    TimeoutError
        If there is nothing by ``end``.
    """
    loop = asyncio.get_running_loop()
    ready = asyncio.Event()
    loop.add_reader(pipe.fileno(), ready.set)
    try:
        async with asyncio.timeout_at(end):
            await ready.wait()
    finally:
        loop.remove_reader(pipe.fileno())


def _serve(work: Work, pipe: Connection, files: str) -> None:
    """Work through requests until the pipe closes: the life of a process."""
    import signal
    import warnings

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server says when it is over
    tempfile.tempdir = files  # the server removes what a process leaves that it stops
    # Numbers beyond all measure are refused by what they lead to, not by a word on the terminal.
    warnings.simplefilter("ignore", RuntimeWarning)
    while True:
        try:
            name, payload = pipe.recv()
        except EOFError:
            return
        last = -1.0

        def advanced(share: float, what: str) -> None:
            nonlocal last
            if share >= last + STEP or share < last:
                last = share
                pipe.send(("progress", (share, what)))

        try:
            answer: tuple[Kind, Any] = ("result", work(name, payload, advanced))
        except OrishellError as error:
            answer = ("refusal", describe_error(error))
        except Exception as error:
            words = f"{type(error).__name__}: {error}"
            answer = ("fault", words.replace(f"{files}{os.sep}", ""))
        pipe.send(answer)
