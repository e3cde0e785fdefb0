"""What a builder needs to know of a shell: sizes to check, packs, mass, ties and feet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from orishell.conventions.quantities import conversion
from orishell.conventions.record import record
from orishell.document import SHELL, Document
from orishell.document.measures import BoxReport, Measures, is_hand_sized
from orishell.document.sizes import deployed_in_words
from orishell.motion.freedom import FreedomOfSheet
from orishell.numerics.arrays import Array, Booleans, Integers
from orishell.numerics.equals import first_smallest
from orishell.workshop.boards import has_sheet
from orishell.workshop.seams import strip_numbers


@record
class KitFacts:
    """Sizes of a shell or of a model of it, in the document's unit."""

    starts_packed: bool  # whether it opens from a pack, or else is folded from the flat sheet
    construction: str  # as in [panel]; empty where panels have no thickness
    one_side: str  # "top" or "bottom" if its membrane has boards on that face alone; empty else
    # sides of the boxes around the flat sheet and around the shell at its target, as its report has
    # them: what folds, with its boards, and that with all other parts
    sheet: tuple[float, float]
    strips: int  # how many strips it is made of, the largest that large; 1 for one sheet
    opened: tuple[float, float, float]
    whole: tuple[float, float, float]
    # sides of the packs of all pieces; none where they were not measured
    packs: tuple[tuple[float, float, float], ...]
    layers: int  # panels that lie on each other in a pack, at most; 0 where it was not measured
    mass: float | None  # kg; None where it is not known
    ties: tuple[float, ...]  # their lengths
    tied: Integers  # vertices (K, 2) that they join
    ties_early: bool  # whether they are fixed to the pack: all are proved slack until it is open
    feet: int  # how many vertices it stands on; 0 where it has no feet
    # whether these are anchored in the ground: not those of a shell that is as small as a lampshade
    # or a model, unless a load case pulls one up
    anchored: bool
    footing: Integers  # vertices (K,) of its feet, as far as the plan of the ground has them
    apart: tuple[float, float] | None  # the least and largest distance of feet opposite each other
    pieces: tuple[Booleans, ...]  # panels (F,) of each piece
    diagonals: tuple[tuple[float, float], ...]  # of the flat sheet of each piece, corner to corner
    shuts: bool  # whether flaps of the sheet are folded flat at the target
    attached: int  # parts that go with the sheet
    flap_panels: int  # their panels
    model: bool  # whether it is a model
    # how its sheet folds where that is not one motion: "known", "nearly" or "unknown", and how many
    # degrees of freedom; None where it is
    freedoms: tuple[str, str] | None
    strings: tuple[float, ...] = ()  # lengths of those that tie end walls to it

    def opened_in_words(self, unit: str) -> str:
        """Its sizes at the target, as its verdict says them."""
        outside = BoxReport(*self.whole) if self.attached else None
        boards = bool(self.construction)
        return deployed_in_words(BoxReport(*self.opened), outside, unit, boards=boards)


def find_facts(document: Document) -> KitFacts:
    """What is known of a document, and of what was measured of its shell."""
    known, factor = document.measures, _factor(document)
    flat, points = document.require_flat(), document.in_world(document.shell.positions)
    pieces = tuple(_pieces(document))
    model, tied = document.model_scale is not None, _tied(document)
    # They are measured with the thickness of panels, which a model has not.
    packs = () if known is None or model else known.packs
    packed = known is not None and known.starts_packed and "pack" in document.named
    apart, feet = _feet(document, known, points)
    strip = strip_numbers(document)
    width, height = np.max(
        [np.ptp(flat[document.mesh.faces[strip == k]], axis=(0, 1)) for k in np.unique(strip)],
        axis=0,
    ).tolist()
    in_strips = len(document.cut_from) > 0
    built = document.panel is not None and document.boards is not None
    boxes = [_sides(document.sheet), _sides(document)]
    if known is not None and not model:
        boxes = [_scaled(each.sides, factor) for each in (known.deployed, known.outside)]
    opened, whole = boxes
    return KitFacts(
        starts_packed=packed,
        construction=document.panel.construction if document.panel and built else "",
        one_side="" if document.panel is None else document.panel.one_side,
        sheet=(width, height),
        strips=int(strip.max()),
        opened=opened,
        whole=whole,
        packs=tuple(_scaled(each, factor) for each in packs),
        layers=known.layers if known is not None and packs else 0,
        mass=None if known is None or model else known.mass,
        # Those of whole boards are between corners of these.
        ties=_tie_lengths(points, tied) if model else tuple(tie.length for tie in document.ties),
        tied=tied,
        ties_early=packed and len(pieces) == 1 and all(tie.slack for tie in document.ties),
        feet=feet,
        anchored=feet > 0 and (_pulled(document) or not is_hand_sized(points, document.unit)),
        footing=_footing(document),
        apart=apart,
        pieces=pieces,
        diagonals=() if in_strips else tuple(_diagonals(document, pieces)),
        shuts=known is not None and known.shuts,
        attached=len(document.attached),
        flap_panels=sum(len(each.mesh.faces) for each in document.attached),
        model=model,
        freedoms=None if known is None else _freedoms(known.freedom),
        strings=() if known is None or model else tuple(factor * each for each in known.strings),
    )


