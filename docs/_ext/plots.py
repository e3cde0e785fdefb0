"""Plots of the gallery, which are seen on light and on dark pages."""

from __future__ import annotations

from typing import Any

INK = "#7c8087"
"""As far from the light page as from the dark one: a contrast of four with either."""


def set_looks(_config: dict[str, Any], _script: str) -> None:
    """Have plots drawn in that ink, without a sheet below them."""
    import matplotlib as mpl

    inks = ("text.color", "axes.edgecolor", "axes.labelcolor", "xtick.color", "ytick.color")
    sheets = ("figure.facecolor", "axes.facecolor", "savefig.facecolor", "legend.facecolor")
    mpl.rcParams.update(dict.fromkeys(inks, INK) | dict.fromkeys(sheets, "none"))
