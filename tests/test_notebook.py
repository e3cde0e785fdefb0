"""The viewer in a notebook: the widget's bytes, and what a browser draws from them."""

from __future__ import annotations

import base64
import builtins
from dataclasses import replace
from typing import Any

import pytest

from documents import demo_document
from orishell import notebook
from orishell.errors import InputError
from orishell.io.formats.html import read_viewer
from orishell.io.view import dump_view
from orishell.notebook import show
from viewer_pages import pixels, require_viewer, running_browser, watched_page

PAGE = """<!doctype html><meta charset="utf-8"><title>notebook</title><div id="cell"></div>"""

RENDER = """async ([view, height]) => {
  // As anywidget does: bytes arrive as a view of a longer buffer, at any place in it.
  const bytes = Uint8Array.from(atob(view), (each) => each.charCodeAt(0));
  const longer = new Uint8Array(bytes.length + 3);
  longer.set(bytes, 3);
  const traits = { view: new DataView(longer.buffer, 3), height };
  const model = { get: (name) => traits[name], on() {}, off() {} };
  const { default: widget } = await import("/viewer.js");
  window.end = widget.render({ model, el: document.getElementById("cell") });
}"""


LOOKS = """() => {
  const style = getComputedStyle(document.body);
  return [style.backgroundColor, style.color, style.fontFamily, style.getPropertyValue("--bg")];
}"""


def test_the_widget_holds_the_view_and_the_program() -> None:
    require_viewer()
    widget: Any = show(demo_document(), height=420)
    assert widget.view == dump_view(demo_document())
    assert widget.height == 420
    assert widget._esm == read_viewer()
    other: Any = show(replace(demo_document(), title="another"))
    assert b'"another"' in other.view


def test_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    true_import = builtins.__import__

    def lacking(name: str, *rest: Any, **more: Any) -> Any:
        if name == "anywidget":
            raise ImportError(name)
        return true_import(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", lacking)
    monkeypatch.setattr(notebook, "_widget_class", notebook._widget_class.__wrapped__)
    with pytest.raises(InputError, match=r"orishell\[notebook\]"):
        show(demo_document())


def test_draws_in_a_cell_and_leaves_the_notebook_alone() -> None:
    view = base64.b64encode(dump_view(demo_document())).decode()
    require_viewer()
    files = {"/": ("text/html", PAGE), "/viewer.js": ("text/javascript", read_viewer())}
    with running_browser() as browser, watched_page(browser) as page:

        def answer(route: Any, request: Any) -> None:
            kind, body = files[request.url.removeprefix("http://viewer.test")]
            route.fulfill(content_type=kind, body=body)

        page.route("http://viewer.test/**", answer)
        page.goto("http://viewer.test/")
        plain = page.evaluate(LOOKS)
        page.evaluate(RENDER, [view, 480])
        box = page.locator("#cell").bounding_box()
        assert box is not None
        assert box["height"] == pytest.approx(480, abs=1)
        page.get_by_role("slider").fill("0.5")
        assert page.locator("output").inner_text() == "90.0\u00b0"
        page.wait_for_timeout(200)
        picture = pixels(page, "#cell .orishell-scene canvas")
        assert picture.max() - picture.min() > 0.4
        assert page.evaluate("document.adoptedStyleSheets.length") == 0
        assert page.evaluate(LOOKS) == plain
        page.evaluate("end()")
        assert page.locator("#cell canvas").count() == 0
