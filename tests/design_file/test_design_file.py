"""Design files: what is accepted, and one clear message for what is not."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.design import PanelSpec
from orishell.design_file import read_design_file, starter_file

GOOD = """
[shell]
family = "parallel-repeating"
unit = "m"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "5*sin(pi*x/10)"
range = [0, 20]
[pattern]
rows = 9
columns = 11
flap = 0.3
xi_deg = 50
"""


def write(directory: Path, text: str) -> Path:
    path = directory / "shell.toml"
    path.write_text(text)
    return path


def test_starter_file_is_a_good_one(tmp_path: Path) -> None:
    file = read_design_file(write(tmp_path, starter_file("parallel-repeating")))
    assert (file.family, file.unit, file.frames) == ("parallel-repeating", "m", 25)
    assert (file.pattern.rows, file.pattern.columns) == (9, 11)
    np.testing.assert_allclose(file.f.position(0.5), [0.5, -0.25])
    np.testing.assert_allclose(file.g.position(5.0), [5, 5])


def test_the_starter_explains_every_key_of_panels(tmp_path: Path) -> None:
    """What its comments say of [panel] is a table with all keys, and is read with its defaults."""
    lines = starter_file("parallel-repeating").partition("# [panel]")[2].partition("\n\n")[0]
    table = "\n".join(line.removeprefix("# ") for line in lines.splitlines()[1:])
    assert set(tomllib.loads(table)) == set(PanelSpec.model_fields)
    panel = read_design_file(write(tmp_path, f"{GOOD}[panel]\n{table}")).panel
    assert panel == PanelSpec(thickness=0.01, membrane=0.001)


def test_pair_of_formulas_and_scale(tmp_path: Path) -> None:
    text = GOOD.replace('"-x**2"\nrange', '["t", "-t**2"]\nscale = 2\nrange')
    np.testing.assert_allclose(read_design_file(write(tmp_path, text)).f.position(0.5), [1, -0.5])


def test_points_are_read_beside_the_design_file(tmp_path: Path) -> None:
    (tmp_path / "profile.csv").write_text("0,0\n1,1\n2,0\n")
    points = GOOD.replace('formula = "-x**2"\nrange = [-1, 1]', 'points = "profile.csv"')
    assert read_design_file(write(tmp_path, points)).f.breaks == ()
    polyline = points.replace('profile.csv"', 'profile.csv"\nsmooth = false')
    assert len(read_design_file(write(tmp_path, polyline)).f.breaks) == 1


FAULTS = {
    "unknown family": (("parallel-repeating", "miura"), "[shell] family", "parallel-repeating"),
    "unknown unit": (('unit = "m"', 'unit = "yd"'), "[shell] unit", "'ft'"),
    "unknown key": (("rows", "row"), "[pattern] row:", "Did you mean rows?"),
    "unknown key in a target": (
        ("range = [-1", "rang = [-1"),
        "[target.f] rang",
        "Did you mean range?",
    ),
    "unknown table": (("[pattern]", "[patern]"), "[patern]", "Did you mean [pattern]?"),
    "missing key": (("columns = 11", ""), "[pattern] columns", "missing"),
    "missing table": (("[shell]", "[motion]"), "[shell]", "missing"),
    "text for a number": (("rows = 9", 'rows = "nine"'), "[pattern] rows", "a whole number"),
    "text for xi": (("xi_deg = 50", 'xi_deg = "wide"'), "[pattern] xi_deg", "a number or 'auto'"),
    "a fraction of a row": (("rows = 9", "rows = 9.5"), "[pattern] rows", "a whole number"),
    "true for a number": (("rows = 9", "rows = true"), "[pattern] rows", "a whole number"),
    "nan": (("flap = 0.3", "flap = nan"), "[pattern] flap", "a finite number"),
    "infinite range": (("[0, 20]", "[0, inf]"), "[target.g] range", "a finite number"),
    "even rows": (("rows = 9", "rows = 8"), "[pattern] rows: ", "(7 or 9)"),
    "no rows": (("rows = 9", "rows = -1"), "[pattern] rows", "at least 1"),
    "too many rows": (("rows = 9", "rows = 1000000001"), "rows, columns", "312 GB"),
    "reversed range": (("[0, 20]", "[20, 0]"), "[target.g] range", "reversed"),
    "empty range": (("[0, 20]", "[20, 20]"), "[target.g] range", "empty"),
    "half a range": (("[0, 20]", "[20]"), "[target.g] range", "2 entries"),
    "no range": (("range = [-1, 1]", ""), "[target.f]", "needs its range"),
    "both sources": (("range = [-1, 1]", 'points = "a.csv"'), "[target.f]", "either"),
    "xi of 180": (("xi_deg = 50", "xi_deg = 180"), "[pattern] xi_deg", "at most 179.9"),
    "negative flap": (("flap = 0.3", "flap = -0.3"), "[pattern] flap", "at least 0"),
    "attack": (("-x**2", "__import__('os')"), "[target.f] formula", "character 12"),
    "fault in a formula": (("-x**2", "-x~2"), "[target.f] formula", "character 3"),
    "one frame": (("[pattern]", "[motion]\nframes = 1\n[pattern]"), "[motion] frames", "least 2"),
    "a decimal comma in a text": (
        ("flap = 0.3", 'flap = "0,3"'),
        "[pattern] flap",
        "write 0.3 with",
    ),
    "a number in quotes": (("rows = 9", 'rows = "9"'), "[pattern] rows", "write 9 without quotes"),
    "decimal commas in a list": (
        ("[0, 20]", "[0,5, 20]"),
        "[target.g] range",
        "Remedy: numbers have a decimal point",
    ),
    "a decimal comma in a formula": (("-x**2", "-0,5*x**2"), "[target.f] formula", "write 0.5"),
    "a decimal comma in a range": (("[0, 20]", '["0,5", 20]'), "range[0]", "write 0.5"),
    "a decimal comma": (("flap = 0.3", "flap = 0,3"), "    flap = 0,3\n            ^", "write 0.3"),
    "a text without quotes": (
        ('family = "parallel-repeating"', "family = parallel-repeating"),
        "    family = parallel-repeating\n             ^",
        'put texts in quotes: "parallel-repeating"',
    ),
    "a number for a range": (("[0, 20]", "20"), "[target.g] range", "a list, in brackets"),
    "one of several tables": (
        ("[pattern]", '[load_case]\nname = "snow"\n[pattern]'),
        "[[load_case]]: ",
        "write the table's name in double brackets",
    ),
    "not TOML": (("[pattern]", "[pattern"), "shell.toml", "not TOML"),
    "missing points": (
        ('formula = "-x**2"\nrange = [-1, 1]', 'points = "none.csv"'),
        "none.csv",
        "does not exist",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_faults(tmp_path: Path, name: str) -> None:
    (old, new), where, says = FAULTS[name]
    assert old in GOOD
    with pytest.raises(InputError) as caught:
        read_design_file(write(tmp_path, GOOD.replace(old, new)))
    message = str(caught.value)
    assert "shell.toml" in message
    assert where in message
    assert says in message
    assert caught.value.exit_status == 2


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("rows = 9", "rows = " + "9" * 5000),
        ("columns = 11", "columns = " + "1" * 400),
        ("rows = 9", "rows = " + "[" * 100_000),
        ('formula = "-x**2"\nrange = [-1, 1]', 'points = "a\\u0000b.csv"'),
        ("range = [-1, 1]", "range = [-1, 1]\nscale = -1"),
        ("[pattern]", "[motion]\nframes = 1000\n[pattern]"),
    ],
)
def test_attacks_are_refused(tmp_path: Path, old: str, new: str) -> None:
    text = GOOD.replace(old, new)
    if "frames" in new:
        text = text.replace("rows = 9", "rows = 999").replace("columns = 11", "columns = 999")
    with pytest.raises(InputError, match=r"shell\.toml|b\.csv"):
        read_design_file(write(tmp_path, text))


def test_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    assert read_design_file(write(tmp_path, "\ufeff" + GOOD)).family == "parallel-repeating"


def test_all_faults_are_named_at_once(tmp_path: Path) -> None:
    text = GOOD.replace("rows = 9", "rows = 8.5").replace("columns = 11", "colums = 11")
    with pytest.raises(InputError) as caught:
        read_design_file(write(tmp_path, text))
    message = str(caught.value)
    assert message.count("shell.toml") == 2  # rows; colums, which is meant for columns


def test_missing_and_unreadable_files(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_design_file(tmp_path / "none.toml")
    with pytest.raises(InputError, match="not a file"):
        read_design_file(tmp_path)
    (tmp_path / "binary.toml").write_bytes(b"\xff\x00\xfe")
    with pytest.raises(InputError, match="cannot be read"):
        read_design_file(tmp_path / "binary.toml")
    (tmp_path / "huge.toml").write_bytes(b"#" * 2_000_000)
    with pytest.raises(InputError, match="too large"):
        read_design_file(tmp_path / "huge.toml")
    (tmp_path / "empty.toml").write_text("")
    with pytest.raises(InputError, match="missing"):
        read_design_file(tmp_path / "empty.toml")
