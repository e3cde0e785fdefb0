"""A crease pattern in the studio as a person uses it: dropped or opened, mended, folded, kept."""

from __future__ import annotations

import base64
import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import httpx

from orishell.conventions.toml_file import parse_toml
from orishell.design_file import starter_file
from patterns import fold_of, miura, svg_of, waterbomb
from samples import thorough
from studio_pages import IDLE, choose, settle
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Page

ARCH = Path(__file__).parents[2] / "examples" / "arch_pattern.svg"


def state(page: Page, of: str) -> Any:
    return page.evaluate(f"window.__orishell.store.{of}")


def drop(page: Page, name: str, text: str, at: str = ".results") -> None:
    content = base64.b64encode(text.encode()).decode()
    page.evaluate(
        """([name, content, at]) => {
            const data = new DataTransfer();
            data.items.add(new File([atob(content)], name));
            const how = { dataTransfer: data, bubbles: true, cancelable: true };
            document.querySelector(at).dispatchEvent(new DragEvent("drop", how));
        }""",
        [name, content, at],
    )


@thorough
def test_our_own_drawing_folds_and_is_kept(page: Page, client: httpx.Client) -> None:
    choose(page, "orthodiagonal")
    sheet = parse_toml(starter_file("pattern"))
    drawn = client.post("/api/export", json={"design": sheet, "format": "svg"}).text
    drop(page, "own.svg", drawn)
    # Mountains, valleys and a border: nobody is asked what that is.
    wait_until(page, "window.__orishell.store.name.value === 'own'")
    assert page.get_by_test_id("drop-choice").is_hidden()
    settle(page)
    assert state(page, "fault.value") is None
    assert state(page, "report.value.parameters.fold_deg") == 90
    assert state(page, "design.value.target.pattern.unit") == "mm"
    facts = page.get_by_test_id("drawing-facts").inner_text()
    assert "6 x 7 panels" in facts
    assert "flat-foldable" in facts
    assert "read from own.svg" in page.get_by_test_id("drawing-form").inner_text().lower()


@thorough
def test_a_drawing_can_be_scaled_and_comes_back_after_a_reload(page: Page) -> None:
    drop(page, "own.fold", json.dumps(fold_of(miura())))
    wait_until(page, "window.__orishell.store.name.value === 'own'")
    settle(page)
    width = state(page, "report.value.sheet.width")
    page.get_by_test_id("drawing-scale").fill("2")
    settle(page)
    assert abs(state(page, "report.value.sheet.width") / width - 2) < 1e-9
    # It is in no design file: the page brings it back.
    page.once("dialog", lambda dialog: dialog.accept())
    page.reload()
    wait_until(page, IDLE)
    assert state(page, "design.value.target.pattern.scale") == 2
    assert state(page, "name.value") == "own"
    assert "5 x 6 panels" in page.get_by_test_id("drawing-facts").inner_text()


def test_a_pattern_of_origami_simulator_is_opened(page: Page) -> None:
    with page.expect_file_chooser() as chooser:
        page.get_by_test_id("open").click()
    chooser.value.set_files(ARCH)
    wait_until(page, "window.__orishell.store.name.value === 'arch_pattern'")
    # It is in pixels: how wide the sheet is, is asked.
    asks = page.get_by_test_id("drawing-asks")
    width = page.get_by_test_id("drawing-width")
    assert asks.is_visible()
    assert width.evaluate("box => box === document.activeElement")
    width.fill("650 cm")
    settle(page)
    assert abs(state(page, "report.value.sheet.width") - 6.5) < 1e-9
    page.keyboard.press("Tab")
    page.get_by_test_id("undo").click()
    assert asks.is_visible()
    page.get_by_test_id("drawing-unit").select_option("cm")
    settle(page)
    assert asks.is_hidden()
    assert state(page, "fault.value") is None
    # 600 units of the drawing.
    assert abs(state(page, "report.value.sheet.width") - 6) < 1e-3
    assert state(page, "report.value.parameters.fold_deg") == 90


def test_what_is_wrong_with_a_file_is_one_message_with_what_mends_it(page: Page) -> None:
    before = state(page, "name.value")
    drop(page, "bomb.svg", svg_of(waterbomb()), "[data-testid=drawing-form]")
    banner = page.get_by_test_id("banner")
    banner.wait_for()
    assert "The panels do not make a grid." in banner.inner_text()
    assert "bomb.svg: at (" in banner.inner_text()
    assert state(page, "name.value") == before
    # It is shown in place of the shell and of its pattern, with every panel that is wrong.
    refused = page.get_by_test_id("refused")
    assert refused.is_visible()
    panels = len(waterbomb().faces)
    for each in (refused, page.get_by_test_id("refused-sheet")):
        assert each.locator(".refused-mark").count() == panels
        assert each.locator(".refused-mountain, .refused-valley, .refused-border").count() == 3
    marks = page.get_by_test_id("refused-marks")
    assert "a panel of 3 vertices" in marks.inner_text()
    marks.locator("li").first.focus()
    assert refused.locator(".refused-mark.lit").count() == panels
    page.get_by_test_id("refused-back").click()
    assert refused.is_hidden()
    assert banner.is_hidden()
    # One line begins beside its corner, by more than is joined unasked: a hundredth of the sheet.
    torn = re.sub(r'x1="([^"]+)"', lambda x: f'x1="{float(x[1]) + 0.1}"', svg_of(miura()), count=1)
    drop(page, "torn.svg", torn, "[data-testid=drawing-form]")
    wait_until(page, "document.querySelector('.banner').innerText.includes('torn.svg')")
    page.get_by_test_id("use-nearest").click()
    wait_until(page, "window.__orishell.store.name.value === 'torn'")
    settle(page)
    assert "5 x 6 panels" in page.get_by_test_id("drawing-facts").inner_text()
    assert not banner.is_visible() or "torn.svg" not in banner.inner_text()
    assert refused.is_hidden()


def test_a_sheet_that_does_not_fold_is_shown_with_its_vertices(page: Page) -> None:
    # One line of a pattern that folds has the colour of the other kind.
    text = svg_of(miura())
    at = text.index("#ff0000", text.index("#ff0000", len(text) // 2))
    drop(page, "wrong.svg", text[:at] + "#0000ff" + text[at + 7 :])
    wait_until(page, "window.__orishell.store.name.value === 'wrong'")
    refused = page.get_by_test_id("refused")
    refused.wait_for()
    assert refused.locator(".refused-mark").count() in (1, 2)
    assert "three creases" in page.get_by_test_id("refused-marks").inner_text()
    settle(page)
    page.get_by_test_id("undo").click()
    settle(page)
    assert refused.is_hidden()
