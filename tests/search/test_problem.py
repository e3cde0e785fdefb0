"""Tables [search] that cannot be used are refused with one message that names the place."""

from __future__ import annotations

import math
import time
import tomllib
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tomlkit

from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from orishell.design_file.search import Range
from orishell.search.problem import parse_problem, read_problem
from orishell.search.space import Choices, Interval
from orishell.search.write import variant_text
from search.problems import PATH, loaded_tables, small_problem
from timing import HANGS

GOOD: dict[str, Any] = {
    "variables": {"pattern.rows": [3, 5]},
    "minimise": ["panels"],
}

BAD: list[tuple[dict[str, Any], str]] = [
    ({"variables": {"pattern.rowz": [3, 5]}}, 'variables "pattern.rowz": [pattern] rowz: unknown'),
    ({"variables": {"patern.rows": [3, 5]}}, 'variables "patern.rows": [patern]: unknown key'),
    ({"variables": {"pattern.rows.x": [3]}}, "the design file has no such key"),
    ({"variables": {"load_case.0.snow": [3]}}, 'variables "load_case.0.snow"'),
    ({"variables": {"pattern.rows": [3, "many"]}}, "got 'many', expected a whole number"),
    ({"variables": {"pattern.rows": [3, 4]}}, "got 4"),
    ({"variables": {"pattern.rows": []}}, "variables pattern.rows"),
    ({"variables": {"pattern.rows": [3, 3]}}, "values that differ"),
    ({"variables": {}}, "[search] variables"),
    ({"variables": {"pattern.rows": 5}}, "[search] variables pattern.rows"),
    ({"variables": {"pattern.flap": {"low": 1.0, "high": 1.0}}}, "a value above low (1)"),
    ({"variables": {"pattern.flap": {"low": 2.0, "high": 1.0}}}, "a value above low (2)"),
    ({"variables": {"pattern.flap": {"low": 0.1, "high": 0.2, "stop": 1}}}, "unknown key"),
    ({"variables": {"pattern.flap": {"low": 0.1}}}, "pattern.flap high: this key is missing"),
    ({"variables": {"pattern.flap": {"low": 0, "high": 1, "step": 1e-9}}}, "too many steps"),
    ({"variables": {"pattern.xi_deg": {"low": 30.0, "high": 200.0}}}, "got 200.0"),
    ({"minimise": []}, "[search] minimise"),
    ({"minimise": ["panels", "panels"]}, "figures that differ"),
    ({"minimise": ["beauty"]}, "the report has no such figure"),
    ({"subject_to": {"beauty": {"most": 1.0}}}, "[search] subject_to: the report has no such"),
    ({"subject_to": {"panels": {}}}, "least, most or both"),
    ({"subject_to": {"panels": {"least": 3.0, "most": 1.0}}}, "a value of at least 3"),
    ({"evaluations": 0}, "[search] evaluations"),
    ({"population": 2}, "[search] population"),
    ({"seed": -1}, "[search] seed"),
    ({"variables": {"motion.frames": [3, 5]}}, "designs cannot be compared by this key"),
    ({"variables": {"search.seed": [3, 5]}}, "designs cannot be compared by this key"),
    (
        {"variables": {"shell": [{"unit": "m"}, {"unit": "mm"}]}},
        "designs cannot be compared by this key",
    ),
    ({"variables": {"motion": [{"frames": 3}]}}, "designs cannot be compared by this key"),
    ({"variables": {"tolerance.panel_max": [math.inf, 5]}}, "expected finite numbers"),
    ({"variables": {"target.f.range": [[-1, 1], [-1, math.inf]]}}, "expected finite numbers"),
    ({"variables": {"pattern.flap": {"low": 0, "high": 5e-324}}}, "at least 1e-300"),
    ({"variables": {"pattern.flap": {"low": 1, "high": 1 + 2e-16}}}, "at least 1e-09"),
    ({"variables": {"target.f.range.0": {"low": -1e308, "high": 1e308}}}, "at most 1e+300"),
    ({"variables": {"pattern" + 2000 * ".a": [1]}}, "expected a key of at most 300 characters"),
    ({"variables": {"pattern." + 2000 * "a": [1]}}, "expected a key of at most 300 characters"),
    (
        {"variables": {"target.f": [{"formula": "x"}], "target.f.scale": [1.0, 2.0]}},
        'got "target.f.scale" beside it',
    ),
    ({"variables": {"pattern.rows": {"low": 3, "high": 5}}}, "got 4, expected an odd number"),
    ({"variables": {"pattern": {"rows": {"low": 3, "hgih": 5}}}}, "Did you mean high?"),
    ({"method": "annealing"}, "[search] method"),
    ({"objectives": ["panels"]}, "[search] objectives: unknown key"),
    ({"method": "grid", "variables": {"pattern.flap": {"low": 0.1, "high": 0.2}}}, "needs steps"),
    (
        {"method": "grid", "evaluations": 3, "variables": {"pattern.rows": [3, 5, 7, 9]}},
        "evaluations = 4",
    ),
]


