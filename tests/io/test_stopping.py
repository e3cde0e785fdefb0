"""Runs that are killed or told to stop at every step: whole files, and nobody else's touched.

Steps are the calls of the system that Python's audit hooks report. This file is also the script
that the runs are forks of.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import warnings
from collections import Counter
from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.progress import stop_quietly
from orishell.io import OutputDirectory
from orishell.io.manifest import NAME, require_one_run

STEPS = ("open", "os.mkdir", "os.rename", "os.remove", "os.rmdir", "shutil.rmtree", "os.listdir")
OLD = {name: f"old {name}" for name in "abcd"}
NEW = {name: f"new {name}" for name in "bcxy"}
MINE = {"mine": "mine"}
STATUS = {"SIGKILL": -9, "SIGTERM": 143, "SIGINT": 130}


def write(directory: Path, files: dict[str, str], *, force: bool = False) -> None:
    with OutputDirectory(directory, force=force).replacing() as draft:
        for name, text in files.items():
            (draft / name).write_text(text)


def found(directory: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in directory.iterdir() if path.name != NAME}


@pytest.fixture(scope="module")
def runs(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[str, Path, int]]:
    """Signal, directory and status of every run; the last of each signal came to its end."""
    root = tmp_path_factory.mktemp("runs")
    script = [sys.executable, __file__, str(root)]
    done = subprocess.run(script, capture_output=True, text=True, check=True, timeout=120)
    assert done.stderr == ""
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return [(name, root / directory, status) for name, directory, status in lines]


def test_whoever_is_told_to_stop_leaves_all_files_or_none(
    runs: list[tuple[str, Path, int]],
) -> None:
    ends: Counter[bool] = Counter()
    for name, directory, status in runs:
        if name == "SIGKILL" or status == 0:
            continue
        assert status == STATUS[name]
        files = found(directory)
        assert files in (OLD | MINE, NEW | MINE)
        require_one_run(directory / "b")
        ends[files == OLD | MINE] += 1
    assert min(ends[True], ends[False]) > 5


def test_files_of_two_runs_are_known_and_the_next_run_makes_order(
    runs: list[tuple[str, Path, int]],
) -> None:
    mixed = 0
    for name, directory, status in runs:
        if name != "SIGKILL" or status == 0:
            continue
        assert status == STATUS[name]
        files = {path.name: path.read_text() for path in directory.iterdir() if path.is_file()}
        files.pop(NAME)
        if files not in (OLD | MINE, NEW | MINE):
            mixed += 1
            with pytest.raises(InputError, match=r"broken off .* got \d of 4 files"):
                require_one_run(directory / "b")
        write(directory, {"z": "next"})
        assert found(directory) == {"z": "next"} | MINE
        require_one_run(directory / "z")
    # Four files are moved and two removed: between them are five states of both runs.
    assert mixed >= 5


def test_what_somebody_changed_or_added_stays(tmp_path: Path) -> None:
    write(tmp_path, OLD)
    first = (tmp_path / NAME).read_bytes()
    (tmp_path / "a").write_text("changed by hand")
    (tmp_path / "d").unlink()
    (tmp_path / "mine").write_text("mine")
    before = found(tmp_path)
    with pytest.raises(InputError, match="a: this file was changed since orishell wrote it"):
        write(tmp_path, {"b": "new"})
    assert found(tmp_path) == before
    write(tmp_path, {"b": "new"}, force=True)  # and what is not written over stays even so
    assert found(tmp_path) == {"a": "changed by hand", "b": "new"} | MINE
    for path in tmp_path.iterdir():
        path.unlink()
    write(tmp_path, OLD)
    assert (tmp_path / NAME).read_bytes() == first


@pytest.mark.parametrize("name", ["../outside", "{root}/outside", "link", "directory", ".", ""])
def test_a_list_by_somebody_else_removes_nothing_elsewhere(tmp_path: Path, name: str) -> None:
    (tmp_path / "outside").write_text("x")
    directory = tmp_path / "out"
    (directory / "directory").mkdir(parents=True)
    (directory / "link").symlink_to(tmp_path / "outside")
    digest = "2d711642b726b04401627ca9fbac32f5c8530fb1903cc4db02258717921a4881"  # of "x"
    listed = {"files": {name.format(root=tmp_path): digest}}
    (directory / NAME).write_text(json.dumps(listed))
    write(directory, NEW, force=True)
    assert (tmp_path / "outside").read_text() == "x"
    assert {path.name for path in directory.iterdir()} == {NAME, *NEW, "link", "directory"}


@pytest.mark.parametrize(
    "text", ["", "[]", "{", "[" * 100_000, '{"files": {"a": 3}}', '{"files": {"a": ["x"]}}', "\0"]
)
def test_a_list_that_is_damaged_is_none(tmp_path: Path, text: str) -> None:
    (tmp_path / "a").write_text("mine")
    (tmp_path / NAME).write_text(text)
    require_one_run(tmp_path / "a")
    with pytest.raises(InputError, match="this file is not of orishell"):
        write(tmp_path, NEW)
    assert (tmp_path / NAME).read_text() == text
    write(tmp_path, NEW, force=True)
    assert found(tmp_path) == {"a": "mine"} | NEW


def test_the_temporary_directory_of_a_run_that_lives_stays(tmp_path: Path) -> None:
    with OutputDirectory(tmp_path).replacing() as draft:
        write(tmp_path, OLD)
        assert draft.is_dir()
        (draft / "e").write_text("e")
    assert found(tmp_path) == {"e": "e"}


def run(directory: Path, number: signal.Signals, step: int) -> None:
    """Write the new files; the signal comes at a step."""
    steps = 0

    def hook(event: str, _: object) -> None:
        nonlocal steps
        if event in STEPS:
            steps += 1
            if steps == step:
                os.kill(os.getpid(), number)

    stop_quietly()
    sys.addaudithook(hook)
    write(directory, NEW)


def main(root: Path) -> None:
    warnings.simplefilter("ignore")  # forking is safe: there is no other thread of Python
    for name in STATUS:
        status, step = -1, 0
        while status != 0:
            step += 1
            directory = root / f"{name}-{step}"
            write(directory, OLD)
            (directory / "mine").write_text("mine")
            child = os.fork()
            if not child:
                run(directory, signal.Signals[name], step)
                os._exit(0)
            status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            sys.stdout.write(json.dumps([name, directory.name, status]) + "\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
