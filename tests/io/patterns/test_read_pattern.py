"""Patterns of all kinds, written as FOLD, SVG and DXF, are read as they were."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion
from orishell.io import read_pattern
from orishell.motion.crease_pattern import CreasePattern
from orishell.numerics.arrays import Array
from patterns import CHANGES, SAMPLES, Sample, fold_file, fold_of, miura, scaled, write
from samples import thorough

ROUNDING = 1e-9
"""Of coordinates, by the largest: welds take the first of points that differ in the last digits."""


def require_same(found: CreasePattern | None, wanted: CreasePattern, scale: float = 1.0) -> None:
    """The same vertices, moved as a whole, and the same edges, letters and panels between them."""
    from scipy.spatial import KDTree

    assert found is not None
    low = [np.min(each.vertices, axis=0) for each in (found, wanted)]
    points = (found.vertices - low[0]) / scale
    found_by = KDTree(wanted.vertices - low[1]).query(points, k=[1])
    away, place = (np.asarray(each)[:, 0] for each in found_by)
    assert away.max() <= ROUNDING * np.ptp(wanted.vertices)
    assert sorted(place) == list(range(len(wanted.vertices)))
    numbers = np.arange(len(wanted.vertices))

    def edges(pattern: CreasePattern, numbers: Any) -> set[tuple[int, int, str]]:
        ends = np.sort(numbers[pattern.edges], axis=1).tolist()
        return {(a, b, letter) for (a, b), letter in zip(ends, pattern.letters, strict=True)}

    def panels(pattern: CreasePattern, numbers: Any) -> set[tuple[int, ...]]:
        loops = (numbers[row[row >= 0]].tolist() for row in pattern.faces)
        return {tuple(loop[(k := loop.index(min(loop))) :] + loop[:k]) for loop in loops}

    assert edges(found, place) == edges(wanted, numbers)
    assert panels(found, place) == panels(wanted, numbers)


@pytest.mark.parametrize("ending", [".fold", ".svg", ".dxf"])
@pytest.mark.parametrize("sample", SAMPLES.values(), ids=SAMPLES)
def test_every_kind_of_pattern_is_read_from_every_kind_of_file(
    sample: Sample, ending: str, tmp_path: Path
) -> None:
    pattern = sample.make()
    found = read_pattern(write(tmp_path / f"pattern{ending}", pattern))
    require_same(found.flat, pattern)
    assert found.unit == "mm"
    assert found.title == "pattern"


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("ending", [".fold", ".svg", ".dxf"])
def test_order_mirror_and_size_change_nothing_else(
    change: str, ending: str, tmp_path: Path
) -> None:
    pattern = CHANGES[change](SAMPLES["Yoshimura"].make())
    require_same(read_pattern(write(tmp_path / f"pattern{ending}", pattern)).flat, pattern)


@pytest.mark.parametrize("name", ["Huffman's grid", "Resch", "Miura with a hole"])
def test_panels_are_found_between_edges(name: str, tmp_path: Path) -> None:
    pattern = SAMPLES[name].make()
    found = read_pattern(fold_file(tmp_path, fold_of(pattern, faces=False)))
    require_same(found.flat, pattern)
    assert "panels were found between its edges" in found.notes[0]


def test_fold_keeps_the_numbers_of_the_file_to_the_last_bit(tmp_path: Path) -> None:
    pattern = miura()
    found = read_pattern(fold_file(tmp_path, fold_of(pattern)))
    assert found.flat is not None
    for name in ("vertices", "edges", "letters", "faces", "edge_faces"):
        np.testing.assert_array_equal(getattr(found.flat, name), getattr(pattern, name))
    assert found.notes == ()


def test_frames_inherit_and_fold_angles_are_kept(tmp_path: Path) -> None:
    pattern = miura()
    degrees = np.linspace(-170, 170, len(pattern.edges))
    folded = np.column_stack([pattern.vertices, np.ones(len(pattern.vertices))])
    keys = fold_of(pattern)
    keys["edges_foldAngle"] = degrees.tolist()
    keys["file_frames"] = [
        {
            "frame_title": "closed",
            "frame_classes": ["foldedForm"],
            "frame_inherit": True,
            "frame_parent": 0,
            "vertices_coords": folded.tolist(),
            "edges_foldAngle": (-degrees).tolist(),
        }
    ]
    found = read_pattern(fold_file(tmp_path, keys))
    (state,) = found.states
    assert state.title == "closed"
    assert state.fold_angles is not None
    np.testing.assert_array_equal(found.fold_angles, np.deg2rad(degrees))
    np.testing.assert_array_equal(state.fold_angles, -np.deg2rad(degrees))
    np.testing.assert_array_equal(state.positions, folded)


@pytest.mark.parametrize("key", ["vertices_coords", "faces_vertices"])
def test_frames_of_other_sheets_are_left_out_and_said(key: str, tmp_path: Path) -> None:
    """Steps of a design, each a sheet of its own: the key frame is the pattern."""
    keys, other = fold_of(miura()), fold_of(miura(2, 2))
    keys["file_frames"] = [other if key == "vertices_coords" else {key: other[key]}]
    found = read_pattern(fold_file(tmp_path, keys))
    require_same(found.flat, miura())
    assert "1 frame of other sheets: left out" in found.notes


def test_letters_are_those_of_fold_angles_where_there_are_none(tmp_path: Path) -> None:
    pattern = miura()
    keys = fold_of(pattern)
    del keys["edges_assignment"]
    degrees = np.where(pattern.crease, 30.0 * pattern.signs, 0.0)
    keys["edges_foldAngle"] = degrees.tolist()
    found = read_pattern(fold_file(tmp_path, keys))
    np.testing.assert_array_equal(found.letters, pattern.letters)
    assert "fold angles" in found.notes[0]


def test_units(tmp_path: Path) -> None:
    pattern = miura()
    keys = fold_of(pattern, unit="cm")
    found = read_pattern(fold_file(tmp_path, keys))
    require_same(found.in_unit("mm").flat, pattern, 10.0)
    del keys["frame_unit"]
    path = fold_file(tmp_path, keys)
    with pytest.raises(InputError, match=r"no unit of length.*unit = "):
        read_pattern(path).in_unit("mm")
    require_same(read_pattern(path, unit="in").in_unit("mm").flat, pattern, 25.4)
    require_same(read_pattern(path, unit="in", scale=3.0).flat, pattern, 3.0)
    svg = write(tmp_path / "pattern.svg", pattern)
    require_same(read_pattern(svg, unit="m").flat, pattern)
    assert read_pattern(svg, unit="m").unit == "m"
    dxf = write(tmp_path / "pattern.dxf", pattern)
    require_same(read_pattern(dxf).in_unit("m").flat, pattern, conversion("mm", "m"))


def apart_by(pattern: CreasePattern, gap: float) -> dict[str, Any]:
    """A FOLD file in which every panel has vertices of its own, its middle a little moved."""
    corners = pattern.faces.ravel()
    points = pattern.vertices[corners] + gap * np.random.default_rng(1).uniform(
        -0.3, 0.3, (len(corners), 2)
    )
    return {
        "vertices_coords": points.tolist(),
        "faces_vertices": np.arange(len(corners)).reshape(pattern.faces.shape).tolist(),
    }


def test_panels_that_share_no_vertices_are_joined_and_it_is_said(tmp_path: Path) -> None:
    pattern = miura()
    read = read_pattern(fold_file(tmp_path, apart_by(pattern, 1e-6)))
    assert "were joined (weld = " in read.notes[0]
    assert read.flat is not None
    assert len(read.flat.vertices) == len(pattern.vertices)
    assert len(read.flat.inner) == len(pattern.inner)


def test_panels_that_are_far_from_each_other_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="not one piece"):
        read_pattern(fold_file(tmp_path, apart_by(miura(), 1e-2)))


def test_a_weld_wider_than_an_edge_is_refused(tmp_path: Path) -> None:
    path = fold_file(tmp_path, fold_of(miura()))
    with pytest.raises(InputError, match=r"repeats a corner|within the tolerance"):
        read_pattern(path, weld=1.01)


def broken(change: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
    keys = fold_of(miura(2, 2))
    change(keys)
    return keys


def move(vertex: int, x: float, y: float) -> Callable[[dict[str, Any]], object]:
    return lambda keys: keys["vertices_coords"].__setitem__(vertex, [x, y])


REFUSED: dict[str, tuple[dict[str, Any], str]] = {
    "a panel across another": (broken(move(4, -3.0, -3.0)), "lie on|crosses itself|same side"),
    "no panel's vertex": (
        broken(lambda keys: keys["faces_vertices"][0].__setitem__(0, 99)),
        r"no such vertex.*0 to 8",
    ),
    "a corner twice": (
        broken(lambda keys: keys["faces_vertices"].__setitem__(1, [0, 1, 1, 4])),
        "panel 1 repeats a corner",
    ),
    "two corners": (
        broken(lambda keys: keys["faces_vertices"].__setitem__(1, [0, 1])),
        r"faces_vertices\[1\].*3 or more",
    ),
    "no area": (
        broken(lambda keys: keys["faces_vertices"].__setitem__(0, [0, 1, 2])),
        "panel 0 has no area|not among the edges",
    ),
    "no number": (broken(move(3, 0.0, float("nan"))), "JSON|no number|does not fit"),
    "a side that is no edge": (
        broken(lambda keys: (keys["edges_vertices"].pop(), keys["edges_assignment"].pop())),
        "not among the edges",
    ),
    "letters": (
        broken(lambda keys: keys["edges_assignment"].__setitem__(2, "X")),
        r"edges_assignment\[2\]",
    ),
    "neither panels nor edges": (
        broken(lambda keys: [keys.pop(k) for k in list(keys) if k[:5] in ("faces", "edges")]),
        "faces_vertices.*missing",
    ),
}


def around(turns: Array) -> dict[str, Any]:
    """Panels between two circles, from each angle to the next (degrees)."""
    angle = np.deg2rad(turns)
    inner = np.stack([np.cos(angle), np.sin(angle)], axis=-1) * (1 + 1e-5 * turns[:, None])
    n = len(turns)
    return {
        "vertices_coords": np.concatenate([inner, 2 * inner]).tolist(),
        "faces_vertices": [[k, n + k, n + k + 1, k + 1] for k in range(n - 1)],
    }


@pytest.mark.parametrize("step", [40.0, 37.0])
def test_a_strip_that_comes_round_onto_itself_is_refused(step: float, tmp_path: Path) -> None:
    """No crease, side or vertex tells: with steps of 40 degrees its end lies along a crease."""
    once = read_pattern(fold_file(tmp_path, around(np.arange(0, 350, step))))
    assert once.flat is not None
    with pytest.raises(InputError, match=r"panels 0 and \d+ lie on each other"):
        read_pattern(fold_file(tmp_path, around(np.arange(0, 500, step))))


@pytest.mark.parametrize("name", REFUSED)
def test_fold_files_that_are_no_sheet_are_refused_by_place(name: str, tmp_path: Path) -> None:
    keys, said = REFUSED[name]
    path = fold_file(tmp_path, keys)
    with pytest.raises(InputError, match=said) as caught:
        read_pattern(path)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("a.svg", b'{"vertices_coords": []}', "looks like FOLD.*ending .fold"),
        ("a.fold", b"<svg/>", "looks like SVG.*ending .svg"),
        ("a.dxf", b"AC1027 ...", "looks like DWG"),
        ("a.pdf", b"%PDF-1.4", "not read from such files.*looks like PDF"),
        ("a.json", b'{"file_spec": 1}', "ending .fold"),
        ("a.fold", b"  ", "the file is empty"),
        ("a.fold", b"\x00\x01\x02", "not JSON"),
    ],
)
def test_a_file_of_another_kind_is_said_to_be_what_it_looks_like(
    name: str, content: bytes, said: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=said):
        read_pattern(tmp_path / name)


def test_no_file_and_no_number(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_pattern(tmp_path / "none.fold")
    path = write(tmp_path / "pattern.fold", miura())
    for asked in ({"unit": "furlong"}, {"scale": 0.0}, {"weld": -1.0}, {"scale": float("nan")}):
        with pytest.raises(InputError):
            read_pattern(path, **asked)


@pytest.mark.parametrize(
    ("ending", "size"),
    [
        (".fold", 100),
        *(pytest.param(each, 300, marks=thorough) for each in (".fold", ".svg")),
    ],
)
def test_large_sheets_are_read_whole(ending: str, size: int, tmp_path: Path) -> None:
    path = write(tmp_path / f"large{ending}", scaled(miura(size, size), 7.0))
    found = read_pattern(path).flat
    assert found is not None
    assert len(found.faces) == size**2
    assert len(found.inner) == (size - 1) ** 2
