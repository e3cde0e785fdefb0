"""How fast shells come close to the surfaces asked for: finer and finer sheets, measured.

Run it with ``python examples/convergence.py [FILE]``; it draws docs/images/convergence.png.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell import (
    Curve,
    Design,
    LongitudinalPattern,
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    curve_from_formulas,
    curve_from_points,
    design_longitudinal_linear_repeating,
    design_orthodiagonal,
    design_parallel_repeating,
    parse_formula,
)
from orishell.deviation import Deviation, measure_approach, measure_deviation

Array = NDArray[np.float64]

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "convergence.png"
SAMPLES = 40_000
ROWS = (9, 17, 35, 71, 143)
"""Each has twice the edges down a column of the one before, but for the first two."""
XI = np.deg2rad(50)


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """A quantity that falls as sheets get finer.

    Parameters
    ----------
    name
        What it is.
    order
        Its order: it falls as 1/count**order.
    counts
        Numbers of edges (K,).
    values
        The quantity (K,), in the unit of the curves.
    """

    name: str
    order: int
    counts: Array
    values: Array

    def orders(self) -> Array:
        """Orders observed (K-1,) from one to the next."""
        falls = np.log(self.values[:-1] / self.values[1:])
        return np.asarray(falls / np.log(self.counts[1:] / self.counts[:-1]))


def graph(text: str, start: float, stop: float) -> Curve:
    """The graph of a formula."""
    return curve_from_formulas(None, parse_formula(text), start, stop)


def polyline(points: object) -> Curve:
    """A merely continuous curve."""
    return curve_from_points(np.asarray(points, dtype=np.float64), smooth=False)


def f() -> Curve:
    """The paper's f."""
    return graph("-x**2", -1, 1)


def deviation(design: Design) -> float:
    """Largest distance between the shell and the surface asked for, both ways."""
    return measure_deviation(design, samples=SAMPLES).max


def approach(design: Design) -> float:
    """Largest distance between the shell and what its family approaches, both ways."""
    found: Deviation | None = measure_approach(design, samples=SAMPLES)
    assert found is not None
    return found.max


def measured(
    name: str, order: int, counts: Iterable[int], measure: Callable[[int], float], less: int = 0
) -> Series:
    """A quantity for several numbers of rows or columns."""
    counts = list(counts)
    values = [measure(count) for count in counts]
    return Series(name, order, np.array(counts, dtype=float) - less, np.array(values))


def parallel_rows() -> Series:
    """Figure 1 with more and more rows; columns enough for g."""
    g = graph("5*sin(pi*x/10)", 0, 20)

    def measure(rows: int) -> float:
        return deviation(
            design_parallel_repeating(
                f(),
                g,
                ParallelRepeatingPattern(rows=rows, columns=401, xi_deg=np.rad2deg(XI), flap=0),
            )
        )

    return measured("parallel repeating, rows", 1, ROWS, measure, -1)


def parallel_columns() -> Series:
    """More and more columns, with an f that is met exactly: a staircase itself."""
    edges = np.array([0.3, 0.35, 0.4, 0.3]) * np.exp(0.5j * (np.pi - XI) * np.array([1, -1, 1, -1]))
    corners = np.concatenate([[0], np.cumsum(edges)])
    staircase = polyline(np.stack([corners.real, corners.imag], axis=-1))
    g = graph("5*sin(pi*x/10)", 0, 20)

    def measure(columns: int) -> float:
        xi = XI * (1 - 1e-10)
        design = design_parallel_repeating(
            staircase,
            g,
            ParallelRepeatingPattern(rows=3, columns=columns, xi_deg=np.rad2deg(xi), flap=0),
        )
        return deviation(design)

    return measured("parallel repeating, columns", 2, (11, 21, 41, 81, 161), measure, 1)


