"""variants.html: which designs it knows, of which it has a shell, and what it refuses."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from command_line import orishell
from orishell.conventions.errors import InputError
from orishell.search import Problem, SearchResult, alone, read_problem
from orishell.search import variants as pages
from orishell.search.variants import NAME, VariantsPage, variants_data
from orishell.search.write import require_apart
from search.test_page import DESIGN, posed
from typescript import fits

GRID = DESIGN.replace("[42, 46, 50]", "[46, 50, 70]")
"""Of six designs two are refused: f is too steep for 70 degrees."""


def told(problem: Problem, found: SearchResult) -> VariantsPage:
    """What a page of variants is told."""
    with alone() as pool:
        page: VariantsPage = json.loads(variants_data(problem, found, pool))
    assert fits(page, VariantsPage)
    return page


def test_a_page_knows_all_designs_and_why_some_do_not_work(tmp_path: Path) -> None:
    problem, found = posed(tmp_path, GRID)
    page = told(problem, found)
    rows, angle = page["variables"]
    assert (rows["label"], rows["unit"], rows["values"]) == ("Rows", "", [3, 5])
    assert (angle["unit"], angle["values"]) == ("\u00b0", [46, 50, 70])
    assert page["figures"] == ["panels", "sheet area (m\u00b2)", "crease length (m)"]
    assert len(page["variants"]) == len(found.outcomes) == 6
    for each, outcome in zip(page["variants"], found.outcomes, strict=True):
        values = [rows["values"][each["at"][0]], angle["values"][each["at"][1]]]
        assert values == list(outcome.values.values())
        refused = values[1] == 70
        assert (each["view"] is None) == (each["figures"] == []) == refused
        assert each["missing"] == (outcome.said if refused else "")
        assert refused == bool(each["missing"])
    first = found.outcomes[page["first"]]
    assert first.values == {"pattern.rows": 5, "pattern.xi_deg": 50}  # the file's own
    assert page["said"] == "6 designs were tried; 4 fold and keep all limits."


def test_a_page_that_is_full_keeps_the_first_shells_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, found = posed(tmp_path, GRID)
    whole = told(problem, found)
    size = max(len(each["view"] or "") for each in whole["variants"])
    monkeypatch.setattr(pages, "MOST_BYTES", 2 * size)
    page = told(problem, found)
    drawn = [k for k, each in enumerate(page["variants"]) if each["view"]]
    assert page["first"] in drawn
    assert len(drawn) == 2
    assert sum(len(each["view"] or "") for each in page["variants"]) <= 2 * size
    assert page["said"].endswith("4 fold and keep all limits, and 2 of them are drawn here.")
    assert [each["figures"] for each in page["variants"]] == [
        each["figures"] for each in whole["variants"]
    ]


def test_a_page_that_knows_fewer_designs_than_were_tried_knows_the_front(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, found = posed(tmp_path, GRID)
    front = [each.values for each in found.front.members]
    last = sorted(found.outcomes, key=lambda each: each.values in front)
    monkeypatch.setattr(pages, "MOST_VARIANTS", len(front))
    page = told(problem, replace(found, outcomes=tuple(last)))
    names = [each["values"] for each in page["variables"]]
    known = [
        [values[k] for values, k in zip(names, each["at"], strict=True)]
        for each in page["variants"]
    ]
    assert sorted(known) == sorted(list(each.values()) for each in front)
    number = len(front)
    assert page["said"].startswith(
        f"6 designs were tried; of {number} that are here, {number} fold and keep all limits"
    )


def test_designs_are_drawn_that_lie_farthest_apart() -> None:
    points = np.array([[0.0], [0.1], [0.5], [0.6], [1.0]])
    assert pages._spread(points, np.arange(5), 1) == [1, 4, 2, 0, 3]
    assert pages._spread(points, np.array([1, 2, 3]), 2) == [2, 1, 3]


def test_without_the_design_of_the_file_the_knee_is_first(tmp_path: Path) -> None:
    problem, found = posed(tmp_path, GRID.replace("xi_deg = 50", "xi_deg = 45"))
    knee = found.front.members[found.front.knee]
    assert found.outcomes[told(problem, found)["first"]].values == knee.values


def test_values_that_are_chosen_freely_have_their_places_on_a_slider(tmp_path: Path) -> None:
    bred = GRID.replace("[46, 50, 70]", "{ low = 40, high = 50 }")
    bred = bred.replace('"grid"', '"auto"\nevaluations = 8\npopulation = 4')
    problem, found = posed(tmp_path, bred)
    made = found.front.members[found.front.knee]
    freely = [replace(made, values={"pattern.rows": 3, "pattern.xi_deg": xi}) for xi in (44.5, 42)]
    page = told(problem, replace(found, outcomes=(*freely, made)))
    angle = page["variables"][1]
    values = [float(str(value)) for value in angle["values"]]
    assert values == sorted({44.5, 42.0, float(made.values["pattern.xi_deg"])})
    assert angle["shares"] == pytest.approx([(value - 40) / 10 for value in values])


def test_a_search_writes_it_if_it_is_asked_to(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("orishell.search.local_processes", lambda *_: alone())
    (tmp_path / "vault.toml").write_text(GRID)
    for form, status in (("pdf", 2), ("html", 0)):
        out = tmp_path / form
        done = orishell("search", tmp_path / "vault.toml", "--out", out, "--write", form)
        assert done.returncode == status, done.stderr
        assert (out / NAME).is_file() == (form == "html")
        assert out.exists() == (form == "html")
        assert ("expected html" in done.stderr) == (form == "pdf")


def test_a_page_that_is_not_of_a_search_is_not_written_over(tmp_path: Path) -> None:
    (tmp_path / "vault.toml").write_text(GRID)
    problem = read_problem(tmp_path / "vault.toml")
    require_apart(problem, tmp_path)
    (tmp_path / NAME).write_text("somebody's own")
    with pytest.raises(InputError, match="this file is not of orishell"):
        require_apart(problem, tmp_path)


def test_a_design_that_breaks_a_limit_has_no_shell(tmp_path: Path) -> None:
    problem, found = posed(tmp_path, GRID)
    broken = [
        replace(each, figures={**each.figures, "crease_length": 61.0}) if k == 0 else each
        for k, each in enumerate(found.outcomes)
    ]
    page = told(problem, replace(found, outcomes=tuple(broken)))
    assert page["variants"][0]["view"] is None
    assert page["variants"][0]["missing"] == "crease_length is above 60: 61"
