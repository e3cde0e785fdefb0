"""Every number that the paper states, beside the same number computed from our reproduction.

``paper.py`` writes them as a table; the tests assert that they agree.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from orishell import Design, ParallelRepeating
from orishell.design_file import read_design_file
from orishell.families.longitudinal_linear_repeating import Sectors, find_solutions
from orishell.families.orthodiagonal import Orthodiagonal
from orishell.motion import Mechanism

Array = NDArray[np.float64]
Pair = tuple[Array, Array]

EXAMPLES = Path(__file__).parent
EXACT = 1e-9
"""Where the paper has a formula, both sides agree to rounding."""


@dataclass(frozen=True, slots=True)
class Number:
    """A number of the paper and ours.

    Parameters
    ----------
    where
        Figure, equation or section.
    name
        What it is.
    paper
        The paper's; where it has a formula, the formula's value.
    ours
        Computed from the reproduction.
    within
        Largest difference that counts as agreement: half of the last digit that the paper gives.
        None where the two are not to agree; the remark says why.
    remark
        What is to be said about it.
    """

    where: str
    name: str
    paper: float
    ours: float
    within: float | None = EXACT
    remark: str = ""

    @property
    def difference(self) -> float:
        """Ours, less the paper's."""
        return self.ours - self.paper

    @property
    def agrees(self) -> bool:
        """Whether the two agree, or are not to."""
        return self.within is None or abs(self.difference) <= self.within


def reproduce(name: str) -> Design:
    """The design of one of the examples' files."""
    file = read_design_file(EXAMPLES / f"{name}.toml")
    return file.pattern.design(file.f, file.g)


def count_freedoms(mechanism: Mechanism) -> int:
    """Ways in which a half folded sheet can begin to move, from its coordinates alone.

    About every inner vertex the rates of the four fold angles, each along its crease, add up to 0.
    """
    points = mechanism.positions(mechanism.target_drive / 2)
    rows, columns = np.array(points.shape[:2]) - 2
    row_crease = np.arange(rows * (columns + 1)).reshape(rows, columns + 1)
    column_crease = row_crease.size + np.arange((rows + 1) * columns).reshape(rows + 1, columns)
    middle = points[1:-1, 1:-1]
    equation = np.arange(3 * rows * columns).reshape(rows, columns, 3)
    matrix = np.zeros((equation.size, row_crease.size + column_crease.size))
    for crease, other in (
        (row_crease[:, :-1], points[1:-1, :-2]),
        (row_crease[:, 1:], points[1:-1, 2:]),
        (column_crease[:-1], points[:-2, 1:-1]),
        (column_crease[1:], points[2:, 1:-1]),
    ):
        along = other - middle
        along /= np.linalg.norm(along, axis=-1, keepdims=True)
        matrix[equation, crease[..., None]] = along
    return matrix.shape[1] - int(np.linalg.matrix_rank(matrix, tol=1e-9))


def largest_error(left: Array, right: Array) -> float:
    """Of an equation's two sides, relative where they are large."""
    return float((np.abs(left - right) / np.maximum(1, np.abs(right))).max())


def shared_numbers(where: str, design: Design, m: int, n: int) -> Iterator[Number]:
    """What the paper says of both of its locking shells."""
    sheet = design.mechanism
    flat, locked = sheet.positions(np.array([0.0, sheet.target_drive]))
    yield Number(where, "rows of inner vertices, m", m, flat.shape[0] - 2)
    yield Number(where, "columns of inner vertices, n", n, flat.shape[1] - 2)
    yield Number(where, "rows, m + 2", m + 2, flat.shape[0])
    yield Number(where, "straight line columns, n + 2", n + 2, flat.shape[1])
    yield Number(where, "lengths d of column 1, m + 1", m + 1, len(np.diff(locked[:, 1], axis=0)))
    inner = locked[:, sheet.inner_columns]
    yield Number(where, "lengths l of the middle row, n - 1", n - 1, inner.shape[1] - 1)
    span = np.linalg.norm(locked[-1, 1] - locked[0, 1])
    yield Number(where, "f from x = -1 to 1: span of column 1", 2, float(span))
    crooked = np.abs(np.cross(np.diff(flat, axis=0)[:-1], np.diff(flat, axis=0)[1:])).max()
    yield Number(where, "columns are straight: area off the line", 0, float(crooked))
    shut = np.abs(sheet.fold_angles(sheet.target_drive).row[:, [0, -1]]).min()
    remark = "the flaps clash there; that nothing touches before is proved for the design files"
    yield Number(
        where, "fold angle of the flaps at the end", 180, float(np.rad2deg(shut)), 1e-6, remark
    )
    yield Number("section 5", f"degrees of freedom, {where}", 1, count_freedoms(sheet))


