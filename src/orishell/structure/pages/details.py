"""What was found of one load case: names and values of a table."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.quantities import Quantities, figure, quantity
from orishell.structure.case import CaseResult
from orishell.structure.combinations import STRENGTH
from orishell.structure.crease_forces import AtCrease
from orishell.structure.equilibrium import CreaseMoment, Equilibrium
from orishell.structure.utilisation import NAMED


def details(case: CaseResult, found: Equilibrium, said: Quantities) -> Iterator[tuple[str, str]]:
    """Names and values of what was found."""
    moved, stress, used = found.displacement, found.stress, found.utilisation
    x, y, z = (said.displacement(each) for each in moved.vector)
    yield (
        "Largest displacement",
        f"{said.displacement(moved.size)} in panel {vertex(moved.panel)} (along x, y, z: "
        f"{x}, {y}, {z}), {percent(moved.share)} of the shell's height",
    )
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
    if found.crease is not None and case.creases != "free":
        yield (
            "Largest moment of a crease",
            f"{said.moment(found.crease.moment)} {_between(found.crease)}",
        )
    buckles = "by linear theory it does not"
    if case.limit_state not in STRENGTH:
        buckles = "found for ULS only"
    if found.buckling_factors:
        lowest, *others = map(figure, found.buckling_factors)
        further = f"; in other ways under {' and '.join(others)} times" if others else ""
        buckles = f"under {lowest} times these loads{further}, by linear theory"
    if found.path is not None:
        path = found.path
        linear = (
            f"By linear theory it is displaced by {said.displacement(path.linear_displacement)}"
        )
        if path.linear_buckling is not None:
            linear += f" and buckles under {figure(path.linear_buckling)} times these loads"
        buckles = f"nonlinear: it {path.in_words()}. {linear}"
    yield "Buckling", buckles
    if hertz := ", ".join(map(figure, found.frequencies)):
        yield "Natural frequencies", f"{hertz} Hz"
    words = [
        f"{NAMED.get(name, name)} {percent(part)}"
        for name, part in used.shares.items()
        if part is not None
    ]
    there = {"membrane": film, "arms": found.arms, "buckling": None}
    bare = {name for name, part in there.items() if part is None}
    unknown = [
        NAMED.get(name, name)
        for name, part in used.shares.items()
        if part is None and name not in bare
    ]
    if unknown:
        words.append(f"of {' and '.join(unknown)} no strength is given")
    yield "Share used", "; ".join(words)


def _between(found: AtCrease | CreaseMoment) -> str:
    one, other = map(vertex, found.panels)
    return f"between panels {one} and {other}"


def vertex(at: tuple[int, int]) -> str:
    """A vertex, or a panel."""
    return f"{at[0]},{at[1]}"


def percent(part: float) -> str:
    """A share in percent."""
    return quantity(100 * part, "%", 3)
