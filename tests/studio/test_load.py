"""Some people drag at once for a while: every answer comes, and memory stays flat."""

from __future__ import annotations

import asyncio
import copy
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import pytest

from apart import run_apart
from orishell.design_file import starter_file
from samples import thorough
from studio_server import Studio, descendants, running_studio

LEAST = 3
"""So many answers everyone waits for, each for a minute at most."""
GROWTH = 1.15
"""How much more memory the second half of the time may take than the first."""


def memory(process: int) -> int:
    """Resident memory of a process and its descendants (kB), as the kernel says."""
    total = 0
    for each in {str(process), *descendants(process)}:
        try:
            text = Path(f"/proc/{each}/status").read_text()
        except (FileNotFoundError, ProcessLookupError):
            continue  # it ended meanwhile
        total += sum(map(int, re.findall(r"^VmRSS:\s+(\d+)", text, re.MULTILINE)))
    return total


async def drag(studio: Studio, number: int, end: float) -> int:
    """Move a curve again and again, and wait for every answer; returns how many there were."""
    design: dict[str, Any] = tomllib.loads(starter_file("orthodiagonal"))
    points = [[x / 2, -((x / 2) ** 2)] for x in range(-2, 3)]
    design["target"]["f"] = {"points": points, "smooth": True}
    answers = 0
    loop = asyncio.get_running_loop()
    async with httpx.AsyncClient(
        base_url=studio.address, cookies=studio.cookies, timeout=60
    ) as client:
        while loop.time() < end or answers < LEAST:  # a busy machine may take longer
            moved = copy.deepcopy(design)
            moved["target"]["f"]["points"][2][1] += 0.01 * ((answers + number) % 20)
            answer = await client.post("/api/design", json={"design": moved, "states": 13})
            assert answer.status_code in (200, 422), answer.text
            if answer.status_code == 422:
                assert answer.json()["error"]["kind"] == "design"
            answers += 1
    return answers


@thorough
@pytest.mark.slow
@pytest.mark.parametrize(("clients", "seconds"), [(4, 5.0), pytest.param(20, 15.0, marks=thorough)])
def test_clients_drag(
    clients: int, seconds: float, record_property: Callable[[str, object], None]
) -> None:
    async def scene(studio: Studio) -> tuple[list[int], list[int]]:
        # Memory grows until all processes have worked: that is before.
        await asyncio.gather(*(drag(studio, k, 0.0) for k in range(clients)))
        end = asyncio.get_running_loop().time() + seconds
        tasks = [asyncio.create_task(drag(studio, k, end)) for k in range(clients)]
        sizes = []
        while not all(task.done() for task in tasks):
            await asyncio.sleep(seconds / 15)
            sizes.append(memory(studio.process))
        return [await task for task in tasks], sizes

    with running_studio() as studio:
        answers, sizes = run_apart(scene(studio))
    half = len(sizes) // 2
    said = f"{sum(answers)} answers, memory {sizes[half]} to {sizes[-1]} kB"
    record_property(f"{clients} clients for {seconds:.0f} s", said)
    assert max(sizes[half:]) < GROWTH * max(sizes[: half + 1])
