"""A design file that leaves its family open: all are tried, one is taken by the rule it states."""

from __future__ import annotations

import re
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from orishell import DesignError, InputError
from orishell.conventions.progress import Progress, no_progress
from orishell.design_file import DesignFile
from orishell.design_file.file import check_design
from orishell.families.registry import TRIED
from orishell.shell.candidate import Candidate
from orishell.shell.export import write_shell
from orishell.shell.families import choose_family, packs_flat
from orishell.shell.family_choice import FamilyTrial
from orishell.shell.make import Shell, make_shell
from orishell.shell.open_questions import find_candidate
from orishell.shell.steps import Step, Work
from samples import thorough

VAULT: dict[str, dict[str, Any]] = {
    "shell": {"family": "auto", "unit": "m"},
    "target": {
        "f": {"formula": "-0.5*x**2", "range": [-1, 1]},
        "g": {"formula": "0*x", "range": [0, 3]},
    },
    "pattern": {"rows": 3, "columns": 3},
    "motion": {"frames": 3},
}


def vault(**pattern: object) -> DesignFile:
    tables = {**VAULT, "pattern": {**VAULT["pattern"], **pattern}}
    return check_design(tables, Path("vault.toml"), files=False)


REST: tuple[Step, ...] = ("remedies", "verification", "pack", "weight", "stock")
"""All that no family is chosen by."""


@pytest.fixture(scope="module")
def shell() -> Shell:
    return make_shell(vault(), skip=REST)


def test_all_families_are_compared_with_the_same_rows_and_columns(shell: Shell) -> None:
    families = shell.report.families
    assert families is not None
    assert [each.family for each in families.tried] == list(TRIED)
    for each in families.tried:
        assert (each.distance is None) == bool(each.why_not)
    assert (shell.report.rows, shell.report.columns) == (3, 3)


def test_the_nearest_that_locks_is_taken(shell: Shell) -> None:
    families = shell.report.families
    assert families is not None
    assert shell.file.family == families.family
    locking = [each for each in families.tried if each.locks and not each.in_strips]
    nearest = min(locking, key=lambda each: each.distance or 0.0)
    assert nearest.family == families.family
    assert shell.deviation is not None
    assert nearest.distance == shell.deviation.max
    assert nearest.sheet_area == shell.report.sheet.area


def test_it_is_the_shell_of_the_family_by_name(shell: Shell) -> None:
    named = make_shell(vault().changed({"shell.family": shell.file.family}), skip=REST)
    expected = named.report.as_dict()
    found = shell.report.as_dict()
    del found["families"], found["verdict"], expected["verdict"]
    assert found == expected


def test_the_table_is_in_the_verdict(shell: Shell) -> None:
    rows = [row.finding for row in shell.report.verdict if row.subject == "family"]
    assert len(rows) == len(TRIED)
    assert sum("(taken" in row for row in rows) == 1
    words = r"[a-z-]+: (within .* m2 of (sheet|strips), .* lock|none; .)"
    assert all(re.match(words, row) for row in rows)


ARCH = {**VAULT, "target": {**VAULT["target"], "g": {"formula": "0.3*x**2", "range": [-1.5, 1.5]}}}


def test_one_made_in_strips_is_named_where_it_is_nearer_but_never_taken_for_that() -> None:
    tables = {**ARCH, "pattern": {"rows": 7, "columns": 5}}
    families = make_shell(check_design(tables, Path("arch.toml"), files=False), skip=REST)
    choice = families.report.families
    assert choice is not None
    made = {each.family: each for each in choice.tried if each.distance is not None}
    strips, taken = made["t-hedral"], made[choice.family]
    assert strips.in_strips
    assert not taken.in_strips
    assert strips.distance is not None
    assert taken.distance is not None
    assert strips.distance < taken.distance
    rows = [row.finding for row in families.report.verdict if row.subject == "family"]
    named = [row for row in rows if row.startswith("t-hedral")]
    assert "m2 of strips" in named[0]
    assert "nearest, but made in strips" in named[0]


def test_one_made_in_strips_is_taken_where_no_sheet_makes_a_shell() -> None:
    def made(file: DesignFile, progress: Progress) -> Candidate:
        if file.family != "t-hedral":
            raise DesignError("it cannot")
        return find_candidate(file, Work(progress))

    file = check_design({**ARCH, "pattern": {"rows": 3, "columns": 5}}, Path("a.toml"), files=False)
    choice = choose_family(file, no_progress, made).answers.families
    assert choice is not None
    assert choice.family == "t-hedral"
    assert "(taken: no one sheet makes a shell)" in [row.finding for row in choice.rows("m")][-1]


