"""The verdict in the studio: rows, the worst first, what each found when it is asked for."""

from __future__ import annotations

from copy import deepcopy
from typing import TYPE_CHECKING, Any

from samples import thorough
from studio_pages import IDLE, opened, settle
from studio_server import HURRIED, running_studio
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

SNOW: dict[str, Any] = {
    "shell": {"family": "orthodiagonal", "unit": "m"},
    "target": {
        "f": {"formula": "-x**2", "range": [-1, 1]},
        "g": {"formula": "0.25*sin(pi*x/2)", "range": [0, 2]},
    },
    "pattern": {"rows": 5, "columns": 5, "flap": 0, "depth": 0.12, "heading_deg": 90},
    "structure": {
        "modulus": 9e9,
        "strength": 40e6,
        "crease_stiffness": "rigid",
        "crease_strength": 1e9,
        "thickness": 0.003,
        "cells": 2,
        "supports": [{"at": "feet", "kind": "pinned"}],
    },
    "load_case": [{"name": "snow", "snow": {"ground": 20000, "arrangement": "undrifted"}}],
    "workshop": {"stock": [2.5, 1.25]},
}
"""An arch without flaps under far more snow than panels of 3 mm bear (as in test_stronger.py)."""
SIGNS = """[...document.querySelectorAll('[data-testid=verify-status] [data-row]')]
    .map((row) => [row.dataset.row, row.dataset.sign])"""

ENDS = """[...document.querySelectorAll('.parameter-head')]
    .filter((row) => row.closest('.parameters, .deployment, .panel') && row.offsetParent)
    .map((row) => Math.max(
        ...[...row.querySelectorAll('input.number, select, .segmented, .stepper')]
            .filter((each) => each.offsetParent)
            .map((each) => each.getBoundingClientRect().right)))"""
"""Where the controls of the left panel end."""

MANY_CELLS, LONG = 12, 180.0
"""Cells with which an analysis that follows large displacements takes much longer than the proof,
and seconds in which it ends."""


@thorough  # what it says: tests/shell/test_verdict
def test_a_shell_that_nothing_holds_and_that_breaks_has_no_tick_for_it(page: Page) -> None:
    page.evaluate("design => window.__orishell.store.change(design, 'snow')", SNOW)
    settle(page)
    card = page.get_by_test_id("verify-status")
    assert card.get_by_role("heading").inner_text().endswith("Fails: Stands")
    rows = dict(page.evaluate(SIGNS))
    assert [*rows] == ["stands", "locks", "boards", "folds", "fits", "notes"]
    # Panels of 3 mm are of no thickness where they fold.
    warned = dict.fromkeys(("locks", "boards"), "warns")
    signs = {"stands": "fails", **warned, "folds": "holds", "fits": "holds"}
    assert {name: rows[name] for name in signs} == signs
    # What a report says is in the page's own words; all of it is there to be read.
    assert "[structure]" not in (card.text_content() or "")
    # The worst is open; the others say all when they are asked to, by keys.
    is_open = "row => row.parentElement.open"
    assert card.get_by_test_id("verdict-stands").evaluate(is_open)
    locks = card.get_by_test_id("verdict-locks")
    assert not locks.evaluate(is_open)
    locks.press("Enter")
    assert locks.evaluate(is_open)
    assert "only its supports stop it closing and opening" in locks.inner_text()
    # While it is proved anew nothing is known of it.
    store = "window.__orishell.store"
    page.evaluate(f"{store}.proof.set({{ state: 'running', share: 0.4, what: 'verifying' }})")
    await_frames(page)
    assert {sign for _, sign in page.evaluate(SIGNS)} == {"pending"}
    assert "40 %" in card.inner_text()
    page.evaluate(f"{store}.proof.set({{ state: 'done', refusal: null, mendable: [] }})")
    await_frames(page)
    assert locks.evaluate(is_open)
    # What mends it has been tried, and is a button.
    card.locator("[data-row=stands]").get_by_test_id("mend").click()
    settle(page)
    assert dict(page.evaluate(SIGNS))["stands"] != "fails"


