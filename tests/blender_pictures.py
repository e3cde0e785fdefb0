"""The guide's picture of Blender: build/bpy/bin/python tests/blender_pictures.py PACKED.zip PLACE.

PACKED.zip is the add-on (``make blender``). The starter ``shelter`` is designed by it, and three
states of its motion are rendered, one beside the other.
"""

from __future__ import annotations

import sys

import bpy
import numpy as np
from mathutils import Vector
from numpy.typing import NDArray

WIDE, HIGH, SAMPLES = 420, 280, 32


def lit(place: str) -> None:
    """A ground, a sun, a bright sky, and a camera that sees the shell in all states."""
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_plane_add(size=200, location=(0, 0, -0.002))
    ground = bpy.data.materials.new("ground")
    ground.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (
        0.8,
        0.8,
        0.78,
        1,
    )
    bpy.context.object.data.materials.append(ground)
    bpy.ops.object.light_add(type="SUN", rotation=(0.7, 0.25, 0.5))
    bpy.context.object.data.energy = 1.6
    scene.world = bpy.data.worlds.new("sky")
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.85, 0.9, 1, 1)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.45
    middle = Vector((3.0, 0.0, 0.7))
    bpy.ops.object.camera_add(location=middle + Vector((-6.5, -9.5, 5.0)))
    scene.camera = bpy.context.object
    scene.camera.data.lens = 58
    scene.camera.rotation_euler = (
        (middle - scene.camera.location).to_track_quat("-Z", "Y").to_euler()
    )
    scene.render.engine, scene.cycles.samples, scene.cycles.seed = "CYCLES", SAMPLES, 1
    scene.render.resolution_x, scene.render.resolution_y = WIDE, HIGH
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = place


def rendered(state: int, place: str) -> NDArray[np.float32]:
    """One state, as rows of pixels from below."""
    bpy.context.scene.frame_set(state + 1)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(place, check_existing=False)
    pixels = np.empty(4 * WIDE * HIGH, dtype=np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(HIGH, WIDE, 4)


if __name__ == "__main__":
    packed, place = sys.argv[1:]
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.extensions.package_install_files(
        filepath=packed, repo="user_default", enable_on_install=True
    )
    bpy.ops.orishell.new(task="shelter")
    bpy.ops.orishell.run()
    lit(place)
    shown = [0, 5, 10]
    whole = np.concatenate([rendered(state, place) for state in shown], axis=1)
    image = bpy.data.images.new("whole", 3 * WIDE, HIGH)
    image.pixels.foreach_set(np.ascontiguousarray(whole).ravel())
    image.filepath_raw, image.file_format = place, "PNG"
    image.save()
