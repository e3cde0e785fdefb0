"""front.html: what stands in the file, whoever made its shells."""

from __future__ import annotations

import base64
import json
import signal
import threading
import zlib
from collections.abc import Sequence
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import orishell
from orishell.conventions.errors import InputError
from orishell.design_file import check_design
from orishell.design_file.tables import with_values
from orishell.search import (
    Problem,
    SearchResult,
    WorkerPool,
    alone,
    journal_in_memory,
    local_processes,
)
from orishell.search import page as pages
from orishell.search.evaluate import Outcome, job_of
from orishell.search.front import Front, costs
from orishell.search.page import FrontPage, PageMember, draw_shells, write_page
from orishell.search.problem import read_problem
from orishell.search.run import search_designs
from orishell.search.write import require_installed
from orishell.shell.make import make_shell
from typescript import fits

DESIGN = """
[shell]
family = "parallel-repeating"
unit = "m"
[target.f]
formula = "-x**2"
range = [-1, 1]
[target.g]
formula = "sin(x)"
range = [0, 4]
[pattern]
rows = 5
columns = 5
flap = 0.2
xi_deg = 50
[search]
minimise = ["panels", "sheet_area"]
subject_to = { "crease_length" = { most = 60 } }
method = "grid"
[search.variables]
"pattern.rows" = [3, 5]
"pattern.xi_deg" = [42, 46, 50]
"""


def posed(directory: Path, text: str = DESIGN) -> tuple[Problem, SearchResult]:
    """A search, and what it found."""
    (directory / "vault.toml").write_text(text)
    problem = read_problem(directory / "vault.toml")
    with alone() as pool:
        return problem, search_designs(problem, pool, journal_in_memory())


@pytest.fixture(autouse=True)
def stub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small program in the place of the page's own."""
    place = tmp_path / "front.js"
    place.write_text("export {}")
    monkeypatch.setattr(pages, "PROGRAM", place)
    return place


