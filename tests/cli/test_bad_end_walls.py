"""Bad values of [[end_wall]]: one message, and nothing is written."""

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
flap = 0
heading_deg = 90
spacing = "equal"

{table}
"""
LAST = '[[end_wall]]\nat = "last"\n'
NOT_READ = {
    "[[end_wall]]": "key is missing",
    '[end_wall]\nat = "last"': "a list",
    'end_wall = "last"': "list",
    '[[end_wall]]\nat = "front"': "expected 'first' or 'last'",
    "[[end_wall]]\nat = 1": "expected 'first' or 'last'",
    '[[end_wall]]\nat = ["first", "last"]': "expected 'first' or 'last'",
    LAST + LAST: "two end walls close one end",
    LAST + "gap = -0.1": "at least 0",
    LAST + 'gap = "wide"': "expected a number",
    LAST + "gap = nan": "a finite number",
    LAST + "gap = 1e-20": "at least 1e-15",
    LAST + "width = 2": "unknown key",
    LAST + "door = true": "expected a table",
    LAST + "door = {}": "these keys are missing",
    LAST + "door = { width = 0.9 }": "key is missing",
    LAST + "door = { width = 0, height = 2 }": "greater than 0",
    LAST + "door = { width = 0.9, height = -2 }": "at least 0",
    LAST + 'door = { width = "90 cm", height = 2 }': "expected a number",
    LAST + "door = { width = 0.9, height = 2, offset = inf }": "a finite number",
    LAST + "door = { width = 0.9, height = 2, leaf = 1 }": "unknown key",
}
"""Tables, and what is said of them."""
NOT_MADE = {
    LAST + "gap = 3": "too far from the end that it closes",
    LAST + "door = { width = 0.4, height = 3 }": "has no room for its door",
    LAST + "door = { width = 3, height = 0.4 }": "goes past the wall",
    LAST + "door = { width = 0.4, height = 0.4, offset = 9 }": "goes past the wall",
}
"""Those that are read and cannot be made."""


@pytest.mark.parametrize("table", NOT_READ)
def test_what_is_no_end_wall_is_refused_by_name(table: str, tmp_path: Path) -> None:
    said = _refused(table, tmp_path, 2)
    assert NOT_READ[table] in said


@pytest.mark.parametrize("table", NOT_MADE)
def test_what_has_no_room_is_refused_with_what_has(table: str, tmp_path: Path) -> None:
    said = _refused(table, tmp_path, 1)
    assert NOT_MADE[table] in said
    assert "emed" in said or "works" in said


def _refused(table: str, where: Path, status: int) -> str:
    """What a design says, on one line, before it writes anything."""
    text = SHELL.format(table=table)
    if table.startswith("end_wall ="):
        text = f"{table}\n{SHELL.format(table='')}"
    (where / "shell.toml").write_text(text, encoding="utf-8")
    ran = orishell("design", "shell.toml", "--out", "out", cwd=where)
    assert ran.returncode == status, ran.stderr
    assert "Traceback" not in ran.stderr
    assert [each.name for each in where.iterdir()] == ["shell.toml"]
    assert "end_wall" in ran.stderr
    return " ".join(ran.stderr.split())
