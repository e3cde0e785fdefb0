"""The components: what each makes of its inputs, and gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import MILLIMETRES, conversion
from orishell.conventions.row import MARKS
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import DesignFile, check_design
from orishell.design_file.embedded import embedded
from orishell.document import FLAT, OPEN, Document
from orishell.document.from_design import document_at
from orishell.io.rhino_geometry import mesh_of_faces, polyline_curve
from orishell.io.solids import find_frames, mesh_of, solids_in
from orishell.motion.quads import longer_diagonals
from orishell.numerics.arrays import Array
from orishell.shell.kit import write_kit
from orishell.shell.make import Shell, make_shell
from orishell.studio.hops.designs import PLACE, file_of, keep, made, shell_of
from orishell.studio.hops.geometry import f_path, g_path, lines, planes, points, surface_table
from orishell.studio.hops.protocol import answered, unfit, values_of
from orishell.studio.processes import Send, ignore
from orishell.workshop.assembly import laid_flat
from orishell.workshop.creases import CREASE_LETTERS
from orishell.workshop.cut_parts import find_outlines

Values = dict[str, Any]
"""Values of inputs by their names, and "modelunits", the document's unit, or ""."""
Given = tuple[list[Any], list[str]]
"""What the outputs of a component have, in their order, and its warnings."""


def _from_curves(values: Values, progress: Progress) -> Given:
    target, warnings = {}, []
    for name, read in (("f", f_path), ("g", g_path)):
        if not hasattr(values[name], "ToNurbsCurve"):
            raise unfit(name, type(values[name]).__name__, "Curve")
        try:
            path, notes = read(values[name])
        except InputError as error:
            raise error.located(f"input {name}") from None
        target[name] = {"path": path}
        warnings += [f"{name}: {each}" for each in notes]
    return _designed(values, target, warnings, progress)


def _from_surface(values: Values, progress: Progress) -> Given:
    table, warnings = surface_table(values["surface"])
    return _designed(values, {"surface": table}, warnings, progress)


def _from_file(values: Values, progress: Progress) -> Given:
    tables = embedded(_whole(values, "path"))
    return _kept(check_design(tables, PLACE, files=False), [], progress)


def _whole(values: Values, name: str) -> Path:
    """A path that begins at the root."""
    path = Path(values[name])
    if path.is_absolute():
        return path
    remedy = "take it from a File Path parameter"
    what = "the path begins nowhere"
    raise InputError(
        what, where=f"input {name}", got=str(path), expected="a whole path", remedy=remedy
    )


def _designed(values: Values, target: Values, warnings: list[str], progress: Progress) -> Given:
    """A design of a target, drawn in the document's unit, and what else the inputs say."""
    drawn = values["modelunits"]
    unit = drawn if values["unit"] == "document" else values["unit"]
    if unit not in MILLIMETRES:
        raise InputError(
            "the unit of the design is not known",
            where="input unit",
            got=repr(unit) if unit else "no unit of the document",
            expected=", ".join(MILLIMETRES),
            remedy="write one of these on a panel and connect it",
        )
    target = {name: {**table, "unit": drawn or unit} for name, table in target.items()}
    pattern: Values = {}
    if values["rows"] or values["columns"]:  # else [tolerance] finds them
        pattern |= {key: values[key] for key in ("rows", "columns")}
    if values["flap"] != "default":
        pattern["flap"] = _number(values["flap"])
    tables = {"shell": {"family": values["family"], "unit": unit}, "pattern": pattern}
    more = parse_toml(values["keys"])
    # What stands before all tables is the family's.
    loose = {
        key: more.pop(key) for key, each in [*more.items()] if not isinstance(each, dict | list)
    }
    tables = _merged({**tables, "target": target}, _merged({"pattern": loose}, more))
    return _kept(check_design(tables, PLACE, files=False), warnings, progress)


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _merged(tables: Mapping[str, Any], more: Mapping[str, Any]) -> dict[str, Any]:
    """Tables with the keys of others, which count."""
    return {
        **tables,
        **{
            key: _merged(tables.get(key, {}), each) if isinstance(each, dict) else each
            for key, each in more.items()
        },
    }


def _kept(file: DesignFile, warnings: list[str], progress: Progress) -> Given:
    """The text of a design, and what is to be said of it; its shell is kept."""
    import tomli_w

    shell = made(file, progress)
    text = tomli_w.dumps(shell.file.tables)
    keep(text, shell)
    notes = [str(each) for each in dict.fromkeys([*file.notes, *shell.report.warnings])]
    if (end := _end(shell)) > 1:
        notes.append(f"at the drive {end:g} it is packed")
    return [text, notes], warnings


def _end(shell: Shell) -> float:
    """The largest drive as a share of the target's."""
    target = shell.design.mechanism.target_drive
    return rounded(max(1.0, float(shell.motion.drives.max()) / target), 6)


def _factor(shell: Shell, values: Values) -> float:
    """What lengths of a shell are multiplied by in the document."""
    return conversion(shell.file.unit, values["modelunits"] or shell.file.unit)


