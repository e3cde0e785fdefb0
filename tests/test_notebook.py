"""The viewer in a notebook: the widget's bytes, and what a browser draws from them."""

from __future__ import annotations

import base64
import builtins
import inspect
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from documents import demo_document
from orishell import (
    Design,
    FoldingMotion,
    ParallelRepeatingPattern,
    analyse_structure,
    curve_from_formulas,
    design_parallel_repeating,
    parse_formula,
)
from orishell.conventions.errors import InputError
from orishell.design_file import read_design_file
from orishell.document.from_design import document_of_design
from orishell.io import DEFAULT_SETTINGS, read_fold, write_fold
from orishell.io.formats import all_formats
from orishell.io.formats.html import read_viewer
from orishell.io.view import dump_view
from orishell.shell.export import write_format, write_shell, write_structure
from orishell.shell.kit import write_kit
from orishell.shell.make import make_shell
from orishell.shell.pictures import lay_surface
from orishell.shell.steps import MEASURES
from orishell.studio import notebook
from orishell.studio.notebook import show
from public_names import public_callables
from viewer_pages import pixels, require_viewer, watched_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser

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


def small_design() -> Design:
    f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    g = curve_from_formulas(None, parse_formula("0.1*x"), 0, 2)
    return design_parallel_repeating(
        f, g, ParallelRepeatingPattern(rows=3, columns=2, xi_deg=50, flap=0.3)
    )


def test_a_design_is_shown_as_it_folds_with_its_surface_and_curves() -> None:
    require_viewer()
    design = small_design()
    widget: Any = show(design)
    document = document_of_design(design)
    assert (document.unit, len(document.states)) == ("unit", 25)
    np.testing.assert_array_equal(
        document.shell.positions, FoldingMotion(design.mechanism, 2).target.positions.reshape(-1, 3)
    )
    assert set(document.curves) == {"f", "g"}
    assert widget.view == dump_view(lay_surface(document, design))


def test_what_has_too_little_to_be_shown_or_written_says_what_to_call(tmp_path: Path) -> None:
    design: Any = small_design()
    others: list[Any] = [design.mechanism, FoldingMotion(design.mechanism, 3), None]
    for thing in others:
        with pytest.raises(InputError, match="expected a Shell, a Design or a Document"):
            show(thing)
    html = next(each for each in all_formats() if each.name == "html")
    with pytest.raises(InputError, match=r"got Design, .* design_shell .*document_of_design"):
        write_shell(design, tmp_path / "out")
    with pytest.raises(InputError, match="document_of_design"):
        write_format(design, html, tmp_path, DEFAULT_SETTINGS)
    with pytest.raises(InputError, match=r"got Design, .* design_shell"):
        write_structure(design, tmp_path / "out")
    with pytest.raises(InputError, match=r"got Design, .* design_shell"):
        write_kit(design, tmp_path / "out")
    with pytest.raises(InputError, match=r"got Design, .* design_shell"):
        analyse_structure(design)
    with pytest.raises(InputError, match=r"make_shell\(read_design_file\(path\)\)") as refused:
        write_shell(design, tmp_path / "out")
    assert 'write_shell(shell, directory, formats=["glb"])' in str(refused.value)
    assert not list(tmp_path.iterdir())
    with pytest.raises(InputError, match=r"got Design, .* take design\.mechanism"):
        FoldingMotion(design, 3)
    write_fold(tmp_path / "shell.fold", document_of_design(design, "m", frames=3))
    fold = read_fold(tmp_path / "shell.fold")
    assert (fold.unit, len(fold.frames)) == ("m", 4)


def test_every_function_that_takes_a_shell_is_among_these() -> None:
    taking = {
        name
        for name, function in public_callables().items()
        if any(
            re.search(r"\bShell\b", str(each))
            for each in inspect.get_annotations(function).values()
        )
        and "Shell" not in str(inspect.get_annotations(function).get("return"))
    }
    assert taking == {
        "orishell.studio.notebook.show",
        "orishell.shell.write_shell",
        "orishell.shell.write_format",
        "orishell.shell.write_structure",
        "orishell.shell.write_kit",
        "orishell.shell.analyse_structure",
    }


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


def test_draws_in_a_cell_and_leaves_the_notebook_alone(browser: Browser) -> None:
    view = base64.b64encode(dump_view(demo_document())).decode()
    require_viewer()
    files = {"/": ("text/html", PAGE), "/viewer.js": ("text/javascript", read_viewer())}
    with watched_page(browser) as page:

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


def test_the_remedy_of_a_design_that_is_written_works(tmp_path: Path) -> None:
    """As its message has it, of a design file."""
    path = Path(__file__).parents[1] / "examples" / "figure1_card.toml"
    shell = make_shell(read_design_file(path), skip=MEASURES)
    written = write_shell(shell, tmp_path / "out", formats=["glb"])
    assert tmp_path / "out" / "shell.glb" in written
