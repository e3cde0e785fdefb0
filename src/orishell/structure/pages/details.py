"""What was found of one load case: names and values of a table, in all that tells of it."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import Quantities, figure, quantity
from orishell.structure.ballast import BallastedFoot
from orishell.structure.case import CaseResult
from orishell.structure.combinations import STRENGTH
from orishell.structure.crease_forces import AtCrease
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.largest import CreaseMoment, PairForce
from orishell.structure.utilisation import NOT_EVERYWHERE, named

NEGLIGIBLE_COMPONENT = 1e-6
"""Components of a displacement below this share of it are none."""


def details(case: CaseResult, found: Equilibrium, said: Quantities) -> Iterator[tuple[str, str]]:
    """Names and values of what was found."""
    moved, stress = found.displacement, found.stress
    least = NEGLIGIBLE_COMPONENT * moved.size
    x, y, z = (said.displacement(each if abs(each) > least else 0.0) for each in moved.vector)
    yield (
        "Largest displacement",
        f"{said.displacement(moved.size)} in panel {vertex(moved.panel)} (along x, y, z: "
        f"{x}, {y}, {z}), {percent(moved.share)} of the shell's height",
    )
    if found.crept > moved.size:
        yield "Largest displacement once it has crept", said.displacement(found.crept)
    yield (
        "Largest stress",
        f"{said.stress(stress.size)} by von Mises, in panel {vertex(stress.panel)} on its "
        f"{stress.face} face; principal stresses from {said.stress(stress.least)} to "
        f"{said.stress(stress.largest)}",
    )
    alone, film = found.lone_board, found.membrane
    if alone is not None:
        yield (
            "Where one board is left",
            f"{said.stress(alone.size)} by von Mises, {_between(alone)}",
        )
    if film is not None:
        yield "Largest pull in the membrane", f"{said.stress(film.size)} {_between(film)}"
    if found.arms is not None:
        yield "Largest stress of an arm", f"{said.stress(found.arms.size)} {_between(found.arms)}"
    yield from _stiffeners(found, said)
    if found.beside is not None:
        yield (
            "Largest stress at a crease",
            f"{said.stress(found.beside.size)} by von Mises, {_between(found.beside)}, by the "
            "forces along a quarter of it",
        )
    yield (
        "Largest force along a crease line",
        f"{said.per_length(found.lines.size)} in any direction, {_between(found.lines)}",
    )
    if found.ties:
        yield "Ties", _pressing(found.ties, "pull")
    if found.rail is not None:
        one, other = map(vertex, found.rail.between)
        size = said.stress(found.rail.size)
        yield "Base rail", f"{size} at most, between feet {one} and {other}"
    if found.flaps:
        yield "Flaps", _pressing(found.flaps, "press on each other")
    if found.crease is not None and case.creases != "free":
        yield (
            "Largest moment of a crease",
            f"{said.moment(found.crease.moment)} {_between(found.crease)}",
        )
    if case.ballast is not None:
        yield "Ballast", _ballasted(case.ballast)
    yield "Buckling", _buckles(case, found, said)
    if hertz := ", ".join(map(figure, found.frequencies)):
        yield "Natural frequencies", f"{hertz} Hz"
    yield "Share used", _shares(found)


def _ballasted(worst: BallastedFoot) -> str:
    """The foot that uses most of what its ballast holds."""
    ways = {"lifts off": "pulled up", "slips": "pushed aside"}
    if not worst.force:
        return "no foot is pulled up or pushed aside"
    return (
        f"foot {vertex(worst.at)} is {ways[worst.kind]} by {quantity(worst.force, 'N')}, and held "
        f"by {quantity(worst.holds, 'N')} of {quantity(worst.mass, 'kg')} there"
    )


def _buckles(case: CaseResult, found: Equilibrium, said: Quantities) -> str:
    """Under how many times its loads the shell buckles, large displacements followed or not."""
    if found.path is not None:
        path = found.path
        linear = f"it is displaced by {said.displacement(path.linear_displacement)}"
        if path.linear_buckling is not None:
            linear += f" and buckles under {figure(path.linear_buckling)} times these loads"
        off = path.imperfection
        built = f", {said.displacement(off)} off its shape as built" if off else ""
        return f"nonlinear{built}: it {path.in_words()}. By linear theory {linear}"
    if found.buckling_factors:
        lowest, *others = map(figure, found.buckling_factors)
        further = f"; in other ways under {' and '.join(others)} times" if others else ""
        return f"under {lowest} times these loads{further}, by linear theory"
    return "by linear theory it does not" if case.limit_state in STRENGTH else "found for ULS only"


def _stiffeners(found: Equilibrium, said: Quantities) -> Iterator[tuple[str, str]]:
    """The largest stress in what stiffens the sheet."""
    carried = "the second skin" if found.model.has_skin else "a box girder"
    if found.gussets is not None:
        where = f"by von Mises, in gusset {vertex(found.gussets.at)}, averaged over part of it"
        yield "Largest stress of a gusset", f"{said.stress(found.gussets.size)} {where}"
    if found.boxes is not None:
        where = f"by von Mises, in {found.boxes.part}, averaged over part of it"
        yield f"Largest stress of {carried}", f"{said.stress(found.boxes.size)} {where}"
    if found.box_lines is not None:
        most = found.box_lines.largest
        yield (
            f"Largest force along a hinge of {carried}",
            f"{said.per_length(most.size)} in any direction, {most.in_words()}",
        )
    if found.plate_edges is not None:
        most = found.plate_edges.largest
        yield (
            "Largest force along an edge of a gusset or plate",
            f"{said.per_length(most.size)} in any direction, {most.in_words()}",
        )


def _shares(found: Equilibrium) -> str:
    """Shares of what is borne, and of what that is not known."""
    there = {
        "membrane": found.membrane,
        "arms": found.arms,
        "gussets": found.gussets,
        "boxes": found.boxes,
        "box_lines": found.box_lines,
        "plate_edges": found.plate_edges,
        **dict.fromkeys(NOT_EVERYWHERE),
    }
    words, unknown = [], []
    for part, share in found.utilisation.shares.items():
        name = named(part, skin=found.model.has_skin)
        if share is not None:
            words.append(f"{name} {percent(share)}")
        elif there.get(part, found) is not None:
            unknown.append(name)
    if unknown:
        words.append(f"of {' and '.join(unknown)} no strength is given")
    return "; ".join(words)


def _pressing(pairs: tuple[PairForce, ...], act: str) -> str:
    """How many pairs of vertices have a force, and the largest."""
    most, active = pairs[0], sum(each.force > 0 for each in pairs)
    if not active:
        return f"none of {len(pairs)} {act}"
    one, other = map(vertex, most.ends)
    return (
        f"{active} of {len(pairs)} {act}, {quantity(most.force, 'N')} at most from {one} to {other}"
    )


def _between(found: AtCrease | CreaseMoment) -> str:
    one, other = map(vertex, found.panels)
    return f"between panels {one} and {other}"


def sentence(text: str) -> str:
    """A finding as a sentence."""
    return f"{text[0].upper()}{text[1:]}."


def vertex(at: tuple[int, int]) -> str:
    """A vertex, or a panel."""
    return f"{at[0]},{at[1]}"


def percent(part: float) -> str:
    """A share in percent."""
    return quantity(100 * part, "%", 3)
