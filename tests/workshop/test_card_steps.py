"""A model of card: its scale, how its creases are made, and how its booklet teaches to fold it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from kits import shell_of
from orishell.document import FLAT, SHELL, Document
from orishell.document.from_design import states_of
from orishell.workshop import Workshop
from orishell.workshop.kit.card_model import CardModel, make_card_model
from orishell.workshop.kit.facts import find_facts
from orishell.workshop.kit.folding import hand_folding
from orishell.workshop.kit.parts import kit_parts
from orishell.workshop.kit.step import Step
from orishell.workshop.kit.steps import kit_steps
from orishell.workshop.paper_model import make_paper_model
from orishell.workshop.settings import Paper
from orishell.workshop.tiling import PAPERS_MM, page_scale, tile_sheet

NAMES = ("canopy", "shelter")


def model_of(name: str, workshop: Workshop) -> tuple[Document, CardModel]:
    shell = shell_of(name)
    document = replace(shell.document, states=states_of(shell.motion))
    return document, make_card_model(document, workshop)


def steps_of(model: CardModel) -> tuple[Step, ...]:
    facts = find_facts(model.document)
    parts = kit_parts(model.document, model.workshop, facts)
    return kit_steps(model.document, model.workshop, facts, parts)


@pytest.mark.parametrize("paper", PAPERS_MM)
@pytest.mark.parametrize("size", [(20.0, 30.0), (300.0, 500.0), (28900.0, 9370.0), (1e3, 1e5)])
def test_the_scale_is_the_largest_that_fits_a_page(size: tuple[float, float], paper: Paper) -> None:
    wide, high = size
    outline = (np.array([[0, 0], [wide, 0], [wide, high], [0, high]]),)
    ratio = 1 / page_scale(outline, paper)
    assert len(tile_sheet(outline, 1 / ratio, paper).pages) == 1
    assert ratio == pytest.approx(round(ratio, 1), abs=1e-9)  # as people write it
    larger = ratio - (1 if ratio > 10 else 0.1)
    assert larger < 1 or len(tile_sheet(outline, 1 / larger, paper).pages) > 1


def test_creases_dashes_and_holes_are_those_of_the_workshop_to_scale() -> None:
    asked = Workshop(creases="dashes", dash=0.2, relief_hole=0.1, paper="A3")
    _, model = model_of("canopy", asked)
    millimetre = 1e3 * model.scale  # of the model, from metres of the shell
    printed = make_paper_model(model.document, model.workshop)
    assert not printed.scored
    wide = np.array([2 * each.radius for each in printed.circles])
    assert len(wide)
    np.testing.assert_allclose(wide, 0.1 * millimetre, rtol=1e-12)
    cuts = [line.points for line in printed.lines if line.layer in ("MOUNTAIN", "VALLEY")]
    lengths = np.array([np.hypot(*(each[-1] - each[0])) for each in cuts])
    # Each is the share of a dash that is cut, but for the rounding to whole numbers of them.
    assert np.median(lengths) == pytest.approx(asked.duty * 0.2 * millimetre, rel=0.1)


def test_what_nobody_cuts_in_card_is_left_out() -> None:
    asked = Workshop(creases="dashes", dash=0.01, relief_hole=0.01)
    _, model = model_of("canopy", asked)
    assert (model.workshop.dash, model.workshop.relief_hole) == ("auto", 0.0)
    assert model.workshop.creases == "dashes"


@pytest.mark.parametrize("name", NAMES)
def test_every_step_has_a_picture_and_they_come_in_the_order_of_hands(name: str) -> None:
    _, model = model_of(name, Workshop())
    steps = steps_of(model)
    assert all(step.state is not None for step in steps)
    names = [step.name for step in steps]
    order = ["cut_card", "score_card", "crease_first", "crease_others", "collapse", "collapsed"]
    assert [each for each in names if each in order] == order
    # On the way from the flat sheet to the target states only go forward.
    document = model.document
    way = [step.state for step in steps if step.name.startswith("collaps")]
    numbers = [document.named[each] if isinstance(each, str) else each or 0 for each in way]
    begin, end = document.named[FLAT], document.named[SHELL]
    assert [abs(each - begin) for each in numbers] == sorted(
        {abs(each - begin) for each in numbers}
    )
    assert begin not in numbers
    assert numbers[-1] == end


@pytest.mark.parametrize("name", NAMES)
def test_each_crease_is_folded_once_those_first_that_fold_more(name: str) -> None:
    _, model = model_of(name, Workshop())
    document, hands = model.document, hand_folding(model.document)
    edges = np.asarray(document.mesh.edges).tolist()
    folds = {
        tuple(edge): letter
        for edge, letter in zip(edges, document.assignment, strict=True)
        if letter in "MV"
    }
    listed = [
        (*end, letter)
        for lines in hands.sets
        for letter, ends in (("M", lines.mountains), ("V", lines.valleys))
        for end in ends.tolist()
    ]
    assert sorted(listed) == sorted((*edge, letter) for edge, letter in folds.items())
    angles = document.state(hands.states[0]).fold_angles_deg
    assert angles is not None
    size = dict(zip(map(tuple, edges), np.abs(angles).tolist(), strict=True))
    first, second = (
        np.mean([size[tuple(end)] for ends in each for end in ends.tolist()])
        for each in ((lines.mountains, lines.valleys) for lines in hands.sets)
    )
    assert first >= second


def test_the_edges_that_are_pushed_come_nearer_to_each_other_than_the_others() -> None:
    _, model = model_of("canopy", Workshop())
    document, hands = model.document, hand_folding(model.document)
    flat, folded = document.require_flat(), document.state(hands.states[-1]).positions
    shape = document.grid_shape
    assert shape is not None
    count = shape[0] * shape[1]
    before, after = flat[:count].reshape(*shape, 2), folded[:count].reshape(*shape, 3)
    shares = {}
    for first, last in ((np.s_[0], np.s_[-1]), (np.s_[:, 0], np.s_[:, -1])):
        apart = [
            np.linalg.norm(each[last] - each[first], axis=-1).mean() for each in (before, after)
        ]
        way = before[last].mean(axis=0) - before[first].mean(axis=0)
        shares["sides" if abs(way[0]) >= abs(way[1]) else "ends"] = apart[1] / apart[0]
    assert hands.sideways == (shares["sides"] <= shares["ends"])
