"""What processes and a cluster gain, and what the search itself costs: ratios of one run."""

from __future__ import annotations

import time
from collections.abc import Sequence
from concurrent.futures import Future
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.search import (
    WorkerPool,
    alone,
    dask_workers,
    journal_in_memory,
    local_processes,
    search_designs,
)
from orishell.search.problem import Problem, parse_problem
from orishell.search.worker_pool import Work
from search.dask_cluster import dask_cluster

SEARCH: dict[str, Any] = {
    "variables": {
        "pattern.depth": {"low": 0.03, "high": 0.2},
        "pattern.heading_deg": {"low": 70.0, "high": 110.0},
        "target.f.scale": {"low": 0.8, "high": 1.2},
    },
    "minimise": ["sheet_area", "deployed.width"],
}


def problem(evaluations: int) -> Problem:
    """A search of orthodiagonal shells, some tens of milliseconds each."""
    tables = parse_toml(starter_file("orthodiagonal"))
    tables["pattern"] |= {"rows": 5, "columns": 7}
    return parse_problem(
        {**tables, "search": {**SEARCH, "evaluations": evaluations}}, Path("search.toml")
    )


def seconds(evaluations: int, workers: AbstractContextManager[WorkerPool]) -> float:
    """Time of a search, from start to end."""
    asked = problem(evaluations)
    begin = time.perf_counter()
    with workers as pool:
        found = search_designs(asked, pool, journal_in_memory())
    assert len(found.outcomes) == evaluations
    return time.perf_counter() - begin


def test_two_processes(benchmark: Any) -> None:
    one = seconds(600, local_processes(1))
    two = benchmark.pedantic(seconds, args=(600, local_processes(2)), rounds=1)
    print(f"\n{600 / one:.1f} and {600 / two:.1f} designs a second: {one / two:.2f} times")


def test_overhead(benchmark: Any) -> None:
    """What a search in one process takes beyond the time in which it makes designs."""
    asked = problem(400)
    seconds(10, alone())  # what is imported is imported
    place = _Timed()
    begin = time.process_time()
    benchmark.pedantic(
        search_designs, args=(asked, WorkerPool([place], 1), journal_in_memory()), rounds=1
    )
    whole = time.process_time() - begin
    share = (whole - place.seconds) / place.seconds
    print(f"\nthe search costs {100 * share:.1f} % of making its designs")


class _Timed:
    """This process, and the time in which it works."""

    died: tuple[type[BaseException], ...] = ()
    seconds = 0.0

    def submit(self, work: Work, chunk: Sequence[Any]) -> Future[list[Any]]:
        future: Future[list[Any]] = Future()
        begin = time.process_time()
        future.set_result(work(chunk))
        self.seconds += time.process_time() - begin
        return future

    def renew(self) -> None: ...


def test_dask(benchmark: Any, tmp_path: Path) -> None:
    local = seconds(2000, local_processes(2))
    with dask_cluster(tmp_path, 2) as cluster:
        seconds(20, dask_workers(cluster.address))  # both workers are there, and have imported
        far = benchmark.pedantic(seconds, args=(2000, dask_workers(cluster.address)), rounds=1)
    print(
        f"\n2000 designs: {local:.1f} s on two processes, {far:.1f} s on two workers of Dask: "
        f"{far / local:.2f} times"
    )
