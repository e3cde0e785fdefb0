"""What a builder tries, step by step, to have a shell carry its loads: changes of its design file.

Every step looks at the file as changed so far and at what was found of it, and proposes changes of
its own kind, none where it has nothing to add. Strengths come from tables with their sources or
from the file: where neither has one, no step makes one up.
"""

from __future__ import annotations

from collections.abc import Iterator
from operator import attrgetter, gt
from typing import Literal

from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import Quantities
from orishell.design.stiffeners import Stiffeners
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.carry_boards import other_materials, thicker, thinner
from orishell.shell.carry_change import Change, Step, together
from orishell.shell.carry_feet import anchored, base_rail, clamped, held_edges, more_ballast
from orishell.shell.load_trials import STANDING_CELLS
from orishell.structure.hinge_lines import DIRECTIONS, hinge_lines
from orishell.structure.results import Analysis

DEEPER = 1.5
"""The zigzag and the waves of g become so many times as deep at a time."""
FEW = 4
"""Stiffeners are tried first in every column that is so many apart, then in twice as many."""
COLUMNS = {"all": "every column", 1: "every column", 2: "every 2nd column"}
PLACES = {"valleys": "valleys", "crests": "crests", "all": "valleys and on the crests"}
Rows = Literal["valleys", "crests", "all"] | tuple[int, ...]
FOLDS = {"deployment.ties": "folds"}


