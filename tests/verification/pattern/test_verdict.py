"""What is said of patterns of other people, against what is known of them by hand."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from orishell.curves import curve_from_formulas, parse_formula
from orishell.families.parallel_repeating import (
    ParallelRepeatingPattern,
    design_parallel_repeating,
)
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.following import follow
from orishell.motion.following.placing import Placing
from orishell.motion.grid import Grid
from orishell.verification.pattern import FoldingMotion, PatternVerdict, Still, judge_pattern
from patterns import (
    SAMPLES,
    egg_box,
    fold_file,
    fold_of,
    graded_miura,
    holed,
    huffman,
    jittered,
    mirrored,
    miura,
    of_mechanism,
    scaled,
    shuffled,
    square_twist,
    write,
)
from samples import thorough

CHANGES: dict[str, Callable[[CreasePattern], CreasePattern]] = {
    "as drawn": lambda pattern: pattern,
    "shuffled": shuffled,
    "mirrored": mirrored,
    "in millimetres": scaled,
}
ENDINGS = (".svg", ".fold", ".dxf")
GUIDE = Path(__file__).parents[3] / "docs" / "guide" / "checking-patterns.md"
KINDS = [
    pytest.param(
        name, change, ending, marks=[] if (k + i) % 4 == 0 and (k + j) % 3 == 0 else thorough
    )
    for k, name in enumerate(SAMPLES)
    for i, change in enumerate(CHANGES)
    for j, ending in enumerate(ENDINGS)
]
"""Each pattern in one way, and in all others in ``make thorough``."""


def judged(pattern: CreasePattern, place: Path, ending: str = ".fold") -> PatternVerdict:
    return judge_pattern(read_pattern(write(place / f"pattern{ending}", pattern)))


def said(verdict: PatternVerdict) -> dict[str, tuple[str, str]]:
    return {row.subject: (row.sign, row.finding) for row in verdict.rows}


@pytest.mark.parametrize(("name", "change", "ending"), KINDS)
def test_it_is_what_is_known_by_hand(name: str, change: str, ending: str, tmp_path: Path) -> None:
    sample = SAMPLES[name]
    verdict = judged(CHANGES[change](sample.make()), tmp_path, ending)
    found, rows = verdict.findings, said(verdict)
    assert found is not None
    assert len(found.pattern.inner) == sample.inner
    conditions = found.conditions
    failing = {*conditions.not_kawasaki.tolist(), *conditions.not_maekawa.tolist()}
    if sample.failing is not None:
        assert len(failing) == sample.failing
    if sample.folds:
        assert rows["folds"][0] == "holds"
        assert verdict.passed
        if sample.freedom is not None:
            assert verdict.degrees_of_freedom == sample.freedom
    else:
        assert rows["folds"][0] in ("fails", "warns")
        assert "freedom" not in rows
    json.dumps(verdict.as_dict(), allow_nan=False)
    assert line_of(name, verdict) in GUIDE.read_text()


def line_of(name: str, verdict: PatternVerdict) -> str:
    """The line of the guide's table, without what is known by hand."""
    found, rows = verdict.findings, said(verdict)
    assert found is not None
    conditions, count = found.conditions, len(found.conditions.vertices)
    failing = [
        f"{name} fails at {len(vertices)} of {count}"
        for name, vertices in (
            ("Kawasaki", conditions.not_kawasaki),
            ("Maekawa", conditions.not_maekawa),
        )
        if len(vertices)
    ]
    folds = rows["folds"][1].partition(":")[0]
    far = "-"
    if "reaches" in rows:
        sign, finding = rows["reaches"]
        degrees = f"{float(finding.partition(' ')[0]):.0f} degrees"
        proved = re.search(r"nothing meets up to (\d+(?:\.\d)?)\d* degrees \(proved\)", finding)
        known = f"proved to {proved[1]}" if proved else "seen in states"
        far = f"{degrees}, {'panels meet' if sign == 'warns' else 'clear'} ({known})"
    freedom = "-" if verdict.degrees_of_freedom is None else verdict.degrees_of_freedom
    return f"| {name} | {', '.join(failing) or 'hold'} | {folds} | {freedom} | {far} |"


def test_a_square_twist_that_no_letters_of_its_kind_fold_is_refused(tmp_path: Path) -> None:
    """By hand p^4 = 1 round the square: it does not fold, though every vertex folds by itself."""
    verdict = judged(square_twist(), tmp_path)
    rows = said(verdict)
    assert rows["vertices"][0] == "holds"
    assert rows["folds"][0] == "fails"
    assert not verdict.passed


