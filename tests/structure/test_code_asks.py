"""What is left of what codes ask: by what was asked of a structure."""

from __future__ import annotations

from typing import Any

import pytest

from analysed import STRUCTURE, analysed
from orishell.io.sections import Bullets
from orishell.structure.code_asks import code_asks
from orishell.structure.load_settings import LoadCase, Person, Snow, Wind
from orishell.structure.pages.sections import structure_sections

DEAD = LoadCase(name="dead", self_weight=True)
ALL = (
    DEAD,
    LoadCase(name="snow", snow=Snow(ground=500, arrangement="undrifted")),
    LoadCase(name="wind", wind=Wind(speed=20, terrain="II", direction_deg=0)),
    LoadCase(name="man", person=Person()),
)
BARE = STRUCTURE.replace_unchecked(cases=(DEAD,))
FULL = STRUCTURE.replace_unchecked(
    cases=ALL,
    combinations="EN 1990",
    material="birch plywood",
    strength=None,
    displacement_limit="span/100",
    nonlinear=True,
    imperfection=0.01,
)
LEFT: dict[str, dict[str, Any]] = {
    "own weight: ": {"cases": ALL[1:]},
    "snow: ": {"cases": (ALL[0], *ALL[2:])},
    "wind: ": {"cases": (*ALL[:2], ALL[3])},
    "somebody who works": {"cases": ALL[:3]},
    "partial factors of loads": {"combinations": "none"},
    "partial factors of panels": {"strength": 1e7},
    "creep: ": {"material": "steel"},
    "limits of displacements": {"displacement_limit": None},
    "imperfections of shape": {"imperfection": 0.0},
}


@pytest.mark.parametrize("begins", LEFT)
def test_what_was_not_asked_is_left(begins: str) -> None:
    """Each by itself: what is on the list then, and only then."""
    always = code_asks(FULL)
    found = code_asks(FULL.replace_unchecked(**LEFT[begins]))
    more = [text for text in found if text not in always]
    assert len(more) == 1
    assert more[0].startswith(begins)
    assert [text for text in found if text in always] == list(always)


def test_fire_and_the_like_are_always_left() -> None:
    words = " ".join(code_asks(FULL))
    for each in ("fire", "earthquakes", "fatigue", "robustness", "joints", "anchors"):
        assert each in words
    assert set(code_asks(FULL)) < set(code_asks(BARE))


def test_the_page_and_the_report_have_the_list() -> None:
    found = analysed()
    (section,) = (
        each for each in structure_sections(found, "m") if each.title.startswith("What codes ask")
    )
    (bullets,) = section.parts
    assert isinstance(bullets, Bullets)
    assert bullets.texts == found.code_asks
    assert "snow: " not in " ".join(found.code_asks)
    assert "somebody who works" in " ".join(found.code_asks)
