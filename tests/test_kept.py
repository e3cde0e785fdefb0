"""What is kept is what would be made, and it is made once for all who ask."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from threading import get_ident

import kept
import numpy as np
import pytest

from documents import EXAMPLES
from fitted_shells import fitted
from orishell.design_file import read_design_file
from orishell.deviation import measure_deviation
from orishell.deviation.triangles import Triangles
from orishell.io.formats import find_formats
from orishell.shell import export
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from samples import led_by

SKIP = (*MEASURES, "verification", "stock")
Forget = Callable[[], None]


@pytest.fixture
def forget(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Forget:
    """Begins with nothing kept; makes this process forget what it has made or read."""
    monkeypatch.setattr(kept, "PLACE", tmp_path / "kept")
    monkeypatch.setattr(kept, "_read", {})
    return kept._read.clear


def files_of(shell: Shell, folder: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, bytes]:
    monkeypatch.setattr(export, "draw_pictures", lambda *_, **__: None)
    export.write_shell(shell, folder, find_formats(["obj", "csv"]))
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("name", led_by(["figure1", "figure1_card", "shelter_hinged"]))
def test_a_kept_shell_is_the_one_that_is_made(
    name: str, tmp_path: Path, forget: Forget, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With formulas, boards or hinged bodies: its files have the same bytes."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    made = make_shell(file, clash="unexamined", skip=SKIP)
    first = kept.kept_shell(file, clash="unexamined", skip=SKIP)
    assert kept.kept_shell(file, clash="unexamined", skip=SKIP) is first
    forget()
    again = kept.kept_shell(file, clash="unexamined", skip=SKIP)
    assert again is not first
    expected = files_of(made, tmp_path / "made", monkeypatch)
    assert {"shell.fold", "report.json", "shell.obj"} <= set(expected)
    assert files_of(again, tmp_path / "again", monkeypatch) == expected


def test_a_fitted_design_is_kept_and_its_distances_are_the_same(forget: Forget) -> None:
    """Trees of boxes, which find distances from its surface, are made anew."""
    design = kept.kept(lambda: fitted("roof", 4))
    first = design()
    forget()
    again = design()
    assert again is not first
    one, other = (measure_deviation(each, samples=20) for each in (first, again))
    assert (other.max, other.rms, other.p95) == (one.max, one.rms, one.p95)
    triangles = Triangles.scattered(np.eye(3), np.array([[0, 1, 2]]))
    points = np.linspace(0, 1, 30).reshape(10, 3)
    whole = kept.kept(lambda: triangles)
    assert whole() is triangles
    forget()
    feet = whole().nearest(points).feet
    np.testing.assert_array_equal(feet, triangles.nearest(points).feet)


def test_another_file_or_another_question_has_another_shell(forget: Forget) -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    shells = [
        kept.kept_shell(each, clash="unexamined", skip=skip)
        for each, skip in (
            (file, SKIP),
            (file.changed({"pattern.rows": 5}), SKIP),
            (replace(file, frames=3), SKIP),
            (file, (*SKIP, "weight")),
        )
    ]
    assert len({id(each) for each in shells}) == 4
    assert [each.file.pattern.rows for each in shells] == [9, 5, 9, 9]
    assert [each.file.frames for each in shells] == [25, 25, 3, 25]


def test_of_all_who_ask_at_once_one_makes_it(forget: Forget) -> None:
    """As processes do, whose first question finds nothing in their memory."""
    made = []

    @kept.kept
    def slow(number: int) -> list[int]:
        made.append(get_ident())
        time.sleep(0.2)
        return [number]

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(slow, [7] * 4)) == [[7]] * 4
    assert len(made) == 1
    forget()
    assert slow(7) == [7]
    assert slow(8) == [8]
    assert len(made) == 2


def test_what_fails_is_not_kept(forget: Forget) -> None:
    answers: Iterator[Exception | int] = iter([ValueError("not yet"), 3])

    @kept.kept
    def fails_once() -> int:
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    with pytest.raises(ValueError, match="not yet"):
        fails_once()
    assert fails_once() == 3
    assert not list(kept.PLACE.rglob("*.begun"))


def test_a_change_of_the_package_begins_anew_and_the_oldest_states_go(
    tmp_path: Path, forget: Forget, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = tmp_path / "src" / "orishell" / "module.py"
    module.parent.mkdir(parents=True)
    monkeypatch.setattr(kept, "ROOT", tmp_path)
    monkeypatch.setattr(kept, "state", kept.state.__wrapped__)
    made = []

    @kept.kept
    def line() -> str:
        made.append(module.read_text())
        return made[-1]

    texts = [f"depth = {number}\n" for number in range(6)]
    for text in texts:
        module.write_text(text)
        forget()
        assert line() == text
        forget()
        assert line() == text
        time.sleep(0.01)
    assert made == texts
    assert len(list(kept.PLACE.iterdir())) == kept.STATES
    for rounding in ("Nehalem", "Haswell"):
        monkeypatch.setenv("OPENBLAS_CORETYPE", rounding)
        forget()
        line()
    assert len(made) == len(texts) + 2
