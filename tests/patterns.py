"""Crease patterns of other people, as a reader gives them, with what is known of them by hand.

``SAMPLES`` lists them; ``shuffled``, ``mirrored``, ``scaled`` and ``jittered`` change them, and
``write`` makes FOLD, SVG (as Origami Simulator has it) and DXF files of them.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from mechanisms import flat_foldable, longitudinal, parallel, random_net, upright
from orishell.families.flat_foldable.named import graded_net
from orishell.motion import Mechanism
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.grid import Grid, crease_signs, edges_assignment
from orishell.numerics.arrays import Array, Integers
from toy_family import Miura


@dataclass(frozen=True)
class Sample:
    """A pattern and what can be said of it with pencil and paper; None is what cannot."""

    make: Callable[[], CreasePattern]
    inner: int  # vertices that panels surround
    # those of them at which Kawasaki's or Maekawa's condition fails with the letters given
    failing: int | None = 0
    folds: bool | None = True  # whether it folds rigidly, exactly, by the letters that it has
    # Degrees of freedom in generic folded states. Of triangles inside one border these are the
    # border's vertices less three: a vertex in space has 3, an edge takes 1, the whole moves in
    # 6 ways, and by Euler there are 3 V - 3 - border edges (Gluck 1975: that is generic).
    freedom: int | None = 1
    grid: bool = True  # whether its panels are those of a grid


def of_mechanism(mechanism: Mechanism) -> CreasePattern:
    """The flat sheet of a mechanism, with the letters that it has at the target."""
    grid = mechanism.grid
    signs = crease_signs(mechanism.fold_angles(mechanism.target_drive))
    flat = mechanism.positions(0.0).reshape(-1, 3)[:, :2]
    letters = np.array(edges_assignment(signs))
    return pattern_of_panels(flat, grid.faces_vertices(), grid.edges_vertices(), letters)


def of_loops(
    vertices: Array, loops: Sequence[Sequence[int]], letter: Callable[[int, int], str]
) -> CreasePattern:
    """Any polygons; a letter by the numbers of a crease's ends, the smaller first."""
    longest = max(map(len, loops))
    faces = np.array([[*loop, *[-1] * (longest - len(loop))] for loop in loops])
    edges = pattern_of_panels(vertices, faces).edges
    letters = np.array([letter(a, b) for a, b in np.sort(edges).tolist()])
    return pattern_of_panels(vertices, faces, edges, letters)


Point = tuple[float, float]


def of_points(
    loops: Sequence[Sequence[Point]], letter: Callable[[Point, Point], str]
) -> CreasePattern:
    """Any polygons by their corners, which are equal to the last bit where panels meet."""
    points = sorted({point for loop in loops for point in loop})
    number = {point: k for k, point in enumerate(points)}
    numbered = [[number[point] for point in loop] for loop in loops]
    return of_loops(np.array(points), numbered, lambda a, b: letter(points[a], points[b]))


def miura(rows: int = 5, columns: int = 6, gamma_deg: float = 60.0) -> CreasePattern:
    """Miura-ori: congruent parallelograms, so that Kawasaki holds by symmetry.

    One degree of freedom: Schenk and Guest, PNAS 110 (2013) 3276.
    """
    sheet = Miura(Grid(rows + 1, columns + 1), np.deg2rad(gamma_deg), np.deg2rad(50))
    return of_mechanism(sheet)


def graded_miura(rows: int = 5, columns: int = 6) -> CreasePattern:
    """Rows and columns of different lengths, sectors and folds: straight columns, zigzag rows."""
    folds = np.deg2rad(np.linspace(70, 95, rows)).tolist()
    sectors = np.deg2rad(np.linspace(58, 68, columns)).tolist()
    lengths = np.linspace(2.0, 3.0, columns + 1).tolist()
    net = graded_net(rows, columns, folds=folds, sectors=sectors, row_lengths=lengths)
    return of_mechanism(flat_foldable(net))


