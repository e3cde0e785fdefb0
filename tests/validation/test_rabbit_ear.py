"""rabbit-ear folds our flat sheets by our fold angles, panel by panel, into our coordinates.

rabbit-ear (npm, 0.9.32, MIT) knows nothing of families or closed forms: it turns each panel about
the crease to its neighbour, along a tree of panels. Valley is positive, as in FOLD.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from node_tools import ask_node
from orishell.design_file import read_design_file
from orishell.io import write_fold
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES
from rigid import distance_after_motion

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"

LIMIT = 1e-9
"""Of the diagonal of the flat sheet. Found: 2.4e-15 at most."""


@pytest.mark.parametrize("root", ["corner", "middle"])
def test_rabbit_ear_folds_every_frame_into_our_coordinates(shell_files: Path, root: str) -> None:
    content = _read(shell_files)
    stays = 0 if root == "corner" else len(content["faces_vertices"]) // 2
    key, *folded = _fold(shell_files, stays)
    ours = [np.array(frame["vertices_coords"]) for frame in content["file_frames"]]
    limit = LIMIT * _diagonal(content)
    assert len(folded) == len(ours) == 25
    assert max(distance_after_motion(*pair) for pair in zip(folded, ours, strict=True)) <= limit
    # The key frame has the fold angles of the locked shell.
    assert distance_after_motion(key, ours[-1]) <= limit


@pytest.mark.parametrize("example", ["shelter", "figure1"])
def test_rabbit_ear_closes_the_sheet_into_our_pack(example: str, tmp_path: Path) -> None:
    """From the flat sheet over the target to the pack: a bundle at 180 degrees, or a roll.

    In the pack of the shelter all row creases are folded by 180 degrees.
    """
    text = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8")
    design_file = tmp_path / "shell.toml"
    if "[deployment]" not in text:
        text += '\n[deployment]\nfrom = "pack"\n'
    design_file.write_text(text, encoding="utf-8")
    shell = make_shell(
        read_design_file(design_file), skip=(*MEASURES, "remedies", "verification", "stock")
    )
    write_fold(tmp_path / "shell.fold", shell.document)
    content = _read(tmp_path)
    key, *folded = _fold(tmp_path, len(content["faces_vertices"]) // 2)
    frames = content["file_frames"]
    ours = [np.array(frame["vertices_coords"]) for frame in frames]
    assert frames[0]["frame_title"] == "pack"
    widest = np.abs(frames[0]["edges_foldAngle"]).max()
    assert widest == pytest.approx(180) if example == "shelter" else 150 < widest < 180
    limit = LIMIT * _diagonal(content)
    assert max(distance_after_motion(*pair) for pair in zip(folded, ours, strict=True)) <= limit
    # The key frame has the fold angles of the target.
    titles = [frame.get("frame_title") for frame in frames]
    assert distance_after_motion(key, ours[titles.index("target")]) <= limit


def test_mountains_and_valleys_are_on_the_right_side(shell_files: Path) -> None:
    """The mirror image, which opposite fold angles would give, is another shape."""
    content = _read(shell_files)
    mirrored = _fold(shell_files)[-1] * [1.0, 1.0, -1.0]
    ours = np.array(content["file_frames"][-1]["vertices_coords"])
    assert distance_after_motion(mirrored, ours) > 1e-2 * _diagonal(content)


def test_rabbit_ear_finds_no_fault_in_the_file(shell_files: Path, tmp_path: Path) -> None:
    assert ask_node("validate_with_rabbit_ear.cjs", {"path": str(shell_files / "shell.fold")}) == {
        "summary": "valid",
        "vertices": {"isolated": [], "duplicate": [], "references": True},
        "edges": {"circular": [], "duplicate": [], "references": True},
        "faces": {"references": True},
    }
    # It would have told: here a vertex belongs to no edge.
    content = _read(shell_files)
    content["vertices_coords"].append([1e3, 1e3])
    faulty = tmp_path / "faulty.fold"
    faulty.write_text(json.dumps(content))
    answer = ask_node("validate_with_rabbit_ear.cjs", {"path": str(faulty)})
    assert answer["summary"] != "valid"
    assert answer["vertices"]["isolated"] == [len(content["vertices_coords"]) - 1]


def _read(shell_files: Path) -> dict[str, Any]:
    content: dict[str, Any] = json.loads((shell_files / "shell.fold").read_text())
    return content


def _fold(shell_files: Path, root: int = 0) -> list[Array]:
    path = str(shell_files / "shell.fold")
    answer = ask_node("fold_with_rabbit_ear.cjs", {"path": path, "root": root})
    return [np.array(frame) for frame in answer]


def _diagonal(content: dict[str, Any]) -> float:
    return float(np.linalg.norm(np.ptp(np.array(content["vertices_coords"]), axis=0)))
