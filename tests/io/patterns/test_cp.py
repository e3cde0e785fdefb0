"""Crease patterns as ORIPA and Oriedita save them: a kind and two points a line, y downwards."""

from __future__ import annotations

from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern
from patterns import SAMPLES, Sample, write

KINDS = {"B": 1, "M": 2, "V": 3}
SQUARE = "1 -200 -200 200 -200\n1 200 -200 200 200\n1 200 200 -200 200\n1 -200 200 -200 -200\n"


def cp_of(pattern: CreasePattern) -> str:
    lines = []
    for ends, letter in zip(pattern.edges.tolist(), pattern.letters.tolist(), strict=True):
        (x, y), (u, v) = pattern.vertices[ends].tolist()
        lines.append(f"{KINDS[letter]} {x!r} {-y!r} {u!r} {-v!r}\n")
    return "".join(lines)


def edges(pattern: CreasePattern | None) -> set[tuple[object, ...]]:
    """Ends to nine digits and letters."""
    assert pattern is not None
    places = [f"{x:.9g} {y:.9g}" for x, y in (pattern.vertices + 0.0).tolist()]
    pairs = zip(pattern.edges.tolist(), pattern.letters.tolist(), strict=True)
    return {(*sorted((places[a], places[b])), letter) for (a, b), letter in pairs}


LETTERED = {
    name: sample for name, sample in SAMPLES.items() if set(sample.make().letters) <= set(KINDS)
}


@pytest.mark.parametrize("sample", LETTERED.values(), ids=LETTERED)
def test_it_is_the_pattern_that_a_drawing_has(sample: Sample, tmp_path: Path) -> None:
    pattern = sample.make()
    (tmp_path / "pattern.cp").write_text(cp_of(pattern))
    found = read_pattern(tmp_path / "pattern.cp", unit="mm")
    drawn = read_pattern(write(tmp_path / "pattern.dxf", pattern))
    assert found.unit == "mm"
    assert edges(found.flat) == edges(drawn.flat)
    assert len(found.faces) == len(drawn.faces)


def test_there_are_patterns_to_try() -> None:
    assert len(LETTERED) >= 5


def test_auxiliary_lines_are_left_out_and_counted(tmp_path: Path) -> None:
    path = tmp_path / "square.cp"
    text = "\ufeff" + SQUARE + "\n2 -200 -200 200 200\n0 -200 0 17 0\r\n4 0.5 0 0 20\n"
    path.write_text(text, encoding="utf-8")
    found = read_pattern(path)
    assert found.unit == "unit"
    assert found.flat is not None
    assert sorted(found.flat.letters) == ["B", "B", "B", "B", "M"]
    assert "auxiliary lines are no creases: 2 left out" in found.notes


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("2 0 0 1", "line 5: this line is not one of a crease pattern.*five numbers"),
        ("2 0 0 1 1 1", "line 5: this line is not one"),
        ("M 0 0 1 1", "line 5: this line is not one"),
        ("2 0 0 inf 1", "line 5: this line is not one"),
        ("2 0 0 nan 1", "line 5: this line is not one"),
        ("5 0 0 1 1", "line 5: this kind of line is not known; got 5"),
        ("2.5 0 0 1 1", "line 5: this kind of line is not known"),
        ("nan 0 0 1 1", "line 5: this kind of line is not known"),
        ("2 0 0 1e300 1", "too large"),
    ],
)
def test_what_is_no_pattern_is_refused_with_its_line(tmp_path: Path, line: str, says: str) -> None:
    path = tmp_path / "square.cp"
    path.write_text(f"{SQUARE}{line}\n")
    with pytest.raises(InputError, match=rf"square\.cp: .*{says}"):
        read_pattern(path)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.cp", b"\xff\xfe\x81", "not text"),
        ("a.cp", b"", "empty"),
        ("a.cp", b"{}", "what looks like FOLD.*Remedy: give it the ending .fold"),
        ("a.cp", b"0 1 2 3 4", "the drawing has no lines"),
        ("a.opx", b"<?xml version='1.0'?><java></java>", "Remedy: export it from ORIPA as FOLD"),
        ("a.ori", b"{}", "Remedy: export it from Oriedita as FOLD"),
    ],
)
def test_files_of_other_kinds(tmp_path: Path, name: str, content: bytes, says: str) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=says):
        read_pattern(tmp_path / name)
