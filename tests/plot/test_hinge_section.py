"""The section through a hinge: its numbers are those of set-backs and of boards in space."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from PIL import Image

from documents import EXAMPLES, thick_document
from orishell.conventions.colours import rgb
from orishell.design import PanelSpec
from orishell.design_file import read_design_file
from orishell.motion import FoldingMotion, Mechanism
from orishell.motion.boards import Boards
from orishell.plot import HingeSection, find_hinge_section, plot_overview
from orishell.plot.hinge_picture import LINE, section_height
from orishell.plot.sections import folded
from orishell.solids import build_boards, drive_for_height, find_set_backs, largest_folds

SANDWICH = PanelSpec(thickness=0.03, membrane=0.002, gap=0.004)
BEVEL = PanelSpec().replace_unchecked(thickness=0.03, construction="bevel")
FIGURES = ("figure1", "figure2")


def section_of(
    name: str, build: PanelSpec, *, packed: bool = False
) -> tuple[HingeSection, Mechanism, Boards, int]:
    """The section, its sheet with its boards, and the number of its crease."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    mechanism = file.pattern.design(file.f, file.g).mechanism.without_flaps()
    pack = drive_for_height(mechanism, build) if packed else None
    folds = largest_folds(mechanism, pack or mechanism.target_drive)
    boards = build_boards(mechanism.positions(0.0), mechanism.grid, build, folds)
    section = find_hinge_section(FoldingMotion(mechanism, 5, pack), boards, build)
    assert section is not None
    edges = mechanism.grid.faces_edges()
    one, other = (i * (mechanism.grid.columns - 1) + j for i, j in section.panels)
    (edge,) = set(edges[one].tolist()) & set(edges[other].tolist())
    return section, mechanism, boards, edge


@pytest.mark.parametrize("name", FIGURES)
@pytest.mark.parametrize("build", [SANDWICH, BEVEL])
def test_boards_stand_back_as_far_as_is_asked(name: str, build: PanelSpec) -> None:
    """On both sides of the crease with the largest set-back of all, on both faces."""
    section, mechanism, _, edge = section_of(name, build)
    folds = largest_folds(mechanism, mechanism.target_drive)
    back = find_set_backs(folds, build.height, build.gap)
    inner = np.isfinite(folds.on_edges(border=np.inf))
    largest = np.maximum(back.top, back.bottom)
    assert section.setback == pytest.approx(largest[inner].max(), rel=1e-12)
    assert largest[edge] == pytest.approx(section.setback, rel=1e-12)
    assert sum(profile.right for profile in section.profiles) == len(section.profiles) // 2
    for profile in section.profiles:
        near = profile.points[len(profile.points) // 2 :]
        for height, expected in ((1, back.top[edge]), (-1, back.bottom[edge])):
            at = near[np.isclose(near[:, 1], height * build.height, rtol=1e-12), 0]
            assert at == pytest.approx(np.full(len(at), expected), rel=1e-12, abs=1e-13)
        assert np.ptp(profile.points[:, 1]) == pytest.approx(
            build.thickness if profile.side == 0 else build.height - build.membrane / 2
        )


@pytest.mark.parametrize("name", FIGURES)
@pytest.mark.parametrize("build", [SANDWICH, BEVEL])
def test_they_meet_on_the_bisecting_plane_where_they_close(name: str, build: PanelSpec) -> None:
    """In the section, and in space: as far from the plane that halves the two panels' angle."""
    section, mechanism, boards, edge = section_of(name, build)
    fold = section.folds[section.states.index("target")]
    assert fold == pytest.approx(
        largest_folds(mechanism, mechanism.target_drive).on_edges()[edge], abs=1e-12
    )
    positions = mechanism.positions(mechanism.target_drive).reshape(-1, 3)
    faces = mechanism.grid.faces_vertices()
    placed = boards.carried(faces, mechanism.positions(0.0).reshape(-1, 3)[:, :2], positions)
    numbers = [i * (mechanism.grid.columns - 1) + j for i, j in section.panels]
    normals = []
    for panel in numbers:
        a, b, c, d = positions[faces[panel]]
        normal = np.cross(c - a, d - b)
        normals.append(normal / np.linalg.norm(normal))
    across = normals[0] - normals[1]
    across *= np.sign(fold) / np.linalg.norm(across)
    start = positions[mechanism.grid.edges_vertices()[edge, 0]]
    for right, panel in enumerate(numbers):
        drawn = min(
            np.abs(folded(each.points, fold, right=each.right)[:, 0]).min()
            for each in section.profiles
            if each.right == right
        )
        signed = (placed[boards.panels == panel] - start) @ across * (1 if right else -1)
        assert drawn == pytest.approx(0, abs=1e-13)
        assert signed.min() == pytest.approx(0, abs=1e-12)
        for profile in section.profiles:
            x = folded(profile.points, fold, right=profile.right)[:, 0]
            assert (x if profile.right else -x).min() > -1e-13


def test_a_pack_is_the_third_state() -> None:
    section, mechanism, _, edge = section_of(
        "shelter", PanelSpec(thickness=0.01, membrane=0.0002), packed=True
    )
    assert section.states == ("flat", "target", "pack")
    assert section.folds[0] == 0
    expected = mechanism.fold_angles(mechanism.target_drive).on_edges()[edge]
    assert section.folds[1] == pytest.approx(expected)
    assert section.setback == pytest.approx(0.005 * np.tan(abs(section.folds[2]) / 2), rel=1e-9)


@pytest.mark.parametrize("build", [SANDWICH, BEVEL])
def test_it_is_drawn_below_the_states(tmp_path: Path, build: PanelSpec) -> None:
    document = thick_document(build=build)
    assert document.boards is not None
    file = read_design_file(EXAMPLES / "figure1.toml")
    motion = FoldingMotion(file.pattern.design(file.f, file.g).mechanism.without_flaps(), 3)
    section = find_hinge_section(motion, document.boards, build)
    pictures = []
    for name, hinge in (("thin", None), ("thick", section)):
        path = tmp_path / f"{name}.png"
        plot_overview(path, motion, {}, title="T", last="Folded", unit="m", hinge=hinge)
        pictures.append(np.asarray(Image.open(path).convert("RGB")) / 255)
    thin, thick = pictures
    added = len(thick) - len(thin)
    assert 300 < added < 1500  # pixels, 200 to the inch
    colours = ["panel-front", *(["panel-back", "target"] if build is SANDWICH else [])]
    for colour in colours:
        near = np.abs(thick[-added:] - rgb(colour)).max(axis=-1) < 0.02
        assert near.mean() > 1e-3, colour


def test_thin_boards_beside_a_large_set_back_are_seen(tmp_path: Path) -> None:
    """Their outlines are as dark as they are meant: 8,200 pixels seen, 1,000 of a hairline."""
    document = thick_document(build=SANDWICH)
    assert document.boards is not None
    file = read_design_file(EXAMPLES / "figure1.toml")
    motion = FoldingMotion(file.pattern.design(file.f, file.g).mechanism.without_flaps(), 3)
    section = find_hinge_section(motion, document.boards, SANDWICH)
    assert section is not None
    far = replace(section, setback=10 * SANDWICH.thickness, ends=(1e3, 1e3))
    path = tmp_path / "far.png"
    plot_overview(path, motion, {}, title="", last="", unit="m", hinge=far)
    pixels = np.asarray(Image.open(path).convert("RGB")) / 255
    below = pixels[-int(200 * section_height(far)) :]
    dark = np.abs(below - to_rgb(LINE)).max(axis=-1) < 0.02
    assert dark.sum() > 5000
