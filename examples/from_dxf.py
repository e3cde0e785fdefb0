"""DXF in, DXF out: a profile from a drawing, swept, and its pattern drawn for a cutter.

Run it with ``python examples/from_dxf.py [DIRECTORY]``; the design is in ``from_dxf.toml``.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from orishell import Shell, design_shell, write_shell
from orishell.io.formats import find_formats


def design() -> Shell:
    """Design the roof, verify its motion, prove that it locks."""
    return design_shell(Path(__file__).with_suffix(".toml"))


def measure(shell: Shell) -> dict[str, float]:
    """Sizes of the roof and of its target, in metres."""
    f = shell.design.targets["f"]
    return {
        "span of f": float(np.linalg.norm(f[-1] - f[0])),
        "rise of f": float(np.ptp(f[:, 2])),
        "from f": shell.design.closeness["f"].max,
        "sheet width": shell.report.sheet.width,
        "sheet height": shell.report.sheet.height,
    }


def main() -> None:
    """Print its sizes and, if a directory is given, write all files and the pattern."""
    shell = design()
    size = measure(shell)
    print(f"the drawing's arch spans {size['span of f']:.3f} m and rises {size['rise of f']:.3f} m")
    print(f"f is met to {size['from f']:.3f} m")
    print(f"from a sheet of {size['sheet width']:.2f} m x {size['sheet height']:.2f} m")
    print(f"locks by its {shell.report.lock.cause}")
    if len(sys.argv) > 1:
        for path in write_shell(shell, Path(sys.argv[1]), find_formats(["dxf"])):
            print(path.name)


if __name__ == "__main__":
    main()
