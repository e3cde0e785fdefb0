"""Files are the same bytes in another process, in another directory, whatever seed hashes have."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

from documents import FAMILIES
from orishell.io.formats import ALL, find_formats

TESTS = Path(__file__).parents[2]
DRAWINGS = ["dxf", "svg", "origami-simulator"]
SCRIPT = f"""
import sys
from pathlib import Path
sys.path.insert(0, {str(TESTS)!r})
from documents import FAMILIES, demo_document, loaded_document, thick_document
from orishell.io import Settings
from orishell.io.formats import ALL, find_formats
from orishell.workshop import Workshop

out = Path(sys.argv[1])
for each in find_formats([ALL]):
    document = loaded_document() if each.analysed else demo_document()
    if each.solid:
        document = thick_document("orthodiagonal")
    each.write(out / each.file, document, Settings())
settings = Settings(
    workshop=Workshop(palette="lightburn", creases="dashes", relief_hole=0.005, labels="both")
)
for family in FAMILIES:
    for each in find_formats({DRAWINGS}):
        each.write(out / f"{{family}}-{{each.file}}", demo_document(family), settings)
"""


def test_same_bytes_in_two_processes_and_directories(tmp_path: Path) -> None:
    digests = []
    for seed in ("1", "77"):
        out = tmp_path / seed
        out.mkdir()
        subprocess.run(
            [sys.executable, "-c", SCRIPT, str(out)],
            env=os.environ | {"PYTHONHASHSEED": seed},
            check=True,
            timeout=120,
        )
        files = sorted(out.iterdir())
        assert not [file.name for file in files if str(tmp_path).encode() in file.read_bytes()]
        digests.append({file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files})
    names = {each.file for each in find_formats([ALL])}
    names |= {f"{family}-{each.file}" for family in FAMILIES for each in find_formats(DRAWINGS)}
    assert names <= digests[0].keys()
    assert digests[0] == digests[1]
