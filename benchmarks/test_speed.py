"""Speed, as ratios to copying the output in the same run (`make bench` prints the times)."""

from __future__ import annotations

import time
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from pytest_benchmark.fixture import BenchmarkFixture

from brute_force import exact_contacts
from orishell.curves import curve_from_formulas, parse_formula
from orishell.design import Design, PanelSpec
from orishell.design_file import read_design_file
from orishell.families.longitudinal_linear_repeating import Sectors, find_solutions
from orishell.families.longitudinal_linear_repeating.sheet import with_fitting_border
from orishell.families.longitudinal_linear_repeating.tessellation.columns import (
    Directions,
    repeat_columns,
)
from orishell.families.longitudinal_linear_repeating.tessellation.lengths import InnerLengths
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.locking import find_lock
from orishell.motion import FoldingMotion
from orishell.shell.designed import designed
from orishell.solids import build_panels, largest_folds, thickness_between
from orishell.verification.residuals import measure_residuals

EXAMPLES = Path(__file__).parents[1] / "examples"


def design(rows: int, columns: int) -> Design:
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("5*sin(pi*x/10)"), 0, 20)
    return design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=rows, columns=columns, xi_deg=50)
    )


def best_time(function: Callable[[], object], rounds: int = 15) -> float:
    times = []
    for _ in range(rounds):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def test_one_state_of_999_x_999(benchmark: BenchmarkFixture) -> None:
    mechanism = design(999, 999).mechanism
    state = mechanism.positions(1.0)
    benchmark(mechanism.positions, 1.0)
    ratio = best_time(lambda: mechanism.positions(1.0)) / best_time(state.copy)
    benchmark.extra_info["ratio to copying"] = ratio
    print(f"\none state of 999 x 999: {ratio:.2f} times copying its coordinates (target 8)")
    assert ratio < 8


@pytest.mark.parametrize("family", ["parallel repeating", "orthodiagonal"])
def test_one_state_beyond_the_target(benchmark: BenchmarkFixture, family: str) -> None:
    # A sheet without flaps: the same closed form on both sides of its target.
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.25*sin(pi*x/2)"), 0, 4)
    if family == "orthodiagonal":
        made = design_orthodiagonal(f, g, OrthodiagonalPattern(rows=999, columns=999, flap=0))
    else:
        made = design_parallel_repeating(
            f, g, ParallelRepeatingPattern(rows=999, columns=999, xi_deg=50, flap=0)
        )
    mechanism = made.mechanism
    before = 0.5 * mechanism.target_drive
    beyond = 0.5 * (mechanism.target_drive + mechanism.end_drive)
    benchmark(mechanism.positions, beyond)
    # In turns, so that what else the machine does slows both alike.
    drives = (beyond, before)
    times = [
        [best_time(partial(mechanism.positions, drive), 1) for drive in drives] for _ in range(40)
    ]
    one, other = np.min(times, axis=0)
    ratio = one / other
    benchmark.extra_info["ratio to one before"] = ratio
    print(f"\none {family} state beyond the target: {ratio:.2f} times one before it (target 1.2)")
    assert ratio < 1.2


def test_one_state_of_999_x_999_orthodiagonal(benchmark: BenchmarkFixture) -> None:
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.25*sin(pi*x/2)"), 0, 4)
    mechanism = design_orthodiagonal(f, g, OrthodiagonalPattern(rows=999, columns=999)).mechanism
    other = design(999, 999).mechanism
    benchmark(mechanism.positions, 1.0)
    ratio = best_time(lambda: mechanism.positions(1.0)) / best_time(lambda: other.positions(1.0))
    benchmark.extra_info["ratio to parallel repeating"] = ratio
    print(f"\none orthodiagonal state: {ratio:.2f} times a parallel repeating one (target 4)")
    assert ratio < 4


def test_one_longitudinal_state_of_999_x_999(benchmark: BenchmarkFixture) -> None:
    # Sector angles so near to 90 degrees that a sheet of this size exists with equal lengths.
    angles = Sectors.from_degrees((89.9995, 89.999, 90.0005, 90.001))
    columns = repeat_columns(find_solutions(angles)[0], 999)
    directions = Directions.of(columns, 999, "F")
    inner = InnerLengths.marched(directions, np.ones(998), np.ones(998))
    mechanism = with_fitting_border(columns, "F", inner, (0.02, 0.02), "auto")
    other = design(999, 999).mechanism
    benchmark(mechanism.positions, 1.0)
    ratio = best_time(lambda: mechanism.positions(1.0), 3) / best_time(lambda: other.positions(1.0))
    benchmark.extra_info["ratio to parallel repeating"] = ratio
    print(f"\none longitudinal state: {ratio:.0f} times a parallel repeating one (target 1 s)")