def egg_box(rows: int = 4, columns: int = 5) -> tuple[Array, Integers]:
    """Positions (V, 3) and panels (F, 4) of an egg-box: no sheet folds to it.

    A zigzag carried along another, square to it, both at 45 degrees: panels are rhombi with a
    corner of 60 degrees, as (1, 0, 1) (0, 1, 1) = 1 = |...|^2 / 2. Four of these meet at every
    top and bottom, 240 degrees together, and four of 120 at every saddle, 480 degrees.
    """
    i, j = np.indices((rows + 1, columns + 1)).astype(np.float64)
    return np.stack([j, -i, i % 2 + j % 2], -1).reshape(-1, 3), Grid(
        rows + 1, columns + 1
    ).faces_vertices()


def square_twist(tilt_deg: float = 60.0, reach: float = 3.0) -> CreasePattern:
    """A square that turns as pleats on its four sides close; the same letters at its corners.

    Sectors at a corner: 90 (square), tilt, 90, 180 - tilt, so Kawasaki holds. The square's sides
    are valleys, of each pleat one crease is a mountain: at a corner one mountain and three
    valleys. It does not fold: at each corner one side of the square is opposite to the mountain,
    the other is not, so that tan(fold/2) of one is p times that of the other, with the same p in
    all corners, p not 1 for a tilt that is not 90 degrees, and p^4 = 1 once round the square.
    """
    turned = np.deg2rad(90.0 - tilt_deg)
    cos, sin = np.cos(turned), np.sin(turned)
    corners = np.array([[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]])
    corners = 0.5 * corners @ np.array([[cos, sin], [-sin, cos]])
    # Pleats go along the axes to the border of the sheet; from corner k and the next one.
    out = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
    across = np.abs(out[:, ::-1])
    ends = [reach * out + across * np.roll(corners, -step, axis=0) for step in (0, 1)]
    vertices = np.concatenate([corners, *ends, reach * (out + np.roll(out, 1, axis=0))])
    loops = [[0, 1, 2, 3]]
    for k, after in enumerate((1, 2, 3, 0)):
        loops += [[k, 4 + k, 8 + k, after], [k, 8 + (k - 1) % 4, 12 + k, 4 + k]]
    mountains = {((k + 1) % 4, 8 + k) for k in range(4)}
    return of_loops(vertices, loops, lambda a, b: "M" if (a, b) in mountains else "V")


def huffman(rows: int = 4, columns: int = 5) -> CreasePattern:
    """Huffman's grid: copies of one quadrilateral with its corners on a circle.

    Half turns about the middles of its sides tile the plane with any quadrilateral ABCD. Round
    every vertex lie its corners in their order, and opposite corners of one on a circle add up to
    180 degrees: Kawasaki. All vertices are congruent, none mirrored, and an edge is the same side
    of both its panels. So four fold angles, one for each side, close all vertices if they close
    one: it folds with the one degree of freedom of a vertex. The smallest corner, C, lies between
    the sides BC and CD: these have different letters, and three of the four sides the same one.
    """
    a, b, c, d = (np.array([np.cos(t), np.sin(t)]) for t in np.deg2rad([180, 260, 350, 470]))
    i, j = np.indices((rows + 1, columns + 1))
    even = ((i + j) % 2 == 0)[..., None]
    along, down = np.where(even, d - a, c - b), np.where(even, b - a, c - d)
    first = np.cumsum(np.concatenate([np.zeros((1, 1, 2)), down[:-1, :1]]), axis=0)
    flat = first + np.cumsum(np.concatenate([0 * first, along[:, :-1]], axis=1), axis=1)
    grid = Grid(rows + 1, columns + 1)
    edges = grid.edges_vertices()
    odd = ~even.ravel()[edges[:, 0]]
    letters = np.where(odd & (edges[:, 1] == edges[:, 0] + 1), "M", "V")
    return pattern_of_panels(flat.reshape(-1, 2), grid.faces_vertices(), edges, letters)