def test_an_egg_box_has_no_flat_sheet(tmp_path: Path) -> None:
    """Four sectors of 60 degrees meet at its tops."""
    positions, faces = egg_box()
    path = tmp_path / "box.fold"
    content = {
        "vertices_coords": positions.tolist(),
        "faces_vertices": faces.tolist(),
        "edges_vertices": Grid(5, 6).edges_vertices().tolist(),
    }
    path.write_text(json.dumps(content))
    verdict = judge_pattern(read_pattern(path))
    assert said(verdict)["sheet"][0] == "fails"
    assert verdict.findings is None
    assert not verdict.passed
    json.dumps(verdict.as_dict(), allow_nan=False)


@pytest.mark.parametrize("share", [1e-6, 1e-4])
def test_what_nearly_folds_is_told_by_how_much(share: float, tmp_path: Path) -> None:
    """In proportion to how far its vertices were moved, at half the way."""
    verdict = judged(jittered(graded_miura(), share), tmp_path)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, FoldingMotion)
    half = motion.misses[12].max()
    assert 0.1 * share < half < 30 * share
    fails, holds = (judge_pattern(verdict.read, tolerance=by * share) for by in (1e-3, 100))
    assert said(fails)["folds"][0] == "fails"
    assert said(holds)["folds"][0] == "holds"


def test_the_worst_vertex_of_kawasakis_comes_first(tmp_path: Path) -> None:
    pattern = miura()
    vertices = pattern.vertices.copy()
    for vertex, shift in ((9, 0.01), (25, 0.05)):
        vertices[vertex] += [shift, 0.0]
    moved = pattern_of_panels(vertices, pattern.faces, pattern.edges, pattern.letters)
    verdict = judged(moved, tmp_path)
    assert verdict.findings is not None
    failing = verdict.findings.conditions.not_kawasaki.tolist()
    assert set(failing) <= {25, 18, 24, 26, 32, 9, 8, 10, 16, 2}  # these and their neighbours
    assert failing[0] in (25, 18, 24, 26, 32)


def test_letters_that_are_missing_are_found(tmp_path: Path) -> None:
    sheet = miura(3, 4)
    verdict = judged(replace(sheet, letters=np.where(sheet.crease, "U", "B")), tmp_path)
    assert verdict.findings is not None
    rows = said(verdict)
    assert "Maekawa's condition is not known at 6" in rows["vertices"][1]
    assert rows["folds"][0] == "holds"
    assert rows["letters"][1].startswith("17 creases have none: 3 or more choices fold it")


def test_all_mountains_are_proved_not_to_fold(tmp_path: Path) -> None:
    letters = np.where(miura().letters == "B", "B", "M")
    verdict = judged(replace(miura(), letters=letters), tmp_path)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, Still)
    assert motion.proved
    assert said(verdict)["folds"][0] == "fails"


def test_what_meets_on_the_way_is_named(tmp_path: Path) -> None:
    """A column rolls up until its rims meet (docs/guide); figure 1 locks at 180 degrees."""
    verdict = judged(SAMPLES["longitudinal"].make(), tmp_path)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, FoldingMotion)
    assert motion.proof is not None
    contact = motion.proof.contact
    assert contact is not None
    assert 0 < contact.clear_until <= contact.drive < np.pi
    assert "meet there" in said(verdict)["reaches"][1]
    clear = judged(SAMPLES["parallel repeating"].make(), tmp_path)
    assert said(clear)["reaches"][0] == "holds"


@pytest.mark.parametrize(("name", "size"), [("miura", 1e-3), ("holed", 5e-4)])
def test_what_nearly_folds_is_told_by_how_far_hinges_give_way(
    name: str, size: float, tmp_path: Path
) -> None:
    """In one way, as the sheet that it nearly is; on a grid, and followed where it has a hole."""
    verdict = judged(jittered({"miura": miura, "holed": holed}[name](), size), tmp_path)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, FoldingMotion)
    assert motion.loose is not None
    assert 1e-4 < motion.loose.gap < 1e-2  # edges are about 1 long
    assert motion.loose.clear == len(motion.loose.drives) == 23
    assert verdict.degrees_of_freedom == 1
    rows = said(verdict)
    assert rows["folds"][0] == "fails"
    assert "free of contact in 23 states to within a hinge gap of" in rows["reaches"][1]
    assert "not proved" in rows["reaches"][1]
    assert "to within a hinge gap of" in rows["freedom"][1]
    assert motion.proof is None


