"""What functions of ``orishell`` make of paths, texts and numbers that are odd: one message."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import orishell
from documents import demo_document
from orishell import InputError
from orishell.curves import read_points
from orishell.io import read_fold, write_fold
from orishell.shell.make import Shell

EXAMPLES = Path(__file__).parent.parent / "examples"
ODD = [math.nan, -1, 2.5, b"x", [], {}, object(), ["a"], (1, 2), "\0", print, True]
"""Values that are no path, no formula, no format and no number of pixels."""
ODD_FOR: dict[str, list[Any]] = {
    "path": ODD,
    "text": [*ODD, None, ""],
    "formula": [*ODD, "x"],
    "number": ["", "1", None, [], b"1", object()],
    "points": [*ODD, None, "ab", [[1, 2]], [[1, 2, 3]] * 2, [["a", "b"]] * 2, [[0, math.nan]] * 2],
    "pixels": [math.nan, math.inf, 0, -5, "560", None, 2.5, 10**30],
    "frames": [math.nan, 1, 0, "3", None, 2.5, [3]],
    "settings": [*ODD, None, "flat"],
    "unit": [math.nan, "metre", "", 1],
    "policy": [math.nan, "", None, "never"],
}


@pytest.fixture(scope="module")
def shell() -> Shell:
    return orishell.design_shell(str(EXAMPLES / "canopy.toml"))


def good() -> list[tuple[str, dict[str, Any], str, str]]:
    """Functions, arguments that fit, the one that is made odd, and what it is."""
    y = orishell.parse_formula("x")
    fold = {"source": "shell.fold", "target": "a.obj"}
    formulas = {"x": None, "y": y, "start": 0, "stop": 1}
    return [
        ("parse_formula", {}, "text", "text"),
        ("curve_from_formulas", formulas, "x", "formula"),
        ("curve_from_formulas", formulas, "y", "formula"),
        ("curve_from_formulas", formulas, "start", "number"),
        ("curve_from_points", {"smooth": True}, "points", "points"),
        ("design_shell", {}, "path", "path"),
        ("design_shell", {"path": "a.toml"}, "clash", "policy"),
        ("convert_fold", fold, "source", "path"),
        ("convert_fold", fold, "target", "path"),
        ("convert_fold", fold, "settings", "settings"),
        ("convert_fold", fold, "unit", "unit"),
        ("show", {"shell": demo_document()}, "height", "pixels"),
        ("FoldingMotion", {"mechanism": None}, "frames", "frames"),
    ]


@pytest.mark.parametrize(
    "case",
    [pytest.param(each, id=f"{each[0]}-{each[2]}") for each in good()],
)
def test_odd_arguments_are_one_message(
    case: tuple[str, dict[str, Any], str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    name, arguments, argument, kind = case
    monkeypatch.chdir(tmp_path)
    if name == "convert_fold":
        write_fold("shell.fold", demo_document())
    if name == "FoldingMotion":
        arguments = {"mechanism": _mechanism()}
    before = sorted(tmp_path.iterdir())
    function: Callable[..., Any] = getattr(orishell, name)
    for odd in ODD_FOR[kind]:
        with pytest.raises(InputError) as caught:
            function(**{**arguments, argument: odd})
        said = str(caught.value)
        assert said, repr(odd)
        assert len(said.splitlines()) == 1 or name == "parse_formula", said
    assert sorted(tmp_path.iterdir()) == before


def _mechanism() -> orishell.Mechanism:
    f = orishell.curve_from_formulas(None, orishell.parse_formula("-x**2"), -1, 1)
    g = orishell.curve_from_formulas(None, orishell.parse_formula("0*x"), 0, 2)
    return orishell.design_parallel_repeating(
        f, g, orishell.ParallelRepeatingPattern(rows=3, columns=3)
    ).mechanism


def test_formats_and_structures_that_are_none(shell: Shell, tmp_path: Path) -> None:
    write: Callable[..., Any] = orishell.write_shell
    for odd, said in ((["oby"], "no such format"), ("o", "no such format"), ([None], "no format")):
        with pytest.raises(InputError, match=said):
            write(shell, tmp_path / "out", odd)
    with pytest.raises(InputError, match="write_shell: directory"):
        write(shell, "\0")
    analyse: Callable[..., Any] = orishell.analyse_structure
    with pytest.raises(InputError, match="expected a Structure"):
        analyse(shell, {"modulus": 1})
    assert not list(tmp_path.iterdir())


def test_states_of_a_shell_are_arrays_where_its_files_have_them(
    shell: Shell, tmp_path: Path
) -> None:
    """As the frames of its FOLD file, whose coordinates are those of the world; by names, too."""
    paths = orishell.write_shell(shell, tmp_path, formats=["obj"])
    assert any(path.suffix == ".obj" for path in paths)
    _, *frames = read_fold(tmp_path / "shell.fold").frames  # the first is the flat pattern
    states = shell.positions([state.drive for state in shell.motion])
    assert len(frames) == len(states)
    for frame, state in zip(frames, states, strict=True):
        np.testing.assert_allclose(frame.positions.reshape(-1, 3), state.reshape(-1, 3), atol=1e-9)
    assert shell.positions(shell.lock.target_drive).shape == states.shape[1:]


def test_paths_may_be_texts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    write_fold("shell.fold", demo_document())
    assert orishell.convert_fold("shell.fold", "a.obj") == [Path("a.obj")]
    assert len(read_fold("shell.fold").frames) == 8
    shutil.copy(EXAMPLES / "canopy.toml", "canopy.toml")
    Path("points.csv").write_text("0,0\n1,1\n")
    assert read_points("points.csv").shape == (2, 2)
    with pytest.raises(InputError, match="a: the file does not exist"):
        orishell.convert_fold("a", "b.obj")
    with pytest.raises(InputError, match="no format has this ending"):
        orishell.convert_fold("a", "b")


@pytest.mark.parametrize("pattern", [3, None, orishell.ParallelRepeatingPattern(rows=5, columns=5)])
def test_the_class_of_a_table_is_named(pattern: Any) -> None:
    arc = orishell.curve_from_formulas(None, orishell.parse_formula("-x**2"), -1, 1)
    with pytest.raises(InputError) as caught:
        orishell.design_orthodiagonal(arc, arc, pattern)
    expected = "an instance of OrthodiagonalPattern, or a dictionary of its keys"
    assert (caught.value.where, caught.value.expected) == (
        "design_orthodiagonal: pattern",
        expected,
    )
