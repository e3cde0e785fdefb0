"""The schedule of joints: what joins panels along every crease, and how long it is."""

from __future__ import annotations

from typing import Final, get_args

import numpy as np
from numpy.typing import NDArray

from orishell.conventions.errors import InputError
from orishell.conventions.record import record
from orishell.document import Part
from orishell.numerics.arrays import Array, Integers
from orishell.workshop.assembly import laid_flat
from orishell.workshop.hinge_parts import fittings_of
from orishell.workshop.settings import HingeKind, Workshop

Names = NDArray[np.str_]
PACK: Final = "pack"
HINGE, UNFOLDED, GLUED = "hinge", "none", "joint"
"""What joins solid panels if nobody says what; a crease that does not fold; boards of two pieces,
which are joined at the target."""
BY_LENGTH: Final = (HINGE, "piano hinge", "tape")
"""Kinds that are bought by length; tape is not sold in bars."""
WEIGHED: Final = (HINGE, "piano hinge")
"""Those that have a mass."""


@record
class Schedule:
    """All creases (C,) of a sheet, then those of what is clipped on; lengths in its unit."""

    edges: Integers  # their numbers, as in creases.csv; those of what is clipped on follow
    panels: Integers  # the two panels (C, 2) beside each
    directions: Names  # "row" or "column"; empty where panels have no rows and columns
    kinds: Names  # what joins the panels
    lengths: Array
    at_target: Array  # fold angles, NaN where unknown (degrees)
    in_pack: Array  # the same in the pack, NaN where there is none (degrees)
    hinge_lengths: Array  # of what is bought by length, NaN where it is not
    screws: Integers  # in both panels, -1 where not known


def find_schedule(document: Part, workshop: Workshop) -> Schedule:
    """The schedule of a document for a workshop.

    Raises InputError where a kind of hinge does not go with what panels are made of.
    """
    everything = laid_flat(document)
    edges = np.flatnonzero(everything.mesh.crease)
    panels = everything.mesh.edge_faces[edges]
    directions = _directions(everything, panels)
    kinds = _kinds(everything, edges, directions, workshop)
    lengths = everything.edge_lengths()[edges]
    bought = np.isin(kinds, BY_LENGTH)
    hinge_lengths = np.where(bought, lengths, np.nan)
    screws = np.full(len(edges), -1)
    fittings = fittings_of(everything)
    if fittings is not None:
        place = np.searchsorted(edges, fittings.edges)
        hinge_lengths[place] = fittings.lengths
        screws[place] = 2 * fittings.counts
    in_pack = np.full(len(everything.mesh.edges), np.nan)
    if PACK in document.named and len(document.states):
        angles = document.state(PACK).fold_angles_deg
        if angles is not None:
            in_pack[: len(angles)] = angles
    return Schedule(
        edges=edges,
        panels=panels,
        directions=directions,
        kinds=kinds,
        lengths=lengths,
        at_target=everything.fold_angles_deg[edges],
        in_pack=in_pack[edges],
        hinge_lengths=hinge_lengths,
        screws=screws,
    )


def _directions(document: Part, panels: Integers) -> Names:
    """Which way creases (C,) between panels (C, 2) run: panels of one column share a row crease."""
    names = [document.panel_name(panel) for panel in range(len(document.mesh.faces))]
    columns = np.array([name.partition(",")[2] for name in names], dtype=np.str_)
    first, second = columns[panels].T
    return np.where(first == "", "", np.where(first == second, "row", "column"))


def _kinds(document: Part, edges: Integers, directions: Names, workshop: Workshop) -> Names:
    """What joins panels along creases (C,)."""
    usual = usual_kind(document, workshop)
    asked = {"row": workshop.row_hinge, "column": workshop.column_hinge, "": "auto"}
    build = document.panel
    for direction, kind in asked.items():
        wrong = build is not None and kind in _UNFIT.get(build.construction, ())
        if build is not None and wrong:
            fit = [each for each in _ALL if each not in _UNFIT[build.construction]]
            raise InputError(
                f'"{build.construction}" panels are not joined by a {kind}',
                keys=(f"workshop.{direction}_hinge",),
                got=f'"{kind}"',
                expected=" or ".join(f'"{each}"' for each in fit),
                remedy='a membrane asks for construction = "sandwich" in [panel]',
            )
    said = {key: usual if kind == "auto" else kind for key, kind in asked.items()}
    kinds = np.select([directions == key for key in said], list(said.values()), "")
    letters = np.array(document.assignment)[edges]
    if build is not None and build.is_solid:
        kinds = np.where(np.isin(letters, ("M", "V")), kinds, UNFOLDED)
    joined = _joined(document)
    if joined is not None:
        kinds = np.where(np.isin(edges, joined), GLUED, kinds)
    return np.asarray(kinds, dtype=np.str_)


_ALL: Final = ("auto", *get_args(HingeKind))
_UNFIT: Final[dict[str, tuple[str, ...]]] = {
    "bevel": ("membrane",),
    "hinged": ("membrane", "tape"),
}
"""Kinds that do not go with a construction: solid panels have no membrane, and whole boards turn
about pins beside the creases."""


def usual_kind(document: Part, workshop: Workshop) -> str:
    """What joins panels if nobody says what: a membrane, hinges, or the sheet as it is creased."""
    if document.panel is None:
        return workshop.creases
    return HINGE if document.panel.is_solid else "membrane"


def _joined(document: Part) -> Integers | None:
    """Numbers of the edges along which pieces of whole boards are joined; None without pieces."""
    if not document.hinges.joint_rows or document.grid_shape is None:
        return None
    across = document.grid_shape[1] - 1
    rows = np.asarray(document.hinges.joint_rows, np.int64)
    return np.asarray(((rows[:, None] + 1) * across + np.arange(across)).ravel())
