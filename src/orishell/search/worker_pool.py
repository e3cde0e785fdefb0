"""Who does the work of a search: this process, further ones of this machine, or those of a cluster.

It travels in chunks. A process that dies costs its chunk again and nothing else.
"""

from __future__ import annotations

import contextlib
import os
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass
from typing import Any, Protocol

Work = Callable[[Sequence[Any]], list[Any]]
"""What is done with a chunk, result by result; processes find it by the name of its module."""
SHARES = 8
"""Chunks for each slot among which designs are shared out, so that none waits long for others."""
LARGEST_CHUNK = 8
ATTEMPTS = 3
"""Times that a chunk is tried whose process dies."""
GLANCE = 0.1
"""Seconds after which it is looked whether to stop."""


class Slot(Protocol):
    """Where one chunk at a time is worked on."""

    died: tuple[type[BaseException], ...]
    """What a chunk raises whose process died."""

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        """Begin some ``work`` on a ``chunk``."""

    def renew(self) -> None:
        """Replace a process that died."""


@dataclass(frozen=True, slots=True)
class WorkerPool:
    """All slots where work is done."""

    slots: list[Slot]  # each works on one chunk at a time
    largest_chunk: int = LARGEST_CHUNK  # items in a chunk, at most
    # raises InputError if nobody is left who could do the work
    require_alive: Callable[[], None] | None = None

    def work(
        self, work: Work, items: Sequence[Any], stop: threading.Event
    ) -> Iterator[tuple[Sequence[Any], list[Any] | None]]:
        """Chunks of items and what becomes of them, as they are ready, until it is to stop.

        None becomes of an item whose process died, however often it was tried.

        Parameters
        ----------
        work
            What is done with a chunk.
        items
            What travels to where it is done.
        stop
            Set where no more are wanted.
        """
        size = -(-len(items) // (SHARES * len(self.slots)))
        size = min(max(size, 1), self.largest_chunk)
        chunks = [items[k : k + size] for k in range(0, len(items), size)]
        waiting = deque((chunk, 1) for chunk in chunks)
        idle = list(self.slots)
        running: dict[Future[list[Any]], tuple[Slot, Sequence[Any], int]] = {}
        while (waiting or running) and not stop.is_set():
            while waiting and idle:
                slot, (chunk, attempt) = idle.pop(), waiting.popleft()
                try:
                    future = slot.submit(work, chunk)
                except slot.died:  # while it had nothing to do
                    slot.renew()
                    future = slot.submit(work, chunk)
                running[future] = (slot, chunk, attempt)
            ready = wait(running, GLANCE, FIRST_COMPLETED).done
            if not ready and self.require_alive:
                self.require_alive()
            for future in ready:
                slot, chunk, attempt = running.pop(future)
                idle.append(slot)
                try:
                    yield chunk, future.result()
                except slot.died:
                    slot.renew()
                    if len(chunk) > 1:  # one of them may be to blame
                        waiting.extendleft(([each], 1) for each in chunk)
                    elif attempt < ATTEMPTS:
                        waiting.appendleft((chunk, attempt + 1))
                    else:
                        yield chunk, None


@contextlib.contextmanager
def alone() -> Iterator[WorkerPool]:
    """No other process than this one does the work."""
    yield WorkerPool([_Here()], largest_chunk=1)


class _Here:
    died: tuple[type[BaseException], ...] = ()

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        future: Future[list[Any]] = Future()
        future.set_result(work(chunk))
        return future

    def renew(self) -> None:
        """Nothing dies here that would not take this process with it."""


@contextlib.contextmanager
def local_processes(count: int | None = None) -> Iterator[WorkerPool]:
    """Processes of this machine, each with one thread.

    Parameters
    ----------
    count
        Their number; None for one a core.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # processes inherit it
    slots = [_Process() for _ in range(count or cores())]
    try:
        yield WorkerPool(list(slots), largest_chunk=1)
    finally:
        for each in slots:
            each.end()


def cores() -> int:
    """How many processes can work at a time here."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


class _Process:
    """A process of its own: where several share a pool, one that dies breaks the work of all."""

    died: tuple[type[BaseException], ...] = (BrokenExecutor,)

    def __init__(self) -> None:
        self.renew()

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        return self._pool.submit(work, chunk)

    def renew(self) -> None:
        from concurrent.futures import ProcessPoolExecutor

        from orishell.conventions.imports import context_of, prepare

        context = context_of("orishell.search.evaluate")
        prepare(context)  # it imports that while this process imports what it needs
        self._pool = ProcessPoolExecutor(1, context, _begin)

    def end(self) -> None:
        """End it, whatever it is at."""
        for each in list((self._pool._processes or {}).values()):
            each.kill()
        self._pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """What a process does first: end with the one that started it, and leave Ctrl-C to it."""
    import signal
    from multiprocessing import parent_process

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=follow, daemon=True).start()
