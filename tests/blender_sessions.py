"""Sessions in Blender, run by bpy's own Python: see ``blender_tool``."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import bpy
import numpy as np

STATE = '["state"]'


def refused(call: Any, **given: Any) -> str:
    """What an operator reports; empty if it does its work."""
    try:
        call(**given)
    except RuntimeError as error:
        return str(error).removeprefix("Error: ").strip()
    return ""


def root() -> Any:
    return bpy.context.scene["orishell_shell"]


def child(name: str) -> Any:
    return next(each for each in root().children if each.name.split(".")[0] == name)


def vertices(thing: Any) -> Any:
    seen = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = seen.to_mesh()
    points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", points)
    seen.to_mesh_clear()
    return points.reshape(-1, 3)


def animation(name: str) -> Any:
    scene = bpy.context.scene
    found = []
    for frame in range(scene.frame_start, scene.frame_end + 1):
        scene.frame_set(frame)
        found.append(vertices(child(name)))
    return np.array(found)


def folding(file: str, place: str) -> dict[str, Any]:
    """Open, run, play, undo, redo, save, reload, play."""
    bpy.ops.orishell.open(filepath=file)
    root()["motion.frames"] = 60
    bpy.ops.ed.undo_push(message="opened")
    bpy.ops.orishell.run()
    bpy.ops.ed.undo_push(message="run")
    before = animation("panels")
    boards = animation("boards")
    bpy.ops.ed.undo()
    undone = [each.name for each in root().children]
    bpy.ops.ed.redo()
    redone = animation("panels")
    bpy.ops.wm.save_as_mainfile(filepath=f"{place}/shell.blend")
    bpy.ops.wm.read_homefile(use_empty=True)
    assert not bpy.data.objects
    bpy.ops.wm.open_mainfile(filepath=f"{place}/shell.blend")
    np.savez(
        f"{place}/frames", first=before, boards=boards, redone=redone, again=animation("panels")
    )
    bpy.ops.orishell.run()  # what was saved is a design all the same
    again = animation("panels")
    return {
        "undone": undone,
        "kinds": sorted(each.name for each in root().children),
        "same": bool((again == before).all()),
        "rows": root()["pattern.rows"],
        "range": root().id_properties_ui("pattern.rows").as_dict()["soft_max"],
        "colour": list(bpy.data.materials["orishell mountain"].diffuse_color),
        "left": [each.name for each in Path(file).parent.glob("*.blender.toml")],
    }


def starters(tasks: list[str], place: str) -> dict[str, Any]:
    found = {}
    for task in tasks:
        bpy.ops.orishell.new(task=task)
        bpy.ops.orishell.run()
        bpy.ops.orishell.save(filepath=f"{place}/{task}.toml")
        np.save(f"{place}/{task}", animation("panels"))
        found[task] = sorted(each.name.split(".")[0] for each in root().children)
    return found


def line(name: str, points: list[list[float]], kind: str = "POLY", *, closed: bool = False) -> Any:
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new(kind)
    if kind == "BEZIER":
        spline.bezier_points.add(len(points) - 1)
        for knot, point in zip(spline.bezier_points, points, strict=True):
            knot.co, knot.handle_left_type, knot.handle_right_type = point, "AUTO", "AUTO"
    else:
        spline.points.add(len(points) - 1)
        for knot, point in zip(spline.points, points, strict=True):
            knot.co = (*point, 1.0)
    spline.use_cyclic_u = closed
    made = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(made)
    return made


def mesh(name: str, points: Any, faces: list[list[int]]) -> Any:
    data = bpy.data.meshes.new(name)
    data.from_pydata(points, [], faces)
    made = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(made)
    return made


def select(*things: Any) -> None:
    """Select things, the last of which is active."""
    for each in bpy.context.view_layer.objects:
        each.select_set(each in things)
    bpy.context.view_layer.objects.active = things[-1] if things else None


def targets(place: str) -> dict[str, Any]:
    """An upright f, turned about z, along a level g; then a mesh; each taken, saved and run."""
    bpy.ops.orishell.new(task="card")
    x = np.linspace(-0.03, 0.03, 9)
    turn = np.array([np.cos(0.6), np.sin(0.6)])
    f = line("f", [[*(turn * each), 0.04 - each**2 / 0.045] for each in x])
    f.location = (1.0, 2.0, 0.0)
    g = line(
        "g",
        [[each, 0.04 * np.sin(np.pi * each / 0.12), 0.3] for each in np.linspace(0, 0.24, 25)],
        "BEZIER",
    )
    bpy.context.view_layer.update()
    select(g, f)
    bpy.ops.orishell.target()
    bpy.ops.orishell.save(filepath=f"{place}/curves.toml")
    bpy.ops.orishell.run()
    panels = len(child("panels").data.polygons)
    bpy.ops.orishell.new(task="canopy")
    at = [
        [u * 4.0, v * 3.0, 1.5 - 1.2 * u * u]
        for u in np.linspace(-1, 1, 9)
        for v in np.linspace(-1, 1, 9)
    ]
    faces = [
        [9 * i + j, 9 * i + j + 1, 9 * i + j + 10, 9 * i + j + 9]
        for i in range(8)
        for j in range(8)
    ]
    select(mesh("roof", at, faces))
    bpy.ops.orishell.target()
    bpy.ops.orishell.save(filepath=f"{place}/surface.toml")
    return {"panels": panels}


def imported(file: str, place: str) -> dict[str, Any]:
    bpy.ops.orishell.fold(filepath=file)
    last = next(each for each in bpy.data.objects if each.parent is None and "state" in each)
    bpy.context.scene["orishell_shell"] = last
    np.save(f"{place}/imported", animation("panels"))
    return {"frames": bpy.context.scene.frame_end}


def slips(place: str, broken: dict[str, str]) -> dict[str, str]:
    """Bad inputs by their names, and what is said of each."""
    said = {"no shell": refused(bpy.ops.orishell.run)}
    for name, text in broken.items():
        path = Path(place) / name
        path.write_bytes(text.encode("latin-1"))
        call = bpy.ops.orishell.fold if name.endswith(".fold") else bpy.ops.orishell.open
        said[name] = refused(call, filepath=str(path))
        if not said[name] and name.endswith(".toml"):
            said[name] = refused(bpy.ops.orishell.run)
    said["missing"] = refused(bpy.ops.orishell.open, filepath=f"{place}/nowhere.toml")
    bpy.ops.orishell.new(task="card")
    level = line("level", [[0, 0, 0], [1, 1, 0], [2, 0, 0]])
    for name, chosen in {
        "nothing selected": [],
        "one curve": [level],
        "not planar": [level, line("bent", [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 1, 1]])],
        "closed": [level, line("ring", [[0, 0, 0], [1, 0, 0], [1, 1, 0]], closed=True)],
        "no faces": [mesh("cloud", [[0, 0, 0], [1, 0, 0]], [])],
    }.items():
        select(*chosen)
        said[name] = refused(bpy.ops.orishell.target)
    said["unwritable"] = refused(bpy.ops.orishell.save, filepath=f"{place}/nowhere/a.toml")
    root()["design_folder"] = f"{place}/gone"
    said["folder gone"] = refused(bpy.ops.orishell.run)
    return said


def commands(place: str, command: str) -> dict[str, str]:
    """Where orishell is not in Blender's Python: without a command, with a wrong one, with one."""
    sys.modules["orishell"] = None  # type: ignore[assignment] # as where it is not installed
    said = {"none": refused(bpy.ops.orishell.new, task="card")}
    preferences = bpy.context.preferences.addons["bl_ext.user_default.orishell"].preferences
    preferences.command = f"{place}/no-such-program"
    said["wrong"] = refused(bpy.ops.orishell.new, task="card")
    preferences.command = command
    said["named"] = refused(bpy.ops.orishell.new, task="card")
    return {
        **said,
        "roots": ", ".join(each.name for each in bpy.data.objects if "pattern.rows" in each),
    }


if __name__ == "__main__":
    packed, session, answer, question = json.loads(sys.argv[1])
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.extensions.package_install_files(
        filepath=packed, repo="user_default", enable_on_install=True
    )
    Path(answer).write_text(json.dumps(globals()[session](**question)), encoding="utf-8")
