"""The family left open in the studio: all are tried, a table says what each does, one goes on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from orishell.families.registry import TRIED
from samples import thorough
from studio_pages import choose, drawn, settle, take_family
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Page

STORE = "window.__orishell.store"
SURFACE = """() => {
    const store = window.__orishell.store, design = structuredClone(store.design.value);
    const formula = "-0.4*x**2 - 0.1*y**2";
    design.target = { surface: { formula, x: [-1, 1], y: [-1, 1] } };
    Object.assign(design.pattern, { rows: 3, columns: 4 });
    store.change(design, "surface");
}"""
VAULT = """() => {
    const store = window.__orishell.store, design = structuredClone(store.design.value);
    design.target = {
        f: { formula: "-0.5*x**2", range: [-1, 1] },
        g: { formula: "0*x", range: [0, 3] },
    };
    Object.assign(design.pattern, { rows: 3, columns: 4 });
    store.change(design, "vault");
}"""


def state(page: Page, of: str) -> Any:
    return page.evaluate(f"{STORE}.{of}")


def any_family(page: Page) -> None:
    choose(page, "parallel-repeating")
    page.evaluate(VAULT)
    take_family(page, "auto")
    settle(page)


@thorough
def test_of_curves_the_best_is_shown_and_another_can_be_taken(page: Page) -> None:
    any_family(page)
    trials = state(page, "trials.value")
    tried = {each["family"]: each for each in trials["tried"]}
    assert list(tried) == list(TRIED)
    assert state(page, "report.value.family") == trials["family"]
    assert state(page, "design.value.shell.family") == "auto"
    # The proof is of the shell in the table, to the last digit.
    assert state(page, "proof.value.state") == "done"
    best = tried[trials["family"]]
    assert state(page, "report.value.deviation.surface.max") == best["distance"]
    assert state(page, "report.value.sheet.area") == best["sheet_area"]
    table = page.get_by_test_id("family-trials")
    assert table.locator("tbody").count() == len(TRIED)
    assert table.locator("tbody.taken").get_attribute("data-family") == trials["family"]
    for family, each in tried.items():
        said = table.locator(f"[data-family={family}]").inner_text()
        assert str(each["panels"]) in said if each["distance"] is not None else "Go on" not in said
    other = next(
        name for name, each in tried.items() if each["distance"] and name != trials["family"]
    )
    page.get_by_test_id(f"go-on-{other}").click()
    settle(page)
    assert state(page, "design.value.shell.family") == other
    assert state(page, "report.value.sheet.area") == tried[other]["sheet_area"]
    assert not table.is_visible()
    page.get_by_test_id("undo").click()
    settle(page)
    assert state(page, "trials.value.family") == trials["family"]


def stopped(page: Page) -> None:
    """A trial on a surface, stopped after the first family."""
    page.evaluate(SURFACE)
    wait_until(page, f"{STORE}.trials.value?.tried.length > 0")
    assert page.get_by_test_id("fit-work").is_visible()
    page.get_by_test_id("fit-work-stop").click()


@thorough  # a fit that is stopped, in test_browser_surface, is the quicker member
def test_a_trial_on_a_surface_can_be_stopped(page: Page) -> None:
    any_family(page)
    stopped(page)
    assert state(page, "freshness.value") == "outdated"
    assert "families was stopped" in page.locator(".fit-bar").inner_text()


@thorough
def test_of_a_surface_all_are_tried_after_one_was_stopped(page: Page) -> None:
    any_family(page)
    stopped(page)
    page.get_by_test_id("fit-again").click()
    settle(page)
    assert state(page, "freshness.value") == "current"
    assert state(page, "report.value.family") == state(page, "trials.value.family")
    assert len(state(page, "trials.value.tried")) == 5


@thorough  # what is told of each family: test_families
def test_where_no_family_makes_a_shell_each_says_why(page: Page) -> None:
    any_family(page)
    curve = "{ formula: '0*x + abs(x)', range: [-1, 1] }"
    page.evaluate(f"{STORE}.set({{ 'target.f': {curve}, 'target.g.formula': '9*x**2' }}, 'bad')")
    drawn(page)
    wait_until(page, f"{STORE}.freshness.value !== 'computing'")
    rows = page.locator("[data-testid=family-trials] tbody")
    reasons = page.locator("[data-testid=family-trials] .why-not")
    made = page.locator("[data-testid^=go-on-]")
    assert rows.count() == reasons.count() + made.count() == 4


def test_keys_on_the_way_to_a_family_take_nothing_from_the_design(page: Page) -> None:
    """Among the cards between is one that follows no surface, and one undo takes the way back."""
    choose(page, "parallel-repeating")
    page.evaluate(SURFACE)
    before = state(page, "design.value")
    page.get_by_test_id("family-parallel-repeating").focus()
    walked = []
    for _ in range(6):
        page.keyboard.press("ArrowRight")
        walked.append(state(page, "design.value.shell.family"))
    assert walked[-3:] == ["pattern", "t-hedral", "auto"]
    assert state(page, "design.value.target") == before["target"]
    page.keyboard.press("ArrowRight")
    assert state(page, "design.value") == before
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    assert state(page, "design.value.target") == before["target"]
    page.evaluate(f"{STORE}.undo()")
    assert state(page, "design.value") == before
    drawn(page)
