"""Forty more kinds of values that [structure] and [[load_case]] do not take, one message each.

Beside those of ``test_structure``, which are asked of the command: here the file is only read.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import check_design

from .test_structure import CASE, DESIGN, STRUCTURE, with_case, with_wind

SUPPORT = 'supports = [{ at = "feet", kind = "pinned" }]'


def with_key(line: str) -> str:
    return f"{STRUCTURE}{line}\n"


def with_support(text: str) -> str:
    return STRUCTURE.replace(SUPPORT, f"supports = [{text}]")


def with_person(text: str) -> str:
    return with_case(f"person = {{ {text} }}")


def with_snow(text: str) -> str:
    return with_case(f"snow = {{ ground = 500, {text} }}")


BAD = {
    "a thickness of a text": (STRUCTURE.replace("0.01", '"thin"'), "thickness"),
    "no thickness at all": (STRUCTURE.replace("0.01", "0"), "thickness"),
    "a modulus that is a table": (STRUCTURE.replace("270e6", "{ x = 1 }"), "modulus"),
    "a modulus that is a list": (STRUCTURE.replace("270e6", "[1, 2]"), "modulus"),
    "a modulus beyond all numbers": (STRUCTURE.replace("270e6", "1e16"), "modulus"),
    "a truth for a strength": (with_key("strength = true"), "strength"),
    "a strength of nothing": (with_key("strength = 0"), "strength"),
    "negative Poisson's ratio": (with_key("poisson = -0.1"), "poisson"),
    "no number for Poisson's ratio": (with_key('poisson = "0.3"'), "poisson"),
    "a material nobody knows": (with_key('material = "oak"'), "material"),
    "a number for a material": (with_key("material = 3"), "material"),
    "negative stiffness of creases": (with_key("crease_stiffness = -1"), "crease_stiffness"),
    "an empty range of stiffness": (with_key("crease_stiffness = []"), "crease_stiffness"),
    "stiffness that is no number": (with_key("crease_stiffness = [0, nan]"), "crease_stiffness"),
    "negative strength of creases": (with_key("crease_strength = -5"), "crease_strength"),
    "a lever of no length": (with_key("crease_lever = 0"), "crease_lever"),
    "ties that do not resist": (with_key("tie_stiffness = 0"), "tie_stiffness"),
    "ties of negative strength": (with_key("tie_strength = -1"), "tie_strength"),
    "no cells": (with_key("cells = 0"), "cells"),
    "a text for cells": (with_key('cells = "many"'), "cells"),
    "negative refinement": (with_key("refine = -0.1"), "refine"),
    "a word for a switch": (with_key('nonlinear = "yes"'), "nonlinear"),
    "a number for a switch": (with_key("nonlinear = 1"), "nonlinear"),
    "an imperfection that is not followed": (with_key("imperfection = 0.001"), "imperfection"),
    "a negative imperfection": (
        with_key("nonlinear = true\nimperfection = -0.001"),
        "imperfection",
    ),
    "a code nobody knows": (with_key('combinations = "ASCE 7"'), "combinations"),
    "an expression nobody knows": (with_key('expression = "6.11"'), "expression"),
    "factors that are no table": (with_key("factors = 1.35"), "factors"),
    "a factor that is unknown": (with_key("factors = { dead = 1.35 }"), "dead"),
    "one factor of two": (with_key("factors = { permanent = [1.35] }"), "permanent"),
    "supports that are a table": (STRUCTURE.replace(SUPPORT, 'supports = "feet"'), "supports"),
    "a support without a place": (with_support('{ kind = "pinned" }'), "at"),
    "a support without a kind": (with_support('{ at = "feet" }'), "kind"),
    "no vertices to support": (with_support('{ at = [], kind = "pinned" }'), "at"),
    "a vertex before the first": (with_support('{ at = [[-1, 0]], kind = "pinned" }'), "at"),
    "half a row of a vertex": (with_support('{ at = [[0.5, 0]], kind = "pinned" }'), "at"),
    "edges and a patch": (
        with_support('{ at = "feet", kind = "pinned", edges = true, patch = 1 }'),
        "patch",
    ),
    "a negative patch": (with_support('{ at = "feet", kind = "pinned", patch = -0.1 }'), "patch"),
    "edges on rough ground": (
        with_support('{ at = "feet", kind = "friction", friction = 0.5, edges = true }'),
        "edges",
    ),
    "too much friction": (
        with_support('{ at = "feet", kind = "friction", friction = 11 }'),
        "friction",
    ),
    "a pressure that is a text": (with_case('pressure = "100 Pa"'), "pressure"),
    "an infinite pressure": (with_case("pressure = inf"), "pressure"),
    "own weight of a number": (with_case("self_weight = 9.81"), "self_weight"),
    "negative snow": (with_case("snow = { ground = -500 }"), "ground"),
    "an arrangement of no cylinder": (
        with_snow('shape = "valleys", arrangement = "drifted left"'),
        "arrangement",
    ),
    "an arrangement nobody knows": (
        with_snow('shape = "cylinder", arrangement = "left"'),
        "arrangement",
    ),
    "wind that stands still": (
        with_case('wind = { speed = 0, terrain = "I", direction_deg = 0 }'),
        "speed",
    ),
    "wind without a terrain": (with_case("wind = { speed = 20, direction_deg = 0 }"), "terrain"),
    "a direction that is a word": (
        with_case('wind = { speed = 20, terrain = "I", direction_deg = "west" }'),
        "direction_deg",
    ),
    "a vault of two zones": (with_wind("vault = [0.5, -1]"), "vault"),
    "a vault and zones": (
        with_wind("vault = [0.5, -1, -0.4], zones = [{ rows = [0, 5], coefficient = 1 }]"),
        "vault",
    ),
    "wind below the ground": (with_wind("height = -1"), "height"),
    "negative friction of the air": (with_wind("friction = -0.01"), "friction"),
    "no pressure inside": (with_wind('internal = "open"'), "internal"),
    "a force at no vertex": (with_case("points = [{ force = [0, 0, -1] }]"), "at"),
    "an infinite force": (with_case("points = [{ at = [0, 0], force = [0, 0, inf] }]"), "force[2]"),
    "points that are no list": (with_case("points = 1000"), "points"),
    "a combination of nothing": (
        STRUCTURE + CASE + '[[load_case]]\nname = "b"\ncombine = {}',
        "[[load_case]][1]",
    ),
    "a combination of a text": (with_case('combine = { dead = "1.35" }') + CASE, "dead"),
    "a combination of itself": (with_case("combine = { a = 1 }"), "combine"),
    "an action nobody knows": (with_case('pressure = 1\naction = "live"'), "action"),
    "a duration of a number": (with_case("pressure = 1\nduration = 10"), "duration"),
    "a person who is a word": (with_person('force = "heavy"'), "force"),
    "one number for a panel": (with_person("at = [1]"), "at"),
    "a case that is no table": (f"{STRUCTURE}\nload_case = 5", "[[load_case]]"),
}


def test_there_are_forty_kinds() -> None:
    assert len(BAD) >= 40
    assert len(set(BAD.values())) == len(BAD)


@pytest.mark.parametrize("name", BAD)
def test_what_is_meant_by_nobody_is_refused(name: str) -> None:
    """By one message that names a key of these tables, and what is expected there."""
    tables, key = BAD[name]
    text = DESIGN + tables
    if name == "a case that is no table":
        text = f"load_case = 5\n{DESIGN}{STRUCTURE}"
    with pytest.raises(InputError) as refused:
        check_design(tomllib.loads(text), Path("shell.toml"))
    said = str(refused.value)
    assert said.splitlines()[0].split(": ")[1].split()[-1] == key
    assert "expected" in said or "Remedy" in said or "missing" in said
