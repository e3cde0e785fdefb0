"""What the panel's buttons do."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from .command import Run
from .design import Refusal, read_design, write_design
from .files import METRES, read_boards, read_fold
from .root import FOLDER, make_current, new_root, require_root, tables_of, take
from .scene import FACTS, show
from .targets import target_of

CHANGES = {"REGISTER", "UNDO"}
LOADS = ("structure", "load_case", "search")
"""Tables that take most of the time, and change nothing of what is seen."""


class Refusing:
    """An operator whose refusals stand where Blender reports errors."""

    def tried(self, work: Callable[..., Any], *given: Any) -> Any:
        """What the work returns, or that it is done."""
        try:
            return work(*given) or {"FINISHED"}
        except Refusal as error:
            self.report({"ERROR"}, str(error))  # type: ignore[attr-defined]
            return {"CANCELLED"}

    def execute(self, context: Any) -> Any:
        """Do what the class says."""
        return self.tried(self.work, context)  # type: ignore[attr-defined]


def new_run(context: Any) -> Run:
    """A run of the command that the preferences name, if they name one."""
    addon = context.preferences.addons.get(__package__)
    return Run("" if addon is None else addon.preferences.command)


class New(Refusing, bpy.types.Operator):
    """Begin with a design file of orishell's own, by what is to be built."""

    bl_idname, bl_label, bl_options = "orishell.new", "New", CHANGES
    task: EnumProperty(items=[(each, each, what) for each, what in FACTS["starters"].items()])  # type: ignore[valid-type]

    def work(self, context: Any) -> None:
        """Have it written, and open it."""
        run = new_run(context)
        try:
            run.start("new", self.task, run.out / "new.toml")
            run.require_success()
            new_root(self.task, read_design(run.out / "new.toml"))
        finally:
            run.close()


class Open(Refusing, bpy.types.Operator, ImportHelper):
    """Open a design file: its values become properties, and the file stays as it is."""

    bl_idname, bl_label, bl_options = "orishell.open", "Open", CHANGES
    filter_glob: StringProperty(default="*.toml", options={"HIDDEN"})  # type: ignore[valid-type]

    def work(self, _: Any) -> None:
        """Read the file."""
        path = Path(self.filepath)
        new_root(path.stem, read_design(path), str(path.absolute().parent))


class Save(Refusing, bpy.types.Operator, ExportHelper):
    """Save the design file of the shell as it is now."""

    bl_idname, bl_label, filename_ext = "orishell.save", "Save as", ".toml"

    def work(self, context: Any) -> None:
        """Write the file."""
        write_design(Path(self.filepath), tables_of(require_root(context)))


class Target(Refusing, bpy.types.Operator):
    """Take two selected curves, f last, or a mesh as the target of the shell."""

    bl_idname, bl_label, bl_options = "orishell.target", "Take as target", CHANGES

    def work(self, context: Any) -> None:
        """Put what is selected into the tables in place of [target]."""
        root = require_root(context)
        tables = tables_of(root)
        metres = METRES.get(tables.get("shell", {}).get("unit", "m"), 1.0)
        take(root, {**tables, "target": target_of(context, metres)})


class Design(Refusing, bpy.types.Operator):
    """Have orishell make the shell and prove that it folds, and show it."""

    bl_idname, bl_label, bl_options = "orishell.run", "Run", CHANGES
    loads: BoolProperty(name="Loads", description="Analyse its loads too, which may take minutes")  # type: ignore[valid-type]

    def begin(self, context: Any) -> None:
        """Start on a copy of the design file, beside it if it may name files that are there."""
        self.root = require_root(context)
        tables = {k: v for k, v in tables_of(self.root).items() if self.loads or k not in LOADS}
        self.run = new_run(context)
        self.file = Path(self.root[FOLDER] or self.run.out) / f"{self.root.name}.blender.toml"
        try:
            write_design(self.file, tables)
            self.run.start("design", self.file, "--out", self.run.out / "made", "--write", "glb")
        except Refusal:
            self.close()
            raise

    def close(self) -> None:
        """End the command, and remove the copy."""
        self.file.unlink(missing_ok=True)
        self.run.close()

    def end(self) -> None:
        """Show what was made."""
        try:
            self.run.require_success()
            made = self.run.out / "made"
            report = json.loads((made / "report.json").read_text(encoding="utf-8"))
            boards = read_boards(made / "shell.glb") if report["panel"] else None
            ties = [each["ends"] for each in (report["deployment"] or {}).get("ties", [])]
            show(self.root, read_fold(made / "shell.fold"), boards, ties)
            rows = [[each["sign"], each["subject"], each["finding"]] for each in report["verdict"]]
            self.root["verdict"] = json.dumps(rows)
            make_current(self.root)
        finally:
            self.close()

    def work(self, context: Any) -> None:
        """Wait for it, as scripts do."""
        self.begin(context)
        self.end()

    def invoke(self, context: Any, _: Any) -> Any:
        """Let Blender go on meanwhile."""
        return self.tried(self.go_on, context)

    def go_on(self, context: Any) -> set[str]:
        """Begin, and look every now and then whether it has ended."""
        self.begin(context)
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set("orishell designs the shell; Esc stops it")
        return {"RUNNING_MODAL"}

    def modal(self, context: Any, event: Any) -> Any:
        """Look whether it has ended."""
        stopped = event.type == "ESC"
        if not stopped and self.run.runs():
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)
        if stopped:
            self.close()
            return {"CANCELLED"}
        return self.tried(self.end)


class Fold(Refusing, bpy.types.Operator, ImportHelper):
    """Import a FOLD file with its folded states."""

    bl_idname, bl_label, bl_options = "orishell.fold", "Import FOLD", CHANGES
    filter_glob: StringProperty(default="*.fold", options={"HIDDEN"})  # type: ignore[valid-type]

    def work(self, _: Any) -> None:
        """Read the file and show it."""
        shell = read_fold(Path(self.filepath))
        root = bpy.data.objects.new(shell.title, None)
        bpy.context.scene.collection.objects.link(root)
        show(root, shell, None, [])
        if len(shell.states) < 2:
            self.report(
                {"WARNING"},
                f"{self.filepath}: it has one state, so nothing moves. orishell fold adds others",
            )


OPERATORS = (New, Open, Save, Target, Design, Fold)
