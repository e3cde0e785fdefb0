"""The studio's page itself: at four sizes, in two themes, in words, by keys, fingers and drops."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import pytest

from orishell.design_file import starter_file
from page_checks import CUT_RINGS, MISPLACED, serious_findings
from samples import led_by, thorough
from studio_pages import FREE, SIZES, all_formats, choose, drawn, drop_file, in_bar, opened, settle
from viewer_pages import await_frames, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

STARTS = ["orishell-theme", "orishell.tour"]


@pytest.mark.parametrize("size", led_by(SIZES))
def test_the_page_at_every_size(browser: Browser, address: str, size: str) -> None:
    options: dict[str, Any] = {**SIZES[size], "bypass_csp": True, "color_scheme": "light"}
    with opened(browser, address, **options) as page:
        choose(page, "parallel-repeating")
        width, height = options["width"], options["height"]
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        scene = _box(page.get_by_test_id("scene"))
        assert scene["width"] >= 0.45 * width
        assert scene["height"] >= 0.35 * height
        if size == "phone":
            _is_one_column(page)
        else:
            assert page.evaluate("document.documentElement.scrollHeight") <= height
            for name in ("curve-f", "curve-g"):
                curve = _box(page.get_by_test_id(name))
                assert 0 <= curve["y"] <= height - min(curve["height"], 80)
                assert curve["x"] + curve["width"] <= scene["x"]
        if "has_touch" in options:
            for name in ("play", "undo", "export", "more-rows", "param-xi_deg"):
                assert _box(page.get_by_test_id(name))["height"] >= 44
        assert page.evaluate(CUT_RINGS) == []
        for theme in ("light", "dark"):
            assert page.evaluate("document.documentElement.dataset.theme") == theme
            await_frames(page)
            assert page.evaluate(MISPLACED) == []
            assert serious_findings(page) == []
            in_bar(page, "theme").click()
        # What is wrong is said beside the shell, and leaves it in sight.
        page.evaluate("window.__orishell.store.setPattern('xi_deg', 120)")
        settle(page)
        scene, banner = (_box(page.get_by_test_id(each)) for each in ("scene", "banner"))
        assert banner["y"] + banner["height"] <= scene["y"] or banner["y"] >= scene["y"] + 100
        assert scene["height"] >= 0.2 * height
        assert page.evaluate(MISPLACED) == []


def test_a_phone_has_one_row_of_buttons_and_a_menu(browser: Browser, address: str) -> None:
    with opened(browser, address, **SIZES["phone"], bypass_csp=True) as page:
        assert _box(page.locator(".toolbar"))["height"] < 60
        menu = page.get_by_test_id("toolbar-more")
        menu.tap()
        buttons = page.locator(".toolbar-menu button").all()
        assert [each.inner_text() for each in buttons] == [
            *("Examples", "New", "Open", "Save", "Copy link", "Dark colours", "Help")
        ]
        assert all(_box(each)["height"] >= 44 for each in buttons)
        page.get_by_test_id("unit").select_option("mm")
        assert page.get_by_test_id("unit").is_visible()  # a choice does not close it
        page.keyboard.press("Escape")
        assert page.get_by_test_id("save").is_hidden()
        assert page.evaluate("document.activeElement.dataset.testid") == "toolbar-more"
        for theme in ("light", "dark"):
            assert page.evaluate("document.documentElement.dataset.theme") == theme
            menu.tap()
            await_frames(page)
            assert serious_findings(page) == []
            page.get_by_test_id("theme").tap()
            assert page.get_by_test_id("theme").is_hidden()  # what is done closes it
        # On a wide page the same controls stand in the bar, and keys go through it.
        page.set_viewport_size({"width": 1280, "height": 720})
        assert menu.is_hidden()
        page.get_by_test_id("link").focus()
        page.keyboard.press("Control+z")
        assert page.evaluate("window.__orishell.store.design.value.shell.unit") == "m"


WINDOWS = ("parts", "examples", "help", "sketch", "surface")


@pytest.mark.parametrize("window", led_by(WINDOWS))
@pytest.mark.parametrize("size", led_by(SIZES))
def test_windows_at_every_size(browser: Browser, address: str, size: str, window: str) -> None:
    with opened(browser, address, **SIZES[size], bypass_csp=True, color_scheme="light") as page:
        if window == "parts":
            for each in page.locator(".inputs details > summary").all():
                if each.is_visible():  # what was tried is there once something was
                    each.click()
            page.evaluate("scrollTo(0, 0)")
        elif window == "examples":
            in_bar(page, window).click()
        elif window == "help":
            page.keyboard.press("?")
        elif window == "sketch":
            in_bar(page, "new").click()
        else:
            page.locator("label:has([data-testid=aim-surface])").click()
            drawn(page)
        for theme in ("light", "dark"):
            page.evaluate("theme => { document.documentElement.dataset.theme = theme; }", theme)
            await_frames(page)
            if window in ("parts", "sketch"):  # windows lie on what is behind them
                assert page.evaluate(MISPLACED) == []
            assert serious_findings(page) == []
            assert page.evaluate("document.documentElement.scrollWidth") <= SIZES[size]["width"]


def _box(element: Locator) -> dict[str, float]:
    box = element.bounding_box()
    assert box is not None
    return {"x": box["x"], "y": box["y"], "width": box["width"], "height": box["height"]}


def _is_one_column(page: Page) -> None:
    """Shell, fold, curves, parameters, pattern and figures below each other; the shell stays."""
    places = [
        _box(page.locator(each).first)
        for each in (".scene", ".fold-bar", ".plot-frame", ".parameters", ".sheet", ".figures")
    ]
    ends = [place["y"] for place in places]
    assert ends == sorted(ends)
    assert all(place["width"] >= 340 for place in places)
    # A swipe beside the shell scrolls the page, one that begins on it turns it.
    camera = "window.__orishell.shell3d.camera.position.toArray()"
    client = page.context.new_cdp_session(page)

    def swipe(x: float, y: float, down: float) -> None:
        for kind, steps in (("touchStart", [0]), ("touchMove", range(1, 9)), ("touchEnd", [None])):
            for step in steps:
                at = [] if step is None else [{"x": x, "y": y + down * step / 8}]
                client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})
                await_frames(page)

    scene = places[0]
    before = page.evaluate(camera)
    x, y = page.evaluate(FREE)
    swipe(x, y, -80)
    assert page.evaluate("scrollY") == 0
    assert page.evaluate(camera) != before
    page.get_by_test_id("fit").click()
    await_frames(page)
    swipe(scene["x"] + 12, scene["y"] + scene["height"] - 60, -120)
    wait_until(page, "scrollY > 40")
    page.evaluate("scrollTo(0, 1e6)")
    await_frames(page)
    assert _box(page.get_by_test_id("scene"))["y"] == pytest.approx(0, abs=1)
    page.evaluate("scrollTo(0, 0)")


def test_words_are_those_of_the_page(page: Page) -> None:
    choose(page, "parallel-repeating")
    settle(page)
    counted = page.get_by_test_id("panel-count").inner_text()
    assert "9 \u00d7 11 vertices" in counted
    assert "10 \u00d7 12 = 120 panels" in counted
    assert page.evaluate("window.__orishell.store.view.value.faces.length") == 4 * 120
    page.get_by_test_id("param-xi_deg").fill("120")
    settle(page)
    banner = page.get_by_test_id("banner")
    assert "Crease angle \u03be = 120\u00b0 is too large for f." in banner.inner_text()
    assert "Use crease angle \u03be = 53" in banner.inner_text()
    assert "Go to Crease angle \u03be" in banner.inner_text()
    assert "_deg" not in page.locator("body").inner_text()
    # Another design: what was wrong with the one before is gone at once.
    gone = page.evaluate(
        "() => { const { store } = window.__orishell; const design = store.design.value;"
        " store.change({ ...design, shell: { ...design.shell } }, 'another');"
        " return store.fault.value; }"
    )
    assert gone is None
    choose(page, "parallel-repeating")
    settle(page)
    assert banner.is_hidden()


def test_the_designs_name_is_that_of_its_files(page: Page) -> None:
    choose(page, "orthodiagonal")
    name = page.get_by_test_id("design-name")
    name.fill("Zelt: 3 m / ")
    name.press("Enter")
    assert name.input_value() == "Zelt 3 m"
    assert page.title().startswith("Zelt 3 m")
    with page.expect_download() as saved:
        page.get_by_test_id("save").click()
    assert saved.value.suggested_filename == "Zelt 3 m.toml"
    page.get_by_test_id("export").click()
    with page.expect_download() as exported:
        all_formats(page)
        page.get_by_test_id("export-csv").click()
    assert exported.value.suggested_filename == "Zelt 3 m-csv.zip"
    page.keyboard.press("Escape")


def test_every_colour_is_explained(page: Page) -> None:
    choose(page, "parallel-repeating")
    legend = page.locator(".orishell-legend")
    assert "underside" in legend.inner_text()
    page.locator("label:has([data-testid=colour-signs])").click()
    for name, words in (("surface", "target surface"), ("f", "curve f"), ("g", "curve g")):
        assert words not in legend.inner_text()
        page.get_by_test_id(f"overlay-{name}").check()
        assert words in legend.inner_text()
        page.get_by_test_id(f"overlay-{name}").uncheck()
    for each in (legend, page.get_by_test_id("pattern-legend")):
        assert {"mountain", "valley", "edge"} <= set(each.inner_text().split())
    page.locator("label:has([data-testid=colour-plain])").click()


def test_the_camera_follows_a_shell_that_grows(page: Page) -> None:
    choose(page, "parallel-repeating")
    look = (
        "(({ eye }) => { const { arm } = eye;"
        " return [arm.clone().normalize().toArray(), arm.length()]; })(window.__orishell.shell3d)"
    )
    page.locator(".scene canvas").focus()
    for key in ("ArrowLeft", "ArrowLeft", "ArrowUp"):
        page.keyboard.press(key)
    await_frames(page)
    direction, away = page.evaluate(look)
    page.evaluate(
        "() => { const { store } = window.__orishell; const { target } = store.design.value;"
        " store.setPattern('flap', 1.2);"
        " for (const name of ['f', 'g'])"
        " store.setCurve(name, { ...target[name], scale: 4 }, 'larger');"
        "}"
    )
    drawn(page)
    turned, farther = page.evaluate(look)
    assert turned == pytest.approx(direction, abs=1e-3)
    assert farther > 3 * away
    # All of it is in view, no larger and no smaller than it would be brought into view.
    page.get_by_test_id("fit").click()
    assert page.evaluate(look)[1] == pytest.approx(farther, rel=1e-6)


def test_files_dropped_anywhere(page: Page) -> None:
    choose(page, "orthodiagonal")
    assert not drop_file(page, "arch.csv", "x,y\n-2,0\n-1,1.2\n0,1.6\n1,1.2\n2,0\n")
    choice = page.get_by_test_id("drop-choice")
    assert "arch.csv" in choice.inner_text()
    page.get_by_test_id("drop-as-f").click()
    wait_until(page, "'formula' in window.__orishell.store.design.value.target.f === false")
    drawn(page)
    assert choice.is_hidden()
    drop_file(page, "picture.png", "")
    assert "picture.png is no design file" in page.get_by_test_id("said").inner_text()
    drop_file(page, "mine.toml", starter_file("longitudinal-linear-repeating"))
    wait_until(page, "window.__orishell.store.name.value === 'mine'")
    drawn(page)
    assert page.evaluate("window.__orishell.report.family") == "longitudinal-linear-repeating"


@thorough
def test_who_is_new_is_shown_around_once(browser: Browser, address: str) -> None:
    with opened(browser, address, width=390, height=844, reduced_motion="reduce") as page:
        # By keys alone: past what comes first, to the shell.
        page.keyboard.press("Tab")
        page.keyboard.press("Enter")
        assert page.evaluate("document.activeElement.matches('.scene canvas')")
        page.get_by_test_id("tour-start").click()
        card = page.get_by_test_id("tour-card")
        titles = []
        for _ in range(20):
            await_frames(page)
            box = _box(card)
            assert min(box["x"], box["y"]) >= 0
            assert box["x"] + box["width"] <= 390
            assert box["y"] + box["height"] <= 844
            titles.append(card.locator("h2").inner_text())
            if titles[-1] == "Keys and gestures":
                break
            page.keyboard.press("ArrowRight")
        assert 6 <= len(titles) <= 7
        assert "Space" in card.inner_text()
        page.keyboard.press("ArrowLeft")
        assert card.locator("h2").inner_text() == titles[-2]
        page.keyboard.press("Escape")
        assert card.is_hidden()
        # A key may come before the browser has moved the focus out of what was closed.
        page.evaluate(
            "document.querySelector('[data-testid=tour-next]').dispatchEvent("
            "new KeyboardEvent('keydown', { key: '?', bubbles: true }))"
        )
        assert card.is_visible()
        page.keyboard.press("Escape")
        assert card.is_hidden()
        page.keyboard.press("?")
        await_frames(page)
        assert "Keys and gestures" in card.inner_text()
        page.get_by_test_id("tour-next").click()
        assert card.is_hidden()
        page.reload()
        wait_until(page, "window.__orishell !== undefined && window.__orishell.idle")
        assert page.get_by_test_id("tour-hint").count() == 0
        kept = page.evaluate("JSON.stringify(Object.keys(localStorage))")
        assert set(json.loads(kept)) <= set(STARTS)
