"""From a design file to a verified shell, its report and its files."""

from typing import TYPE_CHECKING

from orishell.conventions.imports import import_on_demand

if TYPE_CHECKING:
    from orishell.shell.analyse import analyse_structure
    from orishell.shell.export import convert_fold, write_format, write_shell, write_structure
    from orishell.shell.kit import Kit, write_kit
    from orishell.shell.make import Shell, design_shell, make_shell
    from orishell.shell.report import Report

__all__ = [
    "Kit",
    "Report",
    "Shell",
    "analyse_structure",
    "convert_fold",
    "design_shell",
    "make_shell",
    "write_format",
    "write_kit",
    "write_shell",
    "write_structure",
]

__getattr__, __dir__ = import_on_demand(
    __name__,
    {
        "orishell.shell.export": ("convert_fold", "write_format", "write_shell", "write_structure"),
        "orishell.shell.kit": ("Kit", "write_kit"),
        "orishell.shell.make": ("Shell", "design_shell", "make_shell"),
        "orishell.shell.report": ("Report",),
        "orishell.shell.analyse": ("analyse_structure",),
    },
)