def test_memory_of_one_state_of_999_x_999(benchmark: BenchmarkFixture) -> None:
    mechanism = design(999, 999).mechanism

    def peak() -> float:
        tracemalloc.start()
        state = mechanism.positions(1.0)
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return most / state.nbytes

    ratio = peak()
    benchmark(mechanism.positions, 1.0)
    print(f"\npeak memory of one state: {ratio:.2f} times its coordinates (target 6)")
    assert ratio < 6


def test_design_of_999_x_999(benchmark: BenchmarkFixture) -> None:
    benchmark(design, 999, 999)


def test_25_states_of_101_x_101(benchmark: BenchmarkFixture) -> None:
    mechanism = design(101, 101).mechanism
    benchmark(mechanism.positions, np.linspace(0, np.pi, 25))


def test_verifying_25_states_of_101_x_101(benchmark: BenchmarkFixture) -> None:
    motion = FoldingMotion(design(101, 101).mechanism, 25)
    benchmark(lambda: measure_residuals(motion, motion.flat))


def test_writing_the_demo(benchmark: BenchmarkFixture, tmp_path: Path) -> None:
    from orishell.document.from_design import document_of_motion
    from orishell.io import write_fold

    motion = FoldingMotion(design(9, 11).mechanism, 25)
    benchmark(write_fold, tmp_path / "shell.fold", document_of_motion(motion, "m"))


@pytest.mark.parametrize(("size", "target"), [(50, 5), (100, 30)])
def test_the_whole_path(benchmark: BenchmarkFixture, size: int, target: int) -> None:
    # size x size panels, odd rows of vertices: the sheet of Figure 1, finer.
    made = design(size - 1 - size % 2, size - 1)
    lock = benchmark(find_lock, made)
    proof = lock.proof
    assert lock.cause == "flaps"
    assert proof is not None
    print(
        f"\n{made.mechanism.grid.panel_count} panels: {proof.tests} tests of pairs in "
        f"{proof.ranges} ranges of the drive (target {target} s)"
    )


def test_the_whole_path_against_one_exact_state(benchmark: BenchmarkFixture) -> None:
    # libigl's tree and exact predicates on one state alone, as a measure of what a proof costs.
    made = design(49, 50)
    grid, state = made.mechanism.grid, made.mechanism.positions(2.0)
    faces = grid.faces_vertices()
    benchmark(exact_contacts, state, faces)
    ratio = best_time(lambda: find_lock(made), 1) / best_time(
        lambda: exact_contacts(state, faces), 3
    )
    print(f"\nproof of the whole path: {ratio:.0f} times one exact test of one state")


def with_boards(bare: Design, *, to_pack: bool = False) -> Design:
    """Sandwiches of a third of the largest thickness, with a gap of a tenth of theirs."""
    mechanism = bare.mechanism
    folds = largest_folds(mechanism, mechanism.target_drive)
    most = thickness_between(mechanism.positions(0.0), mechanism.grid, folds)
    build = PanelSpec(thickness=most / 3, membrane=most / 100, gap=most / 30)
    return replace(bare, panel=build, opens_from_pack=to_pack)


def test_boards_of_10_000_panels(benchmark: BenchmarkFixture) -> None:
    made = with_boards(replace(design(99, 101).with_clipped_flaps(), clipped=None))
    limit = made.mechanism.target_drive
    benchmark(build_panels, made, limit)
    ratio = best_time(lambda: build_panels(made, limit), 5) / best_time(lambda: design(99, 101), 5)
    benchmark.extra_info["ratio to the design"] = ratio
    print(f"\nboards of 10,000 panels: {ratio:.2f} times the design of the sheet (target 10)")
    assert ratio < 10


@pytest.mark.parametrize("name", ["figure1", "figure2", "figure3", "shelter"])
def test_the_whole_path_with_boards(benchmark: BenchmarkFixture, name: str) -> None:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    opening = file.deployment.start == "pack"
    bare = replace(designed(file).with_clipped_flaps(), clipped=None)
    thick = with_boards(bare, to_pack=opening)
    benchmark(find_lock, thick)
    # In turns, so that what else the machine does slows both alike.
    times = [
        [
            best_time(lambda: find_lock(bare, beyond=opening), 1),
            best_time(lambda: find_lock(thick), 1),
        ]
        for _ in range(5)
    ]
    one, other = np.min(times, axis=0)
    benchmark.extra_info["ratio to panels without a thickness"] = other / one
    print(f"\n{name}, proof with boards: {other / one:.1f} times that without (target 6)")
    assert other / one < 6