def waterbomb(rows: int = 3, columns: int = 4) -> CreasePattern:
    """Squares of side 2, each row half a square beside the last, with diagonals and a middle line.

    Sectors round the centre are 45, 45, 90 twice, round a corner 90, 90 and four times 45, so
    every other one adds up to 180. Diagonals are valleys, all else mountains: 4 and 2 at both.
    """
    loops = []
    for j in range(rows):
        for i in range(columns):
            x, y = 2 * i + j % 2, 2 * j
            around = [(0, 0), (1, 0), (2, 0), (2, 2), (1, 2), (0, 2)]
            ring = [(x + p, y + q) for p, q in around]
            loops += [[(x + 1, y + 1), ring[k], ring[(k + 1) % 6]] for k in range(6)]
    return of_points(loops, lambda a, b: "V" if (a[0] != b[0]) and (a[1] != b[1]) else "M")


def yoshimura(rows: int = 5, columns: int = 6, height: float = 0.3) -> CreasePattern:
    """Isosceles triangles: every other sector at a vertex is one of each corner, 180 together.

    Bases are valleys, sides mountains, 2 and 4 at a vertex.
    """

    def point(i: int, j: int) -> tuple[float, float]:
        return i + 0.5 * (j % 2), j * height

    loops = []
    for j in range(rows):
        for i in range(columns):
            low, high = (j, j + 1) if j % 2 == 0 else (j + 1, j)
            loops.append([point(i, low), point(i + 1, low), point(i, high)])
            loops.append([point(i, high), point(i + 1, low), point(i + 1, high)])
    return of_points(loops, lambda a, b: "V" if a[1] == b[1] else "M")


def resch(rows: int = 3, columns: int = 3) -> CreasePattern:
    """Resch's triangles: pits of side 2 with six creases from their centre, panels of side 1.

    A corner of each pit lies in the middle of another one's side. In the middle of a pit six
    sectors of 60, valleys to the corners and mountains to the sides by turns: Maekawa fails. At
    its corners sectors are 90, 90, 60, 30, 30, 60: Kawasaki holds; one valley, five mountains:
    Maekawa fails. So it does not fold flat, by intention: walls of the pits end upright.
    """

    def point(i: float, j: float) -> tuple[float, float]:
        return i + 0.5 * j, j * np.sqrt(0.75)

    pits = {(u + 2 * v, u - v) for u in range(rows) for v in range(columns)}
    around = [(0, 0), (1, 0), (2, 0), (1, 1), (0, 2), (0, 1)]
    loops, valleys, sides = [], set(), {}
    for i, j in sorted(pits):
        centre = point(i + 2 / 3, j + 2 / 3)
        ring = [(i + p, j + q) for p, q in around]
        valleys |= {(centre, point(*corner)) for corner in ring[::2]}
        for k in range(6):
            sides[frozenset((ring[k], ring[(k + 1) % 6]))] = True
            loops.append([centre, point(*ring[k]), point(*ring[(k + 1) % 6])])
    for i in range(-1, 3 * rows + 3 * columns):
        for j in range(-columns - 1, 3 * rows):
            down = [(i + 1, j), (i + 1, j + 1), (i, j + 1)]
            if (i - j) % 3 and sum(
                frozenset(e) in sides for e in zip(down, down[1:] + down[:1], strict=True)
            ) > 1:
                loops.append([point(*each) for each in down])

    def letter(a: tuple[float, float], b: tuple[float, float]) -> str:
        return "V" if (a, b) in valleys or (b, a) in valleys else "M"

    return of_points(loops, letter)


