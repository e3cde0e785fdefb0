"""viewer.html: what stands in the file, and what a browser makes of it without a network."""

from __future__ import annotations

import base64
import hashlib
import json
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from numpy.typing import NDArray

from documents import (
    FAMILIES,
    demo_document,
    flat_only,
    folded_only,
    pack_document,
    thick_document,
)
from orishell.conventions.colours import rgb
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import box
from orishell.conventions.record import as_table
from orishell.conventions.row import Row
from orishell.design import PanelSpec
from orishell.io.format import DEFAULT_SETTINGS
from orishell.io.formats import html
from orishell.io.formats.html import write_html
from orishell.io.view import dump_view
from samples import led_by, thorough
from viewer_pages import (
    await_frames,
    pixels,
    require_apart,
    wait_until,
    watched_page,
)

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

HOSTILE = "</title></script><script>alert(1)</script><!-- \"'& \u03b1"
STRAIN = 1e-6
"""Single precision, 6e-8, over the twentieth of the sheet that panels here measure at least."""


class Parts(HTMLParser):
    """Text of every element that matters, and the attributes of meta elements."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[tuple[str, str]] = []
        self.metas: list[dict[str, str | None]] = []
        self.inside: str | None = None

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "meta":
            self.metas.append(dict(attrs))
        elif tag in ("title", "script", "style"):
            self.texts.append((tag, ""))
            self.inside = tag

    def handle_endtag(self, tag: str) -> None:
        self.inside = None

    def handle_data(self, data: str) -> None:
        if self.inside:
            tag, text = self.texts[-1]
            self.texts[-1] = (tag, text + data)


@pytest.fixture
def stub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small program in the viewer's place, with all that could end a script too early."""
    place = tmp_path / "viewer.js"
    place.write_text('const a = "</script><!--<script>"; export default a;')
    monkeypatch.setattr(html, "VIEWER", place)
    return place


@pytest.mark.usefixtures("stub")
def test_what_stands_in_the_page_stays_where_it_is(tmp_path: Path) -> None:
    document = replace(demo_document(), title=HOSTILE)
    write_html(tmp_path / "viewer.html", document, DEFAULT_SETTINGS)
    parts = Parts()
    parts.feed((tmp_path / "viewer.html").read_text("utf-8"))
    assert [tag for tag, _ in parts.texts] == ["title", "style", "script", "script"]
    title, style, view, script = (text for _, text in parts.texts)
    assert title == HOSTILE
    assert base64.b64decode(view) == dump_view(document)
    assert script.count("\\/script>") == 1
    assert "<!--" not in script
    (policy,) = (meta["content"] for meta in parts.metas if "http-equiv" in meta)
    assert policy is not None
    assert policy.startswith("default-src 'none';")
    for text in (style, script):
        digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in policy
    assert "unsafe" not in policy


def test_says_what_to_do_where_the_viewer_is_not_built(tmp_path: Path, stub: Path) -> None:
    stub.unlink()
    with pytest.raises(InputError, match="npm run pages") as caught:
        write_html(tmp_path / "viewer.html", demo_document(), DEFAULT_SETTINGS)
    assert caught.value.what == "the viewer has not been built"
    assert not (tmp_path / "viewer.html").exists()


def opened(page: Page, path: Path) -> None:
    page.goto(path.as_uri())
    wait_until(page, "window.orishell !== undefined")


