"""The workers of a Dask cluster, as they do the work of a search."""

from __future__ import annotations

import contextlib
import logging
import socket
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError, Future
from functools import partial
from typing import Any, TypeVar

from orishell.conventions.errors import InputError
from orishell.conventions.version import __version__
from orishell.search.worker_pool import Slot, Work, WorkerPool

T = TypeVar("T")

TIMEOUT = 10.0
"""Seconds within which a cluster must answer, and have a worker."""
SILENCE = 3
"""Times that long without a word a scheduler has stopped, or a worker."""
GOODBYE = 2.0
"""Seconds that are spent on leaving a cluster."""
GOES_ON = "the same command goes on where this one was"
PATIENCE = 60.0
"""Seconds within which another worker must be there, where all have left."""
LOOK = 1.0
"""Seconds after which it is looked whether workers are there."""
AHEAD = 2
"""Chunks under way for each thread of a worker: the next one is there when one is done."""


@contextlib.contextmanager
def dask_workers(address: str, *, timeout: float = TIMEOUT) -> Iterator[WorkerPool]:
    """The workers of a Dask cluster that there are now.

    What they send back is unpickled, which may run anything here: they must be trusted.

    Parameters
    ----------
    address
        Of its scheduler, such as ``tcp://10.0.0.1:8786``.
    timeout
        Seconds that each call of the cluster may take. A worker of which nothing is heard for three
        times as long is taken off the cluster, and others do its work.

    Raises
    ------
    InputError
        If Dask is not installed, nothing answers there, there are no workers, one of them does not
        answer or has another orishell than this, or the cluster or all of its workers are lost on
        the way.
    """
    client = _connected(address, timeout)
    try:
        threads = _threads(client, address, timeout)
        slot = _Workers(client, address, SILENCE * timeout)
        slots: list[Slot] = [slot] * (AHEAD * threads)
        yield WorkerPool(slots, require_alive=slot.require_alive)
    except CancelledError:
        raise _lost("the cluster was lost", address) from None
    finally:
        with contextlib.suppress(OSError):  # it has nothing more to do here
            _within(GOODBYE, client.close)


def _within(seconds: float, call: Callable[[], T]) -> T:
    """What a call gives; raises TimeoutError where it takes longer, whatever it waits for."""
    done: Future[T] = Future()

    def work() -> None:
        try:
            done.set_result(call())
        except Exception as error:  # it is raised where it is waited for
            done.set_exception(error)

    threading.Thread(target=work, daemon=True).start()  # one that hangs holds up no exit
    return done.result(seconds)


def _connected(address: str, timeout: float) -> Any:
    try:
        from distributed import Client
        from distributed.comm.addressing import get_address_host_port
    except ImportError:
        raise InputError(
            "Dask is not installed", where="--cluster", remedy="pip install orishell[cluster]"
        ) from None

    class Closed(Client):
        def __del__(self) -> None:
            """It is closed by hand; one that failed to connect would try on for long."""

    for name in list(logging.root.manager.loggerDict):  # what matters is raised
        if name.startswith("distributed"):
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    connect: Any = partial(Closed, address, timeout=timeout, set_as_default=False)
    try:
        with socket.create_connection(get_address_host_port(address), timeout):
            return _within(timeout, connect)
    except Exception as error:  # whatever it makes of an answer that is none
        raise InputError(
            "no scheduler answers",
            where="--cluster",
            got=f"{address!r} ({str(error).splitlines()[0][:100] if str(error) else 'time is up'})",
            expected="the address of a Dask scheduler, as tcp://10.0.0.1:8786",
            remedy="start one with dask scheduler, and workers with dask worker ADDRESS",
        ) from None


def _threads(client: Any, address: str, timeout: float) -> int:
    """Threads of all workers; raises InputError if there are none, or they are not as this."""
    try:
        _within(timeout, partial(client.wait_for_workers, 1, timeout=timeout))
    except TimeoutError:
        raise InputError(
            "the cluster has no workers",
            where="--cluster",
            got=address,
            remedy=f"start some: dask worker {address} --nthreads 1",
        ) from None
    try:
        found: dict[str, Any] = _within(
            timeout, partial(client.run, _version_there, on_error="return")
        )
        workers = _workers(client, timeout)
    except TimeoutError:
        raise InputError(
            "a worker does not answer",
            where="--cluster",
            got=address,
            expected=f"all workers to answer within {timeout:g} s",
            remedy="end those that have stopped, or start the cluster again",
        ) from None
    for worker, version in found.items():
        if version != __version__:
            raise InputError(
                "a worker does not have this orishell",
                where=f"--cluster: {worker}",
                got=f"{version!r}"[:100],
                expected=__version__,
                remedy=f"install orishell {__version__} where workers run",
            )
    return sum(each["nthreads"] for each in workers.values())


def _workers(client: Any, seconds: float) -> dict[str, dict[str, Any]]:
    """What the scheduler knows of its workers, by their addresses; raises OSError if it is mute."""
    identity = client.sync(client.scheduler.identity, n_workers=-1, callback_timeout=seconds)
    found: dict[str, dict[str, Any]] = identity["workers"]
    return found


def _version_there() -> str:
    return __version__


def _lost(what: str, address: str) -> InputError:
    return InputError(what, where="--cluster", got=address, remedy=f"start it again; {GOES_ON}")


class _Workers:
    def __init__(self, client: Any, address: str, silence: float) -> None:
        from distributed import KilledWorker

        self._client, self._executor = client, client.get_executor(pure=False)
        self._address, self._silence = address, silence
        self._looked = time.monotonic()
        self._mute: float | None = None
        self._gone: float | None = None
        self._beats: dict[str, tuple[float, float]] = {}
        self.died: tuple[type[BaseException], ...] = (KilledWorker,)

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        future: Future[list[Any]] = self._executor.submit(work, chunk)
        return future

    def renew(self) -> None:
        """The cluster's own tools replace workers; its scheduler gives their work to others."""

    def require_alive(self) -> None:
        """Raise InputError if the scheduler has stopped, or all workers left and none came since.

        Workers that have stopped are taken off the cluster.
        """
        now = time.monotonic()
        if now < self._looked + LOOK:
            return
        self._looked = now
        try:
            there = _workers(self._client, LOOK)
            self._mute = None
            for worker in self._stopped(there, now):
                self._client.sync(
                    self._client.scheduler.unregister,
                    address=worker,
                    stimulus_id="orishell-heard-nothing",
                    callback_timeout=LOOK,
                )
        except OSError:  # if it is lost, what is under way will say so
            self._mute = now if self._mute is None else self._mute
            if now > self._mute + self._silence:
                raise _lost("the cluster does not answer any more", self._address) from None
            return
        if there:
            self._gone = None
        elif self._gone is None:
            self._gone = now
        elif now > self._gone + PATIENCE:
            raise InputError(
                "all workers have left the cluster",
                where="--cluster",
                remedy=f"start others; {GOES_ON}",
            )

    def _stopped(self, there: dict[str, dict[str, Any]], now: float) -> list[str]:
        """Workers whose last word is the one that was known so long ago."""
        before = self._beats
        self._beats = {
            worker: before[worker]
            if worker in before and before[worker][0] == each["last_seen"]
            else (each["last_seen"], now)
            for worker, each in there.items()
        }
        return [worker for worker, (_, since) in self._beats.items() if now > since + self._silence]
