"""The table [workshop]: defaults, faults, palettes of one's own."""

from importlib.resources import files
from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file, read_workshop, starter_file
from orishell.workshop import DEFAULT, Workshop


def read(tmp_path: Path, table: str) -> Workshop:
    path = tmp_path / "shell.toml"
    path.write_text(starter_file("parallel-repeating") + "\n[workshop]\n" + table)
    settings = read_design_file(path).workshop
    assert dict(read_workshop(path)) == dict(settings)
    return settings


def test_defaults_are_those_of_the_workshop(tmp_path: Path) -> None:
    assert Workshop().beside(None) == DEFAULT
    assert read(tmp_path, "") == DEFAULT


def test_all_keys(tmp_path: Path) -> None:
    text = """
    palette = "lightburn"
    creases = "dashes"
    dash = 0.05
    duty = 0.5
    corner_gap = 0.01
    relief_hole = 0.02
    labels = "both"
    title_block = false
    stock = [1.2, 0.8]
    roll = [1.5, 50]
    hinge_stock = 2
    tie_stock = 50
    tie_end = 0.1
    row_hinge = "piano hinge"
    column_hinge = "tape"
    stock_price = 60
    roll_price = 180
    hinge_price = 12
    tie_price = 40
    hinge_linear_density = 0.6
    tie_linear_density = 0.2
    margin = 0.01
    spacing = 0.005
    joint = "strips"
    joint_width = 0.03
    paper = "A3"
    paper_scale = 0.1
    language = "de"
    model_scale = 0.05
    areal_density = 1.4
    cutting_error = 0.0003
    cutting_bias = 0.0001
    cutting = "boards"
    """
    settings = read(tmp_path, text)
    assert settings.stock == (1.2, 0.8)
    given = dict(line.split(" = ", 1) for line in map(str.strip, text.splitlines()) if line)
    # Every setting is named here, and none has its default.
    assert set(given) == set(dict(settings))
    assert all(value != getattr(DEFAULT, key) for key, value in dict(settings).items())


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ("duty = 1.0", "[workshop] duty"),
        ('creases = "dotted"', "[workshop] creases"),
        ("stock = [1.0]", "[workshop] stock"),
        ("stock = [1.0, -1.0]", "[workshop] stock[1]"),
        ("kerf = 0.1", "[workshop] kerf"),
        ('palette = "mine.toml"', "[workshop] palette"),
        ('palette = "lightbrun"', "lightburn"),
        ("roll = [1.5]", "[workshop] roll"),
        ("hinge_stock = 0", "[workshop] hinge_stock"),
        ("tie_end = -0.1", "[workshop] tie_end"),
        ('row_hinge = "screws"', "[workshop] row_hinge"),
        ("tie_price = -1", "[workshop] tie_price"),
        ("tie_linear_density = -1", "[workshop] tie_linear_density"),
        ('hinge_linear_density = "light"', "[workshop] hinge_linear_density"),
        ("margin = -1", "[workshop] margin"),
        ("areal_density = 1e308", "at most 1e+12"),
        ("areal_density = 5e-324", "got 5e-324, expected 0, or a value of at least 1e-15"),
        ("dash = 1e-300", "at least 1e-12"),
        ("stock = [1.0, 1e200]", "[workshop] stock[1]"),
    ],
)
def test_faults_name_the_key(table: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, table)
    assert str(tmp_path / "shell.toml") in str(caught.value)
    assert says in str(caught.value)
    with pytest.raises(InputError) as caught:
        read_workshop(tmp_path / "shell.toml")
    assert says in str(caught.value)


def test_a_palette_of_ones_own_lies_beside_the_design_file(tmp_path: Path) -> None:
    import tomllib

    known = tomllib.loads(files("orishell.workshop").joinpath("palettes.toml").read_text())
    name, table = next(iter(known.items()))
    lines = [f"[{name}]", f"note = {table['note']!r}"]
    for layer, pen in table.items():
        if isinstance(pen, dict):
            values = ", ".join(f"{key} = {value!r}" for key, value in pen.items())
            lines.append(f"{layer} = {{ {values} }}")
    (tmp_path / "mine.toml").write_text("\n".join(lines))
    assert read(tmp_path, 'palette = "mine.toml"').palette == str(tmp_path / "mine.toml")
