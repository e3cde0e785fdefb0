"""Tables of the design file in words: the labels of their keys, and of the values these may have.

The words of families and of the workshop are those of their knobs. The page says all of them as
they are here: beside its controls, in its history, and in messages in place of keys.
"""

from __future__ import annotations

from collections.abc import Mapping

from orishell.studio.api import KeyWords, TableWords
from orishell.studio.knobs import describe_workshop
from orishell.workshop.drawing import Layer


def describe_tables() -> dict[str, TableWords]:
    """Labels of all tables but those of a family's parameters, by the tables' names."""
    workshop = {
        each["key"]: _key(each["label"], each["help"], WORKSHOP_CHOICES.get(each["key"], {}))
        for each in describe_workshop()
    }
    return {**TABLES, "workshop": {"label": "Workshop", "keys": workshop}}


def _key(label: str, text: str, choices: Mapping[str, str] | None = None) -> KeyWords:
    return {"label": label, "help": text, "choices": dict(choices or {})}


TABLES: dict[str, TableWords] = {
    "target": {"label": "Curves", "keys": {}},
    "pattern": {"label": "Pattern", "keys": {}},
    "deployment": {
        "label": "Deployment",
        "keys": {
            "from": _key(
                "Opened from",
                "folded up from the flat sheet, or opened from a pack beyond the target",
                {"flat": "Flat sheet", "pack": "Pack"},
            ),
            "flap_attachment": _key(
                "Flaps",
                "part of the folding sheet, or boards that are put on at the target",
                {"folded": "Of the sheet", "clipped": "Clipped on"},
            ),
            "ties": _key(
                "Ties",
                "what keeps the shell from opening beyond its target",
                {"none": "None", "feet": "Between feet"},
            ),
            "largest_fold_deg": _key("Hinges close to", "180\u00b0: hinges fold flat"),
        },
    },
    "panel": {
        "label": "Panels",
        "keys": {
            "thickness": _key(
                "Thickness", "of a panel, boards and membrane together; 0: none is designed for"
            ),
            "construction": _key(
                "Construction",
                "boards on both faces of a membrane that is their hinge, or solid panels, "
                "chamfered where they close",
                {"sandwich": "Sandwich", "bevel": "Bevel"},
            ),
            "membrane": _key("Membrane", "thickness of the hinge between the boards"),
            "gap": _key("Gap", "between panels at every crease: room for a hinge or a kerf"),
            "stop_deg": _key(
                "Stop of the flaps", "angle by which flaps stop short of folding flat"
            ),
            "largest_setback": _key(
                "Largest setback", "how far boards may stand back from creases"
            ),
        },
    },
    "tolerance": {
        "label": "Tolerance",
        "keys": {
            "surface": _key("Surface", "largest distance between shell and surface"),
            "panel_min": _key("Shortest edge", "of a panel in the flat sheet; empty: any"),
            "panel_max": _key("Longest edge", "of a panel in the flat sheet; empty: any"),
        },
    },
    "shell": {
        "label": "Shell",
        "keys": {
            "family": _key("Family", "the crease pattern's"),
            "unit": _key("Unit", "of all lengths"),
            "ground": _key("Ground", "whether the feet stand on z = 0, or g lies there"),
        },
    },
    "motion": {
        # The page has no section for it: messages keep its name.
        "label": "",
        "keys": {
            "frames": _key("Frames", "states that files have"),
            "contact_tolerance": _key("Contact tolerance", "distance below which panels touch"),
        },
    },
}
WORKSHOP_CHOICES = {
    "palette": {
        "plain": "Plain",
        "lightburn": "LightBurn",
        "glowforge": "Glowforge",
        "epilog": "Epilog",
        "shop": "Laser shop",
        "plotter": "Plotter",
    },
    "creases": {"score": "Scored", "dashes": "Dashes", "perforation": "Perforated"},
    "labels": {
        "none": "None",
        "panels": "Panels",
        "creases": "Creases",
        "both": "Panels and creases",
    },
    "joint": {"tabs": "Tabs", "strips": "Strips"},
}
LAYERS: Mapping[Layer, str] = {
    "CUT": "Cut",
    "MOUNTAIN": "Mountain creases",
    "VALLEY": "Valley creases",
    "ENGRAVE": "Engraved",
    "LABEL": "Beside the work",
}
"""Layers of the workshop's drawings in words."""
