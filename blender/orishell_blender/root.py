"""The root of a shell: an empty object with its design file, and its values as properties."""

from __future__ import annotations

import json
from typing import Any

import bpy

from .design import Refusal, Tables, values_of, with_values
from .scene import FACTS

DESIGN, FOLDER, CURRENT = "design_file", "design_folder", "orishell_shell"


def new_root(name: str, tables: Tables, folder: str = "") -> Any:
    """A root with the tables of a design file, which was in a folder."""
    root = bpy.data.objects.new(name, None)
    root.empty_display_size = 0.3
    bpy.context.scene.collection.objects.link(root)
    root[FOLDER] = folder
    take(root, tables)
    make_current(root)
    return root


def make_current(root: Any) -> None:
    """Have the panel show a shell."""
    bpy.context.scene[CURRENT] = root
    bpy.context.view_layer.objects.active = root


def take(root: Any, tables: Tables) -> None:
    """Give a root other tables, with properties that have the ranges of orishell's own knobs."""
    for key in keys_of(root):
        del root[key]
    root[DESIGN] = json.dumps(tables)
    values = {"motion.frames": FACTS["frames"], **values_of(tables)}
    knobs = FACTS["parameters"].get(values.get("shell.family"), {})
    for key, value in values.items():
        if type(value) is int and key not in FACTS["integers"]:
            value = float(value)  # noqa: PLW2901
        root[key] = value
        knob = knobs.get(key, {})
        told = {"description": knob.get("help", "")}
        if knob.get("range") and type(value) in (int, float):
            low, high = map(type(value), knob["range"])
            told |= {"soft_min": min(low, value), "soft_max": max(high, value)}
        root.id_properties_ui(key).update(**told)


def keys_of(root: Any) -> list[str]:
    """The properties of a root that are values of its design file."""
    return [key for key in root.keys() if "." in key]  # noqa: SIM118 # it is no dict


def tables_of(root: Any) -> Tables:
    """The tables of a root with the values of its properties."""
    return with_values(json.loads(root[DESIGN]), {key: root[key] for key in keys_of(root)})


def root_of(context: Any) -> Any:
    """The shell that is meant: that of the active object, or the last one; None without any."""
    active = context.view_layer.objects.active
    while active is not None and DESIGN not in active:
        active = active.parent
    return active or context.scene.get(CURRENT)


def require_root(context: Any) -> Any:
    """As :func:`root_of`; refuses if there is none."""
    root = root_of(context)
    if root is None:
        raise Refusal("there is no shell in this scene. Begin one with New, or open a design file")
    return root