def _freedoms(freedom: FreedomOfSheet) -> tuple[str, str] | None:
    if freedom.one_motion:
        return None
    if freedom.count is None:
        return "unknown", ""
    return ("nearly", str(freedom.nearly)) if freedom.count == 1 else ("known", str(freedom.count))


def _sides(document: Document) -> tuple[float, float, float]:
    """Sides of the box around all parts as they are built, at the target."""
    corners = []
    for part, state in document.parts_in(SHELL):
        if has_sheet(part):
            corners.append(state.positions)
        corners.append(part.corners(state))
    x, y, z = np.ptp(np.concatenate(corners), axis=0).tolist()
    return x, y, z


def _scaled(sides: tuple[float, float, float], factor: float) -> tuple[float, float, float]:
    """Sides of a box, in the document's unit."""
    x, y, z = sides
    return factor * x, factor * y, factor * z


def _factor(document: Document) -> float:
    """From lengths that were measured to those of the document."""
    unit = document.unit if document.measures is None else document.measures.unit
    return (document.model_scale or 1.0) * conversion(unit, document.unit)


def _tied(document: Document) -> Integers:
    """Numbers (K, 2) of the vertices that ties join."""
    ends = np.array([tie.ends for tie in document.ties], np.int64).reshape(-1, 2, 2)
    across = 0 if document.grid_shape is None else document.grid_shape[1]
    return np.asarray(across * ends[..., 0] + ends[..., 1])


def _pulled(document: Document) -> bool:
    """Whether a load case pulls a foot up."""
    return document.ground is not None and any(foot.pull for foot in document.ground.feet)


def _footing(document: Document) -> Integers:
    """Numbers (K,) of the vertices that the plan of the ground has."""
    feet = () if document.ground is None else document.ground.feet
    at = np.array([foot.at for foot in feet], np.int64).reshape(-1, 2)
    across = 0 if document.grid_shape is None else document.grid_shape[1]
    return np.asarray(across * at[:, 0] + at[:, 1])


def _tie_lengths(points: Array, tied: Integers) -> tuple[float, ...]:
    """How far vertices (K, 2) are apart, of ties between vertices themselves."""
    ends = points[tied]
    return tuple(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=-1).tolist())


def _pieces(document: Document) -> Iterator[Booleans]:
    """The panels (F,) of each piece that is folded by itself."""
    count, shape = len(document.mesh.faces), document.grid_shape
    if not document.hinges.joint_rows or shape is None:
        yield np.ones(count, np.bool_)
        return
    rows = np.arange(count) // (shape[1] - 1)
    for piece in document.hinges.pieces_of(shape[0] - 1):
        yield np.asarray((rows >= piece.start) & (rows < piece.stop))


def _diagonals(document: Document, pieces: Iterable[Booleans]) -> Iterator[tuple[float, float]]:
    """Both diagonals of every piece as it lies flat, from corner to corner of what is cut."""
    if document.grid_shape is None:
        return
    for piece in pieces:
        corners = [_corner(document, *each) for each in corner_panels(document, piece)]
        one, other = (float(np.hypot(*(corners[k + 2] - corners[k]))) for k in (0, 1))
        yield one, other


def corner_panels(document: Document, piece: Booleans | None) -> Iterator[tuple[int, int]]:
    """The panels at the four corners of a piece, or of all, in turn, each with its corner there.

    None where panels are no grid.
    """
    shape = document.grid_shape
    if shape is None:
        return
    across = shape[1] - 1
    of_grid = np.arange((shape[0] - 1) * across)
    if piece is not None:
        of_grid = np.flatnonzero(piece[: len(of_grid)])
    first, last = int(of_grid[0]) // across, int(of_grid[-1]) // across
    yield first * across, 0
    yield last * across, 1
    yield last * across + across - 1, 2
    yield first * across + across - 1, 3


def _corner(document: Document, panel: int, corner: int) -> Array:
    """Where a corner (2,) of a panel is, or of its board if that is what is cut."""
    place = document.require_flat()[document.mesh.faces[panel, corner]]
    boards = document.boards
    if boards is None:
        return np.asarray(place)
    mine = np.flatnonzero((boards.panels == panel) & (boards.sides == 0))
    if not len(mine):
        return np.asarray(place)
    levels = boards.outlines[mine[0]]
    outline = levels[len(levels) // 2, :, :2]
    return np.asarray(outline[first_smallest(np.hypot(*(outline - place).T))])


def _feet(
    document: Document, known: Measures | None, points: Array
) -> tuple[tuple[float, float] | None, int]:
    """How far feet in both rows are apart, least and most, and how many there are."""
    shape = document.grid_shape
    if known is None or known.feet is None or shape is None:
        return None, 0
    rows = known.feet
    beside = max(shape[1] - known.columns, 0) // 2
    columns = np.arange(beside, shape[1] - beside)
    count = 2 * len(columns)
    if known.points:
        first, last = ({c for r, c in known.points if r == row} for row in rows)
        columns, count = np.array(sorted(first & last), np.int64), len(known.points)
    if document.hinges.beside or not len(columns):  # whole boards stand beside their vertices
        return None, count
    ends = points[: shape[0] * shape[1]].reshape(*shape, 3)
    away = np.linalg.norm(ends[rows[0], columns] - ends[rows[1], columns], axis=-1)
    return (float(away.min()), float(away.max())), count
