"""Another design takes the place of the present one: nothing is left of that, and what is open is
what comes back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from orishell.design_file import starter_file
from samples import thorough
from studio_pages import drawn, drop_file, figures, fold, opened, settle
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

STORE = "window.__orishell.store"
ORTHODIAGONAL = (
    starter_file("orthodiagonal")
    .replace("rows = 9 ", "rows = 5 ")
    .replace("columns = 13", "columns = 7")
)
PACKED = f"{ORTHODIAGONAL}\n[deployment]\nfrom = 'pack'\n"
SPLINE = """
[shell]
family = "parallel-repeating"
unit = "m"
[target.f]
points = [[-1.55, 0], [-1.1, 1.4], [0, 2.3], [1.2, 1.2], [1.55, 0]]
[target.g]
formula = "0.2*x"
range = [0, 4]
[pattern]
rows = 5
columns = 5
flap = 0.1
xi_deg = "auto"
"""


def open_text(page: Page, name: str, text: str) -> None:
    drop_file(page, f"{name}.toml", text)
    wait_until(page, f"{STORE}.name.value === '{name}'")
    drawn(page)


def reload(page: Page) -> None:
    page.once("dialog", lambda dialog: dialog.accept())
    page.reload()
    wait_until(page, "window.__orishell !== undefined")
    drawn(page)


@thorough
def test_what_is_open_comes_back(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        page.evaluate(f"{STORE}.setPattern('rows', 7)")
        drawn(page)
        # Work on another design was not saved: that is kept, and not what is open.
        open_text(page, "mine", ORTHODIAGONAL)
        reload(page)
        assert page.evaluate(f"{STORE}.name.value") == "mine"
        assert page.evaluate(f"{STORE}.unsaved") is False
        assert page.evaluate(f"{STORE}.design.value.shell.family") == "orthodiagonal"
        # The same once it was changed and saved.
        page.evaluate(f"{STORE}.setPattern('rows', 7)")
        with page.expect_download():
            page.keyboard.press("Control+s")
        wait_until(page, f"!{STORE}.unsaved")
        reload(page)
        assert page.evaluate(f"[{STORE}.name.value, {STORE}.unsaved]") == ["mine", False]
        assert page.evaluate(f"{STORE}.design.value.pattern.rows") == 7
        # What was not saved comes back too, and undo leaves it for the file.
        page.evaluate(f"{STORE}.setPattern('rows', 9)")
        drawn(page)
        reload(page)
        assert page.evaluate(f"[{STORE}.name.value, {STORE}.unsaved]") == ["mine", True]
        assert page.evaluate(f"{STORE}.design.value.pattern.rows") == 9
        page.get_by_test_id("undo").click()
        assert page.evaluate(f"{STORE}.design.value.pattern.rows") == 7
        assert page.evaluate(f"{STORE}.unsaved") is False


@thorough
def test_nothing_is_left_of_the_design_before(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        # Not the text in the field that has the focus, nor the state of its motion.
        fold(page, 0.4)
        text = page.get_by_test_id("formula-g")
        text.fill("0.1*x")
        drawn(page)
        open_text(page, "mine", ORTHODIAGONAL)
        assert page.evaluate("document.activeElement.dataset.testid") == "formula-g"
        assert text.input_value() == page.evaluate(f"{STORE}.design.value.target.g.formula")
        assert page.evaluate("window.__orishell.fold") == 1
        # While one is typed, what means the same is left as it is typed.
        end = page.get_by_test_id("range-g-high")
        end.fill("3.0")
        wait_until(page, f"{STORE}.design.value.target.g.range[1] === 3")  # when typing rests
        assert end.input_value() == "3.0"
        length = page.get_by_test_id("length-g")
        length.fill("4")
        drawn(page)
        page.get_by_test_id("undo").click()
        drawn(page)
        assert float(length.input_value()) == 3
        # And nothing at all while there is no shell.
        page.get_by_test_id("new").click()
        drawn(page)
        for name in ("figures", "pattern", "pattern-legend", "standing-legend", "fold-slider"):
            assert page.get_by_test_id(name).is_hidden()
        assert "There is no shell yet" in page.get_by_test_id("verify-status").inner_text()
        assert page.evaluate("window.__orishell.report") is None
        page.get_by_test_id("undo").click()
        drawn(page)
        assert "Panels" in figures(page)


@thorough
def test_numbers_are_those_that_were_typed_and_counted(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        # What is said to work is what is taken.
        open_text(page, "bend", starter_file("parallel-repeating"))
        settle(page)
        assert "to at least" in page.locator(".parameter[data-key=flap] .note").inner_text()
        page.get_by_test_id("param-flap").fill("5")
        drawn(page)
        assert page.evaluate(f"[{STORE}.freshness.value, {STORE}.fault.value]") == ["current", None]
        # A spline goes another way between points that are stretched in one direction.
        open_text(page, "spline", SPLINE)
        page.get_by_test_id("proportional-f").click()
        for name, size in (("height", "3"), ("span", "4.5")):
            page.get_by_test_id(f"{name}-f").fill(size)
            drawn(page)
            page.get_by_test_id("design-name").focus()
            assert page.get_by_test_id(f"{name}-f").input_value() == size
        page.get_by_test_id("proportional-f").click()
        # Panels are counted with those that are clipped on, as the report and a search count them.
        open_text(page, "packed", PACKED)
        settle(page)
        quantities = page.evaluate("window.__orishell.report.quantities")
        assert quantities["clipped"] > 0
        row = page.locator("[data-figure=panels]")
        assert row.locator(".orishell-number").inner_text() == str(quantities["panels"])
        assert f"and {quantities['clipped']} clipped on" in row.inner_text()
        # Its sheets are drawn, though it opens from the pack.
        page.get_by_test_id("export").click()
        state = "document.querySelector('[data-testid=sheet-preview]').dataset.state"
        wait_until(page, f"['shown', 'refused'].includes({state})")
        assert page.evaluate(state) == "shown"