def test_panels_that_come_nearer_than_the_gap_are_named(tmp_path: Path) -> None:
    """Exact, Huffman's grid meets at 71 degrees (the guide's table): between two states here."""
    verdict = judged(jittered(huffman(), 1e-3), tmp_path)
    assert verdict.findings is not None
    motion = verdict.findings.motion
    assert isinstance(motion, FoldingMotion)
    assert motion.loose is not None
    assert motion.loose.near is not None
    assert np.rad2deg(motion.loose.clear_until) == pytest.approx(67.5)
    assert said(verdict)["reaches"][0] == "warns"
    report = verdict.as_dict()["motion"]["hinge_gap"]
    assert report["near"] == list(motion.loose.near)
    assert report["clear_until_deg"] == 67.5


@pytest.mark.parametrize("offset", [0.0, 1e-4, 2e-2])
def test_creases_that_are_out_of_line_beside_a_hole_are_judged(
    offset: float, tmp_path: Path
) -> None:
    """A square frame folded in the middle: rigid only if both creases are in line.

    Within the tolerance, a millionth of the diagonal of 141, they are.
    """
    frame = (
        '<path d="M0 0H100V100H0Z" stroke="#000"/><path d="M30 30H70V70H30Z" stroke="#000"/>'
        f'<path d="M50 0V30" stroke="red"/><path d="M{50 + offset} 70V100" stroke="red"/>'
    )
    path = tmp_path / "frame.svg"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{frame}</svg>')
    rows = said(judge_pattern(read_pattern(path)))
    sign, finding = rows["folds"]
    assert (sign == "holds") == (offset <= 1.41e-4)
    assert ("a hole" in finding) == (offset != 1e-4)  # there hinges give way to the tolerance


def test_lines_that_bend_by_little_fold_together(tmp_path: Path) -> None:
    """Where two lines cross and one is straight the other folds by as little as the first bends.

    A shell of ours over an almost straight g, with edges 2000 times shorter than it is long.
    """
    sheet = design_parallel_repeating(
        curve_from_formulas(None, parse_formula("-x**2"), -0.02, 0.02),
        curve_from_formulas(None, parse_formula("0.0002*x**2"), 0.0, 20.0),
        ParallelRepeatingPattern(rows=3, columns=7, xi_deg=50.0),
    ).mechanism
    rows = said(judge_pattern(read_pattern(write(tmp_path / "sheet.fold", of_mechanism(sheet)))))
    assert rows["folds"][0] == "holds", rows["folds"]


@pytest.mark.parametrize("digits", [3, 6, 15])
def test_straight_lines_that_cross_are_never_said_to_fold_together(
    digits: int, tmp_path: Path
) -> None:
    """Whatever digits of a grid of straight lines a file has."""
    grid = Grid(4, 5)
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0))
    turn = np.array([[np.cos(0.3), -np.sin(0.3)], [np.sin(0.3), np.cos(0.3)]])
    points = np.round(np.stack([x, y], axis=-1).reshape(-1, 2) @ turn * 10, digits)
    letters = np.where(np.arange(len(grid.edges_vertices())) % 2 == 0, "M", "V")
    pattern = pattern_of_panels(points, grid.faces_vertices(), grid.edges_vertices(), letters)
    rows = said(judge_pattern(read_pattern(write(tmp_path / "grid.fold", pattern))))
    assert rows["folds"][0] != "holds", rows["folds"]


def test_letters_of_the_other_side_are_told(tmp_path: Path) -> None:
    """All creases of a folded state are against theirs: seen from below."""
    keys = fold_of(miura())
    placed, _ = Placing(miura()).placed(follow(miura(), largest=1.0, states=2).folds[-1])
    keys["file_frames"] = [{"frame_classes": ["foldedForm"], "vertices_coords": placed.tolist()}]
    keys["file_frames"][0] |= {"frame_inherit": True, "frame_parent": 0}
    path = fold_file(tmp_path, keys)
    assert "letters" not in said(judge_pattern(read_pattern(path)))
    swap = {"M": "V", "V": "M"}
    keys["edges_assignment"] = [swap.get(each, each) for each in keys["edges_assignment"]]
    (row,) = (
        each
        for each in judge_pattern(read_pattern(fold_file(tmp_path, keys))).rows
        if each.subject == "letters"
    )
    assert row.sign == "fails"
    assert "exchange M and V" in row.remedy