def named_lines(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Crease lines of a kind of which all is known, where it is not of the file's own.

    Or of one that bears more, where the file names a kind and gives no figures of its own. Not
    where a membrane is the hinge of panels.
    """
    assert file.structure is not None
    if file.panel is not None and not file.panel.is_solid:
        return
    asked, given = file.structure.line_strength, value_at(file.tables, "structure.line_strength")
    kind = None if asked is None else asked.kind
    named = None if kind is None or given != {"kind": kind} else hinge_lines()[kind]
    lines, of = file.structure.filled(file.unit).line_strength, attrgetter(*DIRECTIONS)
    lacks = lines is None or not lines.is_known
    for name, made in hinge_lines().items():
        bears = of(made)
        if None in bears:
            continue
        if lacks or (named is not None and all(map(gt, bears, of(named)))):
            values = {"structure.line_strength": {"kind": name}}
            yield Change(values, {"lines": f"{name} along every crease"})


def ties_across_folds(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Ties between feet and across the folds of every vertex, if what they bear is known."""
    assert file.structure is not None
    known = file.structure.tie_strength is not None
    if known and file.deployment.ties in ("none", "feet"):
        yield Change(FOLDS, {"ties": 'ties across the folds (ties = "folds")'})


def fewer_ties(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Ties across the folds of fewer rows: every second one, then every third; feet alone."""
    if file.deployment.ties != "folds" or file.tolerance is not None:
        return
    rows = range(1, file.pattern.rows + 1)
    yield Change({"deployment.ties": "feet"}, {"ties": 'ties between feet only (ties = "feet")'})
    for each in (3, 2):
        chosen = list(rows[each // 2 :: each])
        if chosen:
            yield Change(
                {"deployment.ties": {"folds": chosen}},
                {"ties": f"ties across the folds of rows {', '.join(map(str, chosen))}"},
            )


def flaps(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Flaps as wide as they may be, where there are none."""
    if getattr(file.pattern, "flap", None) == 0:
        yield Change({"pattern.flap": "auto"}, {"flaps": 'flaps (flap = "auto")'})


def gussets(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Gussets in few columns, of folds that look down or of all; then in more of them.

    Not in place of box girders that the file has.
    """
    if file.stiffeners is None or file.stiffeners.kind == "gussets":
        yield from _stiffened(file, found, "gussets", "gussets in the {}, {}")


def box_girders(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """Box girders with plates in few columns, in the place of gussets; then with more of them."""
    yield from _stiffened(file, found, "boxes", "box girders over the {}, plates at {}")


def fixed_edges(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """The strongest kind of line of which all is known, along edges of gussets and plates.

    Where the file does not say what holds them.
    """
    assert file.structure is not None
    strength = file.structure.filled(file.unit).edge_strength
    if strength is None or not strength.is_known:
        of = attrgetter(*DIRECTIONS)
        known = {name: of(each) for name, each in hinge_lines().items() if None not in of(each)}
        name = max(known, key=lambda each: min(known[each]))
        values = {"structure.edge_strength": {"kind": name}}
        yield Change(values, {"fixed": f"{name} along edges of gussets and plates"})


def _stiffened(file: DesignFile, found: Analysis, kind: str, words: str) -> Iterator[Change]:
    """Stiffeners of a kind where there are none of it, or more of them, and what holds them."""
    assert file.structure is not None
    if file.panel is not None and file.panel.construction == "hinged":
        return
    finer = {} if file.structure.cells >= STANDING_CELLS else {"structure.cells": STANDING_CELLS}
    there = file.stiffeners
    begun: dict[str, object] = {}
    if there is not None and there.kind != kind:
        given = value_at(file.tables, "stiffeners") or {}
        begun, there = {f"stiffeners.{key}": None for key in given}, None
    if there is None:
        begun |= {"stiffeners.kind": kind}
        begun |= {"stiffeners.share": "auto"} if kind == "boxes" else {}
    for rows, columns in _more_places(there):
        placed = {
            "stiffeners.rows": rows if isinstance(rows, str) else list(rows),
            "stiffeners.columns": columns,
        }
        which = PLACES[rows] if isinstance(rows, str) else f"rows {', '.join(map(str, rows))}"
        often = COLUMNS.get(columns, f"every {columns}th column")
        said = {"stiffeners": words.format(which, often)}
        yield together((Change({**begun, **placed, **finer}, said), *fixed_edges(file, found)))


def _more_places(there: Stiffeners | None) -> Iterator[tuple[Rows, Literal["all"] | int]]:
    """Rows and columns of stiffeners where there are more than there were."""
    if there is None:
        yield "valleys", FEW
        yield "all", FEW
    elif isinstance(there.columns, int) and there.columns > 1:
        yield there.rows, there.columns // 2
    elif there.columns not in ("all", 1):
        yield there.rows, "all"
    elif there.rows != "all":
        yield "all", "all"


def more_rows(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Two rows more: as they are odd, or even."""
    if file.tolerance is None and file.drawing is None:
        rows = file.pattern.rows + 2
        yield Change({"pattern.rows": rows}, {"rows": f"{rows} rows of vertices"})


def deeper_waves(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """The waves of g deeper, so that panels stand steeper to each other: its y is enlarged."""
    if value_at(file.tables, "target.g") is None or file.fit is not None:
        return
    scale = value_at(file.tables, "target.g.scale") or 1.0
    x, y = scale if isinstance(scale, list) else (scale, scale)
    deeper = rounded(DEEPER * y, 3)
    yield Change({"target.g.scale": [x, deeper]}, {"waves": f"deeper waves (g times {deeper:g})"})


def deeper_folds(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """A deeper zigzag about f."""
    depth = getattr(file.pattern, "depth", None)
    if isinstance(depth, float):
        deeper = rounded(DEEPER * depth, 2)
        said = Quantities(file.unit).displacement(deeper)
        yield Change({"pattern.depth": deeper}, {"folds": f"folds {said} deep"})


def locked_creases(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Every crease locked once the shell stands, if it is known what it bears then."""
    assert file.structure is not None
    known = file.structure.crease_strength is not None
    if known and file.structure.crease_stiffness[0] != float("inf"):
        yield Change({"structure.crease_stiffness": "rigid"}, {"locks": "every crease locked"})


BUILDER: tuple[Step, ...] = (
    held_edges, base_rail, more_ballast, more_ballast, anchored, clamped, named_lines,
    ties_across_folds, flaps, thicker, thicker, other_materials, gussets, gussets, gussets,
    box_girders, box_girders, more_rows, deeper_waves, deeper_waves, deeper_folds, locked_creases,
)  # fmt: skip
"""In the order in which somebody would who has the sheet already."""
DESIGNER: tuple[Step, ...] = (
    held_edges, anchored, named_lines, deeper_waves, deeper_waves, deeper_folds, more_rows,
    ties_across_folds, clamped, thicker, thicker, gussets, gussets, box_girders, box_girders,
    locked_creases,
)  # fmt: skip
"""In the order of somebody who may choose its shape first."""
LIGHTER: tuple[Step, ...] = (thinner, fewer_ties, thinner)
"""What is taken away again where a shell carries."""
