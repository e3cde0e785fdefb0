"""What the studio opens with, and its examples as cards with pictures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from orishell.families.registry import FAMILIES
from page_checks import serious_findings
from studio_pages import SIZES, drawn, opened
from viewer_pages import await_frames, require_apart, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser

PICTURES = Path(__file__).parents[2] / "frontend/src/studio/files/pictures"
CARDS = ["shelter_snow", "shelter", "canopy", "tunnel", "dome", *FAMILIES]
LARGEST = 20_000
"""Bytes of a picture."""


def test_every_card_has_small_pictures() -> None:
    names = {f"{name}-{colours}.webp" for name in CARDS for colours in ("light", "dark")}
    assert {path.name for path in PICTURES.iterdir()} == names
    assert max(path.stat().st_size for path in PICTURES.iterdir()) < LARGEST


def test_opens_with_the_shelter_and_leads_to_others_by_keys(browser: Browser, address: str) -> None:
    with opened(browser, address, bypass_csp=True) as page:
        assert page.get_by_test_id("design-name").input_value() == "shelter"
        report = page.evaluate("window.__orishell.report")
        assert (report["rows"], report["columns"]) == (11, 13)
        button = page.get_by_test_id("examples")
        button.press("Enter")
        window = page.get_by_test_id("examples-window")
        cards = window.locator(".example-card")
        assert [each.get_attribute("data-testid") for each in cards.all()] == [
            f"example-{name}" for name in CARDS
        ]
        for colours in ("light", "dark"):
            page.evaluate(
                "colours => document.documentElement.dataset.theme === colours"
                " || document.querySelector('[data-testid=theme]').click()",
                colours,
            )
            shown = cards.locator("img").evaluate_all(
                "pictures => Promise.all(pictures.map((picture) => {"
                " picture.loading = 'eager';"
                " return picture.decode().then(() => [picture.naturalWidth, picture.src]);"
                "}))"
            )
            assert [width for width, _ in shown] == [336] * len(CARDS)
            assert all(f"-{colours}-" in source for _, source in shown)
            assert serious_findings(page) == []
        for size in ("phone", "tablet", "laptop"):
            width, height = SIZES[size]["width"], SIZES[size]["height"]
            page.set_viewport_size({"width": width, "height": height})
            await_frames(page)
            assert window.evaluate("element => element.scrollWidth <= element.clientWidth")
            require_apart(page, cards.all(), width)
        # Escape leaves all as it was, and the keyboard where it came from.
        page.keyboard.press("Escape")
        assert window.is_hidden()
        assert page.evaluate("document.activeElement.dataset.testid") == "examples"
        page.keyboard.press("Enter")
        for _ in range(20):
            page.keyboard.press("Tab")
            if page.evaluate("document.activeElement.dataset.testid") == "example-canopy":
                break
        page.keyboard.press("Enter")
        wait_until(page, "window.__orishell.store.name.value === 'canopy'")
        drawn(page)
        assert window.is_hidden()
        assert page.evaluate("window.__orishell.report.family") == "parallel-repeating"
        page.keyboard.press("Control+z")
        assert page.get_by_test_id("design-name").input_value() == "shelter"
