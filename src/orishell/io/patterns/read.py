"""Crease patterns from files, whatever program wrote them."""

from __future__ import annotations

from dataclasses import replace
from math import isfinite
from pathlib import Path

import numpy as np

from orishell.conventions.arguments import path_of
from orishell.conventions.errors import InputError, printable
from orishell.conventions.quantities import MILLIMETRES
from orishell.conventions.source_file import require_source_file
from orishell.curves.files import kind_of
from orishell.io.fold_frames import MAX_BYTES, Frames, read_frames
from orishell.io.patterns.arrangement import arrange
from orishell.io.patterns.cp import read_cp_lines
from orishell.io.patterns.dxf import read_dxf_lines
from orishell.io.patterns.fold import read_fold_pattern
from orishell.io.patterns.lines import Lines
from orishell.io.patterns.obj import read_obj_frames
from orishell.io.patterns.pattern_file import ReadPattern
from orishell.io.patterns.svg import read_svg_lines

ENDINGS = (".fold", ".svg", ".dxf", ".cp", ".obj")
OTHERS = {
    ".opx": "export it from ORIPA as FOLD or CP",
    ".orh": "save it in Orihime or Oriedita as CP",
    ".ori": "export it from Oriedita as FOLD or CP",
}
"""What programs keep for themselves, which write one that is read, too."""


def read_pattern(
    path: str | Path,
    *,
    unit: str | None = None,
    scale: float = 1.0,
    weld: float | None = None,
) -> ReadPattern:
    """Read a crease pattern: FOLD (panels of any shape, or only edges), SVG, DXF, CP or OBJ.

    Drawings may have their lines in any order; they are split where they cross. A line is a
    mountain, valley, border, cut or flat by its layer's name, or else by its colour: red mountain,
    blue valley, black border, green cut, yellow flat, magenta not assigned; by its kind in CP. The
    panels of an OBJ file, folded or flat, have no letters.

    Parameters
    ----------
    path
        The file.
    unit
        The unit of the file's coordinates, whatever the file says: mm, cm, m, in, ft.
    scale
        What all lengths are multiplied with.
    weld
        Points nearer to each other than this are one, before ``scale`` (millimetres in an SVG
        file whose page has a physical size). None for 1e-5 of the diagonal in drawings, and for
        the vertices as they are in FOLD.

    Raises
    ------
    InputError
        If the file is none of these, or draws no sheet; by place, with what would help.
    """
    path = path_of(path, "read_pattern: path")
    if unit is not None and unit not in MILLIMETRES:
        raise InputError("this is no unit", got=str(unit), expected=", ".join(MILLIMETRES))
    for name, value in (("scale", scale), ("weld", weld)):
        if value is not None and not (isfinite(value) and value > 0):
            raise InputError(f"{name} is no number above 0", got=repr(value))
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
            found = _read(path, unit, weld)
    except InputError as error:
        raise error.located(f"{path}:") from None
    return found.scaled(scale, unit)


def pattern_of_frames(path: Path, frames: Frames) -> ReadPattern:
    """The pattern in a FOLD file that was parsed before.

    Raises InputError: As :func:`read_pattern`.
    """
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            return read_fold_pattern(path, frames, None)
    except InputError as error:
        raise error.located(f"{path}:") from None


def _read(path: Path, unit: str | None, weld: float | None) -> ReadPattern:
    ending = _require_kind(path)
    if ending == ".fold":
        return read_fold_pattern(path, read_frames(path), weld)
    if ending == ".obj":
        return read_fold_pattern(path, read_obj_frames(path), weld)
    lines, stated, notes = _lines(path, ending, unit)
    if unit is None and stated == "unit":
        notes.append("the drawing states no unit of length")
    return _drawn(path, lines, weld, stated, notes)


def read_lines(path: Path) -> Lines | None:
    """The lines of a drawing, whether or not they make a pattern; None of files that list panels.

    Raises InputError: If the file is no drawing.
    """
    ending = _require_kind(path)
    return None if ending in (".fold", ".obj") else _lines(path, ending, None)[0]


def _lines(path: Path, ending: str, unit: str | None) -> tuple[Lines, str, list[str]]:
    """The lines of a drawing, the unit that it states or "unit", and notes."""
    if ending == ".svg":
        return read_svg_lines(path, whole=unit is not None)
    if ending == ".cp":
        lines, notes = read_cp_lines(path)
        return lines, "unit", notes
    lines, known, notes = read_dxf_lines(path)
    stated, size = known or ("unit", 1.0)
    if stated not in MILLIMETRES and known and unit is None:
        lines, stated = replace(lines, ends=size * lines.ends), "mm"
    return lines, stated, notes


def _drawn(
    path: Path, lines: Lines, weld: float | None, unit: str, notes: list[str]
) -> ReadPattern:
    found = arrange(lines, weld)
    flat = found.pattern
    return ReadPattern(
        path=path,
        title=printable(path.stem),
        unit=unit,
        flat=flat,
        not_flat="",
        faces=flat.faces,
        edges=flat.edges,
        edge_faces=flat.edge_faces,
        letters=flat.letters,
        fold_angles=found.angles,
        states=(),
        notes=(*notes, *found.notes),
    )


def _require_kind(path: Path) -> str:
    """The ending of a file, if its content is of that kind."""
    ending = path.suffix.lower()
    require_source_file(path, "file", MAX_BYTES)
    try:
        with path.open("rb") as file:
            begin = file.read(1000)
    except OSError as error:
        raise InputError("the file cannot be read", got=error.strerror or str(error)) from None
    if not begin.removeprefix(b"\xef\xbb\xbf").strip():
        raise InputError("the file is empty")
    kind = kind_of(begin)
    wanted = ending[1:].upper() if ending in ENDINGS else ""
    if not wanted or (kind and kind != wanted):
        known = f".{kind.lower()}" in ENDINGS
        raise InputError(
            "the file is of another kind than its ending says"
            if wanted
            else "patterns are not read from such files",
            got=(ending or "no ending")
            + ("" if ending in OTHERS else f", and what looks like {kind or 'nothing known'}"),
            expected=", ".join(ENDINGS),
            remedy=OTHERS.get(ending) or (f"give it the ending .{kind.lower()}" if known else ""),
        )
    return ending
