"""What the studio says of the parameters: names, help, and how far their sliders reach."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

from orishell.spec import FAMILIES, starter_file

Kind = Literal["integer", "number", "choice", "angles4"]


@dataclass(frozen=True, slots=True)
class Knob:
    """One parameter, as a control shows it.

    Parameters
    ----------
    label, help
        Its name, and one line that says what it does.
    kind
        What its value is.
    auto
        Whether it may be "auto".
    unit
        "length" (in the design's unit), "deg" or none.
    slider, step
        How far the slider reaches; None where that depends on the curves.
    choices
        Its values, if they are few.
    """

    label: str
    help: str
    kind: Kind
    auto: bool = False
    unit: Literal["length", "deg", ""] = ""
    slider: tuple[float, float] | None = None
    step: float | None = None
    choices: tuple[str, ...] = ()


KNOBS: Final[Mapping[str, Knob]] = {
    "rows": Knob("Rows", "Rows of inner vertices, odd", "integer", slider=(1, 61), step=2),
    "columns": Knob("Columns", "Columns of inner vertices", "integer", slider=(2, 61), step=1),
    "flap": Knob("Flap", "Width of the locking panels; 0: none", "number", True, "length"),
    "xi_deg": Knob(
        "Crease angle ξ",
        "Angle between the creases of column 1 when locked; wide is close to f",
        "number",
        True,
        "deg",
        (1, 179),
        0.5,
    ),
    "theta_deg": Knob(
        "Turn of f θ", "Turns f in its own plane before it is swept", "number", True, "deg",
        (-90, 90), 0.5,
    ),
    "plane_deg": Knob(
        "Plane angle", "Angle from f's plane to g's tangent", "number", False, "deg", (20, 160), 0.5
    ),
    "depth": Knob(
        "Depth", "Distance of the zigzag's vertices from f, on both sides", "number", True, "length"
    ),
    "heading_deg": Knob(
        "Heading", "Angle between f's plane and g's x axis", "number", True, "deg", (0, 180), 0.5
    ),
    "sector_deg": Knob(
        "Sector angles", "Four angles at the first vertex", "angles4", True, "deg"
    ),
    "solution": Knob(
        "Solution", "Which solution of equation (4), as `orishell solve` lists them", "integer",
        slider=(0, 1), step=1,
    ),
    "stage_deg": Knob(
        "Stage", "Fold angle of column 1 at which the shell stands", "number", True, "deg",
        (0.1, 60), 0.1,
    ),
    "first_row": Knob(
        "First row", "Kind of the vertices of row 1: flat-foldable or column-straight", "choice",
        choices=("F", "S"),
    ),
    "flap_side": Knob(
        "Flaps fold to", "End of f to which both flaps fold", "choice", choices=("start", "end")
    ),
    "spacing": Knob(
        "Spacing", "Columns closer where g bends, or at equal lengths", "choice",
        choices=("curvature", "equal"),
    ),
    "placement": Knob(
        "Placement", "Columns on g, or beyond it so that both sides err alike", "choice",
        choices=("inscribed", "balanced"),
    ),
}  # fmt: skip
"""By the key of the table [pattern]; keys that are not here have no control."""


def describe_families() -> dict[str, Any]:
    """Names, parameters and defaults of all families."""
    return {name: _describe(name) for name in FAMILIES}


def describe_examples() -> list[dict[str, str]]:
    """A design of every family to begin with."""
    return [
        {"name": name, "title": f"{family.label} shell of the paper", "text": starter_file(name)}
        for name, family in FAMILIES.items()
    ]


def _describe(name: str) -> dict[str, Any]:
    family = FAMILIES[name]
    fields = family.pattern.model_fields
    parameters = []
    for key in ["rows", "columns", *(each for each in fields if each not in {"rows", "columns"})]:
        if key not in KNOBS:
            continue
        knob, field = KNOBS[key], fields[key]
        choices = list(knob.choices)
        if knob.choices and field.default == "auto":
            choices.insert(0, "auto")
        parameters.append(
            {
                "key": key,
                **{name: value for name, value in asdict(knob).items() if value is not None},
                "auto": knob.auto,
                "choices": choices,
                "default": None if field.is_required() else field.default,
            }
        )
    return {"label": family.label, "what": family.what, "parameters": parameters}
