"""``orishell structure``: whether a designed shell stands, and the summary that it prints."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from orishell.cli.files import (
    CHECK_HELP,
    FORCE_HELP,
    bar,
    directory,
    lines_of,
    require_carried,
    say,
    shortened,
    warn_of_unused,
)
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import Quantities, plain

if TYPE_CHECKING:
    from orishell.structure.case import CaseResult
    from orishell.structure.crease_forces import AtCrease
    from orishell.structure.equilibrium import CreaseMoment, Equilibrium
    from orishell.structure.load_path import LoadPath
    from orishell.structure.loads import Vector
    from orishell.structure.model import Model
    from orishell.structure.results import Analysis

ROUNDING = 1e-6
"""Components of a vector below this share of the largest are none."""


def summarize_structure(
    report: Analysis, unit: str, written: list[Path], remedy: str = ""
) -> Iterator[str]:
    """Lines that say whether it carries its loads, what was analysed, and what was written."""
    from orishell.conventions.row import MARKS, Row
    from orishell.structure.anchors import anchors_in_words

    yield from lines_of(Row(report.sign, "stands", report.in_words(), remedy))
    for case in report.reported_cases:
        yield f"{MARKS[case.sign]} {report.name_of(case)}: it {case.in_words()}"
    yield from _model(report.model, unit)
    for each in {case.name: case for case in report.reported_cases}.values():
        yield from _loads(each)
    for case in report.reported_cases:
        if case.equilibrium is not None:
            yield f"case      {report.name_of(case)}"
            yield from _case(case, case.equilibrium, unit)
    yield f"anchors   {anchors_in_words(report.anchors)}"
    yield f"most used {report.governing_in_words()}"
    yield from _envelopes(report)
    yield from (f"not covered: {text}" for text in report.not_covered)
    yield from (f"wrote     {text}" for text in shortened(written))


def _model(model: Model, unit: str) -> Iterator[str]:
    yield (
        f"model     {model.triangles} triangles, {model.freedoms} degrees of freedom; "
        f"{plain(model.mass)} kg; panels {plain(model.thickness)} {unit} thick, "
        f"E = {Quantities(unit).stress(model.structure.modulus)}"
    )
    low, high = model.crease_stiffness
    stiffness = f"{low}" if low == high else f"{low} to {high}"
    stretch = "that do not stretch" if model.tie_stiffness is None else plain(model.tie_stiffness)
    yield f"stiffness of creases {stiffness} (N), of ties {stretch} (N)"
    for each in model.structure.supports:
        at = each.at if isinstance(each.at, str) else ", ".join(str(list(v)) for v in each.at)
        friction = f" {each.friction:g}" if each.friction else ""
        broad = " along edges" if each.edges else f" over {each.patch:g} {unit}" * bool(each.patch)
        yield f"held      {at}: {each.kind}{friction}{broad}"


def _loads(case: CaseResult) -> Iterator[str]:
    """The loads of a case, which are the same for every stiffness of creases."""
    yield f"load      {case.name}: {_vector(case.load)} in all"
    for load in case.loads:
        of = "" if load.case == case.name else f"{load.factor:g} x {load.case}: "
        yield f"  {of}{load.kind.replace('_', ' ')} {_vector(load.force)}, {load.rule}"


def _case(case: CaseResult, found: Equilibrium, unit: str) -> Iterator[str]:
    from orishell.structure.combinations import STRENGTH

    most = found.displacement
    yield (
        f"  displaced by {plain(most.size)} {unit}, {plain(100 * most.share, 3)} % of its height, "
        f"at panel {list(most.panel)} along {_components(most.vector, 3)}"
    )
    yield from _forces(found, unit)
    if found.path is not None:
        yield f"  buckles   {_followed(found.path, unit)}"
    elif case.limit_state in STRENGTH:
        factors = ", ".join(map(plain, found.buckling_factors))
        yield f"  buckles   {f'under {factors} times the loads' if factors else 'not'}"
    if found.frequencies:
        yield f"  frequency {', '.join(map(plain, found.frequencies))} Hz"
    reaction = _vector(found.reaction)
    yield f"  balance   reactions {reaction}, missing {found.residual:.1g} of the loads"


def _followed(path: LoadPath, unit: str) -> str:
    linear = f"displaced by {plain(path.linear_displacement)} {unit}"
    if path.linear_buckling is not None:
        linear += f", buckles under {plain(path.linear_buckling)} times the loads"
    return f"nonlinear: it {path.in_words()}; by linear theory {linear}"


def _forces(found: Equilibrium, unit: str) -> Iterator[str]:
    used = found.utilisation
    if found.ties:
        tie, pulling = found.ties[0], sum(each.force > 0 for each in found.ties)
        first, second = (list(end) for end in tie.ends)
        yield (
            f"  ties      {pulling} of {len(found.ties)} pull, {plain(tie.force)} N at most, from "
            f"{first} to {second}{_used(used.ties)}"
        )
    pressing = [each for each in found.flaps if each.force > 0]
    if pressing:
        pairs = f"{len(pressing)} of {len(found.flaps)} pairs"
        yield f"  flaps     {pairs} press, {plain(pressing[0].force)} N at most"
    if found.crease is not None:
        yield (
            f"  creases   {plain(found.crease.moment)} N {unit}/{unit} at most, "
            f"{_between(found.crease)}{_used(used.creases)}"
        )
    yield (
        f"  lines     {Quantities(unit).per_length(found.lines.size)} at most, "
        f"{_between(found.lines)}{_used(used.lines)}"
    )
    if found.membrane is not None:
        yield (
            f"  membrane  {plain(found.membrane.size)} N/{unit}2 at most, "
            f"{_between(found.membrane)}{_used(used.membrane)}"
        )
    if found.arms is not None:
        yield (
            f"  arms      {Quantities(unit).stress(found.arms.size)} at most, "
            f"{_between(found.arms)}{_used(used.arms)}"
        )
    if found.lone_board is not None:
        yield (
            f"  one board {plain(found.lone_board.size)} N/{unit}2 at most, where it is alone, "
            f"{_between(found.lone_board)}"
        )
    yield (
        f"  panels    {Quantities(unit).stress(found.stress.size)} at most, on the "
        f"{found.stress.face} face "
        f"of {list(found.stress.panel)}{_used(used.panels)}"
    )
    if found.beside is not None:
        yield (
            f"  at crease {Quantities(unit).stress(found.beside.size)} at most, "
            f"{_between(found.beside)}"
        )


def _between(found: AtCrease | CreaseMoment) -> str:
    first, second = (list(panel) for panel in found.panels)
    return f"between panels {first} and {second}"


def _envelopes(report: Analysis) -> Iterator[str]:
    """What governs each limit state of a code, and how many cases it has."""
    from orishell.structure.stiffness import creases_in_words

    for each in report.envelopes:
        what = "in equilibrium under all of them"
        if each.moves:
            what = f"it moves under {each.moves} of them, such as {each.case}"
        elif each.part is not None and each.share is not None:
            what = f"{each.part} {plain(100 * each.share, 3)} %: {each.case}"
        stiffness = creases_in_words(each.creases)
        yield f"{each.limit_state:10}{each.cases} cases; {what}, {stiffness}"


def _used(share: float | None) -> str:
    return "" if share is None else f": {plain(100 * share, 3)} % of what they bear"


def _vector(force: Vector) -> str:
    unit, size = ("kN", 1e3) if max(map(abs, force)) >= 1e4 else ("N", 1.0)
    x, y, z = (each / size for each in force)
    return f"{_components((x, y, z), 4)} {unit}"


def _components(vector: Vector, digits: int) -> str:
    """Numbers to so many digits; 0 is what rounding leaves beside the largest."""
    least = ROUNDING * max(map(abs, vector))
    kept = (each if abs(each) > least else 0.0 for each in vector)
    return "({})".format(", ".join(plain(each, digits) for each in kept))


def structure(
    file: Annotated[Path, typer.Argument(help="The design file (TOML), with a table [structure].")],
    out: Annotated[
        Path | None,
        typer.Option(
            parser=directory,
            help="Directory for structure.html, structure.png, structure.json, creases.csv and "
            "anchors.csv; made if needed.",
        ),
    ] = None,
    *,
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
    check: Annotated[bool, typer.Option("--check", help=CHECK_HELP)] = False,
    force: Annotated[bool, typer.Option("--force", help=FORCE_HELP)] = False,
) -> None:
    """Analyse a shell as a structure: whether it carries its loads.

    What it finds are displacements, forces, buckling and frequencies under its loads.
    """
    from orishell.conventions.record import as_table
    from orishell.design_file import read_design_file
    from orishell.io import OutputDirectory
    from orishell.shell.export import write_structure
    from orishell.shell.make import make_shell
    from orishell.shell.steps import MEASURES
    from orishell.structure.pages.files import FILES

    asked = read_design_file(file)
    if asked.structure is None:
        raise InputError(
            "there is no structure to analyse",
            file=file,
            keys=("structure",),
            remedy="add the table [structure]; orishell new writes a file that shows its keys",
        )
    if out is not None:
        OutputDirectory(out, inputs=asked.inputs, force=force).require_usable(FILES)
    with bar() as progress:
        shell = make_shell(asked, progress, clash="unexamined", skip=(*MEASURES, "stock"))
    report = shell.report.structure
    assert report is not None
    remedy = next(each.remedy for each in shell.report.verdict if each.subject == "stands")
    for warning in report.warnings:
        say(f"orishell: warning: {warning}", err=True)
    written = [] if out is None else write_structure(shell, out, force=force)
    warn_of_unused(asked.keys.unused(beside=("motion", "search", "workshop")))
    if json_report:
        say(json.dumps(as_table(report), indent=2, allow_nan=False))
    else:
        say("\n".join(summarize_structure(report, shell.report.unit, written, remedy)))
    require_carried(report, check=check)
