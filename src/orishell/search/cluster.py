"""The workers of a Dask cluster, as they do the work of a search."""

from __future__ import annotations

import contextlib
import logging
import socket
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError, Future
from typing import Any

from orishell.conventions.version import __version__
from orishell.errors import InputError
from orishell.search.crew import Crew, Place, Work

TIMEOUT = 10.0
"""Seconds within which a cluster must answer, and have a worker."""
GOES_ON = "the same command goes on where this one was"
PATIENCE = 60.0
"""Seconds within which another worker must be there, where all have left."""
LOOK = 1.0
"""Seconds after which it is looked whether workers are there."""
AHEAD = 2
"""Chunks under way for each thread of a worker: the next one is there when one is done."""


@contextlib.contextmanager
def dask_workers(address: str) -> Iterator[Crew]:
    """The workers of a Dask cluster that there are now.

    Parameters
    ----------
    address
        Of its scheduler, such as ``tcp://10.0.0.1:8786``.

    Raises
    ------
    InputError
        If Dask is not installed, nothing answers there, there are no workers, they have no
        orishell of this version, or the cluster or all of its workers are lost on the way.
    """
    client = _connected(address)
    try:
        threads = _threads(client, address)
        executor = client.get_executor(pure=False)
        place = _Workers(client, executor)
        places: list[Place] = [place] * (AHEAD * threads)
        yield Crew(places, require_alive=place.require_alive)
        executor.shutdown(wait=False)
    except CancelledError:
        raise InputError(
            "the cluster was lost",
            where="--cluster",
            got=address,
            remedy=f"start it again; {GOES_ON}",
        ) from None
    finally:
        client.close(timeout=TIMEOUT)


def _connected(address: str) -> Any:
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
    try:
        with socket.create_connection(get_address_host_port(address), TIMEOUT):
            connect: Any = Closed
            return connect(address, timeout=TIMEOUT, set_as_default=False)
    except Exception as error:  # whatever it makes of an answer that is none
        raise InputError(
            "no scheduler answers",
            where="--cluster",
            got=f"{address!r} ({str(error).splitlines()[0][:100] if str(error) else 'time is up'})",
            expected="the address of a Dask scheduler, as tcp://10.0.0.1:8786",
            remedy="start one with dask scheduler, and workers with dask worker ADDRESS",
        ) from None


def _threads(client: Any, address: str) -> int:
    """Threads of all workers; raises InputError if there are none, or they are not as this."""
    try:
        client.wait_for_workers(1, timeout=TIMEOUT)
    except TimeoutError:
        raise InputError(
            "the cluster has no workers",
            where="--cluster",
            got=address,
            remedy=f"start some: dask worker {address} --nthreads 1",
        ) from None
    found: dict[str, Any] = client.run(_version_there, on_error="return")
    for worker, version in found.items():
        if version != __version__:
            raise InputError(
                "a worker does not have this orishell",
                where=f"--cluster: {worker}",
                got=f"{version!r}"[:100],
                expected=__version__,
                remedy=f"install orishell {__version__} where workers run",
            )
    return sum(client.nthreads().values())


def _version_there() -> str:
    return __version__


class _Workers:
    def __init__(self, client: Any, executor: Any) -> None:
        from distributed import KilledWorker

        self._client, self._executor = client, executor
        self._looked = time.monotonic()
        self._gone: float | None = None
        self.died: tuple[type[BaseException], ...] = (KilledWorker,)

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        future: Future[list[Any]] = self._executor.submit(work, chunk)
        return future

    def renew(self) -> None:
        """The cluster's own tools replace workers; its scheduler gives their work to others."""

    def require_alive(self) -> None:
        """Raise InputError if all workers have left, and none has come since."""
        now = time.monotonic()
        if now < self._looked + LOOK:
            return
        self._looked = now
        try:
            there = self._client.nthreads(callback_timeout=LOOK)
        except OSError:  # what is under way will say that the cluster was lost
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
