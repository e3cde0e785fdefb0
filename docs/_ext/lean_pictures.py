"""Pictures of the site in 256 colours where nobody would see that: a quarter of the bytes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PIL import Image, ImageChops

if TYPE_CHECKING:
    from sphinx.application import Sphinx

SMALL = 20_000
"""Bytes up to which a picture is left as it is."""
UNSEEN = 8
"""Of 255: a colour may change by so much. Smooth shading would turn into bands beyond."""


def shrink_pictures(app: Sphinx, fault: Exception | None) -> None:
    """Shrink what the pages show; the sources keep their pictures as they are."""
    if fault or app.builder.format != "html":
        return
    for path in sorted((Path(app.outdir) / app.builder.imagedir).glob("*.png")):
        if path.stat().st_size > SMALL:
            shrink(path)


def shrink(path: Path) -> None:
    """Give a picture 256 colours, if it has no transparency and none changes by much."""
    with Image.open(path) as picture:
        if picture.mode not in {"RGB", "RGBA"} or picture.convert("RGBA").getextrema()[3][0] < 255:
            return
        whole = picture.convert("RGB")
    # This way of choosing colours keeps those of thin lines.
    few = whole.quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    changes = ImageChops.difference(whole, few.convert("RGB")).getextrema()
    if max(most for _, most in changes) <= UNSEEN:
        few.save(path, optimize=True)


def setup(app: Sphinx) -> dict[str, bool]:
    """Shrink pictures when all are there."""
    app.connect("build-finished", shrink_pictures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
