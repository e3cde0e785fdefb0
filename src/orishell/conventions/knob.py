"""How the studio shows the keys of tables: metadata of their fields."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from pydantic import BaseModel

Kind = Literal["integer", "number", "choice", "angles4", "switch", "size"]
Measure = Literal["length", "deg", "kg/m²", ""]


@dataclass(frozen=True, slots=True)
class Knob:
    """One parameter, as a control of the studio shows it: metadata of its key in a table.

    Parameters
    ----------
    label, help
        Its name, and one line that says what it does.
    kind
        What its value is; a "switch" is on or off, a "size" is a width and a height.
    auto
        Whether it may be "auto".
    unit
        "length" (in the design's unit), another one, or none.
    slider, step
        How far the slider reaches; None where that depends on the curves.
    choices
        Its values, if they are few.
    """

    label: str
    help: str
    kind: Kind
    auto: bool = False
    unit: Measure = ""
    slider: tuple[float, float] | None = None
    step: float | None = None
    choices: tuple[str, ...] = ()

    @classmethod
    def angle(
        cls,
        label: str,
        help: str,  # noqa: A002 # the field's name
        slider: tuple[float, float],
        *,
        step: float = 0.5,
        auto: bool = True,
    ) -> Knob:
        """A knob for an angle in degrees.

        Parameters
        ----------
        label, help, auto
            As of the class.
        slider, step
            How far the slider reaches (degrees).
        """
        return cls(label, help, "number", auto, "deg", slider, step)


def knobs_of(model: type[BaseModel]) -> dict[str, Knob]:
    """The knobs of all keys of a table that the studio shows, in their order.

    Parameters
    ----------
    model
        The table.
    """
    return {
        key: each
        for key, field in model.model_fields.items()
        for each in field.metadata
        if isinstance(each, Knob)
    }
