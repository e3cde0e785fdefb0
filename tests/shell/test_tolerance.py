"""Rows and columns chosen for a distance from the surface, from the design file to the files."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.memory import Memory
from orishell.curves.nearest import Nearest
from orishell.design_file import DesignFile, check_design, read_design_file
from orishell.deviation import measure_deviation
from orishell.deviation.triangles import Triangles
from orishell.families.tolerance import Tolerance
from orishell.shell import tolerance
from orishell.shell.export import write_shell
from orishell.shell.make import design_shell
from orishell.shell.size_trials import Choice, measure
from orishell.shell.tolerance import meet_tolerance
from samples import led_by, thorough

TARGETS = {
    "parallel-repeating": ("-x**2", "[-1, 1]", "5*sin(pi*x/10)", "[0, 20]"),
    "orthodiagonal": ("-x**2", "[-1, 1]", "0*x", "[0, 4]"),
    "longitudinal-linear-repeating": ("-x**2/2", "[-1, 1]", "0*x", "[0, 1]"),
}


def write_file(directory: Path, family: str, tolerance: str, pattern: str = "") -> Path:
    f, f_range, g, g_range = TARGETS[family]
    path = directory / "shell.toml"
    path.write_text(
        f'[shell]\nfamily = "{family}"\nunit = "m"\n'
        f'[target.f]\nformula = "{f}"\nrange = {f_range}\n'
        f'[target.g]\nformula = "{g}"\nrange = {g_range}\n'
        f"[pattern]\n{pattern}\n[tolerance]\n{tolerance}\n[motion]\nframes = 3\n"
    )
    return path


def test_the_studio_does_not_search_twice_for_one_design(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither for other frames; a file beside which curves may lie is read anew."""
    path = write_file(tmp_path, "orthodiagonal", "surface = 0.16", "depth = 0.12")
    tables = tomllib.loads(path.read_text())
    told: list[float] = []

    def sought(files: bool, frames: int, order: int = 1) -> tuple[dict[str, Any], Choice]:
        turned = dict(list(tables.items())[::order])
        file = check_design(turned, path, files=files).changed({"motion.frames": frames})
        assert file.tolerance is not None
        told.clear()
        sized, choice = meet_tolerance(
            file, file.tolerance, lambda share, _what: told.append(share)
        )
        assert sized.frames == frames
        return sized.tables, choice

    monkeypatch.setattr(tolerance, "MEMORY", Memory())
    tables_once, choice = sought(False, 3)
    assert told
    tables_twice, again = sought(False, 5, -1)
    assert not told
    assert tables_twice["pattern"] == tables_once["pattern"]
    assert again is choice
    assert sought(True, 3)[1].trial == choice.trial
    assert told


@thorough
def test_the_choice_needs_a_third_of_the_panels_of_equal_spacing_at_50_degrees(
    tmp_path: Path,
) -> None:
    file = read_design_file(write_file(tmp_path, "parallel-repeating", "surface = 0.05"))
    assert file.tolerance is not None
    sized, choice = meet_tolerance(file, file.tolerance)
    deviation = measure_deviation(sized.pattern.design(file.f, file.g))
    assert deviation.max <= 0.05 + deviation.sample_spacing
    plain = file.changed(
        {
            "pattern.xi_deg": 50.0,
            "pattern.spacing": "equal",
            "pattern.placement": "inscribed",
        }
    )
    _, other = meet_tolerance(plain, file.tolerance)
    assert other.trial.panels > 2.5 * choice.trial.panels


@pytest.mark.slow
@pytest.mark.parametrize(
    ("family", "surface", "pattern"),
    [
        ("parallel-repeating", 0.8, ""),
        pytest.param("parallel-repeating", 0.4, "", marks=thorough),
        pytest.param("parallel-repeating", 0.4, "plane_deg = 80", marks=thorough),
        pytest.param("orthodiagonal", 0.15, "", marks=thorough),
        ("longitudinal-linear-repeating", 0.2, 'sector_deg = "auto"'),
        pytest.param("longitudinal-linear-repeating", 0.1, 'sector_deg = "auto"', marks=thorough),
    ],
)
def test_every_family_comes_as_near_as_asked(
    tmp_path: Path, family: str, surface: float, pattern: str
) -> None:
    path = write_file(tmp_path, family, f"surface = {surface}", pattern)
    shell = design_shell(path)
    assert shell.deviation is not None
    assert shell.deviation.max <= surface
    chosen = shell.report.chosen
    assert chosen is not None
    assert (chosen.trial.rows, chosen.trial.columns) == (shell.report.rows, shell.report.columns)
    names = {path.name for path in write_shell(shell, tmp_path / "out")}
    assert "tradeoff.png" in names
    written = json.loads((tmp_path / "out" / "report.json").read_text())
    panels = [trial["panels"] for trial in written["chosen"]["tradeoff"]]
    assert panels == sorted(panels)