def holed(rows: int = 5, columns: int = 6) -> CreasePattern:
    """A Miura-ori sheet without a panel in its midst: what folds with it folds without."""
    whole = miura(rows, columns)
    kept = np.arange(len(whole.faces)) != (rows // 2) * columns + columns // 2
    return pattern_of_panels(whole.vertices, whole.faces[kept], whole.edges, whole.letters)


def not_folding(rows: int = 4, columns: int = 4) -> CreasePattern:
    """A square grid with its inner vertices moved at random: Kokotsakis meshes are rigid, but for

    those that meet conditions of their own (Izmestiev, IMRN 2017). No letters are given.
    """
    grid = Grid(rows + 1, columns + 1)
    i, j = np.indices((rows + 1, columns + 1))
    flat = np.stack([j, -i], -1).astype(np.float64)
    flat[1:-1, 1:-1] += np.random.default_rng(1).uniform(-0.2, 0.2, (rows - 1, columns - 1, 2))
    return pattern_of_panels(flat.reshape(-1, 2), grid.faces_vertices())


SAMPLES: dict[str, Sample] = {
    "Miura": Sample(miura, inner=4 * 5),
    "graded Miura": Sample(graded_miura, inner=5 * 6),
    "flat-foldable": Sample(lambda: of_mechanism(flat_foldable(random_net(6, 5, 2))), inner=30),
    "parallel repeating": Sample(lambda: of_mechanism(parallel()), inner=9 * 11, failing=None),
    "orthodiagonal": Sample(lambda: of_mechanism(upright()), inner=9 * 13, failing=None),
    "longitudinal": Sample(lambda: of_mechanism(longitudinal()), inner=5 * 6, failing=None),
    "square twist": Sample(square_twist, inner=4, folds=False, freedom=0),
    "Huffman's grid": Sample(huffman, inner=3 * 4),
    # Lines between rows have 2 columns - 2 inner vertices, and four more on the border; the first
    # and the last line have 2 columns + 1 there.
    "waterbomb": Sample(waterbomb, inner=3 * 4 + 2 * 6, freedom=2 * 9 + 4 * 2 - 3, grid=False),
    "Yoshimura": Sample(yoshimura, inner=4 * 5, freedom=2 * (5 + 6) - 3, grid=False),
    # 9 centres and 16 of 38 corners of pits are inside.
    "Resch": Sample(resch, inner=9 + 16, failing=9 + 16, freedom=22 - 3, grid=False),
    "Miura with a hole": Sample(holed, inner=4 * 5 - 4, freedom=None, grid=False),
    "not folding": Sample(not_folding, inner=9, failing=9, folds=False, freedom=0),
}


def shuffled(pattern: CreasePattern, seed: int = 1) -> CreasePattern:
    """The same in another order; edges and panels begin elsewhere."""
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(pattern.vertices))
    place = np.argsort(order)
    which = rng.permutation(len(pattern.edges))
    edges = place[pattern.edges[which]]
    edges = np.where(rng.integers(2, size=(len(edges), 1)) == 1, edges[:, ::-1], edges)
    faces = pattern.faces[rng.permutation(len(pattern.faces))]
    count = (faces >= 0).sum(axis=1)[:, None]
    column = np.arange(faces.shape[1])[None]
    turned = (column + rng.integers(0, count)) % count
    faces = np.where(column < count, place[np.take_along_axis(faces, turned, axis=1)], -1)
    return pattern_of_panels(pattern.vertices[order], faces, edges, pattern.letters[which])


def moved(pattern: CreasePattern, matrix: Array, offset: Sequence[float] = (0, 0)) -> CreasePattern:
    """The same under a map: vertices times ``matrix`` plus ``offset``."""
    vertices = pattern.vertices @ matrix + np.array(offset)
    return pattern_of_panels(vertices, pattern.faces, pattern.edges, pattern.letters)


def mirrored(pattern: CreasePattern) -> CreasePattern:
    """Its mirror image beside it: mountains stay mountains."""
    return moved(pattern, np.diag([-1.0, 1.0]))


def scaled(pattern: CreasePattern, scale: float = 1000.0) -> CreasePattern:
    """Enlarged, as from metres to millimetres."""
    return moved(pattern, scale * np.eye(2))


