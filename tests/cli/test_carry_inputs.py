"""Bad inputs of ties, gussets, rails, structures: one line, and ``--make-it-carry`` writes nothing.

Status 2 where the input is wrong, 1 where there is no such design.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import orishell
from small_arch import SMALL_ARCH

GOOD = f"""{SMALL_ARCH}[deployment]
from = "pack"
ties = "feet"
[structure]
material = "birch plywood"
thickness = 0.009
crease_stiffness = "free"
tie_stiffness = 1e6
tie_strength = 2e4
cells = 1
supports = [{{ at = "feet", kind = "pinned" }}]
[[load_case]]
name = "snow"
snow = {{ ground = 2000, arrangement = "undrifted" }}
"""
RAIL = 'rail = {{ material = "{}", width = {}, height = 0.04, wall = {} }}\ncells'
OTHER = """[[load_case]]
name = "snow"
snow"""

BAD: list[tuple[str, str, str]] = [
    # ties
    ('ties = "feet"', 'ties = "fold"', "ties"),
    ('ties = "feet"', "ties = 3", "ties"),
    ('ties = "feet"', "ties = { folds = [] }", "folds"),
    ('ties = "feet"', "ties = { folds = [0] }", "folds"),
    ('ties = "feet"', "ties = { folds = [6] }", "folds"),
    ('ties = "feet"', "ties = { folds = [1.5] }", "folds"),
    ('ties = "feet"', 'ties = { folds = "all" }', "folds"),
    ('ties = "feet"', "ties = { folds = [1], rows = 2 }", "rows"),
    ('ties = "feet"', "ties = [[[0, 1]]]", "ties"),
    ('ties = "feet"', "ties = [[[0, 1], [6, 2]]]", "two columns"),
    ('ties = "feet"', "ties = [[[0, 1], [0, 1]]]", "itself"),
    ('ties = "feet"', "ties = [[[0, 1], [9, 1]]]", "beyond the rows"),
    ("tie_stiffness = 1e6", "tie_stiffness = -1", "tie_stiffness"),
    ("tie_stiffness = 1e6", 'tie_stiffness = "stiff"', "tie_stiffness"),
    ("tie_strength = 2e4", "tie_strength = nan", "tie_strength"),
    ("tie_strength = 2e4", "tie_strength = -5", "tie_strength"),
    # the structure
    ('"birch plywood"', '"oak"', "material"),
    ("thickness = 0.009", "thickness = 0", "thickness"),
    ("thickness = 0.009", "grain = 3", "grain"),
    ('"free"', "[1, 2, 3]", "crease_stiffness"),
    ("cells = 1", "cells = 0", "cells"),
    ("cells = 1", 'cells = 1\nline_strength = { kind = "welded" }', "kind"),
    ("cells = 1", "cells = 1\nline_strength = { pull = -1 }", "pull"),
    ("cells", RAIL.format("mithril", 0.06, 0.003), "material"),
    ("cells", RAIL.format("steel", -0.06, 0.003), "width"),
    ("cells", RAIL.format("steel", 0.06, 0.03), "wall"),
    ("cells", 'rail = { material = "steel", width = 0.06 }\ncells', "height"),
    ('"pinned"', '"glued"', "supports"),
    ('at = "feet"', 'at = "roof"', "supports"),
    ('[{ at = "feet", kind = "pinned" }]', "[]", "supports"),
    ("ground = 2000", "ground = -1", "ground"),
    (OTHER, 'combinations = "EN 1999"\n' + OTHER, "combinations"),
    # gussets
    ("[structure]", '[stiffeners]\nkind = "ribs"\n[structure]', "kind"),
    ("[structure]", '[stiffeners]\nkind = "gussets"\nshare = 1.5\n[structure]', "share"),
    ("[structure]", '[stiffeners]\nkind = "gussets"\nrows = "hills"\n[structure]', "rows"),
    (
        "[structure]",
        '[stiffeners]\nkind = "gussets"\nrows = [99]\n[structure]\nedge_strength = 1e5',
        "row",
    ),
    ("[structure]", '[stiffeners]\nkind = "gussets"\ncolumns = 0\n[structure]', "columns"),
]


def refused(directory: Path, *options: str) -> str:
    """What is said where nothing is written."""
    before = {each: each.read_bytes() for each in directory.rglob("*") if each.is_file()}
    done = orishell("structure", "arch.toml", "--make-it-carry", *options, cwd=directory)
    assert done.returncode in (1, 2), done.stdout
    assert done.stdout == ""
    said = done.stderr.strip().splitlines()
    assert len(said) == 1, done.stderr
    after = {each: each.read_bytes() for each in directory.rglob("*") if each.is_file()}
    assert after == before
    assert not (directory / "out").is_dir()
    return said[0]


@pytest.mark.parametrize(("old", "new", "named"), BAD, ids=[new[:40] for _, new, _ in BAD])
def test_bad_values_are_refused_in_one_line(tmp_path: Path, old: str, new: str, named: str) -> None:
    assert GOOD.count(old) >= 1
    (tmp_path / "arch.toml").write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    assert named in refused(tmp_path, "--out", "out")


def test_files_that_have_nothing_to_carry(tmp_path: Path) -> None:
    assert "arch.toml" in refused(tmp_path)
    (tmp_path / "arch.toml").write_text(SMALL_ARCH, encoding="utf-8")
    assert "there is no structure to analyse" in refused(tmp_path, "--out", "out")
    (tmp_path / "arch.toml").write_text("[shell", encoding="utf-8")
    assert "arch.toml" in refused(tmp_path, "--json")


def test_places_that_are_taken(tmp_path: Path) -> None:
    (tmp_path / "arch.toml").write_text(GOOD, encoding="utf-8")
    (tmp_path / "place").write_text("a file", encoding="utf-8")
    assert "place" in refused(tmp_path, "--out", "place")
    taken = tmp_path / "full" / "carries-2.toml"
    taken.parent.mkdir()
    taken.write_text("mine", encoding="utf-8")
    assert "carries-2.toml" in refused(tmp_path, "--out", "full")