class Data(HTMLParser):
    """The text of the element that holds the front."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.inside = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.inside = ("id", "orishell-front") in attrs

    def handle_data(self, data: str) -> None:
        if self.inside:
            self.texts.append(data)
            self.inside = False


def written(directory: Path, problem: Problem, found: SearchResult, pool: WorkerPool) -> FrontPage:
    told: list[float] = []
    write_page(directory / "front.html", problem, found, pool, lambda share, _: told.append(share))
    assert told == sorted(told)
    assert told[-1] == 1.0
    return page_at(directory)


def page_at(directory: Path) -> FrontPage:
    """What the page in a directory is told."""
    data = Data()
    data.feed((directory / "front.html").read_text("utf-8"))
    (text,) = data.texts
    page: FrontPage = json.loads(text)
    assert fits(page, FrontPage)
    return page


def test_what_the_page_is_told(tmp_path: Path) -> None:
    problem, found = posed(tmp_path)
    with alone() as pool:
        page = written(tmp_path, problem, found, pool)
    members = found.front.members
    assert page["title"] == "vault"
    assert page["said"].startswith(f"{len(members)} design")
    assert page["variables"] == ["pattern.rows", "pattern.xi_deg"]
    assert [each["name"] for each in page["figures"]] == [
        *("panels", "sheet area (m\u00b2)", "crease length (m)")
    ]
    assert [each["minimised"] for each in page["figures"]] == [True, True, False]
    assert [each["note"] for each in page["figures"]] == ["", "", "at most 60"]
    for number, (told, member) in enumerate(zip(page["members"], members, strict=True)):
        assert told["file"] == f"front-{number + 1:02}.toml"
        assert told["values"] == list(member.values.values())
        assert told["figures"] == list(member.figures.values())
        neighbours = {number - 1, number + 1} & set(range(len(members)))
        assert {step["to"] for step in told["steps"]} == neighbours
        for step in told["steps"]:
            assert step["words"] == costs(problem, member, members[step["to"]])
    assert len(members) + len(page["beaten"]) == 6
    assert page["baseline"] == [36.0, found.baseline.figures["sheet_area"]]


def test_a_shell_is_the_one_that_its_design_file_makes(tmp_path: Path) -> None:
    """Its states have the ends of the motion among them."""
    problem, found = posed(tmp_path)
    with alone() as pool:
        page = written(tmp_path, problem, found, pool)
    for told, member in zip(page["members"], found.front.members, strict=True):
        assert told["view"] is not None
        view = zlib.decompress(base64.b64decode(told["view"]))
        first = 4 + int.from_bytes(view[:4], "little")
        header: dict[str, Any] = json.loads(view[4:first])
        whole = make_shell(check_design(with_values(problem.tables, member.values), problem.path))
        place = header["arrays"]["positions"]
        positions = np.frombuffer(
            view, "<f4", int(np.prod(place["shape"])), first + place["offset"]
        ).reshape(place["shape"])
        for name in ("flat", "target"):
            drawn = positions[header["named"][name]] + np.array(header["origin"])
            expected = whole.document.in_world(whole.document.state(name).positions)
            np.testing.assert_allclose(drawn, expected, atol=1e-5)
        assert header["report"]["lock"] == json.loads(json.dumps(whole.report.as_dict()["lock"]))


def test_bytes_are_the_same_with_two_processes(tmp_path: Path) -> None:
    problem, found = posed(tmp_path)
    texts = []
    for many in (alone(), local_processes(2)):
        with many as pool:
            written(tmp_path, problem, found, pool)
        texts.append((tmp_path / "front.html").read_bytes())
    assert texts[0] == texts[1]


class Dying:
    """A pool of which each other chunk dies."""

    def work(
        self, work: Any, items: Sequence[Any], stop: threading.Event
    ) -> list[tuple[Sequence[Any], list[Any] | None]]:
        return [
            (items[k : k + 1], None if k % 2 else work(items[k : k + 1])) for k in range(len(items))
        ]


def test_members_that_cannot_be_drawn_say_so(tmp_path: Path) -> None:
    problem, found = posed(tmp_path)
    pool: Any = Dying()
    page = written(tmp_path, problem, found, pool)
    for number, member in enumerate(page["members"]):
        assert (member["view"] is None) == bool(number % 2)
        died = (
            f"The process that drew it died. The shell is made by: orishell design {member['file']}"
        )
        assert member["missing"].startswith(died if number % 2 else "")
    job = job_of(problem)
    (drawn,) = draw_shells(job, [(7, {"pattern.rows": 4})])
    assert drawn[:2] == (7, None)
    assert "odd" in drawn[2]


def test_of_many_members_the_ends_and_the_knee_are_drawn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, found = posed(tmp_path)
    member = found.front.members[0]
    many = tuple(
        replace(member, figures={**member.figures, "panels": float(k)}) for k in range(200)
    )
    monkeypatch.setattr(pages, "_drawn", lambda _, number, *__, **___: (number, b"a view", ""))
    with alone() as pool:
        page = written(tmp_path, problem, replace(found, front=Front(many, 101)), pool)
    drawn = [number for number, each in enumerate(page["members"]) if each["view"]]
    assert {0, 101, 199} <= set(drawn)
    assert pages.MOST_SHELLS <= len(drawn) <= pages.MOST_SHELLS + 1
    assert max(np.diff(drawn)) <= -(-200 // pages.MOST_SHELLS)
    assert page["members"][1]["missing"].startswith("Only 60 of the front are drawn. The shell is")


def test_of_a_great_many_beaten_designs_some_are_drawn(tmp_path: Path) -> None:
    problem, found = posed(tmp_path)
    figures = found.front.members[0].figures
    others = tuple(
        Outcome({"pattern.rows": k}, {**figures, "panels": 100.0 + k})
        for k in range(3 * pages.MOST_DOTS)
    )
    with alone() as pool:
        page = written(tmp_path, problem, replace(found, outcomes=found.outcomes + others), pool)
    assert pages.MOST_DOTS / 2 < len(page["beaten"]) <= pages.MOST_DOTS


def test_what_stands_in_the_page_stays_there(tmp_path: Path) -> None:
    """A value of a variable may be any text."""
    hostile = "</script><script>alert(1)</script><!-- \u03b1"
    problem, found = posed(tmp_path)
    member = replace(
        found.front.members[0], values={**found.front.members[0].values, "pattern.rows": hostile}
    )
    with alone() as pool:
        page = written(tmp_path, problem, replace(found, front=Front((member,), 0)), pool)
    assert page["members"][0]["values"][0] == hostile
    assert page["members"][0]["view"] is None


def test_a_stop_while_shells_are_drawn_writes_what_there_is_and_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    several = DESIGN.replace('"sheet_area"', '"deviation.f.max"')
    (tmp_path / "vault.toml").write_text(several)
    monkeypatch.setattr("orishell.search.local_processes", lambda *_: alone())
    drawn = pages._drawn

    def stopping(*job: Any, **asked: Any) -> Any:
        signal.raise_signal(signal.SIGTERM)
        return drawn(*job, **asked)

    def searched() -> tuple[int | str, list[PageMember]]:
        done = orishell("search", tmp_path / "vault.toml", "--out", tmp_path / "out")
        return done.returncode, page_at(tmp_path / "out")["members"]

    with monkeypatch.context() as patched:
        patched.setattr(pages, "_drawn", stopping)
        status, members = searched()
    assert status == 128 + signal.SIGTERM
    assert len(members) > 1
    assert [each["view"] is None for each in members] == [False] + [True] * (len(members) - 1)
    assert members[-1]["missing"].startswith("It was stopped. The shell is made by: orishell")
    status, members = searched()
    assert status == 0
    assert all(each["view"] for each in members)


def test_a_search_does_not_begin_without_its_page(tmp_path: Path, stub: Path) -> None:
    require_installed()
    stub.unlink()
    with pytest.raises(InputError, match="npm run pages") as caught:
        require_installed()
    assert caught.value.what == "the page of a search has not been built"
