"""Nothing of a shell's pages lies outside its box, at four widths, in two themes.

So too those of a structure (``shell/test_structure_page``), of a search
(``search/test_browser_front``, ``search/test_browser_variants``), of the studio
(``studio/test_browser_outside``) and of the site (``docs/test_site_outside``).
"""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from command_line import orishell
from orishell.design_file import starter_file
from outside import WIDTHS, outside, outside_anywhere
from samples import thorough
from viewer_pages import await_frames, require_viewer, wait_until, watched_page

if TYPE_CHECKING:
    from playwright.sync_api import Browser

pytestmark = pytest.mark.slow

READY = """document.readyState === "complete"
    && (!document.querySelector("script") || window.orishell !== undefined)"""
ARCH = Path(__file__).parents[1] / "examples" / "arch_pattern.svg"
WIDE = "grid-template-columns: auto !important;"
TENT = """
[shell]
family = "orthodiagonal"
unit = "m"
[target]
f = { formula = "-x**2", range = [-1, 1] }
g = { formula = "0.25*sin(pi*x/2)", range = [0, 2] }
[pattern]
rows = 5
columns = 5
flap = 0
depth = 0.12
heading_deg = 90
[structure]
modulus = 9e9
strength = 40e6
crease_stiffness = "rigid"
crease_strength = 1e9
thickness = 0.003
cells = 2
supports = [{ at = "feet", kind = "pinned" }]
[[load_case]]
name = "snow that drifts to one side, as at the hut of the mountains"
snow = { ground = 20000, arrangement = "undrifted" }
"""
"""An arch under far more snow than it bears: long rows in the verdict, a case with a long name."""


def written(place: Path, text: str, name: str = "shell") -> Path:
    """Where the pages of a design are."""
    require_viewer()
    (place / f"{name}.toml").write_text(text)
    ran = orishell("design", f"{name}.toml", "--out", "out", "--write", "html", cwd=place)
    assert (place / "out" / "viewer.html").is_file(), ran.stderr
    return place / "out"


def wrong(browser: Browser, path: Path) -> dict[str, list[str]]:
    """What lies outside in a page, by width and theme, with all closed and with all open."""
    with watched_page(browser) as page:
        page.goto(path.as_uri())
        wait_until(page, READY)
        return outside_anywhere(page, opens=True)


def test_nothing_of_the_viewer_lies_outside(browser: Browser, tmp_path: Path) -> None:
    place = written(tmp_path, starter_file("orthodiagonal"))
    with watched_page(browser, bypass_csp=True) as page:
        page.goto((place / "viewer.html").as_uri())
        wait_until(page, READY)
        assert outside_anywhere(page, opens=True) == {}
        # As its panel once was: as wide as its longest line.
        page.add_style_tag(content=f".orishell-viewer .side {{ {WIDE} }}")
        for width, height in WIDTHS.items():
            page.set_viewport_size({"width": width, "height": height})
            await_frames(page)
            assert outside(page), width


@thorough
def test_nothing_of_an_analysed_shells_pages_lies_outside(browser: Browser, tmp_path: Path) -> None:
    place = written(tmp_path, TENT, "a tent with a name that does not end")
    for name in ("viewer.html", "structure.html"):
        assert wrong(browser, place / name) == {}


@thorough
def test_nothing_of_a_folded_patterns_page_lies_outside(browser: Browser, tmp_path: Path) -> None:
    orishell("fold", ARCH, "--out", tmp_path, "--frames", "5", "--unit", "mm")
    assert wrong(browser, tmp_path / "viewer.html") == {}


SEEN = {
    "<p style='overflow: hidden; width: 60px; white-space: nowrap'>cut without a sign</p>": "cut",
    "<p style='overflow: hidden; height: 12px; width: 60px'>cut at its foot</p>": "at its foot",
    "<div style='overflow: auto; width: 9px; white-space: nowrap'>to the right</div>": "sideways",
    "<p style='width: 60px; white-space: nowrap'>runs out of its box</p>": "runs out of p",
    "<p style='height: 12px; width: 60px'>runs out of its box below</p>": "below",
    "<div style='width: 60px'><img width=90 height=9></div>": "img runs out of div",
    "<div style='position: absolute; left: 2000px'>far</div>": "the page scrolls sideways",
    "<div style='position: fixed; left: -20px'>left</div>": "outside the window",
    "<div style='height: 20px; overflow-y: auto; scrollbar-width: none'>a<p>b</div>": "show it",
    "<button style='width: 40px; overflow: hidden'>Unbreakable</button>": "is cut",
    "<svg width=60 height=20><text x=40 y=15>label</text></svg>": "text is cut by svg",
}
NOWRAP = "overflow: hidden; width: 60px; white-space: nowrap"
ALLOWED = [
    f"<p style='{NOWRAP}; text-overflow: ellipsis'>cut, with dots</p>",
    "<pre style='overflow-x: auto; width: 60px'>code of one long line</pre>",
    "<div style='overflow-y: auto; height: 60px; width: 60px'>text that goes on below</div>",
    f"<p style='position: absolute; {NOWRAP}; clip-path: inset(50%)'>for readers of screens</p>",
    "<details><summary>more</summary><p style='width: 9px'>closed</p></details>",
    "<p style='line-height: 1'>tight</p>",
]


def test_what_is_outside_is_seen_and_nothing_else(browser: Browser) -> None:
    with closing(browser.new_page(viewport={"width": 800, "height": 600})) as page:
        for body in [*SEEN, *ALLOWED]:
            page.set_content(f"<!doctype html><body>{body}</body>")
            found = outside(page)
            assert any(SEEN[body] in each for each in found) if body in SEEN else not found, body
