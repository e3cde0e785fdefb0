"""Crease patterns in FOLD files: panels of any number of corners, or only edges."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError, printable
from orishell.conventions.quantities import MILLIMETRES, counted
from orishell.conventions.record import record
from orishell.io.fold_frames import Frames, FramesError, read_title, read_unit
from orishell.io.fold_keys import (
    read_assignment,
    read_classes,
    read_coordinates,
    read_fold_angles,
    read_vertex_numbers,
)
from orishell.io.fold_polygons import read_polygons, require_different
from orishell.io.format import plain_line
from orishell.io.patterns.arrangement import arrange
from orishell.io.patterns.connectivity import PiecesError, require_apart, require_one_piece
from orishell.io.patterns.fold_panels import sides_among
from orishell.io.patterns.layout import lay_out, letters_of_folds, seen_from_above
from orishell.io.patterns.lines import WELD, Lines, weld_points
from orishell.io.patterns.pattern_file import PatternState, ReadPattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.panel_sides import join_loops, sides_of
from orishell.numerics.arrays import Array, Integers

FACES = "faces_vertices"


@record
class _File:
    """The arrays of a file."""

    positions: dict[int, Array]  # vertices (V, 3) by frame
    flat: int | None  # the frame of the flat sheet
    folded: bool  # whether that frame calls itself a folded form: it may be folded flat
    edges: Integers | None  # vertices (E, 2)
    letters: NDArray[np.str_] | None  # (E,)

    @property
    def first(self) -> Array:
        """Vertices (V, 3) of the flat sheet, or else of the first frame that has any."""
        return self.positions[next(iter(self.positions)) if self.flat is None else self.flat]


@record
class _Sheet:
    """The pattern of a file, and what of the file it is made of."""

    flat: CreasePattern | None
    not_flat: str
    faces: Integers
    edges: Integers
    edge_faces: Integers
    letters: NDArray[np.str_]
    frame: int | None  # the frame that the flat sheet is of; None if it was laid out
    vertices: Integers | None  # which of the file's vertices; None if it has others
    chosen: Integers | None  # which of the file's edges; None if it has others
    angles: Array | None = None  # fold angles (E,) where the edges are others (radians)


def read_fold_pattern(path: Path, frames: Frames, weld: float | None) -> ReadPattern:
    """The pattern of a file of frames, and its folded states.

    The flat sheet is the first frame in a plane that calls itself a crease pattern, or else the
    first that lies in one: z = 0, or another as programs save it for which y is up. If there is
    none it is laid out from the first state, if the panels allow that.

    Parameters
    ----------
    weld
        Vertices nearer to each other than this are one; None for those of the file.

    Raises
    ------
    InputError
        If the file cannot be read, or its panels are no sheet of one piece.
    """
    try:
        return _read(path, frames, weld, [])
    except FramesError:
        try:
            note = f"{counted(len(frames) - 1, 'frame')} of other sheets: left out"
            return _read(path, frames.first, weld, [note])
        except InputError:
            pass
        raise


def _read(path: Path, frames: Frames, weld: float | None, notes: list[str]) -> ReadPattern:
    positions = read_coordinates(frames)
    count = len(next(iter(positions.values())))
    edges = read_vertex_numbers(frames, "edges_vertices", "edge", 2, count)
    degrees = {number: read_fold_angles(frames, number, edges) for number in positions}
    letters = _letters(read_assignment(frames, edges), degrees, notes)
    faces = frames.common(FACES, lambda value, where: read_polygons(value, where, count))
    crease_patterns = [n for n in positions if "creasePattern" in read_classes(frames, n)]
    seen = {number: seen_from_above(each) for number, each in positions.items()}
    level = [number for number, each in seen.items() if each is not None]
    named = [number for number in level if number in crease_patterns]
    flat = next(iter(named or level), None)
    of_flat = None if flat is None else seen[flat]
    if flat is not None and of_flat is not None:
        positions[flat] = of_flat
    file = _File(
        positions,
        flat,
        flat is not None and flat not in named and "foldedForm" in read_classes(frames, flat),
        edges,
        letters,
    )
    if faces is None:
        asked = None if file.flat is None else degrees[file.flat]
        sheet = _of_edges(file, asked, weld, notes)
    else:
        sheet = _of_faces(file, faces, weld, notes)

    def angles(number: int | None) -> Array | None:
        given = None if number is None else degrees[number]
        return None if given is None or sheet.chosen is None else np.deg2rad(given[sheet.chosen])

    folded = [n for n in positions if n != sheet.frame and n not in crease_patterns]
    if sheet.vertices is None and folded:
        notes.append("lines cross where the file has no vertex: folded states are left out")
    asked_angles = sheet.angles if sheet.angles is not None else angles(sheet.frame)
    unit = read_unit(frames)
    return ReadPattern(
        path=path,
        title=read_title(frames) or printable(path.stem),
        unit=unit if unit in MILLIMETRES else "unit",
        flat=sheet.flat,
        not_flat=sheet.not_flat,
        faces=sheet.faces,
        edges=sheet.edges,
        edge_faces=sheet.edge_faces,
        letters=sheet.letters,
        fold_angles=np.full(len(sheet.edges), np.nan) if asked_angles is None else asked_angles,
        states=tuple(
            PatternState(
                plain_line(str(frames.raw[number].get("frame_title", ""))[:200]),
                positions[number][sheet.vertices],
                angles(number),
            )
            for number in folded
            if sheet.vertices is not None
        ),
        notes=tuple(notes),
    )


def _letters(
    given: tuple[str, ...] | None, degrees: dict[int, Array | None], notes: list[str]
) -> NDArray[np.str_] | None:
    """Letter (E,) of every edge: by the first fold angles where the file gives none."""
    if given is not None:
        return np.array(given, dtype=np.str_)
    angles = next((each for each in degrees.values() if each is not None and each.any()), None)
    if angles is None:
        return None
    notes.append("the file has no edges_assignment: letters are those of its fold angles")
    letters = np.array(["M", "F", "V"])[np.sign(np.nan_to_num(angles)).astype(np.int64) + 1]
    return np.where(np.isnan(angles), "U", letters)


def _of_edges(file: _File, degrees: Array | None, weld: float | None, notes: list[str]) -> _Sheet:
    """The panels between the edges of a file that lists none."""
    if file.edges is None or file.flat is None:
        raise InputError(
            "this key is missing",
            where=FACES,
            remedy=f"add {FACES}, or edges_vertices and flat vertices_coords",
        )
    count = len(file.edges)
    points = file.first[:, :2]
    lines = Lines(
        points[file.edges],
        np.full(count, "U") if file.letters is None else file.letters,
        np.full(count, np.nan) if degrees is None else np.deg2rad(degrees),
        np.arange(count),
        tuple(f"edge {number}" for number in range(count)),
    )
    found = arrange(lines, weld)
    notes += [f"the file has no {FACES}: panels were found between its edges", *found.notes]
    pattern = found.pattern
    both = np.concatenate([points, pattern.vertices])
    _, first, place = np.unique(both, axis=0, return_index=True, return_inverse=True)
    vertices = first[place.ravel()[len(points) :]]
    known = vertices if (vertices < len(points)).all() else None
    return _with_flat(pattern, file.flat, known, None, found.angles)


def _of_faces(file: _File, faces: Integers, weld: float | None, notes: list[str]) -> _Sheet:
    """The panels that a file lists."""
    try:
        return _sheet(file, faces, weld, notes)
    except PiecesError as error:
        wider = float(f"{WELD * np.linalg.norm(np.ptp(file.first, axis=0)):.2g}")
        if weld is not None:
            raise
        again: list[str] = []
        try:
            found = _sheet(file, faces, wider, again)
        except InputError:
            raise error from None
        notes += [f"vertices up to {wider:g} apart were joined (weld = {wider:g})", *again]
        return found


def _sheet(file: _File, faces: Integers, weld: float | None, notes: list[str]) -> _Sheet:
    edges, letters = file.edges, file.letters
    if weld is not None:
        leader = weld_points(file.first, weld)
        faces = np.where(faces < 0, -1, leader[faces])
        require_different(faces, f"{FACES}, with weld = {weld:g},")
        edges = None if edges is None else leader[edges]
    used = np.unique(faces[faces >= 0])
    size = len(file.first)
    place = np.full(size, -1)
    place[used] = np.arange(len(used))
    loops = np.where(faces < 0, -1, place[faces])
    if len(used) < size:
        notes.append(f"{counted(size - len(used), 'vertex', 'vertices')} of no panel: left out")
    chosen = None
    if edges is not None:
        chosen, letters = sides_among(
            edges, letters, sides_of(faces)[0], size, welded=weld is not None, notes=notes
        )
        edges = place[edges[chosen]]
    positions = file.first[used]
    if file.flat is not None:
        try:
            flat = pattern_of_panels(positions[:, :2], loops, edges, letters)
            require_apart(flat)
        except InputError:
            if not file.folded:
                raise
        else:
            return _with_flat(flat, file.flat, used, chosen)
    joined = join_loops(loops, len(used), edges, None if letters is None else letters == "C")
    require_one_piece(joined.edge_faces[joined.crease], len(loops))
    laid = lay_out(positions, joined)
    reason = laid.reason
    if laid.vertices is not None:
        without = letters is None
        letters = letters_of_folds(positions, joined) if letters is None else letters
        flat = pattern_of_panels(laid.vertices, joined.loops, joined.edges, letters)
        try:
            require_apart(flat)
        except InputError as error:
            reason = f"laid out flat, {error.what}"
        else:
            notes.append("the file has no flat sheet: it was laid out from the first state")
            if without:
                notes.append("the file has no letters: they are those of its folded state")
            return _with_flat(flat, None, used, chosen)
    known = np.full(len(joined.edges), "U") if letters is None else letters
    return _Sheet(
        flat=None,
        not_flat=reason,
        faces=joined.loops,
        edges=joined.edges,
        edge_faces=joined.edge_faces,
        letters=np.where((joined.edge_faces < 0).any(axis=1), "B", known),
        frame=None,
        vertices=used,
        chosen=chosen,
    )


def _with_flat(
    flat: CreasePattern,
    frame: int | None,
    vertices: Integers | None,
    chosen: Integers | None,
    angles: Array | None = None,
) -> _Sheet:
    return _Sheet(
        flat=flat,
        not_flat="",
        faces=flat.faces,
        edges=flat.edges,
        edge_faces=flat.edge_faces,
        letters=flat.letters,
        frame=frame,
        vertices=vertices,
        chosen=chosen,
        angles=angles,
    )