def posed(**changes: Any) -> None:
    parse_problem(
        {**parse_toml(starter_file("parallel-repeating")), "search": {**GOOD, **changes}}, PATH
    )


def test_the_table_that_the_bad_ones_differ_from_can_be_used() -> None:
    posed()


@pytest.mark.parametrize(("changes", "said"), BAD, ids=[said for _, said in BAD])
def test_a_bad_table_is_refused(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError) as error:
        posed(**changes)
    message = str(error.value)
    assert said in message
    assert message.startswith("small.toml: [search]")
    assert "\n" not in message or len(message.splitlines()) == 1 + len(changes)


def test_a_file_without_a_search_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "plain.toml"
    path.write_text(starter_file("orthodiagonal"), encoding="utf-8")
    with pytest.raises(InputError, match="nothing to search for"):
        read_problem(path)


def test_keys_may_be_written_without_quotes() -> None:
    written = parse_toml(
        """
        minimise = ["panels"]
        [variables]
        pattern.rows = [3, 5]
        pattern.flap = { low = 0.1, high = 0.3 }
        "target.f.scale" = [1.0, [1.0, 2.0]]
        [subject_to]
        deviation.f.max = { most = 1.0 }
        """
    )
    tables = {**parse_toml(starter_file("parallel-repeating")), "search": written}
    problem = parse_problem(tables, PATH)
    assert problem.space.axes == {
        "pattern.rows": Choices((3, 5)),
        "pattern.flap": Interval(0.1, 0.3),
        "target.f.scale": Choices((1.0, [1.0, 2.0])),
    }
    assert list(problem.figures) == ["panels", "deviation.f.max"]


def test_whole_numbers_stay_whole_only_where_they_must() -> None:
    ranges = {"pattern.columns": {"low": 3, "high": 5}, "pattern.xi_deg": {"low": 30, "high": 50}}
    axes = small_problem("parallel-repeating", variables=ranges).space.axes
    assert axes == {"pattern.columns": Choices((3, 4, 5)), "pattern.xi_deg": Interval(30, 50)}


def test_entries_of_lists_are_variables_too() -> None:
    tables = loaded_tables(
        variables={"load_case.1.snow.ground": {"low": 100.0, "high": 900.0}},
        minimise=["deflection"],
    )
    assert parse_problem(tables, PATH).space.axes == {"load_case.1.snow.ground": Interval(100, 900)}


def test_whole_steps_are_whole_however_they_are_written() -> None:
    ranges = {"pattern.rows": {"low": 3, "high": 6, "step": 2.0}}
    axes = small_problem("parallel-repeating", variables=ranges).space.axes
    assert axes == {"pattern.rows": Choices((3, 5))}


def test_a_design_is_told_from_others_by_its_tables_and_files(tmp_path: Path) -> None:
    curve = tmp_path / "f.csv"
    tables = parse_toml(starter_file("parallel-repeating"))
    tables["target"]["f"] = {"points": "f.csv"}

    def fingerprint(text: str, **search: Any) -> str:
        curve.write_text(text, encoding="utf-8")
        raw = {**tables, "search": {**GOOD, **search}}
        return parse_problem(raw, tmp_path / "design.toml").fingerprint()

    first = fingerprint("-1, 0\n0, 1\n1, 0\n")
    assert first == fingerprint("-1, 0\n0, 1\n1, 0\n", evaluations=7, seed=3)
    assert first != fingerprint("-1, 0\n0, 1.1\n1, 0\n")


def test_the_narrowest_and_the_widest_range_have_values_that_differ() -> None:
    for low, high in ((0.0, 1e-300), (1.0, 1 + 1.1e-9), (-5e299, 5e299)):
        Range(low=low, high=high)
        axis = Interval(low, high)
        values = [axis.value(share) for share in (0.0, 0.25, 0.5, 1.0)]
        assert len(set(values)) == 4
        assert (values[0], values[-1]) == (low, high)
        assert np.isfinite(axis.snapped(np.array([0.0, 0.5, 1.0]))).all()


def test_what_is_called_as_a_file_is_not_read(tmp_path: Path) -> None:
    # 5 GB, as a load case and a palette are called; the palette of one's own is a file.
    tables = loaded_tables(
        variables={"workshop.palette": ["plain", "own.toml"]}, minimise=["deflection"]
    )
    for name in ("snow", "plain", "feet"):
        with (tmp_path / name).open("wb") as file:
            file.truncate(5_000_000_000)
    palettes = files("orishell.workshop") / "palettes.toml"
    own = tomllib.loads(palettes.read_text(encoding="utf-8"))["plain"]
    (tmp_path / "own.toml").write_text(tomlkit.dumps({"mine": own}), encoding="utf-8")
    begin = time.perf_counter()
    problem = parse_problem(tables, tmp_path / "design.toml")
    assert problem.files() == [tmp_path / "own.toml"]
    assert problem.fingerprint()
    assert time.perf_counter() - begin < HANGS
    text = variant_text(problem, {"workshop.palette": "plain"}, tmp_path / "out")
    assert tomllib.loads(text)["workshop"]["palette"] == "plain"
