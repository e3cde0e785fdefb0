"""Nothing is lost: work comes back after a reload, travels in a link, and outlives the server."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from node_tools import lacking
from orishell.design_file import starter_file
from orishell.studio.app import PAGES
from samples import thorough
from studio_pages import IDLE, choose, drawn, opened, settle
from studio_server import running_studio
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

DESIGN = "window.__orishell.store.design.value"
COLUMNS = f"{DESIGN}.pattern.columns"
KEPT = "Object.entries(localStorage).filter(([key]) => /design|latest/.test(key)).sort()"
"""What the browser keeps of designs that are in no file."""


def set_columns(page: Page, columns: int) -> None:
    box = page.get_by_test_id("param-columns")
    box.fill(str(columns))
    box.press("Enter")


def reload(page: Page) -> bool:
    """Load the page anew; whether it asks before that is left.

    A browser that is kept waiting by other work leaves without asking, so the event says it.
    """
    asks = page.evaluate("!dispatchEvent(new Event('beforeunload', { cancelable: true }))")
    page.once("dialog", lambda dialog: dialog.accept())
    page.reload()
    wait_until(page, IDLE)
    return bool(asks)


@thorough
def test_work_comes_back_after_a_reload_until_it_is_saved(
    browser: Browser, address: str, tmp_path: Path
) -> None:
    with opened(browser, address) as page:
        choose(page, "orthodiagonal")
        assert not reload(page)  # nothing to lose
        choose(page, "orthodiagonal")
        set_columns(page, 17)
        drawn(page)
        assert reload(page)
        assert page.evaluate(COLUMNS) == 17
        assert page.get_by_test_id("design-name").input_value() == "orthodiagonal"
        assert "unsaved work is back" in page.get_by_test_id("said").inner_text()
        with page.expect_download() as download:
            page.get_by_test_id("save").click()
        download.value.save_as(tmp_path / "mine.toml")
        settle(page)
        assert not reload(page)
        assert page.evaluate(COLUMNS) == 17
        assert page.evaluate("window.__orishell.store.unsaved") is False
    assert tomllib.loads((tmp_path / "mine.toml").read_text())["pattern"]["columns"] == 17


@thorough
def test_undo_brings_a_design_back_with_its_name(page: Page) -> None:
    choose(page, "orthodiagonal")
    choose(page, "longitudinal-linear-repeating")
    page.get_by_test_id("undo").click()
    assert page.get_by_test_id("design-name").input_value() == "orthodiagonal"
    drawn(page)


@thorough  # a link that is refused is the quicker member
def test_a_link_brings_the_design(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        place = address.partition("?")[0]
        assert page.url == place  # the key is in the cookie only
        page.context.grant_permissions(["clipboard-read", "clipboard-write"], origin=place)
        choose(page, "orthodiagonal")
        set_columns(page, 15)
        drawn(page)
        page.get_by_test_id("link").click()
        wait_until(page, "window.__orishell.store.said.value !== ''")
        link = page.evaluate("navigator.clipboard.readText()")
        design = page.evaluate(DESIGN)
    assert link.startswith(f"{place}#design=")
    with opened(browser, address) as page:
        page.goto("about:blank")
        page.goto(link)
        wait_until(page, IDLE)
        assert page.evaluate(DESIGN) == design
        # As long as it is what the link brought, the address holds it, and nothing else does.
        assert page.url == link
        assert not reload(page)
        assert page.evaluate(DESIGN) == design
        assert page.evaluate(KEPT) == []
        page.get_by_test_id("undo").click()
        assert page.evaluate(COLUMNS) != 15
        assert page.url == place
        # A link that is put into the address of an open page is followed, a broken one told.
        page.evaluate("(link) => { location.hash = new URL(link).hash }", link)
        wait_until(page, f"{COLUMNS} === 15")
        page.evaluate("(link) => { location.hash = new URL(link).hash.slice(0, -9) }", link)
        wait_until(page, "window.__orishell.store.fault.value !== null")
        assert "broken" in page.get_by_test_id("banner").inner_text()


KEEP_FULL = """() => {
    const design = window.__orishell.store.design.value;
    const names = Array.from({ length: 16 }, (_, k) => `shell ${k}`);
    for (const name of names) {
        localStorage.setItem(`orishell.design:${name}`, JSON.stringify({ name, design }));
    }
    localStorage.setItem("orishell.latest", JSON.stringify(names));
}"""
"""As much work as is kept, in no file, of pages that were closed."""
LINK = """async (named) => {
    const plain = new Blob([typeof named === "number" ? new Uint8Array(named) : named]).stream();
    const packed = await new Response(plain.pipeThrough(new CompressionStream("deflate-raw")))
        .arrayBuffer();
    const text = Array.from(new Uint8Array(packed), (each) => String.fromCharCode(each)).join("");
    return "#design=" + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}"""
"""The fragment that holds a text, or so many zeros."""


@thorough
def test_links_neither_replace_nor_push_out_what_is_kept(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        page.evaluate(KEEP_FULL)
        kept = page.evaluate(KEPT)
        assert len(kept) == 17
        own = page.evaluate("JSON.stringify(window.__orishell.store.design.value)")
        store = "window.__orishell.store"
        for name in ("shell 0", "shell 15", "new", "newer", "../orishell.latest"):
            design = tomllib.loads(starter_file("orthodiagonal"))
            fragment = page.evaluate(LINK, json.dumps({"name": name, "design": design}))
            page.evaluate("(fragment) => { location.hash = fragment }", fragment)
            wait_until(page, f"{store}.name.value === {json.dumps(name)}")
            assert page.evaluate(f"{store}.unsaved") is False
            page.evaluate("dispatchEvent(new Event('pagehide'))")
            assert page.evaluate(KEPT) == kept
        for _ in range(5):
            page.get_by_test_id("undo").click()
        assert page.evaluate("JSON.stringify(window.__orishell.store.design.value)") == own
        page.evaluate("dispatchEvent(new Event('pagehide'))")
        assert page.evaluate(KEPT) == kept


def test_a_link_that_inflates_without_end_is_refused(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        design = page.evaluate(DESIGN)
        fragment = page.evaluate(LINK, 300_000_000)
        assert len(fragment) < 500_000
        page.evaluate("(fragment) => { location.hash = fragment }", fragment)
        wait_until(page, "window.__orishell.store.fault.value !== null")
        assert "more than 10 MB" in page.get_by_test_id("banner").inner_text()
        assert page.url == address.partition("?")[0]
        assert page.evaluate(DESIGN) == design


@thorough
def test_the_page_outlives_its_server(browser: Browser, tmp_path: Path) -> None:
    if not (PAGES / "index.html").is_file():
        lacking("the studio's pages have not been built: make pages")
    context = browser.new_context()
    page = context.new_page()
    with running_studio() as first:
        page.goto(first.entrance)
        wait_until(page, IDLE)
    set_columns(page, 13)
    wait_until(page, "window.__orishell.store.fault.value?.kind === 'network'")
    assert "orishell studio" in page.get_by_test_id("banner").inner_text()
    with running_studio(port=urlsplit(first.address).port) as second:
        # It has another key, which the browser is given in another tab.
        assert second.cookies != first.cookies
        wait_until(page, "window.__orishell.store.fault.value?.what.includes('started anew')")
        assert "open the address that it printed" in page.get_by_test_id("banner").inner_text()
        with page.expect_download() as download:
            page.keyboard.press("Control+s")
        download.value.save_as(tmp_path / "mine.toml")
        assert tomllib.loads((tmp_path / "mine.toml").read_text()) == page.evaluate(DESIGN)
        context.new_page().goto(second.entrance)
        wait_until(page, "window.__orishell.store.fault.value === null")
        settle(page)
        assert page.evaluate("window.__orishell.report.columns") == 13
        assert "proved" in page.get_by_test_id("verify-status").inner_text()
    context.close()
