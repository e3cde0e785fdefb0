"""Errors of cutting at 30 x 30 panels, as a share of making and proving the same shell."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from orishell.deployment.cutting import measure_cutting
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell

EXAMPLE = Path(__file__).parents[1] / "examples" / "figure1.toml"


@pytest.mark.benchmark(min_rounds=3, max_time=0.0)
def test_errors_of_cutting(benchmark: BenchmarkFixture) -> None:
    """Less than that: what is measured of a shell should not make one wait. A third was seen."""
    file = read_design_file(EXAMPLE).changed({"pattern.rows": 29, "pattern.columns": 31})
    start = time.process_time()
    design = make_shell(file).design
    making = time.process_time() - start
    benchmark(lambda: measure_cutting(design.mechanism, error=3e-4))
    start = time.process_time()
    measure_cutting(design.mechanism, error=3e-4)
    share = (time.process_time() - start) / making
    benchmark.extra_info["share"] = share
    assert share < 1
