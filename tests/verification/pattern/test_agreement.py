"""Check, fold and design say one thing of a sheet, however it lies and whatever its numbers are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from orishell.conventions.errors import DesignError
from orishell.families.drawn.design import design_drawn
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.drawing import Drawing, drawing_of
from orishell.motion.grid import CreaseValues, Grid
from orishell.numerics.arrays import Integers
from orishell.shell.folded import fold_pattern
from orishell.verification.pattern import FoldingMotion, judge_pattern
from patterns import fold_file, fold_of, of_loops, square_twist
from samples import THOROUGH, examples

Symmetry = tuple[tuple[float, float], tuple[float, float]]
SYMMETRIES: list[Symmetry] = [
    ((1, 0), (0, 1)), ((0, -1), (1, 0)), ((-1, 0), (0, -1)), ((0, 1), (-1, 0)),
    ((1, 0), (0, -1)), ((-1, 0), (0, 1)), ((0, 1), (1, 0)), ((0, -1), (-1, 0)),
]  # fmt: skip


def random_sheet(seed: int) -> CreasePattern:
    """A small grid: lines that cross, zigzags or anything; random letters, and a few cuts.

    Cuts that would leave two pieces are none: such a sheet is refused (``test_connectivity``).
    """
    rng = np.random.default_rng(seed)
    rows, columns = rng.integers(3, 5, 2).tolist()
    x, y = np.meshgrid(*(np.cumsum(rng.uniform(0.6, 1.4, each)) for each in (columns, rows)))
    match int(rng.integers(4)):
        case 1:
            x = x + (np.arange(rows) % 2)[:, None] * rng.uniform(0.2, 0.5)
        case 2:
            x, y = (each + rng.uniform(-0.2, 0.2, each.shape) for each in (x, y))
        case 3:
            x = x + (np.arange(rows) % 2)[:, None] * rng.uniform(-0.3, 0.3)
            y = y + (np.arange(columns) % 2) * rng.uniform(-0.3, 0.3)
    grid = Grid(rows, columns)
    edges = grid.edges_vertices()
    letters = rng.choice(list("MVFUC"), len(edges), p=[0.35, 0.35, 0.08, 0.17, 0.05])
    points = np.stack([x, y], axis=-1).reshape(-1, 2)
    faces = grid.faces_vertices()
    if pieces(faces, edges[letters != "C"]) > 1:
        letters[letters == "C"] = "F"
    return pattern_of_panels(points, faces, edges, letters)


def pieces(faces: Integers, edges: Integers) -> int:
    """How many pieces panels (F, 4) are that hang together by edges (E, 2)."""
    uncut = {frozenset(edge) for edge in edges.tolist()}
    sides: dict[frozenset[int], list[int]] = {}
    for number, loop in enumerate(faces.tolist()):
        for ends in zip(loop, [*loop[1:], loop[0]], strict=True):
            sides.setdefault(frozenset(ends), []).append(number)
    joined = [both for side, both in sides.items() if len(both) == 2 and side in uncut]
    first, second = np.array(joined, dtype=np.int64).reshape(-1, 2).T
    graph = coo_array((np.ones(len(first)), (first, second)), shape=(len(faces),) * 2)
    return int(connected_components(graph, directed=False)[0])


def changed(pattern: CreasePattern, number: int, seed: int) -> CreasePattern:
    """Turned or mirrored by a symmetry, every other one by any angle, scaled, renumbered."""
    rng = np.random.default_rng([seed, number])
    angle = rng.uniform(0, 2 * np.pi) if number % 2 else 0.0
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    points = pattern.vertices @ np.array(SYMMETRIES[number], dtype=np.float64).T @ turn.T
    order = rng.permutation(len(points))
    place = np.argsort(order)
    faces = np.where(pattern.faces < 0, -1, place[pattern.faces])[
        rng.permutation(len(pattern.faces))
    ]
    edges = rng.permutation(len(pattern.edges))
    return pattern_of_panels(
        rng.choice([0.37, 1.0, 250.0]) * points[order],
        faces,
        place[pattern.edges][edges],
        pattern.letters[edges],
    )


def said_by_check(path: Path) -> tuple[str, int | None]:
    """The sign of the row "folds", and the degrees of freedom."""
    verdict = judge_pattern(read_pattern(path))
    (folds,) = (row.sign for row in verdict.rows if row.subject == "folds")
    return folds, verdict.degrees_of_freedom


@pytest.mark.parametrize("seed", range(examples(300) if THOROUGH else 12))
def test_a_random_sheet_is_judged_alike_by_all_and_in_all_positions(
    seed: int, tmp_path: Path
) -> None:
    pattern = random_sheet(seed)
    found = set()
    for number in range(len(SYMMETRIES)) if THOROUGH else (0, 3, 5):
        path = fold_file(tmp_path, fold_of(changed(pattern, number, seed)))
        checked = said_by_check(path)
        try:
            fold_pattern(path, frames=2, unit="mm")
            folded = True
        except DesignError:
            folded = False
        found.add((*checked, folded))
    ((sign, _, folded),) = found
    if sign == "holds":
        assert folded
    if sign == "warns":
        assert not folded


def crossing(letters: str, tilt_deg: float) -> CreasePattern:
    """Four creases in two straight lines that cross; letters one round the vertex."""
    degrees = np.deg2rad([0, tilt_deg, 180, 180 + tilt_deg])
    tips = np.stack([np.cos(degrees), np.sin(degrees)], axis=-1)
    corners = tips + np.roll(tips, -1, axis=0)
    points = np.concatenate([[[0.0, 0.0]], tips, corners])
    loops = [[0, 1 + k, 5 + k, 1 + (k + 1) % 4] for k in range(4)]
    return of_loops(points, loops, lambda a, b: letters[b - 1] if a == 0 else "B")


@pytest.mark.parametrize("tilt_deg", [90.0, 60.0])
@pytest.mark.parametrize(
    ("letters", "folds"),
    [("MMMV", False), ("MFMF", True), ("MUMU", True), ("UVUV", True), ("UUUU", True)],
)
def test_of_two_straight_lines_that_cross_one_folds(
    letters: str, folds: bool, tilt_deg: float, tmp_path: Path
) -> None:
    """Paper is folded along one and then the other: no motion folds both. All three doors say so,
    and of lines without letters how many creases stay flat."""
    pattern = crossing(letters, tilt_deg)
    path = fold_file(tmp_path, fold_of(pattern))
    verdict = judge_pattern(read_pattern(path))
    row = next(row for row in verdict.rows if row.subject == "folds")
    drawing = drawing_of(pattern)
    if folds:
        assert row.sign == "holds"
        assert ("2 of 4 creases stay flat" in row.finding) == ("U" in letters)
        design_drawn(drawing, fold=1.0, move=None)
        return
    says = "two straight lines cross at vertex"
    assert row.sign == "fails"
    assert says in row.finding
    with pytest.raises(DesignError, match=says):
        fold_pattern(path, unit="mm")
    with pytest.raises(DesignError, match=says):
        design_drawn(drawing, fold=None, move=None)


def test_lines_that_cross_are_straight_to_the_tolerance_for_all(tmp_path: Path) -> None:
    """Of coordinates rounded to seven digits check, fold and design say what exact ones are."""
    exact = crossing("MMMV", 77.0)
    rounded = replace(exact, vertices=np.round(exact.vertices, 7))
    path = fold_file(tmp_path, fold_of(rounded))
    assert said_by_check(path)[0] == "fails"
    for door in (
        lambda: fold_pattern(path, unit="mm"),
        lambda: design_drawn(drawing_of(rounded), fold=None, move=None),
    ):
        with pytest.raises(DesignError, match="two straight lines cross"):
            door()


def test_a_map_fold_is_none_in_one_motion() -> None:
    """Two by three panels of a map: the letters that fold it flat, line after line."""
    grid = Grid(3, 4)
    flat = np.stack(np.meshgrid(np.arange(4.0), -np.arange(3.0)), axis=-1)
    signs = CreaseValues(np.array([[1.0, -1, 1]]), np.array([[1.0, -1], [-1, 1]]))
    assert grid.vertex_count == 12
    with pytest.raises(DesignError, match="so at 2 vertices"):
        design_drawn(Drawing(flat, signs), fold=None, move=None)


@pytest.mark.parametrize("rounding", [0.0, 1e-5, 1e-8])
def test_a_square_twist_has_six_choices_of_letters(rounding: float, tmp_path: Path) -> None:
    """With p and 1/p round its square (see square_twist): letters of its four corners are such that
    p is met as often as 1/p, which are 4 over 2, up to turning all of it over."""
    twist = square_twist()
    rng = np.random.default_rng(3)
    vertices = twist.vertices + rounding * rng.uniform(-0.5, 0.5, twist.vertices.shape)
    letters = np.where(twist.letters == "B", "B", "U")
    pattern = pattern_of_panels(vertices, twist.faces, twist.edges, letters)
    verdict = judge_pattern(read_pattern(fold_file(tmp_path, fold_of(pattern))), tolerance=1e-5)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, FoldingMotion)
    assert len(motion.choices) == 6
    for word in motion.choices:
        own = pattern_of_panels(vertices, twist.faces, twist.edges, np.array(list(word)))
        path = fold_file(tmp_path, fold_of(own))
        rows = judge_pattern(read_pattern(path), tolerance=1e-5).rows
        assert next(row.sign for row in rows if row.subject == "folds") == "holds"
