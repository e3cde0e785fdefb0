"""The same search gives the same files, whoever does its work and whatever happens to it."""

from __future__ import annotations

import json
import os
import random
import signal
import time
import tomllib
from pathlib import Path

import pytest

from command_line import orishell
from orishell.search.journal import NAME
from samples import THOROUGH, led_by, thorough
from search.searching import design, lines, searched, searching, wait_for_lines, written
from studio_server import descendants
from timing import HANGS

pytestmark = pytest.mark.slow


def wait_for_end(processes: set[str]) -> None:
    """Wait until processes have ended of themselves, as they must within seconds."""
    end = time.monotonic() + HANGS
    while any(Path(f"/proc/{each}").exists() for each in processes):
        assert time.monotonic() < end, processes
        time.sleep(0.05)


def test_the_files(file: Path, whole: dict[str, bytes]) -> None:
    members = sorted(name for name in whole if name.endswith(".toml"))
    assert members
    assert {*whole} == {".orishell-search.json", "front.csv", "front.html", "front.png", *members}
    table = [line.split(",") for line in whole["front.csv"].decode().splitlines()]
    keys = ["pattern.rows", "pattern.columns", "pattern.xi_deg"]
    assert table[0] == ["file", "knee", *keys, "panels", "sheet_area"]
    assert [row[0] for row in table[1:]] == members
    assert [row[1] for row in table[1:]].count("knee") == 1
    rows = [(float(row[5]), float(row[6])) for row in table[1:]]
    assert rows == sorted(rows)


def test_a_member_s_file_makes_what_the_front_says(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    first = whole["front.csv"].decode().splitlines()[1].split(",")
    text = whole[first[0]].decode()
    assert "search" not in tomllib.loads(text)
    assert "# the curve that is swept" in text  # comments are kept
    (tmp_path / first[0]).write_text(text, encoding="utf-8")
    done = orishell("design", tmp_path / first[0], "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert report["rows"] == int(first[2])
    assert report["quantities"]["area"] == float(first[6])


@pytest.mark.parametrize("processes", led_by([2, 4]))
def test_any_number_of_processes_gives_the_same_bytes(
    file: Path, whole: dict[str, bytes], tmp_path: Path, processes: int
) -> None:
    searched(file, tmp_path / "out", "--processes", str(processes))
    assert written(tmp_path / "out") == whole


@thorough  # a process that ends: test_worker_pool
def test_a_process_that_dies_costs_nothing_but_time(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    running = searching(file, out, "--processes", "2")
    for count in (4, 10):
        wait_for_lines(running, out, count)
        workers = [each for each in sorted(descendants(running.pid)) if is_worker(each)]
        assert workers
        os.kill(int(workers[-1]), signal.SIGKILL)
    _, errors = running.communicate(timeout=120)
    assert running.returncode == 0, errors
    assert written(out) == whole


def is_worker(process: str) -> bool:
    """Whether a process does work, and is not the one that it is a copy of."""
    return bool(descendants(int(process))) is False and "resource_tracker" not in command(process)


def command(process: str) -> str:
    return Path(f"/proc/{process}/cmdline").read_text()


@thorough
def test_a_search_killed_again_and_again_ends_with_the_same_bytes(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    moments = random.Random(18)
    for kill in range(5 if THOROUGH else 2):
        running = searching(file, out, "--processes", "2")
        wait_for_lines(running, out, 1 + 4 * kill)
        time.sleep(moments.uniform(0.0, 0.4))
        of_it = descendants(running.pid)
        running.kill()
        running.communicate()
        wait_for_end(of_it)
    made = lines(out)
    assert made > 1
    printed = searched(file, out, "--processes", "2")
    assert "searched  20 designs" in printed
    assert written(out) == whole


@thorough
def test_a_line_that_was_broken_off_is_made_again(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    journal = (file.parent / "one" / NAME).read_bytes()
    (out / NAME).write_bytes(journal[: 2 * len(journal) // 3])
    kept = lines(out)
    searched(file, out)
    assert written(out) == whole
    assert lines(out) == journal.count(b"\n") > kept


@thorough
def test_ctrl_c_writes_what_there_is(file: Path, whole: dict[str, bytes], tmp_path: Path) -> None:
    out = tmp_path / "out"
    running = searching(file, out, "--processes", "1")
    wait_for_lines(running, out, 4)
    running.send_signal(signal.SIGINT)
    printed, errors = running.communicate(timeout=120)
    assert running.returncode == 130
    assert "orishell: stopping, and writing what there is" in errors
    assert "stopped before its end: the same command goes on" in printed
    assert {"front.csv", "front.png", "front-01.toml"} <= {*written(out)}
    assert lines(out) < 22
    searched(file, out)
    assert written(out) == whole


def test_two_searches_in_one_directory(file: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    running = searching(file, out, "--processes", "1")
    try:
        wait_for_lines(running, out, 2)
        second = orishell("search", file, "--out", out)
        assert second.returncode == 2
        assert "another search writes here" in second.stderr
    finally:
        running.kill()
        running.communicate()


def test_a_search_does_not_write_over_its_design(tmp_path: Path) -> None:
    file = design(tmp_path).rename(tmp_path / "front-01.toml")
    before = file.read_bytes()
    done = orishell("search", file, "--out", tmp_path)
    assert done.returncode == 2
    assert "this file is read, and would be written over" in done.stderr
    assert file.read_bytes() == before
    assert list(tmp_path.iterdir()) == [file]


def test_a_search_does_not_write_over_what_was_changed(
    file: Path, whole: dict[str, bytes], tmp_path: Path
) -> None:
    for name, content in whole.items():
        (tmp_path / name).write_bytes(content)
    (tmp_path / "front-01.toml").write_bytes(whole["front-01.toml"] + b"# mine\n")
    done = orishell("search", file, "--out", tmp_path)
    assert done.returncode == 2
    assert (
        f"{tmp_path / 'front-01.toml'}: this file was changed since orishell wrote it"
        in done.stderr
    )
    assert written(tmp_path) == {**whole, "front-01.toml": whole["front-01.toml"] + b"# mine\n"}


def test_a_design_among_the_files_of_a_search_leaves_them(
    whole: dict[str, bytes], tmp_path: Path
) -> None:
    for name, content in whole.items():
        (tmp_path / name).write_bytes(content)
    done = orishell("design", tmp_path / "front-01.toml", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    assert {name: (tmp_path / name).read_bytes() for name in whole} == whole
