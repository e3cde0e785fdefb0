"""Files are the same bytes in another process, in another directory, whatever seed hashes have."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

from documents import FAMILIES, SMALL, demo_document, loaded_document, thick_document
from orishell.io import Settings
from orishell.io.format import Format
from orishell.io.formats import ALL, find_formats
from orishell.workshop import Workshop
from samples import THOROUGH

TESTS = Path(__file__).parents[2]
DRAWINGS = ["dxf", "svg", "origami-simulator"]


def formats() -> list[Format]:
    """All, but STEP in ``make thorough`` only: its library is seconds in the loading.

    Of STEP, ``test_step.py`` compares the bytes of two files that one process writes.
    """
    return [each for each in find_formats([ALL]) if THOROUGH or each.name != "step"]


def write_all(out: Path) -> None:
    """Every format of one shell, the drawings with much in them of every family."""
    for each in formats():
        document = loaded_document() if each.analysed else demo_document()
        if each.solid:
            document = thick_document("orthodiagonal", size=SMALL)
        each.write(out / each.file, document, Settings())
    settings = Settings(
        workshop=Workshop(palette="lightburn", creases="dashes", relief_hole=0.005, labels="both")
    )
    for family in FAMILIES:
        for each in find_formats(DRAWINGS):
            each.write(out / f"{family}-{each.file}", demo_document(family), settings)


def digests(out: Path) -> dict[str, str]:
    return {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in out.iterdir()}


def test_same_bytes_in_two_processes_and_directories(tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    for out in (here, there):
        out.mkdir()
    write_all(here)
    paths = [str(TESTS), *filter(None, [os.environ.get("PYTHONPATH")])]
    seed = "1" if os.environ.get("PYTHONHASHSEED") != "1" else "77"
    subprocess.run(
        [sys.executable, __file__, there],
        env=os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(paths)},
        check=True,
        timeout=120,
    )
    files = [*here.iterdir(), *there.iterdir()]
    assert not [file.name for file in files if str(tmp_path).encode() in file.read_bytes()]
    names = {each.file for each in formats()}
    names |= {f"{family}-{each.file}" for family in FAMILIES for each in find_formats(DRAWINGS)}
    assert names <= digests(here).keys()
    assert digests(here) == digests(there)


if __name__ == "__main__":
    write_all(Path(sys.argv[1]))
