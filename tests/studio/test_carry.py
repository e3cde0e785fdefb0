"""What the studio answers where it is asked for designs that carry."""

from __future__ import annotations

import copy
from typing import Any

import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import parse_toml
from orishell.shell import carry, carry_boards
from orishell.studio import api
from orishell.studio.tasks import answer
from small_arch import SMALL_ARCH
from typescript import fits

DESIGN: dict[str, Any] = {
    **parse_toml(SMALL_ARCH),
    "structure": {
        "modulus": 9e9,
        "strength": 40e6,
        "crease_stiffness": "rigid",
        "crease_strength": 1e9,
        "line_strength": 1e9,
        "thickness": 0.003,
        "cells": 1,
        "supports": [{"at": "feet", "kind": "fixed", "edges": True}],
    },
    "load_case": [{"name": "snow", "snow": {"ground": 20000, "arrangement": "undrifted"}}],
}


def test_what_is_tried_is_told_and_what_carries_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(carry, "BUILDER", (carry_boards.thicker, carry_boards.thicker))
    monkeypatch.setattr(carry, "DESIGNER", ())
    told: list[list[str]] = []
    shares: list[float] = []
    result = answer("carry", {"design": DESIGN}, lambda share, _: shares.append(share), told.append)
    assert fits({"result": result}, api.CarryResult)
    assert all(fits({"found": each}, api.CarryFound) for each in told)
    assert told[-1] == result["tried"]
    assert [len(each) for each in told] == list(range(1, len(told) + 1))
    assert shares == sorted(shares)
    assert result["carries"] is False
    (first, *_) = result["found"]
    assert first["changes"].keys() == {"structure.thickness"}
    assert 0 < first["used"] <= 1


def test_without_a_structure_there_is_nothing_to_carry() -> None:
    design = copy.deepcopy(DESIGN)
    del design["structure"], design["load_case"]
    with pytest.raises(InputError, match="no structure to analyse"):
        answer("carry", {"design": design}, lambda _share, _what: None)
