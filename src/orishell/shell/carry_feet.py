"""What a builder tries at the feet of a shell: how they are held, a rail, ballast."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import Quantities, conversion
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.carry_change import Change
from orishell.structure.results import Analysis

RAILS = ((0.06, 0.04, 0.003), (0.1, 0.06, 0.004))
"""Width, height and walls (m) of hollow sections of EN 10219-2 that are tried as base rails."""
Support = Mapping[str, Any]


def held_edges(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Feet are held along their edges, and not at points."""
    yield from _other_supports(
        file,
        lambda each: each["kind"] != "friction" and not (each.get("edges") or each.get("patch")),
        lambda each: {**each, "edges": True},
        {"edges": "{} held along their edges"},
    )


def clamped(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Panels cannot turn where they stand, as on a base that they are screwed to."""
    yield from _other_supports(
        file,
        lambda each: each["kind"] == "pinned",
        lambda each: {**each, "kind": "fixed"},
        {"clamped": "{} clamped (panels cannot turn there)"},
    )


def base_rail(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """A rail of steel joins feet that may slide."""
    assert file.structure is not None
    if file.structure.rail is not None or not any(
        _slides(each) and each["at"] == "feet" for each in _supports(file)
    ):
        return
    metres, said = conversion(file.unit, "m"), Quantities(file.unit)
    for sides in RAILS:
        width, height, wall = (rounded(side / metres, 3) for side in sides)
        rail = {"material": "steel", "width": width, "height": height, "wall": wall}
        size = " x ".join(said.displacement(side) for side in (width, height, wall))
        yield Change({"structure.rail": rail}, {"rail": f"a steel base rail, {size}"})


def more_ballast(file: DesignFile, found: Analysis) -> Iterator[Change]:
    """As much ballast at every foot as that needs which uses most of its own."""
    feet = [case.ballast for case in found.cases if case.ballast is not None]
    needed = rounded(1.1 * max((foot.needed or 0.0 for foot in feet), default=0.0), 2)
    yield from _other_supports(
        file,
        lambda each: 0 < each.get("ballast", 0) < needed,
        lambda each: {**each, "ballast": needed},
        {"ballast": f"ballast of {needed:g} kg at every foot"},
    )


def anchored(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Feet that may slide, or stand under ballast, are anchored in the ground: edges, or points."""
    for edges, said in ((True, "along their edges"), (False, "at points")):
        yield from _other_supports(
            file,
            lambda each: _slides(each) or bool(each.get("ballast")),
            partial(_anchored, edges=edges),
            {"edges": f"{{}} anchored {said}", "ballast": ""},
        )


def _anchored(support: Support, *, edges: bool) -> Support:
    kind = "fixed" if support["kind"] == "fixed" else "pinned"
    return {"at": support["at"], "kind": kind, **({"edges": True} if edges else {})}


def _slides(support: Support) -> bool:
    return support["kind"] in ("sliding", "friction")


def _supports(file: DesignFile) -> list[Support]:
    return list(value_at(file.tables, "structure.supports"))


def _other_supports(
    file: DesignFile,
    which: Callable[[Support], bool],
    changed: Callable[[Support], Support],
    said: Mapping[str, str],
) -> Iterator[Change]:
    """Some supports of a file changed.

    said: What is done, by the kind of change, with a place for what they are.
    """
    supports = _supports(file)
    others = [changed(each) if which(each) else each for each in supports]
    if others != supports:
        places = {str(each["at"]) for each in supports if which(each)}
        name = next(iter(places)) if places in ({"feet"}, {"ends"}) else "supports"
        yield Change(
            {"structure.supports": others}, {kind: each.format(name) for kind, each in said.items()}
        )
