"""Crease patterns in FOLD files: panels of any number of corners, or only edges."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError, printable
from orishell.conventions.quantities import MILLIMETRES, counted
from orishell.conventions.record import record
from orishell.io.fold_content import FACES, FoldContent, FoldFrame, FramesError, read_content
from orishell.io.fold_frames import Frames
from orishell.io.fold_polygons import require_different, sides_among
from orishell.io.format import plain_line
from orishell.io.patterns.arrangement import arrange
from orishell.io.patterns.connectivity import PiecesError, require_apart, require_one_piece
from orishell.io.patterns.layout import lay_out, letters_of_folds, seen_from_above
from orishell.io.patterns.lines import WELD, Lines, weld_points
from orishell.io.patterns.pattern_file import PatternState, ReadPattern
from orishell.motion.crease_pattern import CreasePattern, pattern_of_panels
from orishell.motion.panel_sides import join_loops, sides_of
from orishell.numerics.arrays import Array, Integers

CREASES = "creasePattern"
"""What a frame of a flat sheet calls itself."""


@record
class _File:
    """The sheet of a file: its edges and letters, and which frame is flat."""

    frames: tuple[FoldFrame, ...]  # with coordinates; the flat one as it is seen from above
    flat: FoldFrame | None  # the frame of the flat sheet
    # whether it may be folded flat: it calls itself a folded form, or says nothing where there are
    # other states, which lie in no plane
    folded: bool
    edges: Integers | None  # vertices (E, 2)
    letters: NDArray[np.str_] | None  # (E,)

    @property
    def first(self) -> Array:
        """Vertices (V, 3) of the flat sheet, or else of the first frame that has any."""
        return (self.flat or self.frames[0]).positions


@record
class _NotFlat:
    """Panels of a sheet that has no flat state."""

    faces: Integers
    edges: Integers
    edge_faces: Integers
    letters: NDArray[np.str_]
    reason: str  # why not, in a sentence


@record
class _Sheet:
    """The pattern of a file, and what of the file it is made of."""

    panels: CreasePattern | _NotFlat
    vertices: Integers | None  # which of the file's vertices; None if it has others
    chosen: Integers | None  # which of the file's edges; None if it has others
    frame: FoldFrame | None = None  # the frame that the flat sheet is of; None if there is none
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
    content = read_content(frames)
    file = _file(content, notes)
    if content.faces is None:
        sheet = _of_edges(file, weld, notes)
    else:
        sheet = _of_faces(file, content.faces, weld, notes)

    def angles(frame: FoldFrame) -> Array | None:
        given = frame.fold_angles
        return None if given is None or sheet.chosen is None else given[sheet.chosen]

    folded = [
        each for each in file.frames if each is not sheet.frame and CREASES not in each.classes
    ]
    if sheet.vertices is None and folded:
        notes.append("lines cross where the file has no vertex: folded states are left out")
    asked = angles(sheet.frame) if sheet.angles is None and sheet.frame else sheet.angles
    panels = sheet.panels
    return ReadPattern(
        path=path,
        title=content.title or printable(path.stem),
        unit=content.unit if content.unit in MILLIMETRES else "unit",
        flat=panels if isinstance(panels, CreasePattern) else None,
        not_flat=panels.reason if isinstance(panels, _NotFlat) else "",
        faces=panels.faces,
        edges=panels.edges,
        edge_faces=panels.edge_faces,
        letters=panels.letters,
        fold_angles=np.full(len(panels.edges), np.nan) if asked is None else asked,
        states=tuple(
            PatternState(plain_line(each.title[:200]), each.positions[sheet.vertices], angles(each))
            for each in folded
            if sheet.vertices is not None
        ),
        notes=tuple(notes),
    )


def _file(content: FoldContent, notes: list[str]) -> _File:
    """The sheet of a file: flat is the first frame in a plane, of those that say so if any do."""
    seen = [(each, seen_from_above(each.positions)) for each in content.frames]
    level = [replace(each, positions=above) for each, above in seen if above is not None]
    named = [each for each in level if CREASES in each.classes]
    flat = next(iter(named or level), None)
    called = flat is not None and "foldedForm" in flat.classes
    return _File(
        frames=tuple(
            flat if flat is not None and each.number == flat.number else each
            for each in content.frames
        ),
        flat=flat,
        folded=not named and (called or len(level) < len(content.frames)),
        edges=content.edges,
        letters=_letters(content, notes),
    )


def _letters(content: FoldContent, notes: list[str]) -> NDArray[np.str_] | None:
    """Letter (E,) of every edge: by the first fold angles where the file gives none."""
    if content.assignment is not None:
        return np.array(content.assignment, dtype=np.str_)
    given = (each.fold_angles_deg for each in content.frames)
    angles = next((each for each in given if each is not None and each.any()), None)
    if angles is None:
        return None
    notes.append("the file has no edges_assignment: letters are those of its fold angles")
    letters = np.array(["M", "F", "V"])[np.sign(np.nan_to_num(angles)).astype(np.int64) + 1]
    return np.where(np.isnan(angles), "U", letters)


def _of_edges(file: _File, weld: float | None, notes: list[str]) -> _Sheet:
    """The panels between the edges of a file that lists none."""
    if file.edges is None or file.flat is None:
        raise InputError(
            "this key is missing",
            where=FACES,
            remedy=f"add {FACES}, or edges_vertices and flat vertices_coords",
        )
    count, angles = len(file.edges), file.flat.fold_angles
    points = file.first[:, :2]
    lines = Lines(
        points[file.edges],
        np.full(count, "U") if file.letters is None else file.letters,
        np.full(count, np.nan) if angles is None else angles,
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
    return _Sheet(pattern, known, None, file.flat, found.angles)


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
            return _Sheet(flat, used, chosen, file.flat)
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
            return _Sheet(flat, used, chosen)
    known = np.full(len(joined.edges), "U") if letters is None else letters
    letters = np.where((joined.edge_faces < 0).any(axis=1), "B", known)
    loose = _NotFlat(joined.loops, joined.edges, joined.edge_faces, letters, reason)
    return _Sheet(loose, used, chosen)
