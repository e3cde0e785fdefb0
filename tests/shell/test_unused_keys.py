"""Keys of a design file that nothing asks for: named, and without an effect; all others are not."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from command_line import orishell
from design_tables import Tables, formula, tables
from documents import EXAMPLES
from kits import read_sound
from orishell import (
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    curve_from_formulas,
    parse_formula,
)
from orishell.conventions.table import Table
from orishell.design_file import check_design, read_design_file
from orishell.design_file.tables import with_values
from orishell.families.pattern import Pattern
from orishell.motion.layout import points_of
from orishell.shell import make_shell
from orishell.shell.kit import write_kit
from orishell.shell.steps import MEASURES
from orishell.workshop import Workshop
from samples import led_by

ALL = sorted(path.stem for path in EXAMPLES.glob("*.toml"))
QUICK = ("sectors", "figure1_card")
"""Examples that are made in a second or two: with and without a target, and with many keys."""
LOADED = sorted(name for name in ALL if "[structure]" in (EXAMPLES / f"{name}.toml").read_text())
WHOLE = ".combine"
"""A table of names that the user chose."""


def small(**pattern: Any) -> Tables:
    return tables(
        *("parallel-repeating", formula("-x**2", -1, 1), formula("0.1*x", 0, 2)),
        **{"rows": 3, "columns": 2, "xi_deg": 50, **pattern},
    )


def written(place: Path, design: Tables) -> Path:
    """A design file of tables whose values TOML writes as JSON does, but for their own tables."""
    lines = []
    for name, table in design.items():
        lines += [f"[{name}]", *(f"{key} = {_toml(value)}" for key, value in table.items())]
    (place / "small.toml").write_text("\n".join(lines) + "\n")
    return place / "small.toml"


def _toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_toml(each)}" for key, each in value.items()) + " }"
    return json.dumps(value)


def named(stderr: str) -> set[str]:
    """Keys that a command says are not used: in one line, if there are any."""
    begin = "orishell: warning: nothing here uses "
    lines = [line for line in stderr.splitlines() if line.startswith(begin)]
    assert len(lines) <= 1
    return set(lines[0].removeprefix(begin).split(", ")) if lines else set()


@pytest.mark.slow
def test_commands_name_what_they_do_not_use(tmp_path: Path) -> None:
    workshop = {"creases": "score", "dash": 0.2, "duty": 0.5, "stock": [6.0, 4.0], "margin": 0.0}
    search = {"variables": {"pattern.rows": [3, 5]}, "minimise": ["panels"]}
    design = {**small(flap=0, flap_side="start"), "workshop": workshop}
    file = written(tmp_path, design)
    # Dashes are asked for where creases are dashes, sides of flaps where there are flaps. What is
    # as it would be without the key is a key all the same.
    ran = orishell("kit", file, "--out", tmp_path / "kit")
    assert ran.returncode == 0
    assert named(ran.stderr) == {"pattern.flap_side", "workshop.dash", "workshop.duty"}
    ran = orishell("kit", file, "--out", tmp_path / "paper", "--paper")
    sizes = {"workshop.dash", "workshop.stock", "workshop.margin"}
    assert named(ran.stderr) == {"pattern.flap_side", "workshop.duty"} | sizes
    # What is drawn is no matter of a command that draws nothing; else it is.
    ran = orishell("design", file, "--out", tmp_path / "design")
    assert named(ran.stderr) == {"pattern.flap_side"}
    ran = orishell("design", file, "--out", tmp_path / "design", "--write", "svg")
    assert named(ran.stderr) == {"pattern.flap_side", "workshop.dash", "workshop.duty"}
    # A search of few variants makes all of them, and has no numbers by chance.
    grid = written(tmp_path, {**small(), "search": {**search, "seed": 4, "evaluations": 9}})
    ran = orishell("search", grid, "--out", tmp_path / "search", "--processes", "1")
    assert ran.returncode == 0
    assert named(ran.stderr) == {"search.seed"}


def test_a_card_model_has_the_creases_that_are_asked_for(tmp_path: Path) -> None:
    creases = {}
    for style in ("score", "dashes", "perforation"):
        workshop = {"creases": style, "dash": 0.03, "duty": 0.5, "labels": "none"}
        shell = make_shell(
            check_design({**small(), "workshop": workshop}, Path("small.toml")), skip=MEASURES
        )
        kit = write_kit(shell, tmp_path / style, paper=True)
        drawing = read_sound(tmp_path / style / "fabric/pattern.dxf")
        lines = drawing.modelspace().query('*[layer=="MOUNTAIN" | layer=="VALLEY"]')
        creases[style] = len(lines)
        # Where creases are scored there are no dashes; else they are the shell's, to scale.
        unused = set() if style != "score" else {"workshop.dash", "workshop.duty"}
        assert set(kit.unused) == unused
    # A crease is one line, or many dashes of the length that is asked for.
    assert creases["dashes"] > 2 * creases["score"]
    assert creases["perforation"] > 2 * creases["score"]


def test_what_is_named_can_be_left_out() -> None:
    design = {
        **small(flap=0, flap_side="start"),
        "workshop": {"dash": 0.3, "joint": "strips", "tie_stock": 4.0},
    }
    file = check_design(design, Path("small.toml"))
    shell = make_shell(file, skip=MEASURES)
    unused = file.keys.unused()
    assert "pattern.flap_side" in unused
    without = check_design(with_values(design, dict.fromkeys(unused)), Path("small.toml"))
    one, other = (each.report for each in (shell, make_shell(without, skip=MEASURES)))
    assert {**one.parameters, "flap_side": ""} == {**other.parameters, "flap_side": ""}
    for key in ("quantities", "lock", "sheet", "deployed"):
        assert one.as_dict()[key] == other.as_dict()[key]


@pytest.mark.parametrize("family", [ParallelRepeatingPattern, OrthodiagonalPattern])
def test_where_flaps_fold_to_is_idle_without_flaps(family: Callable[..., Pattern]) -> None:
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.1*x**2"), 0, 2)
    sheets = [
        family(rows=5, columns=3, flap=0.0, **sides).design(f, g).mechanism
        for sides in ({}, {"flap_side": "start"}, {"flap_side": ["end", "start"]})
    ]
    for drive in (0.0, 0.9 * sheets[0].target_drive):
        first, *others = (points_of(sheet, drive) for sheet in sheets)
        assert all((other == first).all() for other in others)


def test_changes_are_of_the_same_file() -> None:
    file = check_design({**small(), "workshop": {"stock": [6.0, 4.0]}}, Path("small.toml"))
    changed = file.changed({"pattern.rows": 5, "workshop.margin": 0.1})
    _ = changed.workshop.stock, changed.workshop.margin
    assert "workshop.stock" not in file.keys.unused()
    assert "workshop.margin" not in file.keys.given  # nobody wrote it
    # Tables are equal, and keys of memories, by their values alone.
    assert file.workshop == Workshop(stock=(6.0, 4.0))
    assert hash(file.workshop) == hash(Workshop(stock=(6.0, 4.0)))
    # What is put in the place of a value is not the file's.
    again = check_design({**small(), "workshop": {"stock": [6.0, 4.0]}}, Path("small.toml"))
    _ = again.workshop.replace_unchecked(stock=None).stock
    assert "workshop.stock" in again.keys.unused()


@pytest.mark.parametrize("name", ALL)
def test_every_key_of_an_example_has_its_place(name: str) -> None:
    """Every value of the file is a key once, so none is passed over, and none invented."""
    file = read_design_file(EXAMPLES / f"{name}.toml")

    def leaves(inside: Any, key: str = "") -> set[str]:
        if isinstance(inside, dict) and not key.endswith(WHOLE):
            return set().union(*(leaves(each, f"{key}.{k}") for k, each in inside.items()))
        if isinstance(inside, list) and inside and all(isinstance(each, dict) for each in inside):
            return set().union(*(leaves(each, f"{key}.{k}") for k, each in enumerate(inside)))
        return {key[1:]}

    given = file.keys.given
    assert len(given) == len(set(given))
    rest = leaves({key: each for key, each in file.tables.items() if key != "search"})
    assert {key for key in given if not key.startswith("search.")} == rest
    assert set(file.keys.unused()) <= set(given)


@pytest.mark.parametrize(
    "name", led_by([*QUICK, *(each for each in ALL if each not in QUICK)], len(QUICK))
)
def test_examples_have_no_key_in_vain(name: str, tmp_path: Path) -> None:
    file = read_design_file(EXAMPLES / f"{name}.toml")
    shell = make_shell(file, clash="unexamined", skip=("remedies", "verification"))
    assert file.keys.unused(beside=("search", "workshop")) == ()
    assert write_kit(shell, tmp_path / "kit").unused == ()
    model = write_kit(shell, tmp_path / "paper", paper=True).unused
    assert {key.rpartition(".")[2] for key in model} <= Workshop.model_fields.keys()
    assert "workshop.creases" not in model


@pytest.mark.parametrize("name", led_by(LOADED, 0))
def test_loaded_examples_have_no_key_in_vain(name: str) -> None:
    ran = orishell("structure", EXAMPLES / f"{name}.toml")
    assert ran.stdout
    assert named(ran.stderr) == set()


def test_a_table_by_itself_notes_nothing() -> None:
    class Some(Table):
        number: int = 1

    assert Some(number=2).replace_unchecked(number=3).number == 3
    assert Some(number=2).noting(set()).number == 2
