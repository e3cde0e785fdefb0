"""How large a design the studio takes.

They are copies of one that has imported all that answers need (``orishell.studio.warm``), so that
one that is stopped is replaced at once. Where a system makes no copies, each imports anew.
"""

from __future__ import annotations

import asyncio
import contextlib
import multiprocessing
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection
from multiprocessing.context import ForkServerContext
from multiprocessing.process import BaseProcess
from typing import Any, Literal

from orishell.conventions.errors import InputError, OrishellError
from orishell.conventions.imports import context_of, prepare
from orishell.conventions.memory import MEMORY
from orishell.conventions.progress import Progress, cleaning_up
from orishell.design_file import DesignFile
from orishell.studio.refusals import describe_error

MAX_VERTICES = 60_000
"""Vertices of a sheet in the studio, at most; the command line takes more."""


def require_small(file: DesignFile) -> None:
    """Refuse a sheet that is too large for the studio."""
    vertices = (file.pattern.rows + 2) * (file.pattern.columns + 2)
    if vertices > MAX_VERTICES:
        raise InputError(
            "the sheet is too large for the studio",
            keys=("pattern.rows", "pattern.columns"),
            got=f"{vertices} vertices",
            expected=f"at most {MAX_VERTICES}",
            remedy="use orishell design",
        )


Payload = dict[str, Any]
Send = Callable[[Any], None]
"""Is told what was found so far."""
Work = Callable[[str, Payload, Progress, Send], Any]
"""Does a task by its name, given a payload, whom to tell how far it is and what was found so far;
raises OrishellError for bad input. A function of a module, so that every process finds it."""


def ignore(_: Any) -> None:
    """Nobody is told."""


Kind = Literal["progress", "found", "kept", "result", "refusal", "fault"]
WARM = "orishell.studio.warm"
POLLED = 0.2
"""Seconds for which a pipe is watched at a time, where the system has to be asked."""
STEP = 0.01
"""Progress is passed on when it grew by this share."""


@dataclass(slots=True)
class Worker:
    """One process, the pipe to it, and what ends it and removes its files."""

    process: BaseProcess
    pipe: Connection
    stop: Callable[[], None]


@contextlib.contextmanager
def prepared_copies() -> Iterator[None]:
    """Start the process that others are copies of, which takes it some seconds, not the caller.

    Its files are removed at the end of the context, or when this process is stopped in it.
    """
    context = context_of(WARM)
    if not isinstance(context, ForkServerContext):
        yield
        return
    files = tempfile.mkdtemp(prefix="orishell-")
    with cleaning_up(lambda: shutil.rmtree(files, ignore_errors=True)):
        # Where the sockets of processes go; Python itself would leave them behind.
        vars(multiprocessing.current_process())["_config"]["tempdir"] = files
        prepare(context)
        yield


def start_worker(work: Work) -> Worker:
    """Start a process that does some ``work``; raises OSError if there is no room for one."""
    context = context_of(WARM)
    ours, theirs = context.Pipe()
    files = tempfile.mkdtemp(prefix="orishell-")
    process = context.Process(target=_serve, args=(work, theirs, files), daemon=True)

    def end() -> None:
        if process.pid is not None and process.is_alive():
            process.kill()
            process.join()
        ours.close()
        shutil.rmtree(files, ignore_errors=True)

    with contextlib.ExitStack() as starting:
        starting.enter_context(cleaning_up(end))
        process.start()
        theirs.close()
        return Worker(process, ours, starting.pop_all().close)


def stop_started(starting: asyncio.Task[Worker]) -> None:
    """Stop the process that was about to start, if it has: for when ``starting`` is done."""
    if not starting.cancelled() and starting.exception() is None:
        starting.result().stop()


async def readable(pipe: Connection, end: float | None) -> None:
    """Wait until there is something to read, for ever if there is no ``end``.

    Raises TimeoutError if there is nothing by then.
    """
    loop = asyncio.get_running_loop()
    ready = asyncio.Event()
    try:
        loop.add_reader(pipe.fileno(), ready.set)
    except NotImplementedError:  # Windows' loop watches no pipes
        async with asyncio.timeout_at(end):
            while not await asyncio.to_thread(pipe.poll, POLLED):
                pass
        return
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
            name, payload, known = pipe.recv()
        except EOFError:
            return
        MEMORY.learn(known)
        last = -1.0

        def advanced(share: float, what: str) -> None:
            nonlocal last
            if share >= last + STEP or share < last:
                last = share
                pipe.send(("progress", (share, what)))

        def found(value: Any) -> None:
            pipe.send(("found", value))

        try:
            answer: tuple[Kind, Any] = ("result", work(name, payload, advanced, found))
        except OrishellError as error:
            answer = ("refusal", describe_error(error))
        except Exception as error:
            words = f"{type(error).__name__}: {error}"
            answer = ("fault", words.replace(f"{files}{os.sep}", ""))
        pipe.send(("kept", {key: each for key, each in MEMORY.all().items() if key not in known}))
        pipe.send(answer)
