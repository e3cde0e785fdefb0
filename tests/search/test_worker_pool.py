"""A process that dies costs its work again; what kills every process costs itself only."""

from __future__ import annotations

import os
import signal
import threading
import time
from dataclasses import replace
from pathlib import Path

import pytest

from orishell.search.worker_pool import local_processes
from search.deadly import DEADLY, doubled, process

NEVER = threading.Event()


@pytest.mark.parametrize(("processes", "chunk"), [(1, 1), (1, 8), (2, 3)])
def test_what_kills_processes_costs_itself_only(processes: int, chunk: int) -> None:
    items = list(range(20))
    with local_processes(processes) as pool:
        work = replace(pool, largest_chunk=chunk).work(doubled, items, NEVER)
        found = {
            item: None if done is None else done[k]
            for given, done in work
            for k, item in enumerate(given)
        }
    assert found == {item: None if item == DEADLY else 2 * item for item in items}


def test_a_process_that_dies_with_nothing_to_do_is_replaced() -> None:
    with local_processes(1) as pool:
        [(_, before)] = pool.work(process, [0], NEVER)
        assert before is not None
        os.kill(before[0], signal.SIGKILL)
        while Path(f"/proc/{before[0]}").exists():
            time.sleep(0.01)
        time.sleep(0.2)  # until its pool knows
        [(_, after)] = pool.work(process, [0], NEVER)
    assert after is not None
    assert after != before


def test_no_work_is_begun_once_it_is_to_stop() -> None:
    stop = threading.Event()
    stop.set()
    with local_processes(1) as pool:
        assert list(pool.work(doubled, [1, 2], stop)) == []