@thorough
def test_panels_keep_the_sizes_asked_for(tmp_path: Path) -> None:
    text = "surface = 0.4\npanel_min = 0.2\npanel_max = 2.5"
    file = read_design_file(write_file(tmp_path, "parallel-repeating", text))
    assert file.tolerance == Tolerance(surface=0.4, panel_min=0.2, panel_max=2.5)
    sized, _ = meet_tolerance(file, file.tolerance)
    measured = measure(sized.pattern.design(file.f, file.g), False)
    assert measured.shortest >= 0.2
    assert measured.longest <= 2.5


@thorough
def test_what_panels_of_the_smallest_size_cannot_meet(tmp_path: Path) -> None:
    text = "surface = 0.02\npanel_min = 0.2"
    file = read_design_file(write_file(tmp_path, "parallel-repeating", text))
    assert file.tolerance is not None
    with pytest.raises(DesignError, match=r"within 0\.02 of the surface") as caught:
        meet_tolerance(file, file.tolerance)
    nearest = float(str(next(iter(caught.value.candidates)).changes["tolerance.surface"]))
    assert meet_tolerance(file, Tolerance(surface=nearest, panel_min=0.2))[1].trial.error <= nearest


def test_what_the_file_says_is_kept(tmp_path: Path) -> None:
    text = 'xi_deg = 40\nspacing = "equal"\nplacement = "inscribed"'
    file = read_design_file(write_file(tmp_path, "parallel-repeating", "surface = 0.5", text))
    assert file.tolerance is not None
    sized, _ = meet_tolerance(file, file.tolerance)
    parameters = sized.pattern.design(file.f, file.g).parameters
    assert parameters["xi_deg"] == 40
    assert (parameters["spacing"], parameters["placement"]) == ("equal", "inscribed")


@pytest.mark.parametrize(
    ("tolerance", "pattern", "says"),
    [
        ("surface = 0.1", "rows = 9", "rows and columns are chosen"),
        ("surface = 0.1", "columns = 9", r"\[pattern\] columns"),
        ("surface = 0", "", "greater than 0"),
        ("surface = nan", "", "a finite number"),
        ("", "", r"\[tolerance\] surface: this key is missing"),
        ("surface = 0.1\npanel = 2", "", "unknown key"),
        ("surface = 0.1\npanel_min = 2\npanel_max = 1", "", "above panel_min"),
        ("surface = 0.1\npanel_min = -1", "", "at least 0"),
    ],
)
def test_tables_that_say_nothing_usable(
    tmp_path: Path, tolerance: str, pattern: str, says: str
) -> None:
    with pytest.raises(InputError, match=says):
        read_design_file(write_file(tmp_path, "parallel-repeating", tolerance, pattern))


def auto_file(directory: Path, tolerance: str) -> DesignFile:
    """-x**2 along a sine, with everything that may be chosen left to be chosen."""
    pattern = 'xi_deg = "auto"\ntheta_deg = "auto"'
    return read_design_file(write_file(directory, "parallel-repeating", tolerance, pattern))


def counted(patch: pytest.MonkeyPatch, of: type, name: str) -> list[int]:
    """Sizes of the arrays that a method is called with from now on."""
    sizes: list[int] = []
    method = getattr(of, name)

    def counting(self: Any, points: np.ndarray) -> Any:
        sizes.append(points.size)
        return method(self, points)

    patch.setattr(of, name, counting)
    return sizes


@pytest.mark.slow
def test_angles_left_open_are_chosen_once_for_each_number_of_rows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # 126 panels were found when every design asked anew: f and g 7,448 times for nearest points,
    # meshes 582 times. Kept for each number of rows or columns it is 596 to 610 and 146 times,
    # with several angles xi.
    file = auto_file(tmp_path, "surface = 0.15")
    assert file.tolerance is not None
    of_curves = counted(monkeypatch, Nearest, "__call__")
    of_meshes = counted(monkeypatch, Triangles, "nearest")
    sized, choice = meet_tolerance(file, file.tolerance)
    assert choice.trial.panels <= 126
    assert choice.trial.error <= 0.15
    assert len(of_curves) < 800
    assert len(of_meshes) < 250
    # The measure that decides is that of the report.
    assert measure_deviation(sized.pattern.design(file.f, file.g)).max == choice.trial.error


@pytest.mark.slow
@pytest.mark.parametrize("sizes", led_by(["surface = 1e-4", "surface = 0.4\npanel_max = 0.02"]))
def test_what_cannot_be_met_is_refused_after_few_questions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, sizes: str
) -> None:
    file = auto_file(tmp_path, sizes)
    assert file.tolerance is not None
    of_curves = counted(monkeypatch, Nearest, "__call__")
    of_meshes = counted(monkeypatch, Triangles, "nearest")
    with pytest.raises(DesignError, match="comes within"):
        meet_tolerance(file, file.tolerance)
    # 5,180 and 10,360 questions before; distances for sheets of up to 201 x 201 remain.
    assert len(of_curves) < 600
    assert sum(of_meshes) / 3 < 1_000_000
