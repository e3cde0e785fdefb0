"""Designs that carry, found in the studio from one that does not: told, stopped, opened."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from node_tools import PACKAGES, lacking
from samples import led_by, thorough
from studio_pages import SIZES, opened, settle
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

ARCH: dict[str, Any] = {
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
        "line_strength": 1e9,
        "thickness": 0.003,
        "cells": 1,
        "supports": [{"at": "feet", "kind": "fixed", "edges": True}],
    },
    "load_case": [{"name": "snow", "snow": {"ground": 20000, "arrangement": "undrifted"}}],
    "workshop": {"areal_density": 5.0},
}
"""A small arch with as little as possible that could be tried: thicker panels do it."""
DESIGN = "window.__orishell.store.design.value"
STATE = "document.querySelector('[data-testid=carry]').dataset.state"
SHOWN = "document.querySelectorAll('[data-testid=carry-table] tbody').length"


def ask(page: Page, design: dict[str, Any] = ARCH) -> None:
    page.evaluate("design => window.__orishell.store.change(design, 'arch')", design)
    settle(page)
    assert page.get_by_test_id("structure-verdict").get_attribute("data-tone") == "fails"
    page.get_by_test_id("make-it-carry").click()


def await_end(page: Page) -> None:
    wait_until(page, f"['found', 'failed'].includes({STATE})", 120)
    await_frames(page)


def test_a_row_of_what_carries_opens_as_the_design(page: Page) -> None:
    ask(page)
    assert page.evaluate(STATE) == "running"
    work = page.get_by_test_id("carry-work")
    wait_until(page, "document.querySelector('[data-testid=carry-work]').innerText.includes('%')")
    assert work.is_visible()
    assert not page.get_by_test_id("make-it-carry").is_visible()
    # What was tried is told while the search goes on.
    wait_until(page, "document.querySelectorAll('[data-testid=carry-tried] li').length > 0")
    await_end(page)
    assert page.evaluate(STATE) == "found"
    assert page.evaluate(SHOWN) >= 1
    assert not work.is_visible()
    tried = page.get_by_test_id("carry-tried")
    assert "changes were tried" in tried.locator("summary").inner_text()
    assert "structure." not in (tried.text_content() or "")

    page.get_by_test_id("carry-open-0").click()
    settle(page)
    first = page.evaluate(DESIGN)
    assert first["structure"]["thickness"] != ARCH["structure"]["thickness"]
    assert page.evaluate("window.__orishell.report.structure.carries") is True
    assert page.get_by_test_id("structure-verdict").get_attribute("data-tone") == "holds"
    assert page.get_by_test_id("carries-0").get_attribute("aria-current") == "true"
    assert not page.get_by_test_id("make-it-carry").is_visible()
    # One step, and the table stays: it begins from the design that is there again.
    page.get_by_test_id("undo").click()
    settle(page)
    assert page.evaluate(DESIGN) == ARCH
    assert page.get_by_test_id("carries-0").get_attribute("aria-current") is None
    assert page.get_by_test_id("carry-table").is_visible()
    # Of another design it says nothing.
    page.evaluate("window.__orishell.store.set({ 'pattern.depth': 0.13 }, 'depth')")
    settle(page)
    assert not page.get_by_test_id("carry-table").is_visible()
    assert page.get_by_test_id("make-it-carry").is_visible()


def test_the_search_is_stopped(page: Page) -> None:
    # Of the arch itself another test may have found what carries, which is still there.
    ask(page, ARCH | {"pattern": ARCH["pattern"] | {"depth": 0.125}})
    page.get_by_test_id("carry-work-stop").click()
    assert page.evaluate(STATE) == "stopped"
    assert "Stopped before the end" in page.get_by_test_id("carry-note").inner_text()
    assert page.get_by_test_id("make-it-carry").is_visible()
    page.wait_for_timeout(500)
    assert page.evaluate(STATE) == "stopped"


@thorough
@pytest.mark.parametrize("size", led_by(SIZES, 2))
def test_what_carries_lies_within_the_page(browser: Browser, address: str, size: str) -> None:
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    with opened(browser, address, bypass_csp=True, **SIZES[size]) as page:
        page.add_script_tag(path=str(axe))
        ask(page)
        await_end(page)
        page.get_by_test_id("carry-tried").locator("summary").click()
        for theme in ("light", "dark"):
            page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
            found = page.evaluate(
                "axe.run('.carry').then((result) => result.violations.filter("
                "({ impact }) => ['serious', 'critical'].includes(impact)).map(({ id }) => id))"
            )
            assert found == []
        section = page.get_by_test_id("carry")
        assert section.evaluate("part => part.scrollWidth <= part.clientWidth")
        box = section.bounding_box()
        assert box is not None
        assert box["x"] + box["width"] <= SIZES[size]["width"]
