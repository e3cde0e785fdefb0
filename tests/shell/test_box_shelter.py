"""The shelter with box girders has the figures that its file's comment says, from a run."""

import re

import numpy as np

from documents import EXAMPLES
from orishell.design_file import read_design_file
from orishell.shell.make import make_shell
from samples import thorough


@thorough
def test_figures_of_the_comment() -> None:
    path = EXAMPLES / "shelter_boxes.toml"
    said = " ".join(path.read_text().split("[shell]")[0].replace("#", " ").split())
    shell, bare = (
        make_shell(read_design_file(EXAMPLES / name))
        for name in ("shelter_boxes.toml", "shelter_boards.toml")
    )
    counts = re.search(r"(\d+) boards, on (\d+) panels .*?, (\d+) of strips and (\d+) plates", said)
    assert counts is not None
    parts = shell.document.parts
    strips, plates = ([p for p in parts if p.kind == kind] for kind in ("girder", "plate"))
    girders = sum(len(part.mesh.faces) for part in strips)
    others = sum(len(part.mesh.faces) for part in parts) - girders - len(plates)
    boards = sum(len(part.boards) for part in parts if part.boards is not None)
    assert [boards, others, girders, len(plates)] == [*map(int, counts.groups())]
    assert len(strips) == 5
    weights = re.search(r"weighs (\d+) N, not (\d+)", said)
    packs = re.search(r"pack is ([\d.x ]+) m, not ([\d.x ]+) m", said)
    assert weights is not None
    assert packs is not None
    for made, weight, pack in zip((shell, bare), weights.groups(), packs.groups(), strict=True):
        rows = {row.subject: row.finding for row in made.report.verdict}
        assert round(float(rows["weight"].split(" N")[0])) == float(weight)
        sides = map(float, rows["packs"].split(" m")[0].split(" x "))
        assert np.allclose([*sides], [*map(float, pack.split(" x "))], rtol=0, atol=0.0051)
