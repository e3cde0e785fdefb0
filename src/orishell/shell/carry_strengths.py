"""Strengths that a file does not give: what other choices make known, and what only its user can.

A shell that is loaded where nobody knows what is borne is never known to carry: while that lasts,
every other change is tried in vain. So it is asked before anything else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from orishell.conventions.errors import DesignError
from orishell.conventions.formatting import rounded
from orishell.conventions.quantities import conversion
from orishell.design_file import DesignFile
from orishell.design_file.tables import value_at
from orishell.shell.carry_change import Change, Step
from orishell.shell.carry_steps import fixed_edges, named_lines
from orishell.structure.results import Analysis
from orishell.structure.utilisation import Limiting

GIVE: Mapping[Limiting, tuple[str, str]] = {
    "panels": ("panels", "strength"),
    "core_shear": ("cores of panels in shear", "sandwich.core_shear_strength"),
    "membrane": ("the membrane", "membrane_strength"),
    "creases": ("creases that do not turn freely", "crease_strength"),
    "lines": ("crease lines in every direction", "line_strength"),
    "arms": ("arms of hinges", "arm_strength"),
    "plate_edges": ("edges of gussets and plates in every direction", "edge_strength"),
    "ties": ("ties", "tie_strength"),
}
"""What bears, and the keys of [structure] that say how much."""


def not_given(file: DesignFile) -> list[Limiting]:
    """What of a file's shell is loaded, and what it bears is not given."""
    assert file.structure is not None
    asked, panel = file.structure.filled(file.unit), file.panel
    made, stiffened = asked.sandwich, file.stiffeners
    hinged = panel is not None and panel.construction == "hinged"
    missing: dict[Limiting, bool] = {
        "panels": asked.strength is None and asked.material is None,
        "core_shear": made is not None and made.core_shear_strength is None,
        "membrane": panel is not None and not panel.is_solid and asked.membrane_strength is None,
        "lines": asked.line_strength is None or not asked.line_strength.is_known,
        "creases": asked.crease_stiffness[1] > 0 and asked.crease_strength is None,
        "arms": hinged and asked.arm_strength is None,
        "plate_edges": (
            stiffened is not None
            and not (stiffened.kind == "boxes" and stiffened.columns == "none")
            and (asked.edge_strength is None or not asked.edge_strength.is_known)
        ),
        "ties": file.deployment.ties != "none" and asked.tie_strength is None,
    }
    return [part for part, open_ in missing.items() if open_]


def free_hinges(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Hinges that turn freely, which have no moment to bear."""
    assert file.structure is not None
    if file.structure.crease_stiffness[1] > 0:
        yield Change({"structure.crease_stiffness": "free"}, {"locks": "hinges that turn freely"})


def no_ties(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """No ties, of which nobody knows what they bear."""
    if file.deployment.ties != "none":
        yield Change({"deployment.ties": "none"}, {"ties": "no ties"})


OF_MEMBRANE = (
    "panel.membrane", "panel.membrane_density", "structure.membrane_modulus",
    "structure.membrane_strength",
)  # fmt: skip
"""What goes with panels on a membrane, and with no others."""
GAP = 0.002
"""Between bevelled boards (m), where the file has none."""


def no_membrane(file: DesignFile, _: Analysis) -> Iterator[Change]:
    """Bevelled boards on hinges, where a membrane is the hinge of panels."""
    if file.panel is None or file.panel.is_solid:
        return
    dropped = {key: None for key in OF_MEMBRANE if value_at(file.tables, key) is not None}
    values: dict[str, object] = {"panel.construction": "bevel", **dropped}
    if not file.panel.gap:
        values["panel.gap"] = rounded(GAP / conversion(file.unit, "m"), 6)
    yield Change(values, {"boards": 'boards bevelled for hinges (construction = "bevel")'})


MAKES_KNOWN: Sequence[tuple[Step, frozenset[Limiting]]] = (
    (no_membrane, frozenset({"membrane", "lines"})),
    (named_lines, frozenset({"lines"})),
    (fixed_edges, frozenset({"plate_edges"})),
    (free_hinges, frozenset({"creases"})),
    (no_ties, frozenset({"ties"})),
)
"""What does without that of which nothing is known, or has a kind of it of which all is."""


def require_known(file: DesignFile) -> None:
    """Raise DesignError if what no change does without bears nobody knows what."""
    mended = frozenset[Limiting]().union(*(parts for _, parts in MAKES_KNOWN))
    refuse([part for part in not_given(file) if part not in mended])


def refuse(missing: Sequence[Limiting], why: str = "") -> None:
    """Raise DesignError, which says what is to be given, if any strength is missing.

    why: Why what would make it known cannot be made.
    """
    if missing:
        keys = [GIVE[part][1] for part in missing]
        raise DesignError(
            f"whatever is changed, it is not known whether it carries: {in_words(missing)} is not "
            f"given (give {' and '.join(keys)} in [structure]){why}",
            keys=tuple(f"structure.{key}" for key in keys),
        )


def in_words(parts: Sequence[Limiting]) -> str:
    """Whose strength it is."""
    *others, last = (f"of {GIVE[part][0]}" for part in parts)
    return f"the strength {', '.join(others)}{' and ' * bool(others)}{last}"
