"""Other people's programs that open solids: where they are, and what they say.

On Debian ``apt-get install freecad-python3 prusa-slicer`` has them, and ``make cad`` installs
build123d. Without one of them a test is skipped, or fails if the environment has
``ORISHELL_REQUIRE_CAD=1``, as in ``.ci/run``, so that nothing is skipped there unnoticed.
"""

from __future__ import annotations

import locale
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from node_tools import lacking

REQUIRED = "ORISHELL_REQUIRE_CAD"

COUNT_SOLIDS = """
import Part
shape = Part.Shape()
shape.read({file!r})
print("answer", len(shape.Solids), repr(sum(solid.Volume for solid in shape.Solids)))
print("valid", all(solid.isValid() and solid.isClosed() for solid in shape.Solids))
"""


def require_build123d() -> None:
    """End the test here if build123d is not installed."""
    if find_spec("build123d") is None:
        lacking("build123d is not installed: make cad", REQUIRED)


def ask_freecad(file: Path) -> tuple[int, float]:
    """How many solids FreeCAD finds in a STEP file, all of them valid, and their volume (mm^3)."""
    script = file.with_suffix(".py")
    script.write_text(COUNT_SOLIDS.format(file=str(file)))
    said = _run("freecadcmd", str(script))
    assert "valid True" in said, said
    (answer,) = (line.split() for line in said.splitlines() if line.startswith("answer"))
    return int(answer[1]), float(answer[2])


def ask_prusa_slicer(file: Path) -> list[dict[str, str]]:
    """What PrusaSlicer says of every object in a file: its size (mm) and whether it is manifold."""
    objects: list[dict[str, str]] = []
    for line in _run("prusa-slicer", "--info", str(file)).splitlines():
        if line == f"[{file.name}]":
            objects.append({})
        elif " = " in line:
            key, _, value = line.partition(" = ")
            objects[-1][key.strip()] = value.strip()
    return objects


def read_3mf(file: Path) -> Any:
    """The model in a 3MF file, as lib3mf has it, which finds nothing to warn of."""
    import lib3mf

    before = locale.setlocale(locale.LC_ALL)
    try:
        model = lib3mf.get_wrapper().CreateModel()
        reader = model.QueryReader("3mf")
        reader.SetStrictModeActive(True)
        reader.ReadFromFile(str(file))
    finally:  # it leaves the whole process in another
        locale.setlocale(locale.LC_ALL, before)
    assert reader.GetWarningCount() == 0
    assert model.GetUnit() == lib3mf.ModelUnit.MilliMeter
    return model


def objects_of(model: Any) -> list[Any]:
    """The meshes of a 3MF model."""
    found, objects = [], model.GetMeshObjects()
    while objects.MoveNext():
        found.append(objects.GetCurrentMeshObject())
    return found


def closed_volume(vertices: NDArray[Any], triangles: NDArray[Any]) -> float:
    """The volume of a surface as manifold3d has it, which takes closed, oriented ones only."""
    import manifold3d

    mesh = manifold3d.Mesh64(
        np.ascontiguousarray(vertices, np.float64), np.ascontiguousarray(triangles, np.uint64)
    )
    solid = manifold3d.Manifold(mesh)
    assert solid.status() == manifold3d.Error.NoError
    return float(solid.volume())


def _run(program: str, *arguments: str) -> str:
    if shutil.which(program) is None:
        lacking(f"{program} is not installed: see tests/cad_tools.py", REQUIRED)
    done = subprocess.run(
        [program, *arguments], capture_output=True, encoding="utf-8", timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