def figure_1() -> Iterator[Number]:
    """Parallel repeating: Figure 1 and equations (1), (2)."""
    design = reproduce("figure1")
    sheet = design.mechanism
    assert isinstance(sheet, ParallelRepeating)
    yield from shared_numbers("Figure 1", design, 9, 11)
    yield Number("Figure 1", "length of g's range", 20, float(np.ptp(sheet.points.real)))
    low, high = np.sort(sheet.points.imag)[[0, -1]]
    remark = "of the middle row; g's own amplitude is 5, its crests are not vertices"
    yield Number("Figure 1", "amplitude of g", 5, float(high - low) / 2, None, remark)
    limit = 2 * np.rad2deg(np.arctan(1 / 2))
    remark = "equation (1) for this f and theta = 0; the paper does not give xi, ours is 50"
    found = design.parameters["xi_limit_deg"]
    assert isinstance(found, float)
    yield Number("equation (1)", "largest xi", float(limit), found, 1e-6, remark)

    alpha, xi = sheet.sector_angles(), sheet.xi
    segments = np.diff(sheet.points)
    odd, even = np.angle(segments / sheet.axes[:-1]), -np.angle(-segments / sheet.axes[1:])
    RU, LU, LD, RD = alpha.T
    square = "all planes are perpendicular to g's tangent"
    yield Number("step (2)", "angles delta, 2n - 2", 20, odd.size + even.size, remark=square)
    yield Number("step (3)", "angles alpha, 4n", 44, alpha.size)
    side = "each flap may take the supplement; it then folds to the other end of f (flap_side)"
    two = "equation (2)"
    degrees = np.rad2deg
    yield Number(
        two, "alpha_3 = (pi - xi)/2", degrees((np.pi - xi) / 2), degrees(LD[0]), remark=side
    )
    sign = "with its sign: |cos alpha_4| fails where delta_1 exceeds 90 degrees"
    yield Number(two, "cos alpha_4", np.cos(odd[0]) * np.cos(LD[0]), np.cos(RD[0]), remark=sign)
    delta = "delta measured as interior angles; measured along one direction g comes out mirrored"
    tangents = np.tan(LD[1:]) * np.tan(odd), np.tan(RD[:-1]) * np.tan(even)
    cosines = np.cos(RD[1:-1]) * np.cos(even[:-1]), np.cos(LD[1:-1]) * np.cos(odd[1:])
    last = np.abs(np.cos(RD[-1:])), np.abs(np.cos(LD[-1:]) / np.cos(even[-1:]))
    lines: tuple[tuple[str, Pair, str], ...] = (
        ("tan alpha_4i+3 / tan delta_2i", tangents, delta),
        ("cos alpha_4i+4 / cos delta_2i+1", cosines, delta),
        ("|cos alpha_4n|", last, side),
        ("alpha_4i-3 = pi - alpha_4i", (RU, np.pi - RD), ""),
        ("alpha_4i-2 = pi - alpha_4i-1", (LU, np.pi - LD), ""),
    )
    for name, (left, right), remark in lines:
        yield Number(two, f"{name}: largest error", 0, largest_error(left, right), remark=remark)


def figure_2() -> Iterator[Number]:
    """Orthodiagonal: Figure 2 and equation (3)."""
    design = reproduce("figure2")
    sheet = design.mechanism
    assert isinstance(sheet, Orthodiagonal)
    yield from shared_numbers("Figure 2", design, 9, 13)
    yield Number("Figure 2", "length of g's range", 4, float(np.ptp(sheet.points.real)))
    yield Number("Figure 2", "amplitude of g", 0.25, float(np.ptp(sheet.points.imag)) / 2, 1e-4)
    alpha, beta = sheet.sector_angles(), sheet.angles
    middle = len(beta) // 2
    yield Number("step (1)", "angles beta, m", 9, beta.size)
    same = "on the side of f's x axis, where they exceed 180 degrees if g bends to the other side"
    gamma = np.pi + np.angle(np.diff(sheet.points)[1:] / np.diff(sheet.points)[:-1])
    yield Number("step (2)", "angles gamma, n - 2", 11, gamma.size, remark=same)
    yield Number("step (3)", "angles alpha, m times 4n", 9 * 4 * 13, alpha.size)
    RU, LU, LD, RD = np.moveaxis(alpha, -1, 0)
    paper_limits = 90.0, float(np.rad2deg(np.pi + beta[middle]) / 2)
    limits = np.array(design.parameters["alpha_0_interval_deg"], dtype=np.float64)
    note = "the paper's interval is only necessary: beyond ours, edges have negative lengths"
    for name, theirs, mine in zip(("lower", "upper"), paper_limits, limits, strict=True):
        yield Number("step (3)", f"alpha_0, {name} end", theirs, float(mine), None, note)
    three = "equation (3)"
    found = np.rad2deg(np.arccos(np.abs(np.cos(LD[:, 0]))))
    side = "or the supplement: the flap then folds to the other end of f (flap_side)"
    worst = float(np.abs(found - np.rad2deg(np.pi - beta) / 2).max())
    yield Number(three, "alpha_i,3 = (pi + beta_i)/2: largest error", 0, worst, remark=side)
    scale = np.abs(np.cos(LD[middle, 0]))
    heading = gamma - np.arccos(np.cos(LD[middle, 1:-1]) / scale)
    right, left = (np.tan(each[:-1, :-1]) / np.tan(each[1:, :-1]) for each in (RD, LD))
    lines: tuple[tuple[str, Pair], ...] = (
        ("alpha_mid,4j-1 = pi - alpha_mid,4j-4", (LD[middle, 1:], np.pi - RD[middle, :-1])),
        ("cos alpha_mid,4j", (np.cos(RD[middle, 1:-1]) / scale, np.cos(heading))),
        ("tan ratios between rows", (right, left)),
        ("alpha_i,4j+3 = pi - alpha_i,4j", (LD[:, 1:], np.pi - RD[:, :-1])),
        ("alpha_i,4j-3 = pi - alpha_i,4j", (RU, np.pi - RD)),
        ("alpha_i,4j-2 = pi - alpha_i,4j-1", (LU, np.pi - LD)),
    )
    for name, (left, right) in lines:
        yield Number(three, f"{name}: largest error", 0, largest_error(left, right))


