"""Forces along creases in tables: the largest on the page, of every crease in ``creases.csv``."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from orishell.conventions.quantities import Quantities
from orishell.io.sections import Paragraph, Table
from orishell.numerics.equals import SOLVED, largest_along_first
from orishell.structure.crease_forces import FORCES, AtCrease, worst_forces
from orishell.structure.crease_lines import used_lines
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.mesh.edge_forces import STRETCHES, crease_sides
from orishell.structure.negligible import NEGLIGIBLE_FORCE
from orishell.structure.results import Analysis

SHARES = {2: "halves", 3: "thirds", 4: "quarters"}
COLUMNS = (*FORCES, "moment")
DIGITS = 6


def crease_table(found: Equilibrium, said: Quantities) -> Table:
    """The largest forces along row and column creases, and where."""

    def shown(each: AtCrease, least: float, *, moment: bool = False) -> str:
        if each.size <= least:
            return "none"
        (row, column), (other, beside) = each.panels
        size = said.moment(each.size) if moment else said.per_length(each.size)
        return f"{size} ({row},{column} | {other},{beside})"

    largest = max(
        (each.size for kind in found.creases for each in (kind.pull, kind.push)), default=0.0
    )
    least = NEGLIGIBLE_FORCE * largest
    rows = [
        (
            f"{kind.kind} creases",
            *(shown(each, least) for each in (kind.pull, kind.push, kind.in_plane, kind.across)),
            shown(kind.moment, 0.0, moment=True),
        )
        for kind in found.creases
    ]
    return Table(
        ("", *COLUMNS),
        rows,
        caption="Forces along creases, per metre: the largest, and the panels beside it",
        lists=True,
    )


CREASE_NOTES = Paragraph(
    f"Forces along creases are means over {SHARES[STRETCHES]} of a crease, in the plane of the "
    "panel on that side of it where they are larger: pull and push square to the crease, shear "
    "along it, shear across the panel. Forces of supports and ties at corners of panels are "
    "not among them. All creases are in creases.csv.",
    "soft",
)
"""What the forces along creases are."""


def crease_head(unit: str) -> tuple[str, ...]:
    """Names of the columns of ``creases.csv``."""
    units = (*4 * (f"N/{unit}",), "N")
    forces = (
        part for name, of in zip(COLUMNS, units, strict=True) for part in (f"{name} ({of})", "case")
    )
    return (
        "row", "column", "other row", "other column", "kind", f"length ({unit})", *forces,
        "used of its line", "case",
    )  # fmt: skip


def crease_rows(report: Analysis) -> Iterator[tuple[object, ...]]:
    """The lines of ``creases.csv``: the largest forces along every crease, of all cases."""
    model = report.model
    edges, sides = crease_sides(model.grid)
    ends = model.mesh.facets.points[model.grid.edges_vertices()[edges]]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    names = [report.name_of(case) for _, case in report.balanced]
    sizes, worst = worst_forces(model, [found.edges for found, _ in report.balanced])
    shares = np.zeros((len(names) or 1, len(edges)))
    for number, (balanced, _) in enumerate(report.balanced):
        shares[number] = used_lines(model, balanced.edges)
    used, by = shares.max(axis=0), largest_along_first(shares, SOLVED)
    for k, edge in enumerate(edges.tolist()):
        (row, column), (other, beside) = (model.panel_at(int(each)) for each in sides[k, :, 0])
        kind = "row" if edge < model.grid.rows * (model.grid.columns - 1) else "column"
        found = (
            part
            for size, case in zip(sizes[k].tolist(), worst[k].tolist(), strict=True)
            for part in (f"{size:.{DIGITS}g}", names[case] if size else "")
        )
        share = (f"{used[k]:.{DIGITS}g}", names[by[k]]) if used[k] else ("", "")
        yield (row, column, other, beside, kind, f"{lengths[k]:.{DIGITS}g}", *found, *share)
