"""Anchors in files: ``anchors.csv``, and the table of the page."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import figure
from orishell.io.sections import Paragraph, Section, Table
from orishell.structure.anchors import ASSUMED, Anchor, Worst, anchors_in_words
from orishell.structure.pages.details import sentence
from orishell.structure.results import Analysis

KINDS = ("push", "pull", "sideways", "ballast")
HEAD = (
    "row", "column",
    "push_N", "push_case", "pull_N", "pull_case", "sideways_N", "sideways_case",
    "ballast_N", "ballast_case", "ballast_kg", "friction", "friction_assumed",
    "given_ballast_kg",
)  # fmt: skip
RULE = (
    "Push is down on the ground, pull up from it, sideways along it: the largest of all cases in "
    "equilibrium, each by itself. A peg holds pull and sideways force. Ballast instead is the "
    "weight W at the foot with which W + R is never negative and sideways force is no more than "
    "friction times W + R, R being the force of the ground upwards. Ground with friction has its "
    f"own; elsewhere {ASSUMED:g} is assumed. In EQU ballast counts with the factor of what is "
    "favourable, 0.9 unless factors say otherwise."
)


def anchor_rows(report: Analysis) -> Iterator[tuple[object, ...]]:
    """The lines of ``anchors.csv`` below its ``HEAD``: one for every support, forces in newtons."""
    for each in report.anchors:
        forces = [cell for kind in KINDS for cell in _cells(getattr(each, kind))]
        friction = (f"{each.friction:g}", "yes" if each.assumed else "no")
        yield (*each.at, *forces, f"{each.ballast_mass:.6g}", *friction, f"{each.given:.6g}")


def _cells(worst: Worst) -> tuple[str, str]:
    return f"{worst.force:.6g}", worst.case or ""


def anchor_section(report: Analysis) -> Section:
    """What supports ask of the ground."""
    head = ("vertex", "push (N)", "pull (N)", "sideways (N)", "ballast (N)", "ballast (kg)")
    rows = [_row(each) for each in report.anchors]
    rule = Paragraph(f"{RULE} The load case of every figure is in anchors.csv.", "soft")
    return Section(
        "Supports and anchors",
        (
            Paragraph(sentence(anchors_in_words(report.anchors))),
            Table(head, rows, numbers=5, lists=True),
            *([rule] if rows else []),
        ),
    )


def _row(anchor: Anchor) -> tuple[str, ...]:
    forces = (figure(getattr(anchor, kind).force) for kind in KINDS)
    return (f"{anchor.at[0]},{anchor.at[1]}", *forces, figure(anchor.ballast_mass))
