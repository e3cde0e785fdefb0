"""The example of a shelter, as long as a test needs it, to be deployed as the test says."""

from __future__ import annotations

import re

from documents import EXAMPLES


def shelter(columns: int = 13, frames: int = 3) -> str:
    """The design file without its own table [deployment]; its columns stay half a metre apart."""
    text = (EXAMPLES / "shelter.toml").read_text(encoding="utf-8")
    text = re.sub(r"\[deployment\]\n(?:[^\n]+\n)+", "", text)
    for old, new in (
        ("columns = 13", f"columns = {columns}"),
        ("range = [0, 6]", f"range = [0, {0.5 * (columns - 1):g}]"),
        ("frames = 25", f"frames = {frames}"),
    ):
        assert text.count(old) == 1
        text = text.replace(old, new)
    return text
