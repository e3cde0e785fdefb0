"""Docstrings of everything public say what a caller must know.

What is public is said in ``public_names``. The rule, for functions, for methods and properties of
classes, and for the fields of dataclasses:

1. There is a docstring, and its first line is one sentence.
2. Parameters of functions have an entry under "Parameters", fields of dataclasses a comment beside
   or above them. Methods, which are short, may have it or name their parameters in their text. A
   parameter or a field needs none if it is what its type says: a class of ours, a file, a
   ``Progress``, or an array whose type is named after its shape (``ALIASES``).
3. Where an array goes in or comes out, its shape is written: "(n, 2)", "(E,)", "(...)".
4. An angle is said to be in radians or degrees, where its name does not end in ``_deg``; a length
   is said to be in some unit, or relative to something.
5. Errors of ours that the function raises, itself or by what else its module has, stand under
   "Raises".
   What can be raised only by arguments that the types exclude is in ``IMPOSSIBLE``.
6. What comes from the paper says from where: its section or equation.

Methods that a protocol of ours asks for are explained once, there.
"""

from __future__ import annotations

import ast
import dataclasses
import inspect
import re
import sys
import textwrap
from collections.abc import Callable, Iterator
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import typer
from field_notes import field_notes
from numpy.typing import NDArray

import orishell.conventions.errors
from orishell.cli.main import app
from orishell.deployment import ColumnDistances
from orishell.design import Rail
from orishell.families.registry import FOLDERS
from orishell.motion import Mechanism
from orishell.motion.hinges import FreeLengths
from public_names import public_callables, public_objects

ARRAY = re.compile(r"\b(Array|ArrayLike|Integers|Booleans|Complex|Singles|NDArray)\b")
NUMERIC = re.compile(r"\b(float|Array|ArrayLike|CreaseValues)\b")
SHAPE = re.compile(r"\((?=[^()]*(?:,|\.\.\.))[\w.+*/-]+(?: ?[+*/-] ?\w+)?(?:, ?[\w.+*/ -]*)*\)")
ANGLES = {"angle", "angles", "drive", "drives", "theta", "xi", "heading", "plane", "tilt"}
LENGTHS = {"length", "lengths", "width", "height", "depth", "distance", "flap", "margin", "radius"}
ANGLE_UNIT = re.compile(r"radian|degree|\bpi\b")
LENGTH_UNIT = re.compile(
    r"\bunits?\b|\(length\b|1/length|relative|share|times|metre|pixel|\bratio|proportion"
)


def is_explained_elsewhere(name: str) -> bool:
    """Whether a method implements one of our protocols."""
    parent, _, method = name.rpartition(".")
    owner = public_objects().get(parent)
    return inspect.isclass(owner) and owner not in PROTOCOLS and any(
        method in vars(protocol) and all(hasattr(owner, each) for each in asked(protocol))
        for protocol in PROTOCOLS
    )  # fmt: skip


def asked(protocol: type) -> set[str]:
    """What a protocol asks for."""
    return {each for each in vars(protocol) if not each.startswith("_")}


ERRORS = {
    name for name, thing in vars(orishell.conventions.errors).items()
    if inspect.isclass(thing) and issubclass(thing, orishell.conventions.errors.OrishellError)
}  # fmt: skip
SOURCE = re.compile(r"paper|equations? \(\d\)")
FROM_THE_PAPER = tuple(
    f"orishell.families.{module}."
    for module in (
        *FOLDERS,
        "candidates",
        "flaps",
        "vertex",
    )  # what else is there is of the program, not the paper
)

PROTOCOLS = (Mechanism, Rail, ColumnDistances, FreeLengths)

CALLABLES = {
    name: each for name, each in public_callables().items() if not is_explained_elsewhere(name)
}
OBJECTS = public_objects()
ALIASES = {"Corners", "Positions", "Vectors"}
SPEAKING = {"Path", "Progress", *ALIASES} | {
    path.rpartition(".")[2] for path, thing in OBJECTS.items() if inspect.isclass(thing)
}


@pytest.mark.parametrize("name", sorted(CALLABLES))
def test_function(name: str) -> None:
    found = list(faults_of_function(CALLABLES[name], is_method=name not in OBJECTS))
    assert not found, f"{name}: " + "; ".join(found)


@pytest.mark.parametrize("name", sorted(set(OBJECTS) - set(CALLABLES)))
def test_class(name: str) -> None:
    found = list(faults_of_class(OBJECTS[name]))
    assert not found, f"{name}: " + "; ".join(found)


@pytest.mark.parametrize("name", [each for each in OBJECTS if each.startswith(FROM_THE_PAPER)])
def test_source(name: str) -> None:
    thing = OBJECTS[name]
    module = inspect.getdoc(sys.modules[thing.__module__]) or ""
    assert SOURCE.search(f"{inspect.getdoc(thing)}\n{module}"), f"{name}: no source"


