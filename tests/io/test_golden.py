"""What a small sheet becomes in every format, byte for byte as it was when someone last looked.

The sheet, ``golden/sheet.fold``, has plain coordinates, so that no machine rounds it otherwise. The
files depend on the versions of the libraries in ``constraints.txt``. To write them anew after a
change that is meant, run the tests with ``ORISHELL_WRITE_GOLDEN=1`` and look at the difference.
"""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from orishell.io import Settings, document_of_fold, read_fold
from orishell.io.formats import all_formats
from orishell.io.formats.gltf import write_gltf
from orishell.workshop import Workshop

GOLDEN = Path(__file__).parent / "golden"
PLAIN = Settings(workshop=Workshop(creases="dashes", labels="both", relief_hole=0.02))
SPLIT = Settings(workshop=Workshop(stock=(1.8, 1.5), joint="tabs"))
FOLDERS = {"plain": PLAIN, "split": SPLIT}
# The page holds a built bundle, and FOLD has no boards for formats of solids.
NAMES = [
    each.name for each in all_formats() if each.name != "html" and not (each.solid or each.analysed)
]


@pytest.mark.parametrize(
    ("name", "folder"), [(name, "plain") for name in NAMES] + [("dxf", "split"), ("svg", "split")]
)
def test_bytes_are_those_of_last_time(name: str, folder: str, tmp_path: Path) -> None:
    (format_,) = (each for each in all_formats() if each.name == name)
    document = document_of_fold(read_fold(GOLDEN / "sheet.fold"))
    format_.write(tmp_path / format_.file, document, FOLDERS[folder])
    written = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    place = GOLDEN / folder
    if os.environ.get("ORISHELL_WRITE_GOLDEN"):
        place.mkdir(exist_ok=True)
        for each, content in written.items():
            (place / each).write_bytes(content)
    known = {path.name: path.read_bytes() for path in place.iterdir()}
    assert {each: known.get(each) for each in written} == written


def test_animations_do_not_depend_on_the_last_bit(tmp_path: Path) -> None:
    """Some processors round it otherwise."""
    sheet = document_of_fold(read_fold(GOLDEN / "sheet.fold"))
    noise = np.random.default_rng(1)
    states = [
        replace(each, positions=each.positions + noise.normal(size=each.positions.shape) * 1e-16)
        for each in sheet.states
    ]
    write_gltf(tmp_path / "shell.glb", replace(sheet, states=tuple(states)), PLAIN)
    assert (tmp_path / "shell.glb").read_bytes() == (GOLDEN / "plain/shell.glb").read_bytes()


def test_nothing_else_is_golden() -> None:
    stems = {each.file.split(".")[0] for each in all_formats()} | {"creases", "order", "schedule"}
    for folder in FOLDERS:
        for path in (GOLDEN / folder).iterdir():
            assert path.name.split(".")[0].split("-")[0] in stems
