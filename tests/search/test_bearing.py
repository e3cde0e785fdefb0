"""A front has no shell that buckles or breaks under its loads, unless the file allows it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from orishell.search import Problem, SearchResult, alone, journal_in_memory, search_designs
from orishell.search.evaluate import asked_of_loads, evaluate, job_of, reasons, violation
from orishell.search.problem import parse_problem
from samples import thorough
from search.problems import PATH, loaded_tables, small_problem

THICK = [0.001, 0.003, 0.014]
BREAKS = {"strength": 0.44e6, "modulus": 270e6}
"""Panels of 3 mm bear 1.19 of that strength, of 14 mm 0.72."""
BUCKLES = {"strength": 5e6, "modulus": 270e6, "cells": 2}
"""Panels of 5 mm bear 4 times what buckles them, of 6 mm 2.4; those of 14 mm use 0.18."""


def posed(structure: dict[str, float], thick: Sequence[float] = THICK, **search: Any) -> Problem:
    """A vault of panels of up to 10 mm, to be thin and stiff under 500 N/m2 of snow."""
    raw = loaded_tables(
        variables={"structure.thickness": thick},
        minimise=["structure.model.thickness", "deflection"],
        **search,
    )
    kept = {key: each for key, each in raw["structure"].items() if key != "strength"}
    snow = [each for each in raw["load_case"] if each["name"] == "snow"]  # with own weight
    return parse_problem({**raw, "structure": {**kept, **structure}, "load_case": snow}, PATH)


def found(problem: Problem) -> SearchResult:
    with alone() as pool:
        return search_designs(problem, pool, journal_in_memory())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("structure", "thick"),
    [(BREAKS, THICK), (BUCKLES, [0.005, 0.006, 0.014])],
    ids=["breaks", "buckles"],
)
def test_what_breaks_or_buckles_is_not_on_the_front(
    structure: dict[str, float], thick: list[float]
) -> None:
    problem = posed(structure, thick)
    kept = found(problem)
    used = [each.figures["utilisation"] for each in kept.outcomes]
    assert used[0] > used[1] > 1.05
    assert used[2] < 0.95
    assert [each.values["structure.thickness"] for each in kept.front.members] == [0.014]
    assert dict(reasons(problem, kept.outcomes)) == {"utilisation is above 1": 2}
    missed = [violation(problem, each) for each in kept.outcomes]
    assert missed[0] > missed[1] > missed[2] == 0.0
    assert "a utilisation of at most 1," in asked_of_loads(problem)


def test_what_is_not_known_to_carry_is_not_on_the_front() -> None:
    """No strength of panels is given: there is no figure of what they bear, whatever is allowed."""
    panels = {"modulus": 270e6, "cells": 2}
    for limits in ({}, {"subject_to": {"utilisation": {"most": 1e4}}}):
        job = job_of(posed(panels, [0.014], **limits))
        thick = evaluate(job, [{"structure.thickness": 0.014}])[0]
        assert thick.reason == "it is not known whether it carries its loads"
        said = "under snow, free creases it is loaded in panels, whose strength is not given"
        assert said in thick.said
        assert not thick.figures


@thorough
def test_the_file_may_allow_it_and_then_it_is_said() -> None:
    problem = posed(BREAKS, subject_to={"utilisation": {"most": 1e4}})
    assert len(found(problem).front.members) == 3
    assert "utilisation may be above 1" in asked_of_loads(problem)


def test_a_shell_that_moves_is_refused_whatever_is_asked_for() -> None:
    """Nothing holds its feet together: only with ties does it stand."""
    raw = loaded_tables(variables={"deployment.ties": ["none", "feet"]}, minimise=["panels"])
    loose, tied = evaluate(job_of(parse_problem(raw, PATH)), [{"deployment.ties": "none"}, {}])
    assert loose.reason == "nothing holds the shell under its loads"
    assert tied.figures["utilisation"] < 1


def test_without_a_structure_nothing_is_said_of_loads() -> None:
    problem = small_problem("orthodiagonal")
    assert "utilisation" not in problem.figures
    assert asked_of_loads(problem).startswith("loads were not looked at")


def test_a_structure_that_only_variants_have_bears_its_loads_too() -> None:
    raw = loaded_tables(minimise=["panels"])
    table = raw.pop("structure")
    del raw["load_case"]  # own weight remains
    raw["search"]["variables"] = {"structure": [table, {**table, "strength": 1e3}]}
    problem = parse_problem(raw, PATH)
    whole = found(problem)
    assert [each.values["structure"]["strength"] for each in whole.front.members] == [5e6]
    assert not whole.baseline.figures
