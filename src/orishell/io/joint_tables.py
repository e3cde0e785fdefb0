"""Tables of joints, ties and of what to order: names of columns, and rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from orishell.document import Document
from orishell.motion.boards import SIDES
from orishell.numerics.arrays import Array, Integers
from orishell.workshop import Workshop
from orishell.workshop.assembly import laid_flat
from orishell.workshop.bars import CutBars
from orishell.workshop.order import cut_hinges, cut_ties, find_order, tie_lengths
from orishell.workshop.schedule import BY_LENGTH, Schedule, find_schedule

Table = tuple[list[str], Iterable[Sequence[object]]]


def schedule_table(document: Document, workshop: Workshop) -> Table:
    """The schedule of joints: a row for every crease, those of what is clipped on last."""
    unit, found = document.unit, find_schedule(document, workshop)
    heads = [
        *("crease", "panel_1", "panel_2", "direction", "kind", f"length_{unit}"),
        *("fold_angle_at_target_deg", "fold_angle_in_pack_deg", f"hinge_length_{unit}"),
        *("screws", "bar", f"force_N_per_{unit}", "force", "case"),
    ]
    sizes, what, cases = _forces(document, found)
    return heads, zip(
        found.edges.tolist(),
        *found.panels.T.tolist(),
        found.directions.tolist(),
        found.kinds.tolist(),
        found.lengths.tolist(),
        _known(found.at_target),
        _known(found.in_pack),
        _known(found.hinge_lengths),
        ("" if count < 0 else count for count in found.screws.tolist()),
        _bars(found, workshop),
        _known(sizes),
        what,
        cases,
        strict=True,
    )


def _known(values: Array) -> Iterable[object]:
    """Numbers, those that are not known left empty."""
    return ("" if value != value else value for value in values.tolist())  # noqa: PLR0124 # NaN


def _bars(found: Schedule, workshop: Workshop) -> Iterable[object]:
    """The bars (C,) that every hinge is cut from, from 1 for each kind; empty where not known."""
    names = [""] * len(found.edges)
    for kind in BY_LENGTH:
        mine = np.flatnonzero(found.kinds == kind)
        bars = cut_hinges(found.hinge_lengths[mine], kind, workshop)
        if bars is not None:
            for crease, name in zip(mine.tolist(), bars.names(), strict=True):
                names[crease] = name
    return names


def _forces(document: Document, found: Schedule) -> tuple[Array, list[str], list[str]]:
    """The largest force along every crease (C,), which it is, and its load case."""
    sizes, none = np.full(len(found.edges), np.nan), [""] * len(found.edges)
    loaded = None if document.loaded is None else document.loaded.creases
    if loaded is None:
        return sizes, none, none
    place = _matching(loaded.panels, found.panels)
    there = place >= 0
    sizes[there] = loaded.sizes[place[there]]
    what, cases = (
        ["" if k < 0 else each[k] for k in place.tolist()] for each in (loaded.what, loaded.cases)
    )
    return sizes, what, cases


def _matching(known: Integers, panels: Integers) -> Integers:
    """Which of known pairs (K, 2) each of pairs (C, 2) is, either way round; -1 for none."""
    many = 1 + max(int(known.max(initial=0)), int(panels.max(initial=0)))
    keys, asked = (pair.min(axis=1) * many + pair.max(axis=1) for pair in (known, panels))
    order = np.argsort(keys)
    place = np.minimum(np.searchsorted(keys[order], asked), len(keys) - 1)
    return np.where(keys[order][place] == asked, order[place], -1)


def ties_table(document: Document, workshop: Workshop) -> Table:
    """Ties: their ends by row and column, how long they are at the target, and as they are cut."""
    unit, cut = document.unit, tie_lengths(document, workshop)
    coils: CutBars | None = cut_ties(cut, workshop)
    numbers: list[object] = [""] * len(cut) if coils is None else (1 + coils.of).tolist()
    heads = [
        *("tie", "row_1", "column_1", "row_2", "column_2", f"length_{unit}"),
        *(f"cut_length_{unit}", "coil"),
    ]
    return heads, (
        [number, *tie.ends[0], *tie.ends[1], tie.length, length, coil]
        for number, (tie, length, coil) in enumerate(
            zip(document.ties, cut.tolist(), numbers, strict=True), 1
        )
    )


def hung_table(document: Document) -> Table | None:
    """Lines along which parts hang on others: where they meet columns; None without any.

    Lengths are along edges of columns: of box girders from the row that they are over, of walls
    from the first row of the panel.
    """
    lying = laid_flat(document)
    found = lying.hung
    if found is None:
        return None
    unit = document.unit
    heads = ["part", "panel", "side", f"at_column_{unit}", f"at_next_column_{unit}"]
    return heads, zip(
        found.names,
        map(lying.panel_name, found.panels.tolist()),
        (SIDES[side] for side in found.sides.tolist()),
        *found.away.T.tolist(),
        strict=True,
    )


def order_table(document: Document, workshop: Workshop) -> Table:
    """What to order."""
    heads = [
        *("item", "what", "count", "least", "size_1", "size_2", "unit", "used", "waste"),
        *("mass_kg", "price"),
    ]
    return heads, (
        [
            *(row.item, row.what, _cell(row.count), _cell(row.least)),
            *(*row.size, "", "")[:2],
            *(row.unit, row.used, _cell(row.waste), _cell(row.mass_kg), _cell(row.price)),
        ]
        for row in find_order(document, workshop)
    )


def _cell(value: float | None) -> object:
    return "" if value is None else value
