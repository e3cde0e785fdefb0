"""The shell as a structure: an input deck for CalculiX, and for others that read Abaqus' keywords.

Cells of the mesh are quadratic quadrilaterals of reduced integration, S8R. On folded plates they
come nearest to thin shells: CalculiX makes solids of all its shells, of which the others are too
stiff in bending (S3, S4) or buckle too late on a coarse mesh (S6). Ties are springs between two
nodes: trusses, T3D2, would hold the rotations of the shell, and spoil its buckling factors.

Creases are rigid, but where gussets or girders keep folds from turning: they would have nothing to
do. There panels and these have nodes of their own, and equations give those at one place one
displacement. So hinges of girders turn, whatever creases do.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import conversion
from orishell.document import Document
from orishell.document.loaded import LoadedShell
from orishell.io.format import Format, Settings
from orishell.io.quadratic import QuadraticMesh, quadratic_mesh
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import first_largest

MODES = 6
"""Natural frequencies that are asked for."""
RIGID = 1e-6
"""A motion of the shell as a whole that moves its supports by less of its size is free."""
BUCKLING = "5,1e-4,40,1000"
"""Buckling factors, accuracy, Lanczos vectors, rounds. Asked for one factor CalculiX may miss the
lowest: with 20 vectors, of the shelter in 8 cells, by 5 %."""
STIFF = 1e3
"""A tie that does not stretch is this many times as stiff as a square of panel."""
_ANSWERS = ("*NODE PRINT,NSET=SHELL", "U", "*NODE FILE", "U,RF", "*EL FILE", "S")


def write_calculix(path: Path, document: Document, settings: Settings) -> None:
    """Write the analysed shell: mesh, sections, supports, ties and the loads of every case.

    Every case is a linear static step, then come natural frequencies, then buckling of every case.
    Supports and ties act both ways, and creases are rigid, or turn freely where something
    stiffens the sheet and creases are not all locked; comments at its head say so. Lengths
    are in the document's unit, forces in newtons, masses so that a newton is a mass times a unit
    of length per square second. Numbers have 13 digits, as many as CalculiX reads.

    Raises
    ------
    InputError
        If the shell was not analysed, is of whole boards, has base rails, or no unit of
        length is known.
    """
    shell = document.loaded
    if shell is None:
        raise InputError(
            "the shell was not analysed as a structure",
            keys=("structure",),
            remedy="add the tables [structure] and [[load_case]] to the design file",
        )
    if shell.whole_boards:
        raise InputError(
            "whole boards on hinges are not written for CalculiX: creases there are rigid, and in "
            "the middle of panels",
            keys=("panel.construction",),
            got='"hinged"',
            expected='"sandwich" or "bevel"',
        )
    if shell.rails:
        raise InputError(
            "base rails are not written for CalculiX",
            keys=("structure.rail",),
            expected="no rail: its feet then stand by themselves",
        )
    unit = document.require_unit()
    hinged = shell.parts is not None and shell.creases_turn
    mesh = quadratic_mesh(shell, hinged=hinged)
    cases = _different_loads(shell)
    lines = [
        *_head(document, unit, [name for name, _ in cases], shell, hinged=hinged),
        *_elements(mesh, document.in_world(mesh.points)),
        *_sections(mesh, conversion(unit, "m")),
        *_together(mesh),
        *_ties(shell, len(mesh.quads) + len(mesh.triangles)),
        *_held(shell, mesh),
    ]
    for name, forces in cases:
        lines += _step(name, "*STATIC", *_loads(forces), *_ANSWERS)
    lines += _step("natural frequencies", "*FREQUENCY", str(MODES), *_ANSWERS)
    for name, forces in cases:
        lines += _step(f"buckling: {name}", "*BUCKLE", BUCKLING, *_loads(forces))
    path.write_text("".join(f"{line}\n" for line in lines), encoding="ascii", newline="\n")


def _different_loads(shell: LoadedShell) -> list[tuple[str, Array]]:
    """Names and forces of the cases; those that differ by the stiffness of creases are one."""
    found: dict[bytes, tuple[str, Array]] = {}
    for case in shell.cases:
        key = case.forces.tobytes()
        name = f"{found[key][0]}; {case.name}" if key in found else case.name
        found[key] = (name, case.forces)
    return list(found.values())


MISSED = ("CalculiX may miss the lowest factors by which slender stiffeners buckle (2.20).",)
TIED = (
    "CalculiX counts springs twice where it buckles (2.20): with ties its factors are too high.",
)


RIGID_CREASES = "- creases are rigid: panels share their rotations there;"
HINGED = "- creases and hinges turn freely: what meets there shares displacements, no rotations;"


def _head(
    document: Document, unit: str, names: Sequence[str], shell: LoadedShell, *, hinged: bool
) -> Iterable[str]:
    kilograms = conversion("m", unit)
    yield "*HEADING"
    yield _plain(document.title)
    yield from (
        f"** {line}"
        for line in (
            f"Units: {unit}, N, s; masses in {kilograms:g} kg, so that N = mass times {unit}/s2.",
            "z is up. Nodes at the corners of cells are those of orishell's analysis.",
            "This is not all that orishell analyses:",
            HINGED if hinged else RIGID_CREASES,
            "- supports and ties hold both ways, feet on the ground are pinned: look at signs;",
            "- where supports let the shell move as a whole some nodes are held, and bear nothing;",
            "- flaps are left out, but for their weight among the loads;",
            f"- ties that do not stretch are {STIFF:g} times as stiff as a square of panel;",
            "- boards on a membrane are one plate, as stiff in its plane and in bending: stresses",
            "  are not those of the boards;",
            "- boards with a grain are as stiff one way as the other, and stiffer in shear;",
            "- cores of sandwich boards do not shear: where there are some, this shell is stiffer;",
            "- frequencies are those of the shell without loads, and with every tie.",
            *TIED * bool(len(shell.ties)),
            *MISSED * (shell.parts is not None),
            "Steps: every case of loads; natural frequencies; buckling under every case.",
            *(f"Case {number}: {_plain(name)}" for number, name in enumerate(names, 1)),
        )
    )


def _elements(mesh: QuadraticMesh, points: Array) -> Iterable[str]:
    yield "*NODE,NSET=ALL"
    yield from (f"{k},{_numbers(point)}" for k, point in enumerate(points.tolist(), 1))
    yield "*NSET,NSET=SHELL,GENERATE"
    yield f"1,{mesh.own},1"
    first = 1
    for kind, name, nodes in (
        ("S8R", "PANELS", mesh.quads[: mesh.panels]),
        ("S8R", "STIFFENERS", mesh.quads[mesh.panels :]),
        ("S6", "STIFFENERS", mesh.triangles),
    ):
        if len(nodes):
            yield f"*ELEMENT,TYPE={kind},ELSET={name}"
        yield from (",".join(map(str, row)) for row in _numbered(nodes + 1, first))
        first += len(nodes)


def _numbered(rows: Integers, first: int) -> Iterable[tuple[int, ...]]:
    return ((number, *row) for number, row in enumerate(rows.tolist(), first))


def _sections(mesh: QuadraticMesh, metres: float) -> Iterable[str]:
    for each in mesh.sections:
        material = each.name.replace("SECTION", "PANEL")
        yield f"*ELSET,ELSET={each.name}"
        yield from map(str, (each.elements + 1).tolist())
        yield f"*MATERIAL,NAME={material}"
        yield "*ELASTIC"
        yield _numbers([each.modulus, each.poisson])
        yield "*DENSITY"
        yield _numbers([each.density * metres])
        yield f"*SHELL SECTION,ELSET={each.name},MATERIAL={material}"
        yield _numbers([each.thickness])


def _together(mesh: QuadraticMesh) -> Iterable[str]:
    """Equations that give nodes at one place one displacement."""
    if len(mesh.together):
        yield "*EQUATION"
    for first, other in (mesh.together + 1).tolist():
        for axis in (1, 2, 3):
            yield "2"
            yield f"{other},{axis},1.,{first},{axis},-1."


def _held(shell: LoadedShell, mesh: QuadraticMesh) -> Iterable[str]:
    """Supports: displacements once for all nodes at a place, rotations of every panel there."""
    every = np.concatenate([shell.restrained, _kept_still(shell)])
    yield "*BOUNDARY"
    for (node, axis), panels in zip(every.tolist(), mesh.of_panels(every[:, 0]), strict=True):
        for each in [node] if axis < 3 else panels.tolist():
            yield f"{each + 1},{axis + 1},{axis + 1}"


def _ties(shell: LoadedShell, cells: int) -> Iterable[str]:
    ends = shell.points[shell.ties]
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    stiffness = np.minimum(shell.tie_stiffness / length, STIFF * float(shell.membrane.max()))
    pairs = (shell.ties + 1).tolist()
    for number, ((first, second), each) in enumerate(
        zip(pairs, stiffness.tolist(), strict=True), 1
    ):
        yield f"*ELEMENT,TYPE=SPRINGA,ELSET=TIE{number}"
        yield f"{cells + number},{first},{second}"
        yield f"*SPRING,ELSET=TIE{number}"
        yield ""  # no direction, which CalculiX would take a number without a point for
        yield f"{each:.12e}"


def _kept_still(shell: LoadedShell) -> Integers:
    """Displacements (k, 2) that keep the shell as a whole where its supports do not.

    Loads that are in balance without them move them by nothing: there is no force on them.
    """
    points = shell.points - shell.points.mean(axis=0)
    points = points / np.abs(points).max()
    axes = np.broadcast_to(np.eye(3), (len(points), 3, 3))
    moved = np.concatenate([axes, np.cross(points[:, None], axes)], axis=2)
    turned = np.concatenate([np.zeros_like(axes), axes], axis=2)
    by_motion = np.concatenate([moved, turned], axis=1)  # (N, 6, 6)
    rows = by_motion[*shell.restrained.T]
    more: list[tuple[int, int]] = []
    while len(more) < 6:
        _, sizes, motions = np.linalg.svd(np.concatenate([rows, np.zeros((6, 6))]))
        free = motions[sizes < RIGID]
        if not len(free):
            break
        by_free = np.linalg.norm(moved @ free.T, axis=2)
        node, axis = divmod(first_largest(by_free), 3)
        more.append((node, axis))
        rows = np.concatenate([rows, moved[node, axis][None]])
    return np.array(more, np.int64).reshape(-1, 2)


def _step(what: str, *lines: str) -> Iterable[str]:
    return f"** {_plain(what)}", "*STEP", *lines, "*END STEP"


def _loads(forces: Array) -> Iterable[str]:
    yield "*CLOAD,OP=NEW"
    for node, axis in np.argwhere(forces).tolist():
        yield f"{node + 1},{axis + 1},{_numbers([forces[node, axis]])}"


def _numbers(values: Sequence[float]) -> str:
    return ",".join(f"{value:.13g}" for value in values)


def _plain(words: str) -> str:
    """One line of ASCII that is no keyword."""
    return " ".join(words.split()).lstrip("*").encode("ascii", "replace").decode("ascii")


FORMAT = Format(
    "inp",
    "shell.inp",
    (".inp",),
    "the analysed structure (CalculiX)",
    write_calculix,
    analysed=True,
    task="analysis",
)
