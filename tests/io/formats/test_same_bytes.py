"""Files for design tools: the same document gives the same bytes, whatever seed hashes have."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

TESTS = Path(__file__).parent.parent.parent
SCRIPT = """
import sys
from pathlib import Path
from documents import demo_document
from orishell.io.formats import gltf, obj, ply, rhino, stl, vtk
from orishell.io.settings import Settings

out, document, settings = Path(sys.argv[1]), demo_document(), Settings()
obj.write_obj(out / "shell.obj", document, settings)
stl.write_stl(out / "shell.stl", document, settings)
ply.write_ply(out / "shell.ply", document, settings)
gltf.write_gltf(out / "shell.glb", document, settings)
rhino.write_rhino(out / "shell.3dm", document, settings)
vtk.write_vtk(out / "shell.vtu", document, settings)
"""


def test_same_bytes_in_two_processes_and_directories(tmp_path: Path) -> None:
    digests = []
    for seed in ("1", "2"):
        out = tmp_path / seed
        out.mkdir()
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(TESTS)}
        subprocess.run([sys.executable, "-c", SCRIPT, str(out)], check=True, env=environment)
        digests.append(
            {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in out.iterdir()}
        )
    assert len(digests[0]) == 6 + 8
    assert digests[0] == digests[1]
