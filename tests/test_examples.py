"""The examples run, and print what they should."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"


def test_figure_1(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure1.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "11 x 13 vertices"
    assert lines[1] == "f is met to 0.1335, g to 0.1134"
    assert lines[2].startswith("panels keep their lengths to ")


def test_figure_2(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure2.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "f is met to 0.1200, g to 0.0051"
    assert lines[1].startswith("its ends stand on the ground to ")
    assert float(lines[1].split()[-1]) < 1e-12
    assert lines[2].startswith("panels keep their lengths to ")
    assert lines[3].startswith("neighbouring rows meet inside the sheet: at heading_deg = 60 ")
    assert "heading_deg between" in lines[3]