@pytest.mark.parametrize("family", led_by(FAMILIES))
def test_folds_from_flat_to_locked_without_bending_a_panel(
    browser: Browser, tmp_path: Path, family: str
) -> None:
    """At a state the panels lie where the document has them, between states they stay rigid."""
    document = demo_document(family)
    write_html(tmp_path / "viewer.html", document, DEFAULT_SETTINGS)
    states = [state.positions for state in document.states]
    origin = (states[-1].min(axis=0) + states[-1].max(axis=0)) / 2
    size = float(np.linalg.norm(np.ptp(states[0], axis=0)))
    with watched_page(browser) as page:
        opened(page, tmp_path / "viewer.html")
        assert page.title() == document.title
        assert page.evaluate("orishell.shell.fold") == 1
        for share in (0, 0.37, 0.5, 0.81, 1):
            page.evaluate("share => orishell.player.set(share)", share)
            strain = page.evaluate("orishell.shell.maxPanelStrain()")
            assert 0 < strain < STRAIN
        for number, positions in enumerate(states):
            placed = page.evaluate(
                """share => {
                  orishell.player.set(share);
                  return [...orishell.shell.drawnPoints()];
                }""",
                number / (len(states) - 1),
            )
            drawn = np.reshape(placed, (-1, 4, 3)) + origin
            np.testing.assert_allclose(drawn, positions[document.mesh.faces], atol=1e-6 * size)


def test_slider_keys_and_play_move_the_picture(browser: Browser, tmp_path: Path) -> None:
    write_html(tmp_path / "viewer.html", demo_document(), DEFAULT_SETTINGS)
    with watched_page(browser) as page:
        opened(page, tmp_path / "viewer.html")
        slider = page.get_by_role("slider")
        slider.focus()
        page.keyboard.press("Home")
        assert page.evaluate("orishell.shell.fold") == 0
        assert page.locator("output").inner_text() == "0.0\u00b0"
        flat = pixels(page, ".orishell-scene canvas")
        page.keyboard.press("End")
        assert page.locator("output").inner_text() == "180.0\u00b0"
        locked = pixels(page, ".orishell-scene canvas")
        assert (np.abs(flat - locked).max(axis=-1) > 0.1).mean() > 0.02
        page.get_by_role("button", name="Play").click()
        wait_until(page, "orishell.shell.fold < 0.98")
        page.get_by_role("button", name="Pause").click()
        stopped = page.evaluate("orishell.shell.fold")
        await_frames(page)
        assert page.evaluate("orishell.shell.fold") == stopped


@thorough
def test_a_shell_is_opened_from_its_pack(browser: Browser, tmp_path: Path) -> None:
    document = pack_document()
    write_html(tmp_path / "viewer.html", document, DEFAULT_SETTINGS)
    shell = document.shell.positions
    origin = (shell.min(axis=0) + shell.max(axis=0)) / 2
    with watched_page(browser) as page:
        opened(page, tmp_path / "viewer.html")
        target = page.evaluate("orishell.shell.fold")
        assert 0 < target < 1
        assert page.get_by_role("slider").get_attribute("aria-label") == (
            "Fold, from pack over target to flat"
        )
        for name in ("Pack", "Flat", "Target"):
            page.get_by_role("button", name=name).click()
            placed = np.reshape(page.evaluate("[...orishell.shell.drawnPoints()]"), (-1, 4, 3))
            positions = document.state(name.lower()).positions[document.mesh.faces]
            np.testing.assert_allclose(placed + origin, positions, atol=1e-5)
        assert page.evaluate("orishell.shell.fold") == target
        # Played from the pack it rests at the target and goes on.
        page.get_by_role("button", name="Pack").click()
        page.get_by_role("button", name="Play").click()
        wait_until(page, f"orishell.shell.fold === {target}")
        wait_until(page, f"orishell.shell.fold > {target}")
        page.get_by_role("button", name="Pause").click()
        for width in (1280, 760, 390, 320):
            page.set_viewport_size({"width": width, "height": 720})
            require_apart(page, page.locator(".player button, .player output").all(), width)
            assert page.locator(".stop-mark").is_visible()