def _posed(values: Values, progress: Progress) -> tuple[Shell, Document, float]:
    """A shell, its document in the state of a drive, and the factor of its lengths."""
    shell = shell_of(values["design"], progress)
    share, most = values["drive"], _end(shell)
    if not 0 <= share <= most:
        first = OPEN if OPEN in shell.document.named else FLAT
        raise InputError(
            "there is no state at this drive",
            where="input drive",
            got=f"{share:g}",
            expected=f"from 0, {first}, to {most:g}",
            remedy=f"give the slider the range 0 to {most:g}",
        )
    target = shell.design.mechanism.target_drive
    return shell, document_at(shell.document, share * target), _factor(shell, values)


def _state(values: Values, progress: Progress) -> Given:
    shell, document, factor = _posed(values, progress)
    meshes = [
        mesh_of_faces(factor * document.in_world(there.positions), part.mesh.faces)
        for part, there in document.parts_in("target")
    ]
    places = factor * document.in_world(document.shell.positions)
    columns = document.grid_shape[1] if document.grid_shape else 0
    ends = [[row * columns + column for row, column in tie.ends] for tie in document.ties]
    ties = lines(places[np.array(ends, np.int64).reshape(-1, 2)])
    stands, feet = shell.report.stands, np.zeros((0, 2), np.int64)
    if stands is not None:
        feet = stands.vertices(shell.design.mechanism)
    standing = points(places[feet[:, 0] * columns + feet[:, 1]])
    return [meshes, *_creases(document, places), ties, standing], []


def _creases(document: Document, places: Array) -> list[Any]:
    """Mountains, valleys and unfolded creases between vertices (V, 3)."""
    letters, ends = np.array(document.assignment), places[document.mesh.edges]
    return [
        lines(ends[np.isin(letters, [*CREASE_LETTERS[layer]]) & document.mesh.crease])
        for layer in ("MOUNTAIN", "VALLEY", "ENGRAVE")
    ]


def _panels(values: Values, progress: Progress) -> Given:
    _, document, factor = _posed(values, progress)
    outlines: dict[str, Any] = {}
    frames: dict[str, Any] = {}
    for number, (part, there) in enumerate(document.parts_in("target")):
        corners = factor * document.in_world(part.panel_corners(there))
        loops = np.concatenate([corners, corners[:, :1]], axis=1)
        outlines[str(number)] = [polyline_curve(loop) for loop in loops]
        # Their longer diagonals are the same in all states, but for rounding.
        frames[str(number)] = planes(*find_frames(corners, longer_diagonals(corners)))
    return [outlines, frames], []


def _boards(values: Values, progress: Progress) -> Given:
    _, document, factor = _posed(values, progress)
    document.boards_in(document.shell)  # refuses, where panels have no thickness
    boards = [*mesh_of(solids_in(document, "target")).each()]
    meshes = [mesh_of_faces(factor * document.in_world(each), faces) for _, each, faces in boards]
    return [meshes, [name for name, _, _ in boards]], []


def _pattern(values: Values, progress: Progress) -> Given:
    shell = shell_of(values["design"], progress)
    document = laid_flat(shell.document.as_cut())
    flat = document.require_flat()
    places = _factor(shell, values) * np.pad(flat, ((0, 0), (0, 1)))
    loops = find_outlines(document.mesh.loops, flat)
    outlines = [polyline_curve(places[[*loop, loop[0]]]) for loop in loops]
    return [outlines, *_creases(document, places)], []


def _verdict(values: Values, progress: Progress) -> Given:
    report = shell_of(values["design"], progress, proved=True).report
    rows = [
        f"{MARKS[row.sign]} {row.subject}: {row.finding}" + (row.remedy and f" -> {row.remedy}")
        for row in report.verdict
    ]
    warnings = [] if report.feasible is not None else ["its motion is proved in part only"]
    return [rows, bool(report.feasible)], warnings


def _files(values: Values, progress: Progress) -> Given:
    folder = _whole(values, "folder")
    if not values["write"]:
        return [[]], []
    shell = shell_of(values["design"], progress, proved=True)
    if not shell.report.feasible:
        shell = make_shell(file_of(values["design"]), progress)  # refuses, and says what works
    return [[str(each) for each in write_kit(shell, folder, progress=progress).files]], []


SOLVES: Final[dict[str, Callable[[Values, Progress], Given]]] = {
    "curves": _from_curves,
    "surface": _from_surface,
    "file": _from_file,
    "state": _state,
    "panels": _panels,
    "boards": _boards,
    "pattern": _pattern,
    "verdict": _verdict,
    "files": _files,
}
"""What components do, by their paths."""


def answer(name: str, payload: dict[str, Any], progress: Progress, send: Send = ignore) -> bytes:
    """The answer of a component by its name, as Hops reads it: a task of the studio's processes."""
    values = values_of(name, payload["values"]) | {"modelunits": payload["modelunits"]}
    return answered(name, *SOLVES[name](values, progress))
