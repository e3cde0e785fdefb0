"""Whole commands on finer and finer sheets: seconds and bytes a panel, which must not grow."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

SIDES = (9, 31, 99, 315, 999)
"""Inner vertices along either side: 10^2 ... 10^6 panels."""
COMPARED = 99
"""What a panel costs here is compared with what it costs in the finest sheet."""
THOROUGH = os.environ.get("ORISHELL_THOROUGH") == "1"
"""A million panels take minutes, and 3 GB for the states that are written."""
MOST_BYTES = 3000
"""A panel at the busiest moment, where the start of the program counts for little."""
SHEETS = {
    "parallel-repeating": ("5*sin(pi*x/10)", 20, "flap = 0.3\nxi_deg = 50"),
    "orthodiagonal": ("0.25*sin(pi*x/2)", 4, 'flap = "auto"'),
    "t-hedral": ("0", 4, "flap = 0"),
}
"""g, where it ends, and the rest of the pattern."""
MEASURED = """
import resource, sys
from orishell.cli.main import run
try:
    run()
finally:
    used = resource.getrusage(resource.RUSAGE_SELF)
    peak = used.ru_maxrss * (1 if sys.platform == "darwin" else 1024)
    print(used.ru_utime + used.ru_stime, peak, file=sys.stderr)
"""


def cost(family: str, side: int, directory: Path, *options: str) -> tuple[float, int]:
    """Seconds of the processor and bytes, at most, that ``orishell design`` takes in all."""
    g, end, rest = SHEETS[family]
    file = directory / "shell.toml"
    file.write_text(
        f'[shell]\nfamily = "{family}"\nunit = "m"\n'
        f'[target.f]\nformula = "-x**2"\nrange = [-1, 1]\n'
        f'[target.g]\nformula = "{g}"\nrange = [0, {end}]\n'
        f"[pattern]\nrows = {side}\ncolumns = {side}\n{rest}\n[motion]\nframes = 25\n"
    )
    command = [sys.executable, "-c", MEASURED, "design", str(file), "--out", str(directory / "out")]
    run = subprocess.run([*command, *options], capture_output=True, text=True, check=True)
    seconds, peak = run.stderr.split()[-2:]
    return float(seconds), int(peak)


@pytest.mark.benchmark(min_rounds=1, max_time=0.0)
@pytest.mark.parametrize("clash", ["unexamined", "proved"])
@pytest.mark.parametrize("family", SHEETS)
def test_a_panel_of_a_fine_sheet_costs_no_more(
    benchmark: BenchmarkFixture, tmp_path: Path, family: str, clash: str
) -> None:
    """A million panels without a proof and only if asked for; 10^4, or then 10^5, with one."""
    options = ["--no-clash-test"] if clash == "unexamined" else []
    most = SIDES[-1 if THOROUGH and options else 3 if THOROUGH or options else 2]
    each = {}
    print()
    for side in SIDES[: SIDES.index(most) + 1]:
        seconds, peak = cost(family, side, tmp_path, *options)
        panels = (side + 1) ** 2
        each[side] = seconds / panels, peak / panels
        print(
            f"{family}, {clash}, {panels:7} panels: {seconds:7.1f} s, {peak / 1e9:5.2f} GB; "
            f"a panel {1e6 * seconds / panels:7.0f} us, {peak / panels:8.0f} bytes"
        )
    benchmark.extra_info["seconds and bytes a panel"] = each
    benchmark(lambda: None)
    assert each[most][0] <= each[min(COMPARED, most)][0]
    assert most <= COMPARED or each[most][1] <= max(MOST_BYTES, each[COMPARED][1])