def faults_of_function(function: Callable[..., Any], *, is_method: bool) -> Iterator[str]:
    """What the docstring of a function or method leaves out."""
    text = inspect.getdoc(function) or ""
    yield from faults_of_summary(text)
    entries = read_entries(text, "Parameters")
    signature = inspect.signature(function)
    for name, parameter in signature.parameters.items():
        if name in {"self", "cls"}:
            continue
        entry = entries.get(name)
        if entry is None and is_method and re.search(rf"\b{name}\b", text):
            entry = text
        annotation = str(parameter.annotation)
        if entry is not None:
            yield from faults_of_entry(name, annotation, entry, text)
        elif annotation not in SPEAKING:
            yield f"{name} is not explained"
    if ARRAY.search(str(signature.return_annotation)) and not SHAPE.search(text):
        yield "no shape of what is returned"
    raised = find_raised(function)
    said = text.partition("\nRaises\n------")[2]
    yield from (f"{error} is raised" for error in sorted(raised) if error not in said)


def faults_of_class(thing: type) -> Iterator[str]:
    """What the docstring of a class leaves out."""
    text = inspect.getdoc(thing) or ""
    yield from faults_of_summary(text)
    if not dataclasses.is_dataclass(thing):
        return
    entries = field_notes(thing)
    text = "\n".join([text, *entries.values()])
    for field in dataclasses.fields(thing):
        if field.name.startswith("_"):
            continue
        if field.name not in entries:
            if str(field.type) not in SPEAKING:
                yield f"{field.name} is not explained"
        else:
            yield from faults_of_entry(field.name, str(field.type), entries[field.name], text)


def faults_of_summary(text: str) -> Iterator[str]:
    """Whether there is a first line, and whether it is a sentence."""
    if not re.match(r"[^\n]+[.:]( [^\n]*)?(\n|$)", text):
        yield "the first line is no sentence"


def faults_of_entry(name: str, annotation: str, entry: str, text: str) -> Iterator[str]:
    """What the explanation of one parameter or field leaves out."""
    if ARRAY.search(annotation) and "Callable" not in annotation and not SHAPE.search(entry):
        yield f"no shape of {name}"
    words = set(name.split("_"))
    if not NUMERIC.search(annotation) or name.endswith(("_deg", "_mm")):
        return
    if words & ANGLES and not ANGLE_UNIT.search(entry):
        yield f"no unit of {name} (radians?)"
    if words & LENGTHS and not LENGTH_UNIT.search(entry) and not LENGTH_UNIT.search(text):
        yield f"no unit of {name}"


def read_entries(text: str, section: str) -> dict[str, str]:
    """Names and explanations of a section in numpydoc's form."""
    found = re.search(
        rf"^{section}\n-+\n(.*?)(?=^\w[^\n]*\n---|\Z)", text, re.DOTALL | re.MULTILINE
    )
    entries: dict[str, str] = {}
    names: list[str] = []
    for line in found.group(1).splitlines() if found else ():
        if line[:1].strip():
            names = [each.strip(" *") for each in line.partition(":")[0].split(",")]
            entries.update(dict.fromkeys(names, ""))
        else:
            entries.update({each: f"{entries[each]} {line.strip()}" for each in names})
    return {name: entry for name, entry in entries.items() if entry.strip()}


def find_raised(function: Callable[..., Any]) -> set[str]:
    """Our errors that a function raises, or functions and methods of its module that it calls."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    module = sys.modules[function.__module__]
    raised, seen, left = set[str](), set[str](), [tree.body[0]]
    while left:
        node = left.pop()
        caught = {
            name.id
            for attempt in ast.walk(node) if isinstance(attempt, ast.ExceptHandler) and attempt.type
            for name in ast.walk(attempt.type) if isinstance(name, ast.Name)
        }  # fmt: skip
        for inner in ast.walk(node):
            if isinstance(inner, ast.Raise) and isinstance(inner.exc, ast.Call):
                made = inner.exc.func
                if isinstance(made, ast.Name) and made.id in ERRORS:
                    raised.add(made.id)
            elif isinstance(inner, ast.Call):
                called = getattr(inner.func, "id", None)
                if called in bodies(module) and called not in seen and not caught & ERRORS:
                    seen.add(called)
                    left.append(bodies(module)[called])
    return raised


@cache
def bodies(module: ModuleType) -> dict[str, ast.stmt]:
    """Functions of a module by name."""
    tree = ast.parse(inspect.getsource(module))
    return {each.name: each for each in tree.body if isinstance(each, ast.FunctionDef)}


def test_the_rule_is_a_rule() -> None:
    # Each fault, planted once, is found; without it the docstring passes.
    good = """Turn points.

    Parameters
    ----------
    points
        Points (n, 2) in any unit.
    angle
        To the left (radians).

    Returns
    -------
    Array
        Points (n, 2).

    Raises
    ------
    InputError
        If there are none.
    """

    def make(text: str) -> Any:
        def turn(points: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
            raise orishell.conventions.errors.InputError(str(points) + str(angle))

        turn.__doc__ = text
        return turn

    def faults(text: str) -> list[str]:
        return list(faults_of_function(make(text), is_method=False))

    assert not [each for each in faults(good) if "InputError" not in each]
    assert faults(good.replace("angle\n", "angles\n")) == ["angle is not explained"]
    assert faults(good.replace("Points (n, 2)", "Points")) == [
        "no shape of points",
        "no shape of what is returned",
    ]
    assert faults(good.replace(" (radians)", "")) == ["no unit of angle (radians?)"]
    assert faults("")[0] == "the first line is no sentence"


def test_the_command_line_explains_itself() -> None:
    for name, command in typer.main.get_group(app).commands.items():
        assert command.help, name
        for each in command.params:
            assert getattr(each, "help", None), f"{name} {each.name}"
