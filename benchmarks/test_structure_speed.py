"""Time and memory of a structure: the shelter with four load cases, buckling and frequencies."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from orishell.design_file import read_design_file
from orishell.shell.analyse import analyse_structure
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from orishell.structure.load_settings import NO_CODE, LoadCase, Snow, Wind
from orishell.structure.settings import Structure, Support

SHELTER = Path(__file__).parents[1] / "examples" / "shelter.toml"
CASES = (
    LoadCase(name="dead", self_weight=True),
    LoadCase(name="snow", snow=Snow(ground=500)),
    LoadCase(
        name="wind",
        wind=Wind(speed=26, terrain="II", direction_deg=90.0, coefficients=NO_CODE),
    ),
    LoadCase(name="own weight", self_weight=True),
    LoadCase(name="dead and snow", combine={"dead": 1.35, "snow": 1.5}),
    LoadCase(name="dead and wind", combine={"dead": 1.0, "wind": 1.5}),
    LoadCase(name="all", combine={"dead": 1.35, "snow": 0.75, "wind": 1.5}),
)
STRUCTURE = Structure(
    modulus=270e6,
    poisson=0.3,
    supports=(Support(at="feet", kind="pinned"),),
    cases=CASES,
    thickness=0.01,
    crease_stiffness=(10.0, 10.0),
    tie_stiffness=1e6,
)
PEAK = """
import resource, sys
sys.path.insert(0, sys.argv[1])
from test_structure_speed import STRUCTURE, shelter
from orishell.shell.analyse import analyse_structure
analyse_structure(shelter(), STRUCTURE)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20)
"""


def shelter() -> Shell:
    return make_shell(read_design_file(SHELTER), clash="unexamined", skip=(*MEASURES, "stock"))


@pytest.mark.benchmark(min_rounds=1, max_time=0.0)
@pytest.mark.parametrize("cells", [2, 4, 8])
def test_four_load_cases(benchmark: BenchmarkFixture, cells: int) -> None:
    """Growth with the number of elements, and how much of it is one factorisation."""
    shell = shelter()
    asked = STRUCTURE.replace_unchecked(cells=cells)
    found = benchmark(analyse_structure, shell, asked)
    begin = time.perf_counter()
    analyse_structure(shell, asked)
    whole = time.perf_counter() - begin
    alone = asked.replace_unchecked(cases=CASES[:1])
    begin = time.perf_counter()
    analyse_structure(shell, alone)
    one = time.perf_counter() - begin
    count = len(found.model.mesh.facets.triangles)
    benchmark.extra_info["triangles"] = count
    freedoms = found.model.mesh.count
    print(
        f"\n{count} triangles, {freedoms} freedoms, four load cases: {whole:.2f} s (target "
        f"5 with 4 x 4 cells), {1e3 * whole / count:.2f} ms a triangle, {whole / one:.1f} times one"
    )
    assert whole < 4.5 * one


@pytest.mark.benchmark(min_rounds=1, max_time=0.0)
def test_memory_of_four_load_cases(benchmark: BenchmarkFixture) -> None:
    def peak() -> float:
        call = [sys.executable, "-c", PEAK, str(Path(__file__).parent)]
        return float(subprocess.run(call, check=True, capture_output=True, text=True).stdout)

    found = benchmark(peak)
    print(f"\nthe shelter with four load cases: {found:.2f} GB at its peak (target 1)")
    assert found < 1