def figure_3() -> Iterator[Number]:
    """Longitudinal linear repeating: Figure 3 and equation (4)."""
    design = reproduce("figure3")
    three, four = "Figure 3", "equation (4)"
    first = Sectors.from_degrees([85, 80, 95, 100])
    second = find_solutions(first)[0].second
    version = (
        "cosine version's only solution; the sine version has one that no sheet beyond 3 x 3 has"
    )
    given = zip(("alpha", "beta", "gamma", "delta"), (91.23, 86.23, 106.23, 76.23), strict=True)
    for (name, theirs), mine in zip(given, second.degrees, strict=True):
        yield Number(three, f"{name}_2", theirs, float(mine), 0.005, version)
    a1, b1, g1, d1 = (np.deg2rad(angle) for angle in first.degrees)
    a2, b2, g2, d2 = (np.deg2rad(angle) for angle in second.degrees)
    yield Number(four, "beta_1 + alpha_2 - gamma_1 - delta_2", 0, float(b1 + a2 - g1 - d2))
    yield Number(four, "alpha_1 + beta_2 - gamma_1 - delta_2", 0, float(a1 + b2 - g1 - d2))
    sines = np.sin(g1) * np.sin(g2) - np.sin(d1) * np.sin(d2)
    yield Number(four, "product of sines", 0, float(sines))
    left = np.cos((a1 - b1) / 2) * np.cos((b2 + a2) / 2) / np.cos((a1 + b1) / 2)
    left /= np.cos((b2 - a2) / 2)
    k = np.sign((g1 + d1 - np.pi) * (g2 + d2 - np.pi))
    root = np.sqrt(np.sin(d2 + g2) * np.sin(g1 - d1) / np.sin(d2 - g2) / np.sin(g1 + d1))
    yield Number(four, "c: both sides of the cosine version", float(left), float(k * root))
    turned = "column 1 is the largest: the radius grows from right to left"
    largest, smallest = np.array(design.parameters["radius"], dtype=np.float64)
    yield Number(three, "growth of the radius", 1.67, float(largest / smallest), 0.005, turned)
    sheet = design.mechanism
    lengths = np.linalg.norm(np.diff(sheet.positions(0.0)[:, 1], axis=0), axis=1)
    yield Number(
        three, "lengths down column 1: largest to least", 1, float(lengths.max() / lengths.min())
    )
    columns, rows = find_periods(sheet)
    arrangement = (
        "Figure 3(a)'s arrangement is not in the text; ours satisfies equation (4) and folds"
    )
    yield Number("section 4", "period of the columns", 4, columns, remark=arrangement)
    yield Number("section 4", "period of the rows", 2, rows, remark=arrangement)
    planar = "S rows are planar, F rows are not: the paper says that all are"
    for kind, within, remark in (("s", EXACT, ""), ("f", None, planar)):
        off = design.parameters[f"{kind}_row_out_of_plane"]
        assert isinstance(off, float)
        name = f"{kind.upper()} rows out of their planes, of their extent"
        yield Number("section 4", name, 0, off, within, remark)
    yield Number("section 5", "degrees of freedom, Figure 3", 1, count_freedoms(sheet))


def find_periods(sheet: Mechanism) -> tuple[int, int]:
    """Columns and rows after which the sector angles of a flat sheet repeat."""
    flat = sheet.positions(0.0) @ [1, 1j, 0]
    middle = flat[1:-1, 1:-1]
    arms = [flat[:-2, 1:-1], flat[1:-1, :-2], flat[2:, 1:-1], flat[1:-1, 2:]]
    arms = [arm - middle for arm in arms]
    turns = [after / before for before, after in zip(arms, arms[1:] + arms[:1], strict=True)]
    angles = np.asarray(np.angle(turns), dtype=np.float64)

    def period(values: Array) -> int:
        return next(
            p for p in range(1, len(values)) if np.abs(values[p:] - values[:-p]).max() < EXACT
        )

    return period(np.moveaxis(angles, 2, 0)), period(np.moveaxis(angles, 1, 0))


def all_numbers() -> list[Number]:
    """Every number that the paper states, beside ours."""
    return [*figure_1(), *figure_2(), *figure_3()]
