"""The add-on for Blender, in Blender: shells that fold as the library has them."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from blender_tool import PYTHON, ask_blender
from node_tools import ROOT
from orishell import DesignFile, make_shell, read_design_file, write_shell
from orishell.conventions.colours import linear_rgb
from orishell.shell.steps import MEASURES
from samples import thorough

pytestmark = [pytest.mark.slow, thorough]
CARD = ROOT / "examples" / "figure1_card.toml"
METRES = {"mm": 0.001, "m": 1.0}


def frames_of(file: DesignFile) -> NDArray[Any]:
    """Positions (S, V, 3) that the library has in all states (metres)."""
    document = make_shell(file, skip=MEASURES).document
    states = [document.in_world(each.positions) for each in document.states]
    return np.array(states) * METRES[file.unit]


def assert_single(found: NDArray[Any], expected: NDArray[Any]) -> None:
    """Equal but for three roundings in single precision: to a key, from it and back to it."""
    assert found.shape == expected.shape
    off = np.abs(found - expected).max() / np.abs(expected).max()
    assert off <= 1.5 * np.finfo(np.float32).eps


def test_a_shell_folds_as_the_library_has_it(tmp_path: Path) -> None:
    """60 frames; undone and redone; saved and opened again; run again from what was saved."""
    said = ask_blender("folding", tmp_path, file=str(CARD))
    frames = np.load(tmp_path / "frames.npz")
    expected = frames_of(read_design_file(CARD).changed({"motion.frames": 60}))
    assert len(expected) == 60
    assert_single(frames["first"], expected)
    for name in ("redone", "again"):
        assert (frames[name] == frames["first"]).all()
    assert said["same"]
    assert said["undone"] == []
    assert {"panels", "boards", "mountains", "valleys", "person"} <= {*said["kinds"]}
    assert (said["rows"], said["range"]) == (5, 61)
    assert said["colour"][:3] == pytest.approx(linear_rgb("mountain"), abs=1e-6)
    assert said["left"] == []


def test_boards_stand_where_their_panels_take_them(tmp_path: Path) -> None:
    """Against the document's own corners of boards and panels, either way."""
    ask_blender("folding", tmp_path, file=str(CARD))
    boards = np.load(tmp_path / "frames.npz")["boards"]
    document = make_shell(
        read_design_file(CARD).changed({"motion.frames": 60}), skip=MEASURES
    ).document
    for number in (0, 17, 59):
        state = document.states[number]  # the membrane between the boards is there, too
        solids = document.boards_in(state).reshape(-1, 3)
        corners = document.in_world(np.concatenate([solids, state.positions])) * METRES["mm"]
        for one, other in ((corners, boards[number]), (boards[number], corners)):
            away = [np.linalg.norm(other - each, axis=1).min() for each in one[::7]]
            assert max(away) < 4e-7 * np.abs(corners).max()  # quaternions in single precision


def test_starters_run(tmp_path: Path) -> None:
    tasks = ["arch", "screen", "card"]
    said = ask_blender("starters", tmp_path, tasks=tasks)
    for task in tasks:
        assert_single(
            np.load(tmp_path / f"{task}.npy"),
            frames_of(read_design_file(tmp_path / f"{task}.toml")),
        )
    assert "boards" in said["arch"]
    assert "boards" not in said["card"]
    assert "ties" in said["arch"]


def test_what_was_drawn_in_blender_is_the_target(tmp_path: Path) -> None:
    """f stands turned and moved, g is a level Bezier curve; a mesh is in metres as Blender is."""
    said = ask_blender("targets", tmp_path)
    file = read_design_file(tmp_path / "curves.toml")
    assert said["panels"] == file.panel_count
    x, y = np.array(file.tables["target"]["f"]["points"]).T
    np.testing.assert_allclose(x - x.mean(), np.linspace(-30, 30, 9), atol=2e-3)
    np.testing.assert_allclose(y, 40 - (x - x.mean()) ** 2 / 45, atol=2e-3)
    x, y = np.array(file.tables["target"]["g"]["points"])[::12].T
    np.testing.assert_allclose(y, 40 * np.sin(np.pi * x / 120), atol=2e-3)
    surface = tomllib.loads((tmp_path / "surface.toml").read_text())["target"]["surface"]
    assert np.ptp(surface["vertices"], axis=0) == pytest.approx([8, 6, 1.2])
    assert len(surface["triangles"]) == 128
    assert read_design_file(tmp_path / "surface.toml").surface is not None


def test_a_fold_file_is_shown_with_its_states(tmp_path: Path) -> None:
    file = read_design_file(ROOT / "examples" / "shelter.toml")
    write_shell(make_shell(file, skip=MEASURES), tmp_path / "out")
    fold = str(tmp_path / "out" / "shell.fold")
    said = ask_blender("imported", tmp_path, file=fold)
    assert_single(np.load(tmp_path / "imported.npy"), frames_of(file))
    assert said["frames"] == file.frames


def test_what_is_refused_says_what_where_and_what_helps(tmp_path: Path) -> None:
    steep = (ROOT / "examples" / "figure1.toml").read_text().replace("xi_deg = 50", "xi_deg = 60")
    broken = {
        "toml.toml": "[shell\n",
        "binary.toml": "\xff\xfe\x00",
        "steep.toml": steep,
        "unknown.toml": CARD.read_text().replace("rows = 5", "rowz = 5"),
        "text.fold": "no JSON",
        "list.fold": "[1, 2]",
        "bare.fold": "{}",
        "short.fold": '{"vertices_coords": [[0, 0]], "edges_vertices": [[0, 1]], '
        '"faces_vertices": [[0, 1, 2]]}',
        "still.fold": '{"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]], '
        '"edges_vertices": [[0, 1]], "faces_vertices": [[0, 1, 2, 3]]}',
    }
    said = ask_blender("slips", tmp_path, broken=broken)
    for name, words in {
        "no shell": "there is no shell in this scene. Begin one with New",
        "toml.toml": "this is not TOML",
        "binary.toml": "this is no text. Choose a design file",
        "steep.toml": "Nearest found that works: xi_deg = ",
        "unknown.toml": "rows",
        "text.fold": "orishell check says more of it",
        "list.fold": "orishell check says more of it",
        "bare.fold": "vertices_coords",
        "short.fold": "orishell check says more of it",
        "missing": "nowhere.toml: No such file or directory. Choose another file",
        "nothing selected": "select two curves, f last",
        "one curve": "Got: level",
        "not planar": "bent: the curve is not planar: it leaves its plane by",
        "closed": "ring: a target is one open spline, and it is closed. Open or part it",
        "no faces": "cloud: the mesh has no faces",
        "unwritable": "Save the design file elsewhere",
        "folder gone": "Save the design file elsewhere",
    }.items():
        assert words in said[name], (name, said[name])
    assert said["still.fold"] == ""  # it is shown, with a warning


def test_without_orishell_it_says_what_to_do(tmp_path: Path) -> None:
    command = str(PYTHON.with_name("orishell"))
    said = ask_blender(
        "commands",
        tmp_path,
        command=command,
        environment={"PATH": str(tmp_path)},
    )
    assert said["none"].startswith("orishell was not found, neither in Blender's own Python nor")
    assert "Edit > Preferences > Add-ons > orishell" in said["none"]
    assert "no-such-program: no such program" in said["wrong"]
    assert said["named"] == ""
    assert said["roots"] == "card"
