"""A person on the shell: where, how much, and that the place that is found is the worst."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.structure import worst_place
from orishell.structure.combinations import Factors, action_of, combine
from orishell.structure.equilibrium import COLLAPSED
from orishell.structure.load_settings import LoadCase, Person, Side, Snow, Wind
from orishell.structure.loads.person import force_at, place_in_words
from orishell.structure.mesh.sheet import mesh_sheet
from orishell.structure.mesh.stops import Stops
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.plausibility import doubts
from orishell.structure.results import Analysis
from orishell.structure.solve.active_set import respond

from .test_verdicts import arch

DEAD = LoadCase(name="dead", self_weight=True)
SNOW = LoadCase(name="snow", snow=Snow(ground=500, arrangement="undrifted"))
MAN = LoadCase(name="man", person=Person())
KEYS: dict[str, Any] = {"line_strength": 1e6}


def under(person: dict[str, Any], keys: dict[str, Any] | None = None) -> Analysis:
    case = {"name": "man", "self_weight": True, "person": person}
    return arch({**KEYS, **(keys or {})}, [case])


def used(found: Analysis) -> list[float]:
    """The largest of both shares by which places are compared, case by case."""
    shares = []
    for case in found.cases:
        balanced = case.equilibrium
        assert balanced is not None
        assert balanced.strength is not None
        stress = balanced.stress.size / balanced.strength
        shares.append(max(stress, balanced.displacement.share / COLLAPSED))
    return shares


@pytest.mark.parametrize("cells", [1, 2, 3])
@pytest.mark.parametrize("side", ["middle", "left", "bottom", "right", "top"])
def test_a_force_is_in_the_middle_of_a_panel_or_of_a_side(cells: int, side: Any) -> None:
    """Its moment is that of 1 N in the middle of the four corners, or of the two of a side."""
    model = PLAIN.with_refinement(PLAIN.change, None)
    model = type(model)(model.design, model.structure, model.site, cells)
    corners = model.positions.reshape(-1, 3)[model.grid.faces_vertices()[5]]
    which = {"middle": [0, 1, 2, 3], "left": [0, 1], "bottom": [1, 2], "right": [2, 3]}
    place = corners[which.get(side, [3, 0])].mean(axis=0)
    forces = force_at(model.exposure, 5, side)
    assert forces.sum(axis=0) == pytest.approx([0, 0, -1])
    moment = np.cross(model.mesh.facets.points, forces).sum(axis=0)
    assert moment == pytest.approx(np.cross(place, [0, 0, -1]), abs=1e-12)


PLAIN = arch(KEYS).model


def test_a_force_is_in_the_middle_where_lines_of_nodes_are_moved() -> None:
    """As gussets move them: four nodes share it, in the panel's middle all the same."""
    stops = Stops.of_plates(PLAIN.grid, [1], 0.8)
    mesh = mesh_sheet(PLAIN.positions, PLAIN.grid, 4, stops=stops)
    exposure = replace(PLAIN.exposure, mesh=mesh.facets, panels=mesh.panels)
    corners = PLAIN.positions.reshape(-1, 3)[PLAIN.grid.faces_vertices()[1]]
    forces = force_at(exposure, 1, "middle")
    assert np.count_nonzero(forces[:, 2]) > 1
    moment = np.cross(mesh.facets.points, forces).sum(axis=0)
    assert moment == pytest.approx(np.cross(corners.mean(axis=0), [0, 0, -1]), abs=1e-12)


