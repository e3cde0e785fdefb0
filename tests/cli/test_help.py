"""What ``--help`` prints: all that the program's own texts say, brackets too."""

from __future__ import annotations

import inspect
from collections.abc import Iterator

import pytest
import typer

from command_line import orishell
from orishell.cli.main import app

GROUP = typer.main.get_group(app)


def texts(name: str) -> Iterator[str]:
    """What a command's function says of itself, its arguments and its options."""
    command = GROUP.commands[name]
    assert command.callback is not None
    yield inspect.getdoc(command.callback) or ""
    for parameter in inspect.signature(command.callback, eval_str=True).parameters.values():
        if parameter.annotation is not typer.Context:  # which is no argument of its users
            (described,) = parameter.annotation.__metadata__
            yield described.help


def words(text: str) -> str:
    return " ".join(text.split())


@pytest.mark.parametrize("name", GROUP.commands)
def test_help_says_all_that_its_texts_say(name: str) -> None:
    printed = orishell(name, "--help")
    assert (printed.returncode, printed.stderr) == (0, "")
    said = list(texts(name))
    assert len(said) > 1
    for text in said:
        assert words(text) in words(printed.stdout)


def test_tables_are_named_in_brackets() -> None:
    # A mark-up language that has [names] of its own leaves these out.
    for name, table in (("structure", "[structure]"), ("search", "[search]")):
        assert f"with a table {table}." in words(orishell(name, "--help").stdout)


def test_the_list_of_commands_is_not_cut() -> None:
    listed = words(orishell("--help").stdout)
    assert "..." not in listed.replace("[ARGS]...", "")
    for name, command in GROUP.commands.items():
        assert f"{name} {words(command.help or '').partition('. ')[0]}" in listed
