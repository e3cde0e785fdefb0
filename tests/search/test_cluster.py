"""A search on a Dask cluster: the bytes of processes of this machine, whatever dies."""

from __future__ import annotations

import signal
import socket
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import pytest

from command_line import orishell, orishell_process
from orishell.conventions.errors import InputError
from orishell.search import dask_workers
from orishell.search.cluster import AHEAD
from orishell.search.evaluate import evaluate, job_of
from samples import thorough
from search.dask_cluster import DaskCluster, dask_cluster
from search.problems import small_problem
from search.searching import lines, searched, searching, wait_for_lines, written
from timing import HANGS

pytestmark = pytest.mark.slow
MOST_STOPPING = HANGS
"""Seconds: 5 on a machine of its own, and others run beside a test."""
T = TypeVar("T")


def apart(call: Callable[[], T]) -> T:
    """Call in a thread of its own: the loop of the tests' browser may have this one."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(call).result()


def enter(address: str, timeout: float = 10.0) -> int:
    """Be connected to a cluster for a moment; how many chunks it would take."""
    with dask_workers(address, timeout=timeout) as pool:
        return len(pool.slots)


@pytest.fixture(scope="module")
def two_workers(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DaskCluster]:
    with dask_cluster(tmp_path_factory.mktemp("dask"), 2) as running:
        yield running


@thorough  # processes of one machine: test_running
def test_a_cluster_gives_the_same_bytes(
    file: Path, whole: dict[str, bytes], two_workers: DaskCluster, tmp_path: Path
) -> None:
    searched(file, tmp_path / "out", "--cluster", two_workers.address)
    assert written(tmp_path / "out") == whole


@thorough
def test_a_worker_that_dies_costs_nothing_but_time(
    file: Path, whole: dict[str, bytes], two_workers: DaskCluster, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    running = searching(file, out, "--cluster", two_workers.address)
    wait_for_lines(running, out, 6)
    two_workers.workers[0].kill()
    two_workers.add_worker()
    _, errors = running.communicate(timeout=180)
    assert running.returncode == 0, errors
    assert written(out) == whole


@thorough
def test_a_search_that_loses_its_cluster_goes_on_without(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    with dask_cluster(tmp_path, 1) as short:
        running = searching(file, out, "--cluster", short.address)
        wait_for_lines(running, out, 6)
    _, errors = running.communicate(timeout=180)
    assert running.returncode == 2
    assert "the cluster was lost" in errors
    assert "Traceback" not in errors
    assert lines(out) >= 6
    searched(file, out)
    assert written(out) == whole


def test_a_cluster_that_does_not_answer_is_refused(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))  # taken, and nobody listens
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        for each in (address, "no address", ""):
            done = apart(partial(orishell, "search", file, "--out", out, "--cluster", each))
            assert done.returncode == 2
            assert "--cluster: no scheduler answers" in done.stderr
            assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "out").exists()


def test_a_server_that_is_no_scheduler_is_refused(file: Path, tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:

        def answer() -> None:
            other.accept()[0].close()  # a look whether anybody is there at all
            connection, _ = other.accept()
            with connection:
                connection.sendall(b"HTTP/1.0 400 Bad Request\r\n\r\n")

        answering = threading.Thread(target=answer)
        answering.start()
        address = f"tcp://127.0.0.1:{other.getsockname()[1]}"
        done = orishell_process("search", file, "--out", tmp_path, "--cluster", address)
        answering.join()
    assert done.returncode == 2
    assert "--cluster: no scheduler answers" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_a_scheduler_that_accepts_and_is_silent_is_refused() -> None:
    """It would be waited for without end."""
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"tcp://127.0.0.1:{silent.getsockname()[1]}"
        with pytest.raises(InputError, match=r"no scheduler answers.*time is up"):
            apart(lambda: enter(address, 1.0))


def test_a_cluster_without_workers_is_refused(tmp_path: Path) -> None:
    with (
        dask_cluster(tmp_path, 0) as empty,
        pytest.raises(InputError, match="the cluster has no workers"),
    ):
        apart(lambda: enter(empty.address, 2.0))


@thorough
def test_a_scheduler_that_stops_ends_a_search(tmp_path: Path) -> None:
    with dask_cluster(tmp_path, 1) as running:
        apart(lambda: list(work_on(running.address, 1)))  # while workers import they say nothing

        def work() -> None:
            for _ in work_on(running.address, timeout=2.0):
                running.scheduler.send_signal(signal.SIGSTOP)

        with pytest.raises(InputError, match="the cluster does not answer any more"):
            apart(work)


@thorough
def test_workers_that_stop(file: Path, tmp_path: Path) -> None:
    """They are named before a search; in one, others do their work; and none holds up its end."""
    with dask_cluster(tmp_path, 2) as running:
        while apart(lambda: enter(running.address)) < 2 * AHEAD:
            time.sleep(0.1)
        first, second = running.workers
        first.send_signal(signal.SIGSTOP)
        with pytest.raises(InputError, match="a worker does not answer"):
            apart(lambda: enter(running.address, 5.0))
        first.send_signal(signal.SIGCONT)
        apart(lambda: list(work_on(running.address, 1)))  # while workers import they say nothing

        def work() -> int:
            made = 0
            for chunk, done in work_on(running.address, 3, timeout=4.0):
                first.send_signal(signal.SIGSTOP)
                assert done is not None
                made += len(chunk)
            return made

        assert apart(work) == 3 * 27
        out = tmp_path / "out"
        search = searching(file, out, "--cluster", running.address)
        wait_for_lines(search, out, 4)
        second.send_signal(signal.SIGSTOP)
        search.send_signal(signal.SIGTERM)
        begun = time.monotonic()
        _, errors = search.communicate(timeout=120)
        assert search.returncode == 128 + signal.SIGTERM, errors
        assert time.monotonic() - begun < MOST_STOPPING
    assert (out / "front.csv").is_file()


def test_workers_of_another_version_are_refused(
    two_workers: DaskCluster, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("orishell.search.cluster.__version__", "99.0")
    with pytest.raises(InputError, match="a worker does not have this orishell"):
        apart(lambda: enter(two_workers.address))


def test_dask_that_is_not_installed_is_said(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    out = tmp_path / "out"
    done = apart(lambda: orishell("search", file, "--out", out, "--cluster", "tcp://127.0.0.1:1"))
    assert done.returncode == 2
    assert "pip install orishell[cluster]" in done.stderr


def work_on(
    address: str, times: int = 30, timeout: float = 10.0
) -> Iterator[tuple[Sequence[Any], list[Any] | None]]:
    """A small grid, so many times, on a cluster, in pieces: a minute's work without a number."""
    problem = small_problem("parallel-repeating")
    variants = [*problem.space.grid()] * times
    with dask_workers(address, timeout=timeout) as pool:
        yield from pool.work(partial(evaluate, job_of(problem)), variants, threading.Event())


@thorough
def test_workers_that_all_leave_end_a_search(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("orishell.search.cluster.PATIENCE", 1.0)

    def lose(running: DaskCluster) -> None:
        for done, _ in enumerate(work_on(running.address)):
            if done == 2:
                running.workers[0].kill()

    with (
        dask_cluster(tmp_path, 1) as running,
        pytest.raises(InputError, match="all workers have left the cluster"),
    ):
        apart(lambda: lose(running))
