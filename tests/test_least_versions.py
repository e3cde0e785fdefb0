"""What ``.ci/least`` installs, and what it tries, are what the package needs and has."""

from __future__ import annotations

import sys

import pytest

from command_line import orishell
from every_command import COMMANDS, EXAMPLES, commands
from least_versions import ROOT, needed, project, pythons
from orishell.cli.main import app

EXTRAS = ["cluster", "notebook", "print", "studio"]
"""Those that ``.ci/least`` installs."""


def test_every_package_has_a_least_version() -> None:
    lines = set(needed(EXTRAS, least=True))
    assert all("==" in line for line in lines)
    # Every package that is imported by the package itself, and those of extras of extras.
    assert {"numpy", "scipy", "fastapi", "distributed", "pymoo", "lib3mf"} <= {
        line.partition("==")[0] for line in lines
    }
    assert {line.replace("==", ">=") for line in lines} == set(needed(EXTRAS, least=False))
    assert f"extras=({' '.join(EXTRAS)})" in (ROOT / ".ci/least").read_text()


def test_no_least_version_is_beyond_what_tests_run_with() -> None:
    pinned = dict(
        line.split("==") for line in (ROOT / "constraints.txt").read_text().splitlines()[1:]
    )
    pinned = {name.lower().replace("_", "-"): found for name, found in pinned.items()}

    def numbers(text: str) -> list[int]:
        return [int(each) for each in text.split(".") if each.isdecimal()]

    for line in needed(EXTRAS, least=True):
        name, least = line.split("==")
        assert numbers(least) <= numbers(pinned[name.lower()])


def test_pythons_are_those_that_the_package_asks_for() -> None:
    assert project()["requires-python"] == f">={pythons()[0]}"
    assert ".".join(map(str, sys.version_info[:2])) in pythons()


def test_every_command_is_tried() -> None:
    said = orishell("--help").stdout
    registered = {each.callback.__name__ for each in app.registered_commands if each.callback}
    assert commands() == registered
    assert all(name in said for name in registered)


@pytest.mark.parametrize("line", COMMANDS)
def test_what_is_tried_is_there(line: str) -> None:
    for word in line.split():
        if word.startswith("@"):
            assert (EXAMPLES / word[1:]).exists()
