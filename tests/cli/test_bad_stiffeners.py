"""Bad values of the table [stiffeners]: one line, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import orishell

SHELL = """
[shell]
family = "orthodiagonal"
unit = "m"

[target.f]
formula = "-x**2"
range = [-1, 1]

[target.g]
formula = "0.1*cos(2*pi*x)"
range = [0, 1]

[pattern]
rows = 3
columns = 3
flap = {flap}
heading_deg = 90
spacing = "equal"
{more}
"""
NOT_READ = {
    "": "key is missing",
    'kind = "gusset"': "expected 'gussets'",
    "kind = 1": "expected 'gussets'",
    'kind = ["gussets"]': "expected 'gussets'",
    'kind = ["gussets", "boxes"]': "expected 'gussets', 'boxes' or 'skin'",
    'rows = "valley"': "got 'valley'",
    "rows = 1": "a list, in brackets",
    "rows = true": "a list, in brackets",
    "rows = [1.5]": "a whole number",
    'rows = ["1"]': "expected 'valleys', 'crests' or 'all' or a list, each entry a whole number",
    "rows = [1, -1]": "at least 0",
    "rows = [0]": "numbers from 1 to 3",
    "rows = [4]": "numbers from 1 to 3",
    "rows = []": "no row is named",
    'columns = "some"': "got 'some'",
    "columns = 0": "at least 1",
    "columns = -2": "at least 1",
    "columns = 2.5": "a whole number",
    "columns = [3]": "numbers from 0 to 2",
    "columns = []": "no column is named",
    "share = 0": "greater than 0",
    "share = 1": "less than 1",
    "share = nan": "a finite number",
    'share = "most"': "expected a number",
    "size = 0.9": "unknown key",
    "thickness = 0": "greater than 0",
    "thickness = -0.004": "at least 0",
    "thickness = 1e-20": "at least 1e-15",
    "thickness = inf": "a finite number",
    'thickness = "4 mm"': "expected a number",
    "thickness = true": "expected a number",
    "thickness = 0.004": "with a thickness",
    'material = "wood"': '"birch plywood", ',
    'material = "Steel"': '"steel"',
    'material = ""': "no such material",
    "material = 1": "expected a text",
    'material = "steel"': "with a thickness",
    "bolts = 0.1": "expected a table",
    "bolts = { hole = 0.006 }": "key is missing",
    "bolts = {}": "bolts hole, spacing: these keys are missing",
    "bolts = { hole = 0, spacing = 0.1 }": "greater than 0",
    "bolts = { hole = 0.006, spacing = -0.1 }": "at least 0",
    "bolts = { hole = 0.006, spacing = 0.01 }": "two diameters, 0.012",
    "bolts = { hole = 0.006, spacing = 0.1, edge = 0.005 }": "diameter of a hole, 0.006",
    'bolts = { hole = 0.006, spacing = "auto" }': "expected a number",
    "bolts = { hole = 0.006, spacing = 0.1, nuts = 2 }": "unknown key",
    "bolts = { hole = 0.006, spacing = 0.1 }": "with a thickness",
}
"""Lines of the table, and what is said of them; those without a kind are of gussets."""


BOXES = {
    "rows = [0]": "numbers from 1 to 3",
    "rows = [9]": "numbers from 1 to 3",
    "rows = []": "no row is named",
    'rows = "both"': "got 'both'",
    "rows = 2": "a list, in brackets",
    'rows = ["1"]': "a whole number",
    "columns = [9]": "numbers from 0 to 2",
    "columns = []": "no column is named",
    "columns = 0": "at least 1",
    'columns = "ends"': "got 'ends'",
    "columns = [1.5]": "a whole number",
    "share = 0": "greater than 0",
    "share = 1": "less than 1",
    "share = 1.5": "less than 1",
    "share = -0.5": "greater than 0",
    'share = "most"': "expected a number",
    'share = "0.5"': "write 0.5 without quotes",
    "share = [0.5, 0.6]": "expected a number",
    "joined_from = 0.5": "unknown key",
    "plates = 4": "unknown key",
    "thickness = 0.004": "it is of",
    'material = "steel"': "it is of",
    "bolts = { hole = 0.006, spacing = 0.1 }": "it is of",
}
"""Lines beside kind = "boxes", and what is said of them."""


SKIN = {
    "": "needs a sheet whose columns are images of one another",
    "gap = 0": "greater than 0",
    "gap = -1": "at least 0",
    'gap = "wide"': "expected a number",
    "gap = true": "expected a number",
    "walls = 0": "at least 1",
    "walls = [1.5]": "a whole number",
    'walls = "none"': "got 'none'",
    "walls = true": "a list, in brackets",
    "share = 0.5": 'of "gussets" or "boxes"',
    'rows = "all"': 'of "gussets" or "boxes"',
    'columns = "none"': 'of "gussets" or "boxes"',
    "thickness = 0.004": 'of "gussets"',
    "plates = 4": "unknown key",
}
"""Lines beside kind = "skin", and what is said of them; that of no line is of the family."""


def refusal(path: Path, line: str, more: str = "", flap: str = "0") -> tuple[int | str, str]:
    """How the program ends, and what it says in its one line; nothing is written."""
    kind = "" if not line or line.startswith("kind") else 'kind = "gussets"\n'
    text = SHELL.format(flap=flap, more=more) + f"[stiffeners]\n{kind}{line}\n"
    return refused(path, text)


def refused(path: Path, text: str) -> tuple[int | str, str]:
    """Likewise of a design file."""
    file = path / "shell.toml"
    file.write_text(text)
    done = orishell("design", file, "--out", path / "out")
    assert not (path / "out").exists()
    assert done.stdout == ""
    (said,) = done.stderr.splitlines()
    return done.returncode, said


@pytest.mark.parametrize("line", NOT_READ)
def test_what_cannot_be_read_is_said_in_one_line(tmp_path: Path, line: str) -> None:
    status, said = refusal(tmp_path, line)
    assert status == 2
    assert "[stiffeners]" in said
    assert NOT_READ[line] in said


@pytest.mark.parametrize("line", BOXES)
def test_what_boxes_cannot_be_is_said_in_one_line(tmp_path: Path, line: str) -> None:
    status, said = refusal(tmp_path, f'kind = "boxes"\n{line}')
    assert status == 2
    assert "[stiffeners]" in said
    assert BOXES[line] in said


@pytest.mark.parametrize("line", SKIN)
def test_what_a_second_skin_cannot_be_is_said_in_one_line(tmp_path: Path, line: str) -> None:
    status, said = refusal(tmp_path, f'kind = "skin"\n{line}')
    assert status == 2
    assert "[stiffeners]" in said
    assert SKIN[line] in said


CURVE = '[target.inner]\nformula = "-x**2 - 0.5"\n'
RANGE = "range = [-0.7, 0.7]\n"
INNER = {
    f'[stiffeners]\nkind = "skin"\ngap = 0.1\n{CURVE}{RANGE}': "of its own, or is as far",
    f'[stiffeners]\nkind = "boxes"\n{CURVE}{RANGE}': "a curve of a second skin needs one",
    f"{CURVE}{RANGE}": "a curve of a second skin needs one",
    f"{CURVE}": "[target.inner]: a formula needs its range",
    f"{CURVE}{RANGE}slope = 2\n": "unknown key",
    f"{CURVE}{RANGE}[target.fit]\nwidth = 2\n": "goes with f and g, without fit",
}


@pytest.mark.parametrize("tables", INNER)
def test_what_a_curve_of_a_second_skin_cannot_be_is_said_in_one_line(
    tmp_path: Path, tables: str
) -> None:
    file = tmp_path / "shell.toml"
    file.write_text(SHELL.format(flap=0, more=tables))
    done = orishell("design", file, "--out", tmp_path / "out")
    assert done.returncode == 2
    assert INNER[tables] in done.stderr
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("kind", ["gussets", "boxes"])
def test_a_gap_is_of_a_second_skin(tmp_path: Path, kind: str) -> None:
    status, said = refusal(tmp_path, f'kind = "{kind}"\ngap = 0.1')
    assert status == 2
    assert 'it is of "skin"' in said


BEVEL = 'thickness = 0.02\ngap = 0.004\nconstruction = "bevel"'
THIN = 'thickness = 0.005\ngap = 0.002\nconstruction = "bevel"'
STRUCTURE = '[structure]\nmodulus = 8e9\nsupports = [{ at = "feet", kind = "pinned" }]'
NOT_MADE = {
    "no room": ("share = 0.01", f"[panel]\n{BEVEL}", "0", 1, "too far off"),
    "whole boards": ("", '[panel]\nthickness = 0.01\nconstruction = "hinged"', "0", 2, "beside"),
    "between flaps": ("columns = [1]", "", "0.1", 2, "numbers from 2 to 2"),
    "too thick": ("thickness = 2", f"[panel]\n{THIN}", "0", 1, "thickness = "),
    "farther apart than edges are long": (
        "bolts = { hole = 0.006, spacing = 3 }",
        *(f"[panel]\n{THIN}", "0", 1, "no two bolts along an edge"),
    ),
    "no room for holes": (
        "bolts = { hole = 0.2, spacing = 0.4 }",
        *(f"[panel]\n{THIN}", "0", 1, "room for 0 between holes"),
    ),
    "boxes on whole boards": (
        'kind = "boxes"',
        *('[panel]\nthickness = 0.01\nconstruction = "hinged"', "0", 2, "beside"),
    ),
    "boxes between flaps": ('kind = "boxes"', "", "0.1", 2, "take the place of box girders"),
    "boxes between flaps that are clipped on": (
        'kind = "boxes"',
        *('[deployment]\nfrom = "pack"\nflap_attachment = "clipped"', "0.1", 2),
        "take the place of box girders",
    ),
    "as large as there is room for, and there is none": (
        'kind = "boxes"\nshare = "auto"',
        *(f"[panel]\n{BEVEL.replace('0.02', '0.2')}", "0", 1, "too little is left"),
    ),
    "boxes of thick boards": (
        'kind = "boxes"',
        *(
            '[panel]\nthickness = 0.2\ngap = 0.004\nconstruction = "bevel"',
            "0",
            1,
            "too little is left",
        ),
    ),
    "far too thick": ("thickness = 1e300", f"[panel]\n{THIN}", "0", 1, "too far off"),
    "no room for a core": (
        'thickness = 0.002\nmaterial = "GFRP skins on foam"',
        f"[panel]\n{THIN}\n{STRUCTURE}",
        *("0", 2, "faces leave no room for a core"),
    ),
}
"""Lines of the table, other tables, the width of flaps, the status and what is said."""


@pytest.mark.parametrize("case", NOT_MADE)
def test_what_cannot_be_made_is_said_in_one_line(tmp_path: Path, case: str) -> None:
    line, more, flap, status, words = NOT_MADE[case]
    ended, said = refusal(tmp_path, line or 'kind = "gussets"', more, flap)
    assert ended == status
    assert words in said


SLIT = """[shell]
family = "flat-foldable"
unit = "m"
[pattern]
sheet = "lists"
rows = 3
columns = 3
row_folds_deg = [80, -95, 85]
column_folds_deg = [60, -70, 65]
flap = 0.1
[stiffeners]
kind = "boxes"
"""
"""Borders that are not straight."""


def test_flaps_that_are_slit_have_no_box_girders(tmp_path: Path) -> None:
    status, said = refused(tmp_path, SLIT)
    assert status == 2
    assert "slit from each other leave no room for box girders" in said
    assert 'flap_attachment = "clipped"' in said


def test_there_is_one_table_of_stiffeners(tmp_path: Path) -> None:
    """Gussets in some rows and box girders over others are not one design."""
    both = '[[stiffeners]]\nkind = "gussets"\n[[stiffeners]]\nkind = "boxes"\n'
    status, said = refused(tmp_path, SHELL.format(flap="0", more=both))
    assert status == 2
    assert "[stiffeners]" in said
    assert "expected a table" in said
