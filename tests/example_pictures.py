"""Makes the pictures on the studio's cards of examples, from what the studio shows of them.

Run it with ``python tests/example_pictures.py [NAME ...]``, pages built and Chromium installed; it
writes frontend/src/studio/files/pictures, one for light and one for dark colours.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from PIL import Image

from studio_pages import opened
from studio_server import running_studio
from viewer_pages import await_frames, running_browser, wait_until

if TYPE_CHECKING:
    from playwright.sync_api import FloatRect, Page

PICTURES = Path(__file__).parents[1] / "frontend" / "src" / "studio" / "files" / "pictures"
SIZE = (336, 224)
QUALITY = 82
WINDOW = {"width": 1480, "height": 760}
SHELL = "window.__orishell.store"
SHOWN = f"{SHELL}.freshness.value === 'current' && {SHELL}.fitting.value === null"
ONLY_THE_SHELL = """
.scene-frame > :not(.scene), .scene > :not(canvas) { visibility: hidden; }
"""


def take(page: Page, name: str) -> None:
    """Open an example and keep what its shell looks like."""
    page.get_by_test_id("examples").click()
    page.get_by_test_id(f"example-{name}").click()
    wait_until(page, f"{SHELL}.name.value === {name!r} && {SHOWN}", seconds=300)
    for colours in ("light", "dark"):
        if page.evaluate("document.documentElement.dataset.theme") != colours:
            page.get_by_test_id("theme").click()
        await_frames(page)
        frame = page.get_by_test_id("scene").bounding_box()
        assert frame is not None
        with Image.open(io.BytesIO(page.screenshot())) as whole:
            picture = whole.convert("RGB").crop(middle(frame))
        picture.resize(SIZE, Image.Resampling.LANCZOS).save(
            PICTURES / f"{name}-{colours}.webp", quality=QUALITY, method=6
        )


def middle(frame: FloatRect) -> tuple[int, int, int, int]:
    """The largest part of a frame, about its middle, that has the shape of a picture."""
    scale = min(frame["width"] / SIZE[0], frame["height"] / SIZE[1])
    left = frame["x"] + (frame["width"] - scale * SIZE[0]) / 2
    top = frame["y"] + (frame["height"] - scale * SIZE[1]) / 2
    return (
        round(left),
        round(top),
        round(left + scale * SIZE[0]),
        round(top + scale * SIZE[1]),
    )


def main() -> None:
    """Take all, or those that are named."""
    PICTURES.mkdir(exist_ok=True)
    with (
        running_studio() as studio,
        running_browser() as browser,
        opened(browser, studio.entrance, **WINDOW) as page,
    ):
        page.add_style_tag(content=ONLY_THE_SHELL)
        cards = page.locator("[data-testid=examples-window] .example-card").all()
        names = [str(card.get_attribute("data-testid")).removeprefix("example-") for card in cards]
        for name in sys.argv[1:] or names:
            take(page, name)


if __name__ == "__main__":
    main()