def test_the_place_that_is_found_is_the_worst() -> None:
    """Against each place by itself, whose conditions are found anew, with stress of all panels."""
    found = under({})
    own, load = found.cases[0].loads
    assert own.kind == "self_weight"
    assert load.force == pytest.approx((0, 0, -1000))
    assert "the worst of 56 places" in load.rule
    model = found.model
    structure, mesh, strength = model.factorised(0.0), model.mesh, model.structure.strength
    assert strength is not None
    rows, columns = model.grid.rows - 1, model.grid.columns - 1
    panels: dict[Side, list[int]] = {
        "middle": list(range(rows * columns)),
        "left": list(range(0, rows * columns, columns)),
        "right": list(range(columns - 1, rows * columns, columns)),
        "top": list(range(columns)),
        "bottom": list(range((rows - 1) * columns, rows * columns)),
    }
    shares = {}
    for side, panel in ((side, panel) for side, which in panels.items() for panel in which):
        forces = own.forces + 1000 * force_at(model.exposure, panel, side)
        held = respond(structure, structure.free_loads(forces))
        corners = mesh.corners_moved(structure.moved(held.displacements))
        borne = facet_stresses(mesh.facets, model.section, corners)
        stress = float(panel_stresses(mesh, model.section, borne).von_mises().max())
        most = structure.furthest(held.displacements) / (COLLAPSED * model.height)
        shares[place_in_words(model.panel_at(panel), side)] = max(most, stress / strength)
    assert len(shares) == 56
    worst = max(shares.values())
    (there,) = (each for words, each in shares.items() if f"down {words} (" in load.rule)
    assert there == pytest.approx(worst, rel=1e-9)
    assert used(found) == pytest.approx([worst], rel=1e-6)
    assert f"{100 * worst:.3g} % are used" in load.rule
    # The shell is symmetric: two places are as bad, and no third.
    assert sorted(shares.values())[-3] < 0.99 * worst


def test_many_panels_are_tried_by_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """At most so many at a time, and the place is as bad as the worst within a tenth."""
    whole = used(under({}))[0]
    monkeypatch.setattr(worst_place, "MOST", 20)
    found = under({})
    tried = int(found.cases[0].loads[1].rule.split(" places")[0].split()[-1])
    assert tried < 40
    assert used(found)[0] > 0.9 * whole


def test_a_person_is_combined_as_maintenance() -> None:
    """Beside neither snow nor wind (EN 1991-1-1, 3.3.2), with psi 0 (table A1.1, category H).

    For both factors of own weight: nothing, snow, man, wind. SLS: dead alone, the three leading
    ones, and frequent snow and wind with 0.2; the frequent man has psi_1 = 0, and is dead alone.
    """
    wind = LoadCase(name="wind", wind=Wind(speed=20, terrain="II", direction_deg=0))
    found = combine((DEAD, SNOW, MAN, wind), Factors(), "6.10")
    names = {each.name for each in found if "man" in each.combine}
    assert names == {
        "ULS dead + 1.5 man",
        "ULS 1.35 dead + 1.5 man",
        "EQU 0.9 dead + 1.5 man",
        "EQU 1.1 dead + 1.5 man",
        "SLS characteristic dead + man",
    }
    # With snow and wind, each leading: 6 of each kind without the man.
    count = Counter(each.limit_state for each in found)
    assert count == {"ULS": 12, "EQU": 12, "SLS": 1 + 3 + 2 + 2}
    assert action_of(LoadCase(name="q", pressure=400, action="maintenance")) == "maintenance"
    assert MAN.lasts(()) == "short"


@pytest.mark.parametrize(
    ("case", "says"),
    [
        (MAN.replace_unchecked(action="snow"), "one action each"),
        (MAN.replace_unchecked(self_weight=True), "one action each"),
        (LoadCase(name="q", pressure=400), '"imposed" or "maintenance"'),
    ],
)
def test_what_is_no_single_action_is_refused(case: LoadCase, says: str) -> None:
    with pytest.raises(InputError) as refused:
        action_of(case)
    assert says in str(refused.value)


def test_a_panel_that_is_not_there_is_refused() -> None:
    with pytest.raises(InputError, match="a row from 0 to 7, a column from 0 to 3"):
        under({"at": [8, 0]})


@pytest.mark.parametrize("force", [1.0, 1e5])
def test_persons_of_another_unit_are_warned_of(force: float) -> None:
    case = MAN.replace_unchecked(person=Person(force=force))
    said = list(doubts(PLAIN.structure.replace_unchecked(cases=(case,)), "m", None))
    assert any("a code's person is 1000" in text for text in said)
    usual = PLAIN.structure.replace_unchecked(cases=(MAN,))
    assert not any("person" in text for text in doubts(usual, "m", None))
