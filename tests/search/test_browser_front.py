"""front.html in a real browser: points chosen, shells folded and compared."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from orishell.conventions.progress import no_progress
from orishell.search import Problem, SearchResult, alone, journal_in_memory, search_designs
from orishell.search import page as pages
from orishell.search.page import write_page
from outside import outside_anywhere
from page_checks import MISPLACED, serious_findings
from samples import led_by, thorough
from search.problems import small_problem
from studio_pages import SIZES
from viewer_pages import (
    await_frames,
    pixels,
    require_viewer,
    wait_until,
    watched_page,
)

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow

VARIABLES = {"pattern.rows": [3, 5, 7], "pattern.columns": [3, 4, 5], "pattern.xi_deg": [50]}
MIXED = ["panels", "deviation.f.max", "deviation.g.max"]


def searched(minimise: list[str]) -> tuple[Problem, SearchResult]:
    problem = small_problem(
        "parallel-repeating", variables=VARIABLES, minimise=minimise, method="grid"
    )
    with alone() as pool:
        return problem, search_designs(problem, pool, journal_in_memory())


def written(path: Path, minimise: list[str]) -> tuple[Path, SearchResult]:
    require_viewer()
    problem, found = searched(minimise)
    with alone() as pool:
        write_page(path, problem, found, pool, no_progress)
    return path, found


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, SearchResult]:
    """The page of a search with two objectives, and what it shows."""
    return written(tmp_path_factory.mktemp("pair") / "front.html", ["panels", "deviation.f.max"])


@pytest.fixture(scope="module")
def three(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, SearchResult]:
    """Likewise with three."""
    return written(tmp_path_factory.mktemp("three") / "front.html", MIXED)


def opened(page: Page, path: Path) -> None:
    page.goto(path.as_uri())
    settled(page)


def settled(page: Page) -> None:
    """What was chosen is shown."""
    await_frames(page)
    wait_until(page, "window.orishell !== undefined && orishell.idle")
    await_frames(page)


def pressed(page: Page, key: str) -> tuple[int, int]:
    """The member chosen after a key was pressed, and the one that has the focus."""
    page.keyboard.press(key)
    settled(page)
    focused = page.evaluate(
        "[...document.querySelectorAll('[role=option]')].indexOf(document.activeElement)"
    )
    return page.evaluate("orishell.chosen"), focused


def figures(page: Page) -> str:
    return page.locator("table").inner_text()


def folds(page: Page) -> list[float]:
    return list(page.evaluate("orishell.shells.drawn.map((shell) => shell.fold)"))


def test_points_are_chosen_by_pointer_and_by_keys(
    browser: Browser, pair: tuple[Path, SearchResult]
) -> None:
    path, found = pair
    members, knee = found.front.members, found.front.knee
    last = len(members) - 1
    assert last >= 2
    with watched_page(browser) as page:
        opened(page, path)
        assert page.evaluate("orishell.chosen") == knee
        points = page.get_by_role("option")
        assert points.count() == len(members)
        for number in (last, 0):
            points.nth(number).click()
            settled(page)
            member = members[number]
            assert (
                page.get_by_role("heading", level=2)
                .inner_text()
                .startswith(f"front-{number + 1:02}")
            )
            assert f"front-{number + 1:02}.toml" in page.locator(".file").inner_text()
            assert f"{member.figures['panels']:.0f}" in figures(page)
            assert f"{member.values['pattern.columns']}" in figures(page)
            drawn = page.evaluate("orishell.shells.drawn[0].view.faces.length / 4")
            assert drawn == member.figures["panels"]
        # Objectives are two: along the front one grows and the other gets less.
        assert pressed(page, "ArrowRight") == (1, 1)
        assert pressed(page, "ArrowDown") == (2, 2)
        assert pressed(page, "ArrowLeft") == (1, 1)
        assert pressed(page, "ArrowUp") == (0, 0)
        assert pressed(page, "ArrowUp") == (0, 0)
        assert pressed(page, "End") == (last, last)
        assert pressed(page, "Home") == (0, 0)
        ring = "getComputedStyle(document.activeElement.querySelector('.ring')).strokeWidth"
        assert page.evaluate(ring) == "3.5px"
        assert points.nth(0).get_attribute("aria-selected") == "true"
        page.get_by_role("button", name="front-02").click()
        settled(page)
        assert page.evaluate("orishell.chosen") == 1
        assert " %, " in page.locator(".steps").inner_text()


@thorough
def test_a_shell_is_folded_and_stays_so_when_another_is_chosen(
    browser: Browser, pair: tuple[Path, SearchResult]
) -> None:
    with watched_page(browser) as page:
        opened(page, pair[0])
        assert folds(page) == [1.0]
        locked = pixels(page, ".orishell-scene canvas")
        page.get_by_role("slider").focus()
        page.keyboard.press("Home")
        await_frames(page)
        assert folds(page) == [0.0]
        flat = pixels(page, ".orishell-scene canvas")
        assert (np.abs(flat - locked).max(axis=-1) > 0.1).mean() > 0.01
        page.get_by_text("Mountain, valley", exact=True).click()
        page.get_by_role("option").nth(0).click()
        settled(page)
        assert folds(page) == [0.0]
        assert page.get_by_label("Mountain, valley").is_checked()
        assert page.evaluate("orishell.shells.drawn[0].look.colouring") == "signs"
        page.get_by_role("button", name="Locked").click()
        assert folds(page) == [1.0]


@thorough
def test_two_are_compared_at_one_scale_with_one_slider(
    browser: Browser, pair: tuple[Path, SearchResult]
) -> None:
    path, found = pair
    members = found.front.members
    with watched_page(browser) as page:
        opened(page, path)
        points = page.get_by_role("option")
        points.nth(0).click()
        settled(page)
        points.nth(len(members) - 1).click(modifiers=["Shift"])
        settled(page)
        assert page.evaluate("[orishell.chosen, orishell.pinned]") == [0, len(members) - 1]
        assert page.locator(".orishell-scene canvas").count() == 2
        first, second = (each.figures["panels"] for each in (members[0], members[-1]))
        share = 100 * (first - second) / second
        assert f"\u2212{-share:.1f} %" in figures(page)
        # Sizes are in the words of the verdict, of both.
        assert figures(page).count(" of panels without a thickness") == 2

        # The same size on the screen is the same size in the world, before and after a turn.
        arms = "orishell.shells.drawn.map((shell) => shell.eye.arm.toArray())"
        before = np.array(page.evaluate(arms))
        np.testing.assert_allclose(before[0], before[1], rtol=1e-9)
        box = page.locator(".orishell-scene canvas").nth(1).bounding_box()
        assert box is not None
        page.mouse.move(box["x"] + 20, box["y"] + 200)
        page.mouse.down()
        page.mouse.move(box["x"] + 120, box["y"] + 180, steps=4)
        page.mouse.up()
        await_frames(page)
        after = np.array(page.evaluate(arms))
        assert np.linalg.norm(after[0] - before[0]) > 0.05 * np.linalg.norm(before[0])
        np.testing.assert_allclose(after[0], after[1], rtol=1e-6)

        assert page.get_by_role("slider").count() == 1
        page.get_by_role("slider").focus()
        page.keyboard.press("Home")
        await_frames(page)
        assert folds(page) == [0.0, 0.0]
        page.get_by_role("button", name="Stop comparing").click()
        settled(page)
        assert page.locator(".orishell-scene canvas").count() == 1

        # Without a pointer: compare this one with the next that is chosen.
        page.get_by_role("button", name="Compare").click()
        assert "Choose another point" in page.locator(".hint").inner_text()
        page.get_by_role("option").nth(0).focus()
        assert pressed(page, "ArrowRight") == (1, 1)
        assert page.locator(".orishell-scene canvas").count() == 2
        assert page.evaluate("orishell.pinned") == 0


@pytest.mark.parametrize("size", led_by(["narrow", *SIZES]))
def test_the_page_at_every_size(
    browser: Browser, three: tuple[Path, SearchResult], size: str
) -> None:
    shape: dict[str, Any] = SIZES.get(size, {"width": 360, "height": 740})
    width, height = shape["width"], shape["height"]
    options = {key: value for key, value in shape.items() if key not in ("width", "height")}
    with watched_page(browser, bypass_csp=True, color_scheme="light", **options) as page:
        page.set_viewport_size({"width": width, "height": height})
        opened(page, three[0])
        for theme in ("light", "dark"):
            assert page.evaluate("document.documentElement.dataset.theme") == theme
            for pinned in ("null", "0"):
                page.evaluate(f"orishell.pin({pinned})")
                settled(page)
                assert page.evaluate("document.documentElement.scrollWidth") <= width
                assert page.evaluate("document.documentElement.scrollHeight") <= height
                assert page.evaluate(MISPLACED) == []
                assert serious_findings(page) == []
                for canvas in page.locator(".orishell-scene canvas").all():
                    box = canvas.bounding_box()
                    assert box is not None
                    assert min(box["width"], box["height"]) >= 180
            page.get_by_role("button", name="Light or dark").click()


@thorough
def test_axes_are_chosen_among_three_objectives(
    browser: Browser, three: tuple[Path, SearchResult]
) -> None:
    path, found = three
    points = np.array([[each.figures[name] for name in MIXED] for each in found.front.members])
    with watched_page(browser) as page:
        opened(page, path)

        def places() -> Any:
            return np.array(
                page.evaluate(
                    "[...document.querySelectorAll('[role=option] .ring')]"
                    ".map((ring) => [Number(ring.getAttribute('cx')), -ring.getAttribute('cy')])"
                )
            )

        for across, up in ((0, 1), (2, 1), (1, 2)):
            page.get_by_label("Across").select_option(str(across))
            page.get_by_label("Up").select_option(str(up))
            await_frames(page)
            for axis, objective in enumerate((across, up)):
                line = np.polyfit(points[:, objective], places()[:, axis], 1)
                assert line[0] > 0
                fitted = np.polyval(line, points[:, objective])
                np.testing.assert_allclose(places()[:, axis], fitted, atol=0.1)
        page.get_by_label("Across").select_option("2")
        assert page.get_by_label("Up").input_value() == "1"

        # Where points lie on each other, every click takes the next of them.
        page.get_by_label("Across").select_option("1")
        page.get_by_label("Up").select_option("2")
        place = places()[-1]
        lying = np.flatnonzero(np.abs(places() - place).max(axis=1) < 1)
        assert len(lying) == 2
        box = page.locator(".front-plot").bounding_box()
        assert box is not None
        page.locator(".point").nth(0).click()
        for number in (*lying, *lying):
            page.mouse.click(box["x"] + place[0], box["y"] - place[1])
            settled(page)
            assert page.evaluate("orishell.chosen") == number


def test_a_member_without_a_shell_says_what_makes_it(
    browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pages, "MOST_SHELLS", 1)
    path, found = written(tmp_path / "front.html", ["panels", "deviation.f.max"])
    last = len(found.front.members) - 1
    assert found.front.knee != last
    with watched_page(browser) as page:
        opened(page, path)
        page.get_by_role("option").nth(last).click()
        settled(page)
        said = page.locator(".missing").inner_text()
        assert said.startswith("Only 1 of the front")
        assert f"orishell design front-{last + 1:02}.toml" in said
        assert page.evaluate("orishell.shells.drawn.length") == 0
        assert f"{found.front.members[last].figures['panels']:.0f}" in figures(page)
        page.get_by_role("option").nth(0).click(modifiers=["Shift"])
        settled(page)
        assert page.evaluate("orishell.shells.drawn.length") == 1
        assert page.get_by_role("slider").is_visible()


def test_a_front_of_one_design(browser: Browser, tmp_path: Path) -> None:
    path, found = written(tmp_path / "front.html", ["sheet_area"])
    assert len(found.front.members) == 1
    with watched_page(browser) as page:
        opened(page, path)
        assert page.get_by_role("option").count() == 1
        assert page.get_by_role("button", name="Compare").count() == 0
        page.get_by_role("option").click()
        for key in ("ArrowRight", "ArrowUp", "End"):
            assert pressed(page, key) == (0, 0)
        assert page.locator(".orishell-scene canvas").count() == 1


def test_nothing_of_the_page_lies_outside(
    browser: Browser, three: tuple[Path, SearchResult]
) -> None:
    with watched_page(browser) as page:
        opened(page, three[0])
        page.evaluate("orishell.pin(0)")
        settled(page)
        assert outside_anywhere(page, opens=True) == {}
