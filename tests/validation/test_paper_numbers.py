"""Every number that the paper states, beside ours: `make paper`'s table.

The paper's numbers are typed once, in examples/paper_numbers.py; ours are computed there.
"""

import importlib.util
import json
import re
import shutil
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from numpy.typing import NDArray

from samples import THOROUGH

EXAMPLES = Path(__file__).parents[2] / "examples"
PAPER = EXAMPLES / "paper_numbers.py"


def load(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


numbers = load(PAPER)
ALL = numbers.all_numbers()


@pytest.mark.parametrize("number", ALL, ids=lambda number: f"{number.where}: {number.name}")
def test_number(number: object) -> None:
    """Agreement within half of the paper's last digit, or a remark that says why not."""
    assert isinstance(number, numbers.Number)
    if number.within is None:
        assert number.remark
        # What is said not to agree does not: otherwise the remark is wrong.
        assert abs(number.difference) > numbers.EXACT
    else:
        assert number.agrees, number


def test_what_does_not_agree() -> None:
    """These four, for the reasons in docs/theory/differences.md, and no others."""
    assert [number.name for number in ALL if number.within is None] == [
        "amplitude of g",
        "alpha_0, lower end",
        "alpha_0, upper end",
        "F rows out of their planes, of their extent",
    ]


def test_alpha_0_lies_within_the_papers_interval() -> None:
    low, high = (number for number in ALL if number.name.startswith("alpha_0"))
    assert low.paper < low.ours < high.ours < high.paper


@pytest.mark.parametrize("name", ["figure1", "figure2"])
def test_count_of_freedoms_notices_a_sheet_that_does_not_fold(name: str) -> None:
    """With vertices moved at random out of their places, nothing can move."""
    mechanism = numbers.reproduce(name).mechanism

    class Moved:
        target_drive = mechanism.target_drive

        def positions(self, drive: float) -> NDArray[np.float64]:
            points: NDArray[np.float64] = mechanism.positions(drive)
            return points + 0.01 * np.random.default_rng(1).normal(size=points.shape)

    assert numbers.count_freedoms(mechanism) == 1
    assert numbers.count_freedoms(Moved()) == 0


def test_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(EXAMPLES))
    paper = load(EXAMPLES / "paper.py")
    paper.write_tables(tmp_path, ALL)
    entries = json.loads((tmp_path / "table.json").read_text(encoding="utf-8"))
    assert [entry["name"] for entry in entries] == [number.name for number in ALL]
    assert [entry["ours"] - entry["paper"] for entry in entries] == [
        entry["difference"] for entry in entries
    ]
    rows = (tmp_path / "table.md").read_text(encoding="utf-8").splitlines()
    rows = [row for row in rows if row.startswith("|")][2:]
    assert len(rows) == len(ALL)
    assert all(len(re.findall(r"(?<!\\)\|", row)) == 7 for row in rows)
    assert sum("**" in row for row in rows) == sum(number.within is None for number in ALL)


@pytest.mark.slow
def test_figures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Figures 1(a)-(d), 2(a)-(d), 3(a)-(b): drawn, not blank, the same bytes every time."""
    monkeypatch.syspath_prepend(str(EXAMPLES))
    monkeypatch.syspath_prepend(str(EXAMPLES / "gallery"))
    paper = load(EXAMPLES / "paper.py")
    from PIL import Image

    one, two = tmp_path / "one", tmp_path / "two"
    for directory in (one, two):
        directory.mkdir()
    paper.draw_figures(one)
    if not THOROUGH:  # Figure 3 again, not all of them
        pages = tmp_path / "gallery"
        pages.mkdir()
        for page in (EXAMPLES / "gallery").glob("plot_figure_3.py"):
            shutil.copy(page, pages)
        monkeypatch.setattr(paper, "EXAMPLES", tmp_path)
    paper.draw_figures(two)
    names = sorted(path.stem for path in (tmp_path / "one").iterdir())
    assert names == [
        f"figure-{n}" for n in ("1a", "1b", "1c", "1d", "2a", "2b", "2c", "2d", "3a", "3b", "3c")
    ]
    for name in names:
        first, second = (each / f"{name}.png" for each in (one, two))
        if THOROUGH or name.startswith("figure-3"):
            assert first.read_bytes() == second.read_bytes()
        with Image.open(first) as picture:
            grey = np.asarray(picture.convert("L"))
        assert 0.005 < (grey < 250).mean() < 0.9