def test_what_is_seldom_needed_is_folded_away(page: Page) -> None:
    page.evaluate("design => window.__orishell.store.change(design, 'snow')", SNOW)
    settle(page)
    spacing = page.get_by_test_id("param-spacing")
    assert spacing.is_hidden()
    page.get_by_test_id("more").press("Enter")
    assert spacing.is_visible()
    page.get_by_test_id("more").press("Enter")
    # Controls end at one edge.
    ends = page.evaluate(ENDS)
    assert len(ends) > 5
    assert max(ends) - min(ends) <= 1


@thorough  # waits out a limit, twice
def test_what_is_known_when_time_is_over_stays(browser: Browser, address: str) -> None:
    assert address, "pages are built"
    design = deepcopy(SNOW)
    design["structure"] |= {"cells": MANY_CELLS, "nonlinear": True, "thickness": 0.05}
    with running_studio(program=HURRIED) as studio, opened(browser, studio.entrance) as page:
        page.evaluate("design => window.__orishell.store.change(design, 'snow')", design)
        settle(page)
        card = page.get_by_test_id("verify-status")
        assert "Not finished in time" in card.get_by_role("heading").inner_text()
        row = {name: card.locator(f"[data-row={name}]") for name in ("stands", "folds", "fits")}
        signs = {name: each.get_attribute("data-sign") for name, each in row.items()}
        assert signs == {"stands": "warns", "folds": "holds", "fits": "holds"}
        assert "nothing touches" in (row["folds"].text_content() or "")
        assert "not finished in time" in row["stands"].inner_text()
        retry = card.get_by_test_id("retry")
        assert retry.count() == row["stands"].get_by_test_id("retry").count() == 1
        retry.click()
        # Until more is known, what is known is still there.
        wait_until(page, "window.__orishell.store.proof.value.found === true")
        assert row["folds"].get_attribute("data-sign") == "holds"
        wait_until(page, IDLE, LONG)
        assert retry.count() == 0
        assert "under snow" in (row["stands"].text_content() or "")


def test_a_note_has_the_button_that_does_it(page: Page) -> None:
    design = {key: table for key, table in SNOW.items() if key in ("shell", "target", "pattern")}
    page.evaluate("design => window.__orishell.store.change(design, 'arch')", design)
    settle(page)
    notes = page.get_by_test_id("verify-status").locator("[data-row=notes]")
    notes.get_by_test_id("verdict-notes").press("Enter")
    # How a file says it is no affair of the page.
    assert not {"=", "["} & set(notes.inner_text())
    opens = notes.get_by_text("opens under its own weight")
    assert opens.count() == 1
    notes.get_by_role("button", name="Tie its feet together").click()
    settle(page)
    assert page.evaluate("window.__orishell.store.design.value.deployment") == {"ties": "feet"}
    assert opens.count() == 0
    # Notes that are open stay so, and what mends them is tried again.
    notes.get_by_role("button", name="Boards of 2.5 x 1.25 m").wait_for()


def test_what_takes_long_to_mend_is_tried_at_a_word(page: Page) -> None:
    design = {key: table for key, table in SNOW.items() if key in ("shell", "target", "pattern")}
    design |= {"tolerance": {"surface": 0.2}, "pattern": {"flap": 0, "depth": 0.12}}
    page.evaluate("design => window.__orishell.store.change(design, 'arch')", design)
    page.get_by_test_id("choose").click()
    settle(page)
    notes = page.get_by_test_id("verify-status").locator("[data-row=notes]")
    if notes.locator("details").get_attribute("open") is None:
        notes.get_by_test_id("verdict-notes").click()
    slot = notes.get_by_test_id("mend-no-flaps")
    look = slot.get_by_test_id("look-for-mend")
    look.wait_for()
    assert slot.get_by_test_id("mend").count() == 0
    look.click()
    slot.get_by_role("button", name="Flaps as wide as they may be").click(timeout=120_000)
    assert page.evaluate("window.__orishell.store.design.value.pattern.flap") == "auto"
