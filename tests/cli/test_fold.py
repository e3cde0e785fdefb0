"""``orishell fold``: any pattern becomes files with its states."""

from __future__ import annotations

import json
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from command_line import orishell
from orishell.io import read_fold, read_pattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from patterns import SAMPLES, fold_of, jittered, miura, of_loops, write


def folded(tmp_path: Path, pattern: CreasePattern, *arguments: str) -> tuple[str, Path]:
    source = write(tmp_path / "mine.fold", pattern)
    ran = orishell("fold", source, "--out", tmp_path / "out", *arguments)
    assert (ran.returncode, ran.stderr) == (0, ""), ran.stderr
    return ran.stdout, tmp_path / "out" / "shell.fold"


def two_hexagons() -> CreasePattern:
    """Two hexagons and a triangle between their sides, hinged at one side each."""
    angles = np.deg2rad(60 * np.arange(6))
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    other = ring[[0, 1, 2, 5]] + np.array([1.5, np.sqrt(0.75)])  # the ring's 1 and 0 are 3 and 4
    vertices = np.vstack([ring, other, [1.5, -np.sqrt(0.75)]])
    loops = [[0, 1, 2, 3, 4, 5], [0, 9, 6, 7, 8, 1], [0, 10, 9]]
    return of_loops(vertices, loops, lambda a, b: "V")


def test_quadrilaterals(tmp_path: Path) -> None:
    """A Miura sheet: 7 frames up to 120 degrees, rigid by what ``check`` finds."""
    said, path = folded(tmp_path, SAMPLES["Miura"].make(), "--frames", "7", "--angle", "120")
    assert "v reaches   120 degrees: it was asked for; nothing meets up to 120 degrees" in said
    assert "v folds     rigidly, exactly as " in said
    assert "1 degree of freedom" in said
    states = read_fold(path)
    assert len(states.frames) == 1 + 7
    degrees = states.frames[-1].fold_angles_deg
    assert degrees is not None
    assert np.abs(degrees).max() == pytest.approx(120, abs=1e-12)
    checked = orishell("check", path)
    assert checked.returncode == 0, checked.stdout


def test_letters_of_a_grid_that_are_missing_are_found(tmp_path: Path) -> None:
    """A generic flat-foldable sheet, which numerical starts did not find, in closed form."""
    pattern = SAMPLES["flat-foldable"].make()
    letters = np.where(pattern.crease, "U", pattern.letters)
    said, _ = folded(tmp_path, replace(pattern, letters=letters), "--frames", "3")
    assert f"{int(pattern.crease.sum())} creases have none: " in said
    assert "v folds     rigidly, exactly as flat-foldable sheets do" in said


def test_one_of_several_choices_is_folded(tmp_path: Path) -> None:
    """A small Miura sheet without letters: its own, others with straight lines that stay flat."""
    pattern = miura(3, 4)
    bare = replace(pattern, letters=np.where(pattern.crease, "U", pattern.letters))
    letters = []
    for number in ("1", "2"):
        said, path = folded(tmp_path, bare, "--frames", "3", "--choice", number)
        choices = "3 or more choices fold it, up to turning it over"
        assert f"{choices}, of which number {number} is taken" in said
        assert ("creases stay flat" in said) == (number == "2")
        letters.append(json.loads(path.read_text())["edges_assignment"])
        assert orishell("check", path).returncode == 0
    assert letters[0] != letters[1]
    refused = orishell("fold", tmp_path / "mine.fold", "--out", tmp_path / "out", "--choice", "4")
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "expected 1 to 3" in refused.stderr


def test_polygons_stay_polygons(tmp_path: Path) -> None:
    """FOLD has hexagons and triangles as they were, and lengths stay in every state."""
    pattern = two_hexagons()
    _, path = folded(tmp_path, pattern, "--frames", "4")
    file = json.loads(path.read_text())
    assert sorted(map(len, file["faces_vertices"])) == [3, 6, 6]
    again = read_pattern(path)
    assert again.flat is not None
    assert len(again.states) == 4
    ends = pattern.edges
    flat = np.linalg.norm(np.diff(pattern.vertices[ends], axis=1), axis=-1)
    for state in again.states:
        lengths = np.linalg.norm(np.diff(state.positions[ends], axis=1), axis=-1)
        np.testing.assert_allclose(lengths, flat, rtol=1e-14)