def parallel_polylines() -> Series:
    """Merely continuous f and g."""
    roof = polyline([[-1, 0], [-0.4, 0.5], [0.3, 0.7], [1, 0]])
    zigzag = polyline([[0, 0], [4, 1], [8, 0], [12, 3]])

    def measure(rows: int) -> float:
        return deviation(
            design_parallel_repeating(
                roof,
                zigzag,
                ParallelRepeatingPattern(rows=rows, columns=13, xi_deg=np.rad2deg(XI), flap=0),
            )
        )

    return measured("parallel repeating, rows, f and g polylines", 1, ROWS, measure, -1)


def orthodiagonal_rows() -> Series:
    """A straight g; the corrugation is as deep as right angles make it."""

    def measure(rows: int) -> float:
        return deviation(
            design_orthodiagonal(
                f(), graph("0*x", 0, 4), OrthodiagonalPattern(rows=rows, columns=5, flap=0)
            )
        )

    return measured("orthodiagonal, rows, g straight", 1, ROWS, measure, -1)


def orthodiagonal_approach() -> Series:
    """A g that leaves the columns' normal as far as the rows allow: what is approached then."""

    def measure(rows: int) -> float:
        g = graph(f"{1 / (rows + 1)}*sin(pi*x/2)", 0, 4)
        return approach(
            design_orthodiagonal(f(), g, OrthodiagonalPattern(rows=rows, columns=41, flap=0))
        )

    return measured("orthodiagonal, rows, from the cylinder", 1, ROWS, measure, -1)


def longitudinal(rows: int) -> Design:
    """Sector angles ever nearer to a right one, so that the radius grows ever less."""
    arch = curve_from_formulas(parse_formula("cos(t)"), parse_formula("sin(t)"), 0.3, 2.84)
    sectors = 90 + 50 / (rows + 1) ** 2 * np.array([-5.0, -10, 5, 10])
    return design_longitudinal_linear_repeating(
        arch,
        graph("0*x", 0, 3),
        LongitudinalPattern(rows=rows, columns=9, sector_deg=sectors.tolist()),
    )


def longitudinal_rows() -> Series:
    """The deviation grows with the rows and with the angles' distance from a right one."""
    name = "longitudinal, rows, sectors to 90° as 1/rows²"
    return measured(name, 1, (9, 19, 39, 79), lambda rows: deviation(longitudinal(rows)), -1)


def longitudinal_column() -> Series:
    """Column 1 follows f."""
    name = "longitudinal, rows, column 1 from f"
    rows = (9, 19, 39, 79)
    return measured(name, 2, rows, lambda count: longitudinal(count).closeness["f"].max, -1)


SERIES = (
    parallel_rows,
    parallel_polylines,
    orthodiagonal_rows,
    orthodiagonal_approach,
    longitudinal_rows,
    parallel_columns,
    longitudinal_column,
)


def draw(series: list[Series], path: Path) -> None:
    """Draw all of them, with their orders as slopes."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 7), facecolor="white", layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    for k, each in enumerate(series):
        colour = f"C{k}"
        axes.loglog(
            each.counts,
            each.values,
            "o-" if each.order == 1 else "s-",
            color=colour,
            label=f"{each.name} (order {each.orders()[-1]:.2f})",
        )
        slope = each.values[-1] * (each.counts / each.counts[-1]) ** -each.order
        axes.loglog(each.counts, slope, ":", color=colour, linewidth=1)
    axes.set_xticks([10, 20, 40, 80, 160], ["10", "20", "40", "80", "160"], minor=False)
    axes.set_xticks([], minor=True)
    axes.set_xlabel("edges down a column, or along the middle row")
    axes.set_ylabel("largest distance")
    axes.set_title("Distance of shell and surface; dotted: slopes of order 1 and 2")
    axes.grid(visible=True, which="major", alpha=0.3)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    figure.savefig(path, dpi=150, metadata={"Software": None})


def main() -> None:
    """Measure, print the orders, draw."""
    series = [measure() for measure in SERIES]
    for each in series:
        orders = ", ".join(f"{order:.3f}" for order in each.orders())
        print(f"{each.name}: {orders}")
    draw(series, Path(sys.argv[1]) if len(sys.argv) > 1 else PICTURE)


if __name__ == "__main__":
    main()
