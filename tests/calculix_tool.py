"""CalculiX, which Debian has as ``calculix-ccx``, and what it answers.

Without it a test is skipped, or fails if the environment has ``ORISHELL_REQUIRE_CALCULIX=1``, as in
``.ci/run``, so that nothing is skipped there unnoticed.
"""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from node_tools import lacking

REQUIRED = "ORISHELL_REQUIRE_CALCULIX"
ROW = r"^ +\d+((?: +[-+.\dE]+){%d})$"


@dataclass(frozen=True)
class Answers:
    """What CalculiX found.

    Parameters
    ----------
    displacements
        Of the shell's nodes (N, 3) in every static step.
    frequencies
        Of the shell (Hz); empty, as ``buckling`` is, if the deck does not ask for them.
    squares
        Of them as angular frequencies (1/s2): negative where the shell has buckled.
    buckling
        The lowest factor of every case.
    """

    displacements: list[NDArray[np.float64]]
    frequencies: NDArray[np.float64]
    squares: NDArray[np.float64]
    buckling: list[float]


def run_calculix(deck: Path) -> Answers:
    """Run a deck as ``orishell design --write inp`` writes them."""
    if shutil.which("ccx") is None:
        lacking("CalculiX is not installed: apt-get install calculix-ccx", REQUIRED)
    done = subprocess.run(
        ["ccx", "-i", deck.stem],
        cwd=deck.parent,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:]
    assert "*ERROR" not in done.stdout, done.stdout
    text = deck.with_suffix(".dat").read_text()
    static = re.split(r"E I G E N V A L U E", text)[0]
    tables = static.split("displacements")[1:]
    frequencies = re.split(r"E I G E N V A L U E   O U T P U T", text)[1:]
    buckling = re.split(r"B U C K L I N G", text)[1:]
    modes = [row for each in frequencies for row in _rows(each.split("P A R T")[0], 4)]
    return Answers(
        [_rows(table, 3) for table in tables],
        np.array([row[2] for row in modes]),
        np.array([row[0] for row in modes]),
        [float(_rows(table, 1)[0, 0]) for table in buckling],
    )


def _rows(table: str, columns: int) -> NDArray[np.float64]:
    """Numbers (n, columns) after the number of every row."""
    rows = re.findall(ROW % columns, table, flags=re.MULTILINE)
    return np.array([row.split() for row in rows], dtype=float)