def test_colours_overlays_and_theme_are_seen(browser: Browser, tmp_path: Path) -> None:
    write_html(tmp_path / "viewer.html", demo_document(), DEFAULT_SETTINGS)

    def share(red: float, green: float, blue: float) -> float:
        """Share of the picture's pixels within a tenth of a colour."""
        await_frames(page)
        picture = pixels(page, ".orishell-scene canvas")
        return float((np.abs(picture - [red, green, blue]).max(axis=-1) < 0.1).mean())

    mountain, valley, curve_g = (rgb(name) for name in ("mountain", "valley", "curve-g"))
    with watched_page(browser, color_scheme="light") as page:
        opened(page, tmp_path / "viewer.html")
        before = share(*mountain), share(*valley), share(*curve_g)
        assert max(before) < 1e-4
        page.get_by_text("Mountain, valley", exact=True).click()
        assert share(*mountain) > 5e-4
        assert share(*valley) > 5e-4
        page.get_by_text("g", exact=True).click()
        assert share(*curve_g) > 5e-4
        assert not page.get_by_text("Distance", exact=True).is_visible()  # there is none here
        light = pixels(page, ".orishell-scene canvas").mean()
        page.get_by_role("button", name="Light or dark").click()
        assert page.evaluate("document.documentElement.dataset.theme") == "dark"
        await_frames(page)
        assert pixels(page, ".orishell-scene canvas").mean() < light - 0.4


def test_a_panel_pointed_at_is_marked_in_both_views(browser: Browser, tmp_path: Path) -> None:
    write_html(tmp_path / "viewer.html", demo_document(), DEFAULT_SETTINGS)
    with watched_page(browser) as page:
        opened(page, tmp_path / "viewer.html")
        await_frames(page)
        before = pixels(page, ".orishell-scene canvas")
        page.get_by_role("application", name="Crease pattern").hover()
        await_frames(page)
        assert page.locator(".caption").inner_text().startswith("panel ")
        marked = page.evaluate("[orishell.shell.u.hovered.value, orishell.pattern.chosen]")
        assert marked[0] == marked[1] >= 0
        changed = np.abs(pixels(page, ".orishell-scene canvas") - before).max(axis=-1) > 0.05
        assert 1e-4 < changed.mean() < 0.2


@pytest.mark.parametrize("part", [flat_only, folded_only])
def test_parts_of_a_document_are_shown_as_well(browser: Browser, tmp_path: Path, part: Any) -> None:
    write_html(tmp_path / "viewer.html", part(demo_document()), DEFAULT_SETTINGS)
    with watched_page(browser) as page:
        opened(page, tmp_path / "viewer.html")
        assert page.evaluate("orishell.shell.maxPanelStrain()") < STRAIN
        assert page.get_by_role("slider").is_visible() == (part is folded_only)
        assert page.get_by_text("Folded states only").is_visible() == (part is folded_only)
        picture = pixels(page, ".orishell-scene canvas")
        assert np.ptp(picture.mean(axis=-1)) > 0.4


def test_a_view_has_the_outlines_of_boards() -> None:
    """As they are in the flat sheet; a view of panels without a thickness is as it was."""
    document = thick_document(build=PanelSpec(thickness=0.05, membrane=0.002))
    assert document.boards is not None
    view = dump_view(document)
    arrays = parts_of(view)[1]
    np.testing.assert_allclose(arrays["boards"], document.boards.outlines, rtol=1e-7)
    np.testing.assert_array_equal(arrays["board_panels"], document.boards.panels)
    thin = parts_of(dump_view(replace(document, panel=None, boards=None)))[1]
    assert set(arrays) - set(thin) == {"boards", "board_panels"}


def test_flaps_that_are_clipped_on_are_views_within_the_view() -> None:
    """Where they are at the target, about the origin of the whole."""
    document = thick_document("parallel-repeating")
    header, blocks = parts_of(dump_view(document))
    alone = parts_of(dump_view(replace(document, attached=())))[0]["arrays"]
    strips = [name for name in blocks if name.startswith("clipped_")]
    assert set(blocks) - set(alone) == set(strips)
    assert len(strips) == len(document.attached) == 2
    for name, strip in zip(strips, document.attached, strict=True):
        own, within = parts_of(blocks[name].tobytes())
        assert strip.boards is not None
        assert own["origin"] == header["origin"]
        assert own["named"] == {"target": 0}
        placed = within["positions"][0] + np.array(header["origin"])
        np.testing.assert_allclose(placed, strip.shell.positions, atol=1e-6)
        np.testing.assert_allclose(within["boards"], strip.boards.outlines, rtol=1e-6, atol=1e-9)


