"""The family's table in the design file: what is accepted, and one clear message otherwise."""

from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file, starter_file

GOOD = starter_file("orthodiagonal")


def write(directory: Path, text: str) -> Path:
    path = directory / "shell.toml"
    path.write_text(text)
    return path


def test_starter_file_is_a_good_one(tmp_path: Path) -> None:
    file = read_design_file(write(tmp_path, GOOD))
    assert (file.family, file.pattern.rows, file.pattern.columns) == ("orthodiagonal", 9, 13)
    assert file.pattern.design(file.f, file.g).parameters["depth"] == 0.12


@pytest.mark.parametrize(
    "pattern",
    [
        'depth = "auto"\nheading_deg = "auto"\nflap = "auto"',
        'flap_side = ["start", "auto"]\nspacing = "equal"',
        'flap_side = "end"',
        "flap = 0",
        "",
    ],
)
def test_other_good_ones(tmp_path: Path, pattern: str) -> None:
    head, tail = GOOD.split("[pattern]")
    motion = tail[tail.index("[motion]") :]
    text = f"{head}[pattern]\nrows = 9\ncolumns = 13\n{pattern}\n{motion}"
    file = read_design_file(write(tmp_path, text))
    assert file.pattern.design(file.f, file.g)


FAULTS = {
    "text for depth": (("depth = 0.12", 'depth = "deep"'), "depth", "a number or 'auto'"),
    "negative depth": (("depth = 0.12", "depth = -0.1"), "depth", "greater than 0"),
    "no depth": (("depth = 0.12", "depth = 0"), "depth", "greater than 0"),
    "infinite depth": (("depth = 0.12", "depth = inf"), "depth", "a finite number"),
    "heading beyond 180": (("heading_deg = 90", "heading_deg = 181"), "heading_deg", "at most 180"),
    "negative heading": (("heading_deg = 90", "heading_deg = -1"), "heading_deg", "at least 0"),
    "text for heading": (("heading_deg = 90", 'heading_deg = "n"'), "heading_deg", "'auto'"),
    "negative flap": (("flap = 0.15", "flap = -0.1"), "flap", "at least 0"),
    "unknown side": (("flap = 0.15", 'flap_side = "top"'), "flap_side", "'start'"),
    "three sides": (
        ("flap = 0.15", 'flap_side = ["end", "end", "end"]'),
        "flap_side",
        "2 entries",
    ),
    "even rows": (("rows = 9", "rows = 8"), "rows", "(7 or 9)"),
    "another family's key": (("depth = 0.12", "xi_deg = 50"), "xi_deg", "depth"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_faults(tmp_path: Path, name: str) -> None:
    (old, new), key, says = FAULTS[name]
    assert old in GOOD
    with pytest.raises(InputError) as caught:
        read_design_file(write(tmp_path, GOOD.replace(old, new)))
    message = str(caught.value)
    assert f"[pattern] {key}" in message
    assert says in message
