"""The site's colours and type: those of the studio and the viewer, from their own style sheet."""

from __future__ import annotations

import re
from pathlib import Path

THEME = Path(__file__).parents[2] / "frontend" / "src" / "shared" / "theme.css"
"""Colours and measures by name, first the light ones."""

FURO = {
    "color-brand-primary": "accent",
    "color-brand-content": "accent",
    "color-brand-visited": "accent",
    "color-background-primary": "surface",
    "color-background-secondary": "bg",
    "color-background-hover": "surface-2",
    "color-background-border": "line",
    "color-foreground-primary": "text",
    "color-foreground-secondary": "text-2",
    "color-foreground-muted": "text-2",
    "color-foreground-border": "line-strong",
    "color-code-background": "surface-2",
    "color-inline-code-background": "surface-2",
    "font-stack": "font",
}
"""What the theme calls them."""


def variables() -> tuple[dict[str, str], dict[str, str]]:
    """The theme's variables and ours, light and dark."""
    light, dark = (
        dict(re.findall(r"--([\w-]+):\s*([^;]+);", block))
        for block in re.findall(r"\{(.*?)\}", THEME.read_text("utf-8"), re.DOTALL)
    )
    return tuple(  # type: ignore[return-value]
        {**own, **{furo: own[name] for furo, name in FURO.items()}}
        for own in (light, {**light, **dark})
    )
