"""Processes: one slow request is stopped in time and is in nobody's way."""

import asyncio
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path
from typing import Any

import pytest

from apart import run_apart
from never_ending import answer_or_never
from orishell.design_file import starter_file
from orishell.studio.processes import Worker
from orishell.studio.refusals import RefusalError
from orishell.studio.tasks import answer
from orishell.studio.workers import BusyError, FaultError, OutOfTimeError, Pool
from timing import HANGS


def said_by(program: str, *arguments: str) -> str:
    """What a program prints that finds the tests' modules."""
    call = [sys.executable, "-c", program, *arguments]
    found = os.pathsep.join(sys.path)
    environment = {**os.environ, "PYTHONPATH": found}
    done = subprocess.run(call, check=True, capture_output=True, text=True, env=environment)
    return done.stdout.strip()


def payload(rows: int = 9, columns: int = 11) -> dict[str, Any]:
    design = tomllib.loads(starter_file("parallel-repeating"))
    design["pattern"] |= {"rows": rows, "columns": columns}
    return {"design": design}


def test_a_loop_that_watches_no_pipes() -> None:
    """As that of Windows: answers come all the same, and what takes too long is stopped."""

    async def scene() -> None:
        loop = asyncio.get_running_loop()
        watching = loop.add_reader

        def refuse(fileno: int, *_: Any) -> None:
            raise NotImplementedError

        pool = Pool(answer_or_never, 1, seconds=HANGS)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(loop, "add_reader", refuse, raising=False)
            assert len(await pool.run("design", payload())) > 10_000
            pool.seconds = 0.5
            with pytest.raises(OutOfTimeError):
                await pool.run("never", {})
        assert loop.add_reader == watching
        pool.close()

    run_apart(scene())


def test_slow_requests_are_stopped_and_others_go_on() -> None:
    async def scene() -> None:
        pool = Pool(answer_or_never, 2, seconds=HANGS)
        started = (pool.run("parse", {"text": ""}) for _ in range(2))
        await asyncio.gather(*started, return_exceptions=True)
        slow = pool.stream("never", {})
        assert (await anext(slow))[0] == "progress"
        # The other process answers while this one is at work.
        assert len(await pool.run("design", payload())) > 10_000
        await slow.aclose()
        pool.seconds = 0.5
        with pytest.raises(OutOfTimeError):
            await pool.run("never", {})
        pool.seconds = HANGS
        # Its process is gone, another takes its place: both answer.
        views = await asyncio.gather(*(pool.run("design", payload()) for _ in range(2)))
        assert all(len(view) > 10_000 for view in views)
        pool.close()

    run_apart(scene())


def test_a_stream_that_is_closed_stops_its_work() -> None:
    async def scene() -> None:
        pool = Pool(answer_or_never, 1, seconds=10 * HANGS)
        stream = pool.stream("never", {})
        kind, _ = await anext(stream)
        assert kind == "progress"
        await stream.aclose()
        # It is the only process: this would wait for what never ends.
        view = await asyncio.wait_for(pool.run("design", payload()), HANGS)
        assert len(view) > 10_000
        pool.close()

    run_apart(scene())


def test_refusals_and_lines_that_are_too_long() -> None:
    async def scene() -> None:
        pool = Pool(answer, 1, seconds=60.0, waiting=1)
        with pytest.raises(RefusalError) as caught:
            await pool.run("parse", {"text": "[shell"})
        assert "TOML" in caught.value.body["error"]["message"]
        first = asyncio.create_task(pool.run("design", payload()))
        await asyncio.sleep(0)
        second = asyncio.create_task(pool.run("design", payload()))
        await asyncio.sleep(0)
        with pytest.raises(BusyError):
            await pool.run("design", payload())
        await asyncio.gather(first, second)
        pool.close()

    run_apart(scene())


def test_what_comes_after_a_stopped_task_waits_for_no_imports() -> None:
    # In a program of its own: what this one has started before may have imported all.
    program = """
import asyncio
from orishell.studio.processes import prepared_copies
from orishell.studio.workers import Pool
from warmth import notes_warmth

async def scene():
    pool = Pool(notes_warmth, 1, seconds=60.0)
    stream = pool.stream("stay", {})
    kind, (stopped, warm) = await anext(stream)
    await stream.aclose()
    process, after = await pool.run("who", {})
    pool.close()
    print(kind, warm, process != stopped, after)

with prepared_copies():
    asyncio.run(scene())
"""
    assert said_by(program) == "progress warm True True"


def test_a_process_that_cannot_start_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: object) -> Worker:
        raise OSError("no room")

    async def scene() -> None:
        pool = Pool(answer, 1, seconds=60.0)
        for _ in range(2):
            with pytest.raises(FaultError, match="no room"):
                await pool.run("parse", {"text": ""})
        monkeypatch.undo()
        with pytest.raises(RefusalError):
            await pool.run("parse", {"text": "x"})
        pool.close()

    monkeypatch.setattr("orishell.studio.workers.start_worker", refuse)
    run_apart(scene())


def test_the_studio_warms_up_with_all_that_answers_import() -> None:
    program = """
import json, sys
from orishell.conventions.progress import no_progress
from orishell.studio.tasks import answer
payload = json.loads(sys.argv[1])
answer("warm_up", {}, no_progress)
before = set(sys.modules)
for name in ("design", "verify", "ranges"):
    answer(name, payload, no_progress)
print(sorted(set(sys.modules) - before))
"""
    assert said_by(program, json.dumps(payload())) == "[]"


def test_what_is_stopped_leaves_no_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))

    async def scene() -> None:
        pool = Pool(answer, 1, seconds=60.0)
        with contextlib.suppress(RefusalError):
            await pool.run("parse", {"text": ""})
        (files,) = tmp_path.glob("orishell-*")
        # The process works in this directory, whatever it leaves there.
        pdf = {**payload(), "format": "pdf"}  # takes a while to write
        export = asyncio.create_task(pool.run("export", pdf))
        while not list(files.iterdir()) and not export.done():
            await asyncio.sleep(0.002)
        assert not export.done()
        export.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await export
        assert not list(tmp_path.glob("orishell-*"))
        pool.close()

    run_apart(scene())
