"""A proof that takes longer than the studio waits: what is known stays, the rest can be tried again."""

from __future__ import annotations

from copy import deepcopy
from typing import TYPE_CHECKING

from studio_pages import IDLE, opened, settle
from studio_server import HURRIED, running_studio
from test_browser_verdict import SNOW
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser

MANY_CELLS, LONG = 16, 180.0
"""Cells with which an analysis that follows large displacements takes much longer than the proof,
and seconds in which it ends."""


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
