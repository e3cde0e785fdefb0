"""What is said of a shell as a structure, in sections: for an engineer who checks it by hand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from orishell.conventions.quantities import Quantities, figure, quantity
from orishell.io.sections import Bullets, Paragraph, Part, Picture, Section, Table
from orishell.numerics.equals import SOLVED, largest_of
from orishell.structure.case import CaseResult
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.largest import PairForce
from orishell.structure.loads import KINDS, Vector
from orishell.structure.negligible import NEGLIGIBLE_FORCE
from orishell.structure.pages.anchor_tables import anchor_section
from orishell.structure.pages.crease_tables import CREASE_NOTES, crease_table
from orishell.structure.pages.details import details, percent, sentence, vertex
from orishell.structure.pages.model_section import model_section
from orishell.structure.results import Analysis
from orishell.structure.stiffness import creases_in_words

AXES = ("x (N)", "y (N)", "z (N)")
STRESS_RULE = (
    "Stress is that of membrane forces and moments averaged over a sixteenth of a panel, a quarter "
    "of its sides long and wide, at its corners over a quarter of it: corners of panels are "
    "singular points, where stress grows with every finer mesh. What tears there is not covered."
)
NOTHING = "\u2013"
PATHS = "Loads against displacements, large ones followed; dashed: linear theory."


def answer(report: Analysis, unit: str) -> Section:
    """How far it is displaced, what governs, and what every case says, the worst first."""
    said = Quantities(unit)
    parts: list[Part] = []
    if report.balanced:
        found, case = largest_of(report.balanced, lambda each: each[0].displacement.size, SOLVED)
        most = said.displacement(found.displacement.size)
        text = f"The largest displacement is {most}, under {report.name_of(case)}."
        parts.append(Paragraph(text, "lead"))
    parts.append(Paragraph(sentence(report.governing_in_words()), "lead"))
    cases = report.reported_cases
    rows = [(report.name_of(case), CARRIES[case.carries], case.in_words()) for case in cases]
    signs = [case.sign for case in cases]
    return Section("", (*parts, Table(("load case", "carries", "the shell"), rows, signs=signs)))


def structure_sections(report: Analysis, unit: str, paths: bytes | None = None) -> list[Section]:
    """The model, loads, results and what is not covered.

    paths: The picture of loads against displacements, if large displacements were followed.
    """
    said = Quantities(unit)
    return [
        model_section(report.model, said),
        Section("Loads and reactions", tuple(_loads(report, said))),
        anchor_section(report),
        Section("Results", tuple(_results(report, said, paths))),
        *(_case(case, report, said) for case in report.reported_cases),
        Section("What codes ask, and is not done here", (Bullets(report.code_asks),)),
        Section("What is not covered", (Bullets(report.not_covered),)),
    ]


CARRIES = {True: "yes", False: "no", None: "not known"}


def _loads(report: Analysis, said: Quantities) -> Iterator[Part]:
    """What loads each case, and what bears it; loads are the same for all stiffnesses."""
    names = dict.fromkeys(case.name for case in report.reported_cases)
    for name in names:
        same = [case for case in report.cases if case.name == name]
        rows = [
            (
                ("" if load.case == name else f"{load.case}: ") + KINDS[load.kind],
                NOTHING if load.pressure is None else said.pressure(load.pressure),
                load.rule,
                figure(load.factor),
                *_vector(load.force, same[0].load),
            )
            for load in same[0].loads
        ]
        totals = [("all loads", "", "", "", *_vector(same[0].load, same[0].load))]
        for case in same:
            words = report.name_of(case).removeprefix(f"{name}, ")
            which = "" if words == name else f", {words}"
            if case.equilibrium is None:
                totals.append(
                    (f"reactions{which}", "", "none: nothing holds it", "", *3 * [NOTHING])
                )
                continue
            missing = f"missing: {figure(case.equilibrium.residual, 2)} of the loads"
            reaction = _vector(case.equilibrium.reaction, case.load)
            totals.append((f"reactions{which}", "", missing, "", *reaction))
        yield Table(
            ("", "from", "how", "factor", *AXES),
            [*rows, *totals],
            caption=name,
            numbers=4,
            totals=len(totals),
        )
    yield Paragraph(
        "Factors are those of combinations, and are in the forces. What is missing between loads "
        "and reactions is the larger of force and moment, relative to the loads.",
        "soft",
    )


def _results(report: Analysis, said: Quantities, paths: bytes | None) -> Iterator[Part]:
    """All cases beside each other; those of one name, with little and much stiffness, in turn."""
    order = {name: k for k, name in enumerate(dict.fromkeys(each.name for each in report.cases))}
    cases = sorted(report.cases, key=lambda each: order[each.name])
    rows = [(report.name_of(case), *_figures(case, said)) for case in cases]
    head = ("", "displacement", "of the height", "stress", "crease moment", "tie")
    yield Table((*head, "buckling factor", "first frequency", "used"), rows, numbers=8, lists=True)
    yield Paragraph(
        "Used is the largest share of what panels, membrane, creases, crease lines, ties, what "
        "stiffens the sheet and its edges can bear, as far as their strength is given, and of the "
        "load at which the shell buckles.",
        "soft",
    )
    if paths is not None:
        yield Picture(paths, PATHS)
    yield Paragraph(STRESS_RULE, "soft")
    yield CREASE_NOTES
    envelopes = [
        (
            each.limit_state,
            f"{each.cases}",
            f"{each.moves}",
            f"{each.case}, {creases_in_words(each.creases)}",
            NOTHING if each.share is None else f"{each.part}: {percent(each.share)}",
        )
        for each in report.envelopes
    ]
    yield Table(("limit state", "cases", "move", "governs", "by"), envelopes)
    if envelopes:
        yield Paragraph(
            "ULS is judged by strength and buckling, EQU by equilibrium, SLS by displacements: "
            "shares of what can be borne, of friction and what ballast holds, and of the "
            "shell\u2019s height.",
            "soft",
        )


def _figures(case: CaseResult, said: Quantities) -> Sequence[str]:
    found = case.equilibrium
    if found is None:
        return ("unstable", *7 * [NOTHING])
    used = found.utilisation
    known = [share for share in used.shares.values() if share is not None]
    return (
        said.displacement(found.displacement.size),
        percent(found.displacement.share),
        said.stress(found.stress.size),
        NOTHING
        if found.crease is None or case.creases == "free"
        else said.moment(found.crease.moment),
        quantity(found.ties[0].force, "N") if found.ties and found.ties[0].force else NOTHING,
        _factor(found),
        quantity(found.frequencies[0], "Hz") if found.frequencies else NOTHING,
        percent(max(known)) if known else NOTHING,
    )


def _factor(found: Equilibrium) -> str:
    """Under how many times its loads it buckles, if it does."""
    if found.path is not None and found.path.carries:
        return "followed"
    return NOTHING if found.buckling is None else figure(found.buckling)


def _case(case: CaseResult, report: Analysis, said: Quantities) -> Section:
    """What was found of a case in full, on what the shell does under its loads."""
    name, found = report.name_of(case), case.equilibrium
    if found is None:
        text = f"The shell {case.in_words()}. Nothing else was found of it."
        return Section(name, (Paragraph(text, case.sign),), level=3)
    reactions = [(vertex(each.at), *_vector(each.force, case.load)) for each in found.reactions]
    half = -(-len(reactions) // 2)
    reactions += [4 * ("",)] * (2 * half - len(reactions))
    beside = zip(reactions[:half], reactions[half:], strict=True)
    return Section(
        name,
        (
            Table((), list(details(case, found, said))),
            crease_table(found, said),
            Table(
                2 * ("vertex", *AXES),
                [one + other for one, other in beside],
                caption="Reactions of supports; their sum is above, under the loads",
                numbers=7,
                lists=True,
            ),
            _pairs("Ties: the force with which they pull", found.ties, "slack"),
            _pairs("Flaps: the force with which they press on each other", found.flaps, "apart"),
        ),
        level=3,
    )


def _pairs(caption: str, pairs: Sequence[PairForce], idle: str) -> Table:
    """Forces between two vertices; those without any are counted, and called by a word."""
    rows = [
        (f"{vertex(each.ends[0])} to {vertex(each.ends[1])}", figure(each.force))
        for each in pairs
        if each.force
    ]
    rest = len(pairs) - len(rows)
    if rest:
        rows.append((f"{rest} more" if rows else f"all {rest}", idle))
    return Table(("vertices", "force (N)"), rows, caption=caption, numbers=1, lists=True)


def _vector(force: Vector, load: Vector) -> Iterator[str]:
    """Components of a force; 0 where they are rounding errors of a load."""
    least = NEGLIGIBLE_FORCE * max(map(abs, load))
    return (figure(each if abs(each) > least else 0.0) for each in force)
