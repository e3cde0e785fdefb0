"""Searches on the design that is open in the studio."""

from __future__ import annotations

from typing import Any

import pytest

from apart import run_apart
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.search.figures import NAMES
from orishell.studio import processes, searches
from orishell.studio.api import SearchState
from orishell.studio.tasks import answer
from orishell.studio.workers import Pool

SIZES = {"pattern.rows": [3, 5], "pattern.columns": {"low": 3, "high": 5}}


def design_with(**search: Any) -> dict[str, Any]:
    asked = {"variables": SIZES, "minimise": ["panels", "deviation"], **search}
    return {**parse_toml(starter_file("parallel-repeating")), "search": asked}


def searched(design: dict[str, Any]) -> tuple[list[SearchState], SearchState]:
    """What is told on the way, and at the end."""
    told: list[SearchState] = []
    result = answer("search", {"design": design}, lambda _share, _what: None, told.append)
    return told, result


@pytest.fixture(autouse=True)
def told_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(searches, "EVERY", 0.0)


def test_the_front_grows_and_no_design_is_told_twice() -> None:
    told, last = searched(design_with())
    assert [state["made"] for state in told] == [0, 1, 2, 3, 4, 5, 6]
    assert last["made"] == last["total"] == 6
    baseline = told[0]["baseline"]
    assert baseline is not None
    assert baseline["values"] == {}
    assert baseline["figures"]["panels"] == 120.0
    designs = [each for state in [*told, last] for each in state["designs"]]
    assert len({str(each["values"]) for each in designs}) == len(designs) == 6
    front = [designs[member["number"]] for member in last["front"]]
    panels, deviations = ([each["figures"][name] for each in front] for name in last_names(last))
    assert panels == sorted(panels)
    assert deviations == sorted(deviations, reverse=True)
    for each in designs:  # none is better in both than a member of the front
        assert any(
            p <= each["figures"]["panels"] and d <= each["figures"]["deviation"]
            for p, d in zip(panels, deviations, strict=True)
        )
    costs = [member["costs"] for member in last["front"]]
    assert [not each for each in costs] == [k == last["knee"] for k in range(len(front))]
    assert all("panels" in each or "deviation" in each for each in costs if each)
    assert [each["label"] for each in last["objectives"]] == ["panels", "deviation (m)"]


def last_names(state: SearchState) -> list[str]:
    return [each["name"] for each in state["objectives"]]


def test_what_cannot_be_made_is_counted_by_its_reason() -> None:
    limit = {"panels": {"most": 41}}
    _, last = searched(design_with(variables={"pattern.columns": [3, 4, 6]}, subject_to=limit))
    assert last["refused"] == [("panels is above 41", 2)]
    assert len(last["front"]) == 1


def test_variants_are_as_large_as_designs_may_be(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "MAX_VERTICES", 11 * 13)
    _, last = searched(design_with(variables={"pattern.columns": [3, 50]}))
    assert last["refused"] == [("the sheet is too large for the studio", 1)]
    assert [member["number"] for member in last["front"]] == [0]


@pytest.mark.parametrize(
    ("search", "message"),
    [
        ({"subject_to": {"panels": {"most": 1}}}, "no design was found"),
        ({"variables": {"pattern.no_such": [1, 2]}}, "no_such"),
        ({"minimise": ["mass"]}, "does not say mass"),
        ({"variables": {"pattern.rows": {"low": 5, "high": 3}}}, "above low"),
    ],
)
def test_what_cannot_be_searched_says_why(search: dict[str, Any], message: str) -> None:
    with pytest.raises((DesignError, InputError), match=message):
        searched(design_with(**search))


def test_what_is_wrong_with_a_search_concerns_only_the_search() -> None:
    design = design_with(minimise=[])
    assert len(answer("design", {"design": design}, lambda _share, _what: None)) > 1000
    with pytest.raises(InputError, match="minimise"):
        answer("format", {"design": design}, lambda _share, _what: None)
    text = answer("format", {"design": design_with()}, lambda _share, _what: None)["text"]
    found = answer("parse", {"text": text}, lambda _share, _what: None)
    assert found["design"]["search"] == design_with()["search"]


def test_without_pymoo_it_is_said_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    described = searches.describe_search()
    assert described["install"] == ""
    assert [each["name"] for each in described["figures"]] == list(NAMES)
    monkeypatch.setattr(searches, "find_spec", lambda _: None)
    with pytest.raises(InputError, match="pip install") as caught:
        searched(design_with())
    assert caught.value.remedy == searches.describe_search()["install"]


def test_a_search_in_a_process_tells_what_it_finds() -> None:
    async def scene() -> list[str]:
        pool = Pool(answer, 1, seconds=100.0)
        design = design_with(variables={"pattern.columns": [3, 4]})
        kinds: list[str] = [kind async for kind, _ in pool.stream("search", {"design": design})]
        pool.close()
        return kinds

    kinds = run_apart(scene())
    assert kinds[-1] == "result"
    assert {"progress", "found"} <= {*kinds}
