"""orishell in Blender: design files and their parameters, shells that fold, curves as targets."""

import json
from typing import Any

import bpy
from bpy.props import StringProperty

from .operators import OPERATORS
from .root import keys_of, root_of

ICONS = {"fails": "ERROR", "warns": "INFO", "holds": "CHECKMARK"}


class Preferences(bpy.types.AddonPreferences):
    """Where the command is."""

    bl_idname = __package__
    command: StringProperty(  # type: ignore[valid-type]
        name="orishell command",
        description="Empty: the library in Blender's own Python, or the command on the PATH",
        subtype="FILE_PATH",
    )

    def draw(self, _: Any) -> None:
        """Draw its field."""
        self.layout.prop(self, "command")


class Sidebar(bpy.types.Panel):
    """The tab of the sidebar in a 3D view."""

    bl_idname, bl_label, bl_category = "ORISHELL_PT_shell", "orishell", "orishell"
    bl_space_type, bl_region_type = "VIEW_3D", "UI"

    def draw(self, context: Any) -> None:
        """Draw buttons, parameters and the verdict."""
        layout, root = self.layout, root_of(context)
        layout.operator_menu_enum("orishell.new", "task")
        for name in ("orishell.open", "orishell.fold"):
            layout.operator(name)
        if root is None:
            return
        for key in keys_of(root):
            layout.prop(root, f'["{key}"]', text=key)
        for name in ("orishell.target", "orishell.save", "orishell.run"):
            layout.operator(name)
        if "state" in root:
            layout.prop(root, '["state"]', text="state", slider=True)
        for sign, subject, finding in json.loads(root.get("verdict", "[]")):
            layout.label(text=f"{subject}: {finding}", icon=ICONS.get(sign, "NONE"))


CLASSES = (Preferences, *OPERATORS, Sidebar)


def register() -> None:
    """Add all of it to Blender."""
    for each in CLASSES:
        bpy.utils.register_class(each)


def unregister() -> None:
    """Take all of it away."""
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
