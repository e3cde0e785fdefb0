"""The shell as objects of Blender: panels or boards, creases, ties, a person, and their motion."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from numpy.typing import NDArray

from .files import Folding

FACTS: dict[str, Any] = json.loads(Path(__file__).with_name("facts.json").read_text("utf-8"))
"""What orishell's tables say of parameters, colours and starters: ``make blender`` packs it."""
KINDS = {"M": "mountain", "V": "valley", "B": "border-crease", "C": "border-crease"}
STATE = '["state"]'
BODY = ((0.0, 0.13), (0.9, 0.17), (1.0, 0.2), (1.42, 0.24), (1.5, 0.08), (1.55, 0.08), (1.58, 0.11))
HEAD = ((1.66, 0.12), (1.72, 0.09), (1.75, 0.01))
"""A person of 1.75 m, turned as on a lathe: heights and radii (metres)."""


def material(meaning: str) -> Any:
    """The material of a meaning, in the colour that it has in all our pictures."""
    name = f"orishell {meaning}"
    found = bpy.data.materials.get(name)
    if found is None:
        found = bpy.data.materials.new(name)
        if bpy.app.version < (5, 0, 0):
            found.use_nodes = True  # later all have them
        found.diffuse_color = (*FACTS["colours"][meaning], 1.0)
        shader = next(each for each in found.node_tree.nodes if each.type == "BSDF_PRINCIPLED")
        shader.inputs["Base Color"].default_value = found.diffuse_color
        shader.inputs["Roughness"].default_value = 0.9
    return found


def show(root: Any, shell: Folding, boards: NDArray[Any] | None, ties: Sequence[Any]) -> None:
    """Put a shell below its root in place of what was there, and have the root's state move it.

    boards: Corners (S, 3 T, 3) of their triangles. ties: Rows and columns of their two ends.
    """
    clear(root)
    size = float(np.ptp(shell.states[0], axis=0).max())
    panels = _mesh(root, "panels", shell.states, shell.faces, "panel-front")
    if boards is not None:
        triangles = np.arange(boards.shape[1]).reshape(-1, 3).tolist()
        _mesh(root, "boards", boards, triangles, "panel-front")
        panels.hide_render = True
        panels.hide_set(True)
    kinds = np.array([KINDS.get(each, "unfolded") for each in shell.letters])
    for kind in np.unique(kinds).tolist():
        name = {"mountain": "mountains", "valley": "valleys"}.get(kind, kind)
        _lines(root, name, shell.states[:, shell.edges[kinds == kind]], kind, size / 800)
    if ties:
        ends = shell.states[:, np.array(ties) @ [shell.columns, 1]]
        _lines(root, "ties", ends, "tie", size / 1200)
    shown = shell.names.get("target", len(shell.states) - 1)
    _person(root, shell.states[shown].min(axis=0) - [0.6, 0.0, 0.0])
    _animate(root, shell, shown)


def clear(root: Any) -> None:
    """Remove what is below a root, and its motion."""
    for each in root.children:
        data = each.data
        bpy.data.objects.remove(each)
        (bpy.data.curves if isinstance(data, bpy.types.Curve) else bpy.data.meshes).remove(data)
    root.animation_data_clear()


def _linked(root: Any, name: str, data: Any, meaning: str) -> Any:
    data.materials.append(material(meaning))
    made = bpy.data.objects.new(name, data)
    made.parent = root
    for collection in root.users_collection:
        collection.objects.link(made)
    return made


def _mesh(root: Any, name: str, states: NDArray[Any], faces: list[Any], meaning: str) -> Any:
    data = bpy.data.meshes.new(name)
    data.from_pydata(states[0].tolist(), [], faces)
    made = _linked(root, name, data, meaning)
    _move(root, made, states)
    return made


def _lines(root: Any, name: str, ends: NDArray[Any], meaning: str, radius: float) -> None:
    """Lines whose ends (S, N, 2, 3) move, as round bars."""
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions, data.bevel_depth, data.bevel_resolution = "3D", radius, 1
    for each in ends[0]:
        line = data.splines.new("POLY")
        line.points.add(1)
        line.points.foreach_set("co", np.c_[each, np.ones(2)].ravel())
    _move(root, _linked(root, name, data, meaning), ends.reshape(len(ends), -1, 3))


def _move(root: Any, made: Any, states: NDArray[Any]) -> None:
    """Give an object a shape key for every state (S, V, 3), each driven by the root's state.

    At whole numbers one key counts alone: the state is exact. Between two it is blended.
    """
    if len(states) < 2:
        return
    for number, points in enumerate(states):
        key = made.shape_key_add(name=f"state {number}", from_mix=False)
        key.data.foreach_set("co", points.astype(np.float32).ravel())
        if number:
            driver = key.driver_add("value").driver
            state = driver.variables.new()
            state.name, state.targets[0].id, state.targets[0].data_path = "state", root, STATE
            driver.expression = f"max(0, 1 - abs(state - {number}))"


def _person(root: Any, place: NDArray[Any]) -> None:
    around = np.exp(2j * np.pi * np.arange(12) / 12)
    rings = [np.c_[r * around.real, r * around.imag, np.full(12, z)] for z, r in (*BODY, *HEAD)]
    sides = [(v, v - 11 if v % 12 == 11 else v + 1) for v in range(12 * (len(rings) - 1))]
    faces = [[one, two, two + 12, one + 12] for one, two in sides]
    data = bpy.data.meshes.new("person")
    data.from_pydata((np.concatenate(rings) + place).tolist(), [], faces)
    _linked(root, "person", data, "foot")


def _animate(root: Any, shell: Folding, shown: int) -> None:
    """The root's property ``state``, with a key on the first frame and on the last."""
    last = len(shell.states) - 1
    words = ", ".join(f"{number} is {name}" for name, number in shell.names.items())
    root["state"] = float(shown)
    root.id_properties_ui("state").update(
        min=0.0, max=float(last), description=f"State of the motion. {words}".strip()
    )
    scene = bpy.context.scene
    if last:
        for state in (0, last):
            root["state"] = float(state)
            root.keyframe_insert(STATE, frame=state + 1)
        for curve in _curves(root.animation_data):
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
        scene.frame_start, scene.frame_end = 1, last + 1
    scene.frame_set(shown + 1)


def _curves(animation: Any) -> Any:
    """The curves of an object's action, which stand elsewhere from Blender 5.0 on."""
    if hasattr(animation.action, "fcurves"):
        return animation.action.fcurves
    from bpy_extras.anim_utils import action_get_channelbag_for_slot

    return action_get_channelbag_for_slot(animation.action, animation.action_slot).fcurves
