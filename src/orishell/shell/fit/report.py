"""What is said of a shell whose target was scaled to sizes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from orishell.conventions.quantities import plain, size
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.design_file.fit import Side


@record
class FittedSize:
    """The sizes that were asked for and that the built shell has, by their keys (lengths)."""

    of: Side
    head_height: float | None  # up to which it is clear; None where no clear size is asked for
    asked: Mapping[str, float]
    found: Mapping[str, float]
    # what keys of the design file would say for the shell to be as large as it is: ``scale`` of a
    # target, lengths of edges of a sheet without one
    scales: Mapping[str, float | list[float]]
    trials: int  # shells that were tried without a proof

    def rows(self, unit: str) -> Iterator[Row]:
        """A row of the verdict."""
        head = "" if self.head_height is None else f" up to {size(self.head_height, unit)}"
        scaled = ", ".join(_said(key, each) for key, each in self.scales.items())
        how = f"; scaled: {scaled}" if scaled else ""
        of = (
            "outside, boards and flaps included"
            if self.of == "outside"
            else f"inside{head}, ties left out"
        )
        yield Row("holds", "sizes", f"{in_words(self.found, unit)} {of}{how}")


def _said(key: str, scale: float | list[float]) -> str:
    """A target is scaled by a factor, an edge to a length."""
    table, name = key.split(".")[:2]
    factors = " x ".join(plain(each) for each in (scale if isinstance(scale, list) else [scale]))
    return f"{name} {'to' if table == 'pattern' else 'by'} {factors}"


def in_words(sizes: Mapping[str, float], unit: str) -> str:
    """Sizes to a millimetre or better: width 4, depth 2.5 m."""
    return ", ".join(f"{key} {plain(each)}" for key, each in sizes.items()) + f" {unit}"
