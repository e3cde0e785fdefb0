"""Numbers are read as people type them, in the unit of their box or another one, in a browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from studio_pages import choose, drawn, settle

if TYPE_CHECKING:
    from playwright.sync_api import Page

DESIGN = "window.__orishell.store.design.value"
TYPED = [
    ("depth", "250 mm", 0.25, "= 0.25 m"),
    ("depth", "0,3", 0.3, "= 0.3 m"),
    ("depth", "1/4", 0.25, "= 0.25 m"),
    ("heading_deg", "pi/2 rad", 90, "= 90 °"),
]


def test_numbers_in_other_units(page: Page) -> None:
    """What each means is said below it; the box holds it in its own unit once it is left."""
    choose(page, "orthodiagonal")
    settle(page)
    for key, text, value, echo in TYPED:
        field = page.get_by_test_id(f"param-{key}")
        if not field.is_visible():
            page.get_by_test_id("more-parameters").click()
        field.fill(text)
        said = page.locator("output.echo")
        assert said.inner_text().strip() == echo
        assert field.input_value() == text
        field.press("Tab")
        assert said.count() == 0
        assert float(field.input_value()) == pytest.approx(value)
        drawn(page)
        assert page.evaluate(f"{DESIGN}.pattern.{key}") == pytest.approx(value)


def test_what_is_no_number_changes_nothing(page: Page) -> None:
    """Nor a number of what the box is not of; its border says so until it is mended."""
    choose(page, "orthodiagonal")
    settle(page)
    field = page.get_by_test_id("param-depth")
    before = page.evaluate(f"{DESIGN}.pattern.depth")
    for text in ("deep", "45°", "1,2,3", ""):
        field.fill(text)
        assert "unfinished" in (field.get_attribute("class") or "")
        assert page.evaluate(f"{DESIGN}.pattern.depth") == before
    field.fill("0.2 m")
    assert "unfinished" not in (field.get_attribute("class") or "")
    assert page.evaluate(f"{DESIGN}.pattern.depth") == pytest.approx(0.2)
    field.press("ArrowUp")
    assert page.evaluate(f"{DESIGN}.pattern.depth") == pytest.approx(0.21)
