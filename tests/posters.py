"""Takes the pictures of shells on the site, docs/posters, from its own pages with the viewer.

Run ``python tests/posters.py [NAME ...]`` after ``make docs``, Chromium installed. Beside them it
notes of which designs they are: a test says which have become older than these.
"""

from __future__ import annotations

import hashlib
import io
import json
import sys
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PIL import Image

from orishell.conventions.toml_file import read_toml
from viewer_pages import await_frames, running_browser, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Page

ROOT = Path(__file__).parents[1]
POSTERS, LIVE = ROOT / "docs" / "posters", ROOT / "build" / "docs" / "live"
NOTED = POSTERS / "designs.json"
SIZE: Any = {"width": 720, "height": 450}
QUALITY = 70
ONLY_THE_SHELL = """
html, body, .orishell-viewer { background: none !important; }
.orishell-viewer { display: block !important; }
.orishell-viewer .stage { position: fixed !important; }
.side, .toolbar, .player, .orishell-legend, .orishell-scale { display: none !important; }
"""
STYLED = """css => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}"""


def designs() -> dict[str, Path]:
    """The design files that the site shows, by name."""
    return {path.stem: path for path in sorted((ROOT / "examples").glob("*.toml"))}


def digest(path: Path) -> str:
    """What tells a design from others, whatever its file says in comments."""
    tables = json.dumps(read_toml(path), sort_keys=True, default=str)
    return hashlib.sha256(tables.encode()).hexdigest()[:16]


def take(page: Page, name: str) -> None:
    """Take a shell at its target, on light and on dark ground."""
    page.goto((LIVE / f"{name}.html").as_uri())
    wait_until(page, "window.orishell !== undefined", seconds=300)
    page.evaluate(STYLED, ONLY_THE_SHELL)
    await_frames(page)
    page.evaluate("orishell.shell.fit()")
    for colours in ("light", "dark"):
        page.evaluate("colours => orishell.theme.set(colours)", colours)
        await_frames(page)
        with Image.open(io.BytesIO(page.screenshot(omit_background=True))) as picture:
            picture.save(POSTERS / f"{name}-{colours}.webp", quality=QUALITY, method=6)


def main() -> None:
    """Take all, or those that are named."""
    POSTERS.mkdir(exist_ok=True)
    noted = json.loads(NOTED.read_text("utf-8")) if NOTED.is_file() else {}
    with running_browser() as browser, closing(browser.new_page(viewport=SIZE)) as page:
        for name in sys.argv[1:] or designs():
            take(page, name)
            noted[name] = digest(designs()[name])

    NOTED.write_text(json.dumps(noted, indent=2, sort_keys=True) + "\n", "utf-8")


if __name__ == "__main__":
    main()
