"""A Dask cluster on this machine: a scheduler and workers with one thread, real processes."""

from __future__ import annotations

import contextlib
import json
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

SECONDS = 60.0
"""So long a scheduler or a worker may take to start."""


@dataclass(slots=True)
class DaskCluster:
    """A scheduler, where it answers, and its workers."""

    directory: Path
    scheduler: subprocess.Popen[bytes]
    address: str
    workers: list[subprocess.Popen[bytes]] = field(default_factory=list)

    def add_worker(self) -> None:
        """Start one more."""
        options = ["--nthreads", "1", "--no-nanny", "--no-dashboard"]
        place = ["--local-directory", str(self.directory)]
        self.workers.append(_started("dask_worker", self.address, *options, *place))


@contextlib.contextmanager
def dask_cluster(directory: Path, workers: int) -> Iterator[DaskCluster]:
    """A cluster that runs as long as this lasts."""
    told = directory / "scheduler.json"
    place = ["--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(told)]
    scheduler = _started("dask_scheduler", *place, "--no-dashboard")
    cluster = DaskCluster(directory, scheduler, "")
    try:
        cluster.address = _address(told)
        for _ in range(workers):
            cluster.add_worker()
        yield cluster
    finally:
        for process in (*cluster.workers, scheduler):
            process.kill()
            process.wait()


def _started(program: str, *options: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", f"distributed.cli.{program}", *options]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def _address(told: Path) -> str:
    end = time.monotonic() + SECONDS
    while True:
        with contextlib.suppress(FileNotFoundError, json.JSONDecodeError):
            return str(json.loads(told.read_text())["address"])
        assert time.monotonic() < end
        time.sleep(0.05)
