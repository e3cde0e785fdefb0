"""What the codes ask of a structure like this, and is not done here: said once, by what was asked.

Whoever puts his name to a shell has this left to do.
"""

from __future__ import annotations

from collections.abc import Callable

from orishell.structure.load_settings import LOADS
from orishell.structure.materials import materials
from orishell.structure.settings import Structure

Left = Callable[[Structure], bool]
"""Whether something is left to do of a structure, by what was asked."""


def _without(load: str) -> Left:
    """Without a load of a kind in any case."""
    assert load in LOADS
    return lambda asked: not any(getattr(case, load) for case in asked.cases)


def _always(_: Structure) -> bool:
    return True


def _creeps_unknown(asked: Structure) -> bool:
    return asked.material is None or not materials()[asked.material].k_def


ASKS: tuple[tuple[Left, str, str], ...] = (
    (_without("self_weight"), "own weight", ": no load case has it (self_weight)"),
    (_without("snow"), "snow", ": no load case has any (EN 1991-1-3)"),
    (_without("wind"), "wind", ": no load case has any (EN 1991-1-4)"),
    (
        _without("person"),
        "somebody who works on the shell",
        ": no load case has a person (EN 1991-1-1, 6.3.4)",
    ),
    (
        lambda asked: asked.combinations == "none",
        "partial factors of loads",
        ", equilibrium with factors of its own (EQU), and all combinations (EN 1990, 6.4, 6.5): "
        'combinations = "EN 1990" makes them',
    ),
    (
        lambda asked: any(each.kind != "friction" and not each.ballast for each in asked.supports),
        "whether supports hold",
        " (EN 1990, 6.4.2): what they have to is found, and no ballast is given for all of them",
    ),
    (
        lambda asked: any(each.ballast and not each.friction for each in asked.supports),
        "whether feet under ballast slip",
        ": no friction is given for all of them",
    ),
    (
        lambda asked: asked.strength is not None,
        "partial factors of panels",
        ", and how long loads last: the strength that is given is taken as the design value",
    ),
    (
        _creeps_unknown,
        "creep",
        ": nothing is known of that of this material (EN 1995-1-1, 2.2.3)",
    ),
    (
        lambda asked: asked.displacement_limit is None,
        "limits of displacements",
        " (EN 1990, A1.4): no displacement_limit is given",
    ),
    (
        lambda asked: not asked.nonlinear or asked.imperfection == 0,
        "imperfections of shape",
        " (EN 1993-1-1, 5.3; EN 1995-1-1, 5.4.4): a shell whose large displacements are followed "
        "may have one (imperfection in [structure])",
    ),
    (_always, "fire", " (EN 1991-1-2)"),
    (_always, "earthquakes", " (EN 1998)"),
    (
        _always,
        "accidents",
        ", exceptional snow, and robustness: what fails with a panel, a tie or a foot "
        "(EN 1991-1-7)",
    ),
    (_always, "fatigue", ", of what folds often and of what gusts shake"),
    (
        _always,
        "joints in detail",
        ": screws, rivets, glue, seams, and what ties are fixed to (EN 1993-1-8; EN 1995-1-1, 8)",
    ),
    (_always, "heat and moisture", " (EN 1991-1-5), and how long what it is made of lasts"),
    (
        _always,
        "loads while it is raised",
        ", on the way from the pack to the target (EN 1991-1-6)",
    ),
    (
        _always,
        "gusts that shake the shell",
        ", suction at its edges, and drifts at obstacles and taller buildings (EN 1991-1-4, 6 and "
        "7.2; EN 1991-1-3, 6)",
    ),
    (
        _always,
        "anchors in the ground",
        ": how they hold, and how the ground under feet settles (EN 1997)",
    ),
)
"""When something is left to do; what it is, and what of it, with where codes ask for it."""


def code_asks(asked: Structure) -> tuple[str, ...]:
    """What codes ask and is not done, of a structure under its load cases."""
    return tuple(f"{name}{detail}" for left, name, detail in ASKS if left(asked))


def asks_in_words(asked: Structure) -> str:
    """All that is left to do by its names: for one line."""
    *names, last = (name for left, name, _ in ASKS if left(asked))
    return f"ask for more, which is not done here: {', '.join(names)} and {last}"