def test_pictures_have_whole_panels(tmp_path: Path) -> None:
    """In glTF a hexagon is six quadrilaterals with one name, and its creases are drawn whole."""
    folded(tmp_path, two_hexagons(), "--frames", "3")
    data = (tmp_path / "out" / "shell.glb").read_bytes()
    content = json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])
    names = [node["name"] for node in content["nodes"][1:]]
    assert sorted(names) == sorted(["panel 0"] * 6 + ["panel 1"] * 6 + ["panel 2"] * 3)
    assert {each["name"] for each in content["materials"]} == {
        "panel-front",
        "valley",
        "border-crease",
    }


def test_many_motions_are_said(tmp_path: Path) -> None:
    said, _ = folded(tmp_path, SAMPLES["Resch"].make(), "--frames", "3", "--angle", "30")
    assert "19 degrees of freedom" in said
    assert "one of many motions" in said
    assert "reaches   30 degrees: it was asked for; " in said
    assert "in 25 states, followed" in said


def fault(tmp_path: Path, pattern: CreasePattern, *arguments: str, unit: str = "mm") -> str:
    """The message, which is one line; nothing is written."""
    source = tmp_path / "mine.fold"
    source.write_text(json.dumps(fold_of(pattern, unit=unit)))
    ran = orishell("fold", source, "--out", tmp_path / "out", *arguments)
    assert ran.returncode in (1, 2)
    assert ran.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()
    return f"{ran.returncode} {ran.stderr}"


def test_what_does_not_fold(tmp_path: Path) -> None:
    assert "1 orishell: no folded state was found" in fault(
        tmp_path, SAMPLES["square twist"].make()
    )


def test_a_hole(tmp_path: Path) -> None:
    """Miura sheets fold round a hole as without, and so do triangles, of many freedoms."""
    said, _ = folded(tmp_path, SAMPLES["Miura with a hole"].make(), "--frames", "3")
    assert "v folds     rigidly" in said
    assert "panels round a hole or cut to" in said
    whole = SAMPLES["Yoshimura"].make()
    inside = np.isin(whole.faces, whole.inner).all(axis=1).argmax()
    holed = pattern_of_panels(whole.vertices, np.delete(whole.faces, inside, axis=0), whole.edges)
    source = write(tmp_path / "holed.fold", holed)
    ran = orishell("fold", source, "--out", tmp_path / "none", "--frames", "3")
    assert ran.returncode == 0
    assert "panels round a hole or cut to" in ran.stdout


def test_an_angle_out_of_reach(tmp_path: Path) -> None:
    """With no tolerance for rounding no state of what has no closed form closes but the first, at
    0.05 radians."""
    said = fault(tmp_path, SAMPLES["Resch"].make(), "--angle", "90", "--tolerance", "1e-20")
    assert "1 orishell: the motion does not reach 90 degrees: it ends at 2.8648 degrees" in said


def test_odd_options(tmp_path: Path) -> None:
    miura = SAMPLES["Miura"].make()
    odd = {"--angle": "0 200 nan", "--frames": "1", "--unit": "x", "--tolerance": "0 1 nan"}
    for option, value in ((name, each) for name, values in odd.items() for each in values.split()):
        assert f"2 orishell: {option}: " in fault(tmp_path, miura, option, value)


def test_a_file_without_a_unit_is_taken_in_millimetres_and_it_is_said(tmp_path: Path) -> None:
    source = tmp_path / "plain.fold"
    source.write_text(json.dumps(fold_of(SAMPLES["Miura"].make(), unit="unit")))
    ran = orishell("fold", source, "--out", tmp_path / "out", "--frames", "2")
    assert ran.returncode == 0
    assert "it is taken in mm, unless --unit says another" in ran.stdout


def test_rounded_coordinates_fold_to_a_tolerance(tmp_path: Path) -> None:
    pattern = jittered(SAMPLES["Miura"].make(), 1e-6)
    said, _ = folded(tmp_path, pattern, "--tolerance", "0.01", "--frames", "3")
    assert "! states    3 up to 180 degrees: followed to a tolerance, vertices close to " in said