@thorough
def test_a_family_that_cannot_says_why() -> None:
    tables = {**VAULT, "target": {**VAULT["target"], "g": {"formula": "sin(x)", "range": [0, 3]}}}
    report = make_shell(check_design(tables, Path("wave.toml"), files=False)).report
    assert report.families is not None
    reasons = {each.family: each.why_not for each in report.families.tried}
    assert "g is not straight" in reasons["longitudinal-linear-repeating"]


@thorough
def test_even_rows_leave_the_families_that_take_them() -> None:
    families = make_shell(vault(rows=4)).report.families
    assert families is not None
    assert all("odd number" in each.why_not for each in families.tried[:2])
    assert families.family in {each.family for each in families.tried[2:]}


def test_no_family_is_refused_with_all_reasons() -> None:
    def refused(file: DesignFile, progress: Progress) -> Candidate:
        raise DesignError("it cannot", size=f"{file.family} is unable")

    with pytest.raises(DesignError, match="no family makes a shell") as error:
        choose_family(vault(), no_progress, make=refused)
    assert all(f"{name}: it cannot: {name} is unable" in str(error.value) for name in TRIED)


def test_every_shell_is_made_once_and_told_at_once() -> None:
    done: list[str] = []
    told: list[FamilyTrial] = []

    def made(file: DesignFile, progress: Progress) -> Candidate:
        assert len(told) == len(done)
        done.append(file.family)
        return find_candidate(file, Work(progress))

    found = choose_family(vault(), no_progress, made, told.append)
    choice = found.answers.families
    assert choice is not None
    assert done == list(TRIED)
    assert choice.tried == tuple(told)
    assert found.file.family == choice.family


def test_keys_of_one_family_are_refused_where_it_is_open() -> None:
    with pytest.raises(InputError, match="xi_deg"):
        vault(xi_deg=60)


def test_a_zigzag_row_packs_flat_and_flaps_do_not() -> None:
    file = vault(flap=0).changed({"shell.family": "orthodiagonal", "pattern.row": "zigzag"})
    folds = make_shell(file, skip=REST)
    assert packs_flat(folds.design.mechanism, folds.lock.closes_to)
    locks = make_shell(vault().changed({"shell.family": "orthodiagonal"}), skip=REST)
    assert not packs_flat(locks.design.mechanism, locks.lock.closes_to)


def test_f_and_g_of_a_surface_are_written(shell: Shell, tmp_path: Path) -> None:
    by_curves = {
        "target.surface": None,
        "target.f.points": [[-1.0, 0.0], [0.0, 0.5], [1.0, 0.0]],
        "target.f.smooth": True,
        "target.g.points": [[0.0, 0.0], [3.0, 0.0]],
        "pattern.heading_deg": 90.0,
    }
    swept = replace(shell, design=replace(shell.design, by_curves=by_curves))
    names = [path.name for path in write_shell(swept, tmp_path)]
    assert "f-and-g.toml" in names
    tables = tomllib.loads((tmp_path / "f-and-g.toml").read_text())
    assert tables == {
        "target": {
            "f": {"points": by_curves["target.f.points"], "smooth": True},
            "g": {"points": by_curves["target.g.points"]},
        },
        "pattern": {"heading_deg": 90.0},
    }


@thorough
def test_a_surface_is_tried_by_all_and_its_f_and_g_are_the_same_shell() -> None:
    surface = {"formula": "-0.4*x**2 - 0.1*y**2", "x": [-1, 1], "y": [-1, 1]}
    tables = {**VAULT, "target": {"surface": surface}}
    shell = make_shell(check_design(tables, Path("roof.toml"), files=False))
    families = shell.report.families
    assert families is not None
    made = {each.family: each.distance for each in families.tried}
    assert all(made[each] is not None for each in ("parallel-repeating", "orthodiagonal"))
    assert shell.file.family == families.family == "parallel-repeating"
    own = shell.file.changed(shell.design.by_curves)
    assert own.surface is None
    swept = make_shell(own)
    target = shell.design.mechanism.target_drive
    again, first = (each.design.mechanism.positions(target) for each in (swept, shell))
    assert (again == first).all()
    assert shell.deviation is not None
    assert shell.report.deviation is not None
    assert shell.report.deviation.approached is not None
    assert swept.deviation is not None
    assert shell.report.deviation.approached.max == swept.deviation.max


def test_a_flat_foldable_sheet_is_fitted_to_f_swept_along_g(shell: Shell) -> None:
    assert shell.report.families is not None
    found = {each.family: each for each in shell.report.families.tried}["flat-foldable"]
    assert found.distance is not None
    assert found.packs_flat
    assert not found.locks
    assert found.distance < 0.1 * 3.6  # of the diagonal
