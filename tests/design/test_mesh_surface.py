"""Meshes as surfaces: mended, refused by place, their corners found."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.design import MeshSurface
from orishell.design.mesh_files import read_mesh
from orishell.numerics.arrays import Array, Integers


def sheet(columns: int = 8, rows: int = 6) -> tuple[Array, Integers]:
    """A wavy rectangle over 0 to 2 and 0 to 1, its triangles counter-clockwise from above."""
    x, y = np.meshgrid(np.linspace(0, 2, columns + 1), np.linspace(0, 1, rows + 1))
    points = np.stack([x, y, 0.1 * np.sin(x) * y], axis=-1)
    number = np.arange(points[..., 0].size).reshape(rows + 1, columns + 1)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return points.reshape(-1, 3), np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)


def corners(surface: MeshSurface) -> Array:
    return np.array([surface.piece.vertices[side[0], :2] for side in surface.piece.sides])


def test_corners_are_where_the_rim_turns_and_sides_run_clockwise_from_the_top_left() -> None:
    surface = MeshSurface.of(*sheet())
    assert corners(surface).tolist() == [[0, 1], [2, 1], [2, 0], [0, 0]]
    assert (surface.piece.normals[:, 2] > 0.9).all()


def test_triangles_run_through_either_way_and_vertices_there_several_times_are_mended() -> None:
    """As an STL file has them: three vertices of its own for every triangle, in single digits."""
    points, triangles = sheet()
    rng = np.random.default_rng(3)
    turned = np.where(rng.random(len(triangles))[:, None] < 0.5, triangles, triangles[:, ::-1])
    soup = points[turned].reshape(-1, 3).astype(np.float32).astype(np.float64)
    surface = MeshSurface.of(soup, np.arange(len(soup)).reshape(-1, 3))
    whole = MeshSurface.of(points, triangles)
    assert len(surface.piece.vertices) == len(points)
    assert (surface.piece.normals[:, 2] > 0.9).all()
    assert surface.area() == pytest.approx(whole.area(), rel=1e-6)
    assert corners(surface) == pytest.approx(corners(whole), abs=1e-6)


def test_a_mesh_with_a_hole_is_refused_by_place() -> None:
    points, triangles = sheet()
    inner = 2 * (3 * 8 + 4)
    with pytest.raises(InputError, match="holes") as refused:
        MeshSurface.of(points, np.delete(triangles, [inner, inner + 1], axis=0))
    assert "2 rims, one of 4 edges near (1.125, 0.5833" in refused.value.got
    assert refused.value.remedy.startswith("close the holes, or name a rectangle")


def test_several_pieces_are_refused_by_place() -> None:
    points, triangles = sheet()
    apart = np.concatenate([points, [[5, 0, 0], [6, 0, 0], [5, 3, 0]]])
    with pytest.raises(InputError, match="several pieces") as refused:
        MeshSurface.of(apart, np.concatenate([triangles, [[63, 64, 65]]]))
    assert "near (5.333, 1, 0)" in refused.value.got


def test_three_triangles_at_an_edge_are_refused_by_place() -> None:
    points, triangles = sheet()
    more = np.concatenate([points, [[0.1, 0.1, 1.0]]])
    with pytest.raises(InputError, match="more than two triangles") as refused:
        MeshSurface.of(more, np.concatenate([triangles, [[0, 10, 63]]]))
    assert "3 near (0.125, 0.0833" in refused.value.got


def test_a_closed_mesh_is_refused() -> None:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    with pytest.raises(InputError, match="closed"):
        MeshSurface.of(points, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))


def folded(turn: float, radius: float) -> tuple[Array, Integers]:
    """A strip along x whose last third is turned under by an angle, over a roll of a radius."""
    angle = np.linspace(0, turn, 25 if radius else 2)
    roll = radius * np.stack([np.sin(angle), np.cos(angle) - 1], axis=-1)
    way = np.array([np.cos(turn), -np.sin(turn)])
    flat = np.stack([np.linspace(-2, 0, 9), np.zeros(9)], axis=-1)
    under = roll[-1] + np.linspace(0.1, 1, 9)[:, None] * way
    line = np.concatenate([flat, roll[1:] if radius else roll[:0], under])
    y = np.linspace(0, 1, 5)
    points = np.stack(
        [np.tile(line[:, 0], (5, 1)), np.tile(y[:, None], len(line)), np.tile(line[:, 1], (5, 1))],
        axis=-1,
    )
    number = np.arange(points[..., 0].size).reshape(5, -1)
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return points.reshape(-1, 3), np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)


def test_a_rim_that_is_folded_under_is_refused_by_place() -> None:
    with pytest.raises(InputError, match="folds over") as refused:
        MeshSurface.of(*folded(np.deg2rad(175), 0.0))
    assert "folded by 175 degrees near (0, " in refused.value.got
    assert "remove what is folded" in refused.value.remedy


def test_a_rim_that_rolls_under_is_refused_and_a_half_cylinder_is_not() -> None:
    with pytest.raises(InputError, match="folds over") as refused:
        MeshSurface.of(*folded(np.deg2rad(175), 0.2))
    assert "from its mean normal" in refused.value.got
    turn, y = np.meshgrid(np.linspace(0, np.pi, 41), np.linspace(0, 3, 9))
    points = np.stack([-np.cos(turn), y, np.sin(turn)], axis=-1).reshape(-1, 3)
    _, triangles = sheet(40, 8)
    assert MeshSurface.of(points, triangles).area() == pytest.approx(3 * np.pi, rel=1e-3)


def test_triangles_that_are_there_twice_are_taken_once() -> None:
    points, triangles = sheet()
    surface = MeshSurface.of(points, np.concatenate([triangles, triangles[::2, ::-1]]))
    assert len(surface.piece.triangles) == len(triangles)


def test_a_strip_with_a_twist_is_refused() -> None:
    """A Moebius strip of one row of cells."""
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    side = np.array([-0.3, 0.3])[:, None]
    radius = 1 + side * np.cos(turn / 2)
    points = np.stack([radius * np.cos(turn), radius * np.sin(turn), side * np.sin(turn / 2)], -1)
    k, after = np.arange(24), (np.arange(24) + 1) % 24
    low, high = k, k + 24
    low_after, high_after = np.where(after, after, 24), np.where(after, after + 24, 0)
    cells = [np.stack([low, low_after, high_after], -1), np.stack([low, high_after, high], -1)]
    with pytest.raises(InputError, match="no two sides"):
        MeshSurface.of(points.reshape(-1, 3), np.concatenate(cells))


def test_a_round_rim_is_cut_into_four_sides_of_about_a_quarter() -> None:
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    points = np.concatenate([[[0, 0, 0.2]], np.stack([np.cos(turn), np.sin(turn), 0 * turn], -1)])
    k = np.arange(40)
    surface = MeshSurface.of(points, np.stack([0 * k, 1 + k, 1 + (k + 1) % 40], axis=-1))
    assert [len(side) for side in surface.piece.sides] == [11, 11, 11, 11]


def test_corners_that_are_given_are_taken_at_the_nearest_vertices_of_the_rim() -> None:
    given = np.array([[0.3, 0.0, 0], [2, 0.4, 0], [2, 1, 0], [0, 0.85, 0]])
    surface = MeshSurface.of(*sheet(), given)
    assert corners(surface) == pytest.approx(np.array([[0, 5 / 6], [2, 1], [2, 1 / 3], [0.25, 0]]))


def test_a_lattice_of_a_mesh_lies_on_it() -> None:
    surface = MeshSurface.of(*sheet(40, 20))
    points = surface.lattice(0.1).points
    assert np.abs(points[..., 2] - 0.1 * np.sin(points[..., 0]) * points[..., 1]).max() < 1e-4
    assert points[0, 0, :2] == pytest.approx([0, 0], abs=1e-9)
    assert points[-1, -1, :2] == pytest.approx([2, 1], abs=1e-9)


def test_a_gltf_file_is_read_with_its_y_up_and_its_nodes_in_place(tmp_path: Path) -> None:
    """As pygltflib writes it, which shares nothing with the reader."""
    import pygltflib

    points, triangles = sheet()
    drawn = np.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=-1).astype("<f4")
    parts = [drawn.tobytes(), triangles.astype("<u2").tobytes()]
    file = pygltflib.GLTF2(
        scene=0,
        scenes=[pygltflib.Scene(nodes=[0])],
        nodes=[pygltflib.Node(mesh=0, translation=[1.0, 2.0, 3.0], scale=[2.0, 2.0, 2.0])],
        meshes=[
            pygltflib.Mesh(
                primitives=[
                    pygltflib.Primitive(attributes=pygltflib.Attributes(POSITION=0), indices=1)
                ]
            )
        ],
        accessors=[
            pygltflib.Accessor(bufferView=0, componentType=5126, count=len(points), type="VEC3"),
            pygltflib.Accessor(
                bufferView=1, componentType=5123, count=triangles.size, type="SCALAR"
            ),
        ],
        bufferViews=[
            pygltflib.BufferView(buffer=0, byteOffset=0, byteLength=len(parts[0])),
            pygltflib.BufferView(buffer=0, byteOffset=len(parts[0]), byteLength=len(parts[1])),
        ],
        buffers=[pygltflib.Buffer(byteLength=sum(map(len, parts)))],
    )
    file.set_binary_blob(b"".join(parts))
    file.save(str(tmp_path / "roof.glb"))
    found = read_mesh(tmp_path / "roof.glb")
    assert found.vertices == pytest.approx(2 * points + [1.0, -3.0, 2.0], abs=1e-6)
    assert found.triangles.tolist() == triangles.tolist()
    assert (found.unit, found.up) == ("m", "y")
