"""How large a shell is that was proved: beside the sizes that it may be asked for."""

from __future__ import annotations

from orishell.design_file import DesignFile
from orishell.design_file.fit import AXES, usual_head
from orishell.shell.fit.built_size import BuiltShell
from orishell.shell.make import Shell
from orishell.studio.api import BuiltSizes


def head_of(file: DesignFile) -> float:
    """Height up to which a room is clear in a design, in its unit."""
    return usual_head(file.unit) if file.fit is None else file.fit.head(file.unit)


def measure_sizes(shell: Shell, head: float) -> BuiltSizes:
    """All sizes of a shell, as it stands at its target."""
    built = BuiltShell.of(shell.design, shell.lock)
    inside = None
    if shell.report.stands is not None:
        inside = dict(zip(AXES, built.inside(head).tolist(), strict=True))
    outside = dict(zip(AXES, built.outside().tolist(), strict=True))
    return {"outside": outside, "inside": inside, "head_height": head}
