"""The examples run, and print what they should."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"


def test_figure_1(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(EXAMPLES / "figure1.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "11 x 13 vertices"
    assert lines[1] == "f is met to 0.1335, g to 0.1381"
    assert lines[2].startswith("panels keep their lengths to ")