def jittered(pattern: CreasePattern, size: float, seed: int = 1) -> CreasePattern:
    """Every coordinate moved at random by up to a share of the shortest edge."""
    ends = pattern.vertices[pattern.edges]
    shortest = float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).min())
    move = np.random.default_rng(seed).uniform(-1, 1, pattern.vertices.shape) * size * shortest
    return pattern_of_panels(pattern.vertices + move, pattern.faces, pattern.edges, pattern.letters)


CHANGES: dict[str, Callable[[CreasePattern], CreasePattern]] = {
    "as it is": lambda pattern: pattern,
    "shuffled": shuffled,
    "mirrored": mirrored,
    "in mm": scaled,
}


def loops_of(pattern: CreasePattern) -> list[list[int]]:
    return [row[row >= 0].tolist() for row in pattern.faces]


def fold_of(pattern: CreasePattern, *, unit: str = "mm", faces: bool = True) -> dict[str, Any]:
    """The keys of a FOLD file."""
    return {
        "file_spec": 1.2,
        "frame_classes": ["creasePattern"],
        "frame_unit": unit,
        "vertices_coords": pattern.vertices.tolist(),
        "edges_vertices": pattern.edges.tolist(),
        "edges_assignment": pattern.letters.tolist(),
        **({"faces_vertices": loops_of(pattern)} if faces else {}),
    }


def fold_file(directory: Path, keys: dict[str, Any]) -> Path:
    """A FOLD file of these keys."""
    path = directory / "pattern.fold"
    path.write_text(json.dumps(keys))
    return path


STROKES = {"B": "#000000", "M": "#ff0000", "V": "#0000ff", "F": "#ffff00", "U": "#ff00ff"}
"""As Origami Simulator tells assignments apart; its own page says so under "File Import Tips"."""


def svg_of(pattern: CreasePattern, *, width_mm: float | None = None) -> str:
    """Lines as Origami Simulator reads them, y downwards; a page of physical size if asked for."""
    low, size = pattern.vertices.min(axis=0), np.ptp(pattern.vertices, axis=0)
    points = (pattern.vertices - low) * [1, -1] + [0, size[1]]
    lines = "".join(
        f'<line x1="{x1!r}" y1="{y1!r}" x2="{x2!r}" y2="{y2!r}" stroke="{STROKES[letter]}"/>\n'
        for ((x1, y1), (x2, y2)), letter in zip(
            points[pattern.edges].tolist(), pattern.letters.tolist(), strict=True
        )
    )
    width, height = size.tolist()
    page = "" if width_mm is None else f' width="{width_mm!r}mm"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg"{page} viewBox="0 0 {width!r} {height!r}">\n'
        f"{lines}</svg>\n"
    )


LAYERS = {"B": "BORDER", "M": "MOUNTAIN", "V": "VALLEY", "F": "FLAT", "U": "UNASSIGNED"}


def dxf_of(pattern: CreasePattern, *, insunits: int | None = 4) -> str:
    """Lines on layers named by what they are."""
    unit = [] if insunits is None else [(9, "$INSUNITS"), (70, insunits)]
    tags: list[tuple[int, object]] = [
        *((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"), *unit, (0, "ENDSEC")),
        *((0, "SECTION"), (2, "ENTITIES")),
    ]
    for ((x1, y1), (x2, y2)), letter in zip(
        pattern.vertices[pattern.edges].tolist(), pattern.letters.tolist(), strict=True
    ):
        tags += [(0, "LINE"), (8, LAYERS[letter]), (10, x1), (20, y1), (30, 0.0)]
        tags += [(11, x2), (21, y2), (31, 0.0)]
    tags += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:3d}\n{value}\n" for code, value in tags)


def write(path: Path, pattern: CreasePattern) -> Path:
    """A file by its ending, in millimetres."""
    width = float(np.ptp(pattern.vertices[:, 0]))
    text = {
        ".fold": lambda: json.dumps(fold_of(pattern)),
        ".svg": lambda: svg_of(pattern, width_mm=width),
        ".dxf": lambda: dxf_of(pattern),
    }[path.suffix]()
    path.write_text(text)
    return path