def parts_of(view: bytes) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """Header of a view, and its arrays by name."""
    first = 4 + int.from_bytes(view[:4], "little")
    header = json.loads(view[4:first])
    arrays = {
        name: np.frombuffer(
            view, place["type"], int(np.prod(place["shape"])), first + place["offset"]
        ).reshape(place["shape"])
        for name, place in header["arrays"].items()
    }
    return header, arrays


@thorough
@pytest.mark.parametrize(
    "build",
    [
        PanelSpec(thickness=0.1, membrane=0.005),
        PanelSpec().replace_unchecked(thickness=0.1, construction="bevel"),
    ],
)
def test_thickness_is_switched_off_and_on(
    browser: Browser, tmp_path: Path, build: PanelSpec
) -> None:
    """Off, the picture is that of panels without a thickness."""
    document = thick_document(build=build)
    pictures = []

    def rested(page: Page) -> NDArray[np.float64]:
        await_frames(page)
        wait_until(page, "orishell.shell.quality.taps === 12")  # drawn finely, nothing moves
        await_frames(page)
        return pixels(page, ".orishell-scene canvas")[60:]  # below the switches

    for thick in (True, False):
        shown = document if thick else replace(document, panel=None, boards=None)
        write_html(tmp_path / "viewer.html", shown, DEFAULT_SETTINGS)
        with watched_page(browser) as page:
            opened(page, tmp_path / "viewer.html")
            page.evaluate("orishell.player.set(0.5)")
            pictures.append(rested(page))
            switch = page.get_by_text("Thickness", exact=True)
            assert switch.count() == thick
            if thick:
                for colours in ("Mountain, valley", "Fold angle", "Plain"):
                    page.get_by_text(colours, exact=True).click()
                    await_frames(page)
                switch.click()
                pictures.append(rested(page))
                for width in (1280, 760, 390, 320):
                    page.set_viewport_size({"width": width, "height": 720})
                    require_apart(page, page.locator(".toolbar > *").all(), width)
    on, off, none = pictures
    assert (np.abs(on - off).max(axis=-1) > 0.1).mean() > 5e-3
    assert np.abs(off - none).max() < 0.02


def test_figures(browser: Browser, tmp_path: Path) -> None:
    """They are rows as they are written; of a document without a report, of its panels alone."""
    document = demo_document("orthodiagonal")
    rows = (
        Row("warns", "held", "at 90 degrees: by its ties"),
        Row("holds", "folds", "in one motion"),
        Row("says", "deployed", "4 x 3 x 2 m of its boards; 5 x 3.1 x 2 m with clipped parts"),
        Row("says", "sheet", "6 x 4 m, area 24 m2"),
    )
    sizes = box(np.ptp(document.shell.positions, axis=0), "m")
    width, height = np.ptp(document.require_flat(), axis=0)
    sheet = f"{box((width, height), 'm')}, area {document.areas().sum():.3g} m2"
    with watched_page(browser) as page:
        for report, expected in (
            ({}, [sizes + " of panels without a thickness", sheet]),
            ({"verdict": as_table(rows)}, [rows[2].finding, rows[3].finding, rows[0].finding]),
        ):
            shown = replace(document, report=report)
            write_html(tmp_path / "viewer.html", shown, DEFAULT_SETTINGS)
            opened(page, tmp_path / "viewer.html")
            numbers = page.locator(".figures .orishell-number").all_inner_texts()
            assert numbers[1] == f"{len(document.mesh.faces)}"
            assert numbers[:1] + numbers[2:] == expected
