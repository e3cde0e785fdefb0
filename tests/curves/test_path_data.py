"""Curves as SVG path data: written exactly where SVG has their pieces, and read again."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from orishell.curves import curve_data, parse_curve, trace_curve
from orishell.curves.joining import Chain
from orishell.curves.nearest import Nearest
from orishell.curves.pieces import Arc, Piece, nurbs
from orishell.curves.piecewise import PieceArrays
from orishell.numerics.arrays import Array


def points_of(chain: Chain) -> Array:
    shares = np.linspace(0, 1, 21)
    return np.concatenate(
        [PieceArrays.of([p]).jet(np.zeros(21, np.intp), shares)[0] for p in chain.pieces]
    )


def chain_of(pieces: list[Piece]) -> Chain:
    ends = [PieceArrays.of([piece]).at(1.0)[0] for piece in pieces]
    return Chain(tuple(pieces), np.array([PieceArrays.of(pieces[:1]).at(0.0)[0], *ends]))


def test_upwards_an_arc_with_the_flag_sweep_turns_left() -> None:
    left, right = (parse_curve(f"M-3 0A3 3 0 0 {sweep} 3 0").curve() for sweep in (1, 0))
    middle = 0.5 * (left.start + left.stop)
    np.testing.assert_allclose(left.position(middle), [0, -3], atol=1e-12)
    np.testing.assert_allclose(right.position(middle), [0, 3], atol=1e-12)


def test_every_command_survives() -> None:
    text = "m1,2 h3 v-1 q1 1 2 0 t 1 1 c 1 1 2 2 3 -1 s 1 1 2 2 a 4 2 30 1 0 3 3 L20 1 20 1 21 2"
    chain = parse_curve(text)
    data, farthest = curve_data(chain)
    assert farthest == 0
    assert [word[0] for word in data.split() if word[0].isalpha()] == list("MLLQQCCALL")
    np.testing.assert_allclose(points_of(parse_curve(data)), points_of(chain), atol=1e-11)


@pytest.mark.parametrize("sweep", [np.pi, -np.pi, 1.0, -4.0, 2 * np.pi])
@pytest.mark.parametrize("seed", range(5))
def test_arcs_of_any_ellipse_are_written_exactly(sweep: float, seed: int) -> None:
    """Half of one, too, where rounding its radii could leave less than half."""
    draw = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(draw.normal(size=(2, 2)))
    axes = np.diag(draw.uniform(0.5, 9, 2)) @ turn if seed else 3 * np.eye(2)
    chain = chain_of([Arc(draw.normal(size=2), axes, draw.uniform(0, 6), sweep)])
    read = parse_curve(curve_data(chain)[0])
    assert len(read.pieces) == 1 + (sweep > 6)
    lengths = [trace_curve(each.curve()).length for each in (read, chain)]
    assert lengths[0] == pytest.approx(lengths[1], rel=1e-10)
    near = Nearest.to(trace_curve(chain.curve()))
    assert near(points_of(read))[1].max() < 1e-9


def of_nurbs(*numbers: Any) -> Chain:
    return chain_of(nurbs(*numbers))


def test_a_rational_quarter_of_a_circle_is_an_arc() -> None:
    knots, corner = [0, 0, 0, 1, 1, 1], [[1, 0], [1, 1], [0, 1]]
    assert curve_data(of_nurbs(2, knots, corner, [1, np.sqrt(0.5), 1])) == (
        "M1 0 A1 1 0 0 1 0 1",
        0,
    )


@pytest.mark.parametrize("weights", [[1, 3, 2], [1, 0.3, 2]])
def test_what_svg_does_not_have_is_followed_closely(weights: list[float]) -> None:
    chains = [
        of_nurbs(2, [0, 0, 0, 1, 1, 1], [[1, 0], [2, 1], [0, 1]], weights),
        of_nurbs(3, [0] * 4 + [1] * 4, [[1, 0], [2, 1], [0, 1], [0, 3]], [*weights, 1]),
    ]
    for chain in chains:
        data, farthest = curve_data(chain)
        near = Nearest.to(trace_curve(chain.curve()))
        assert near(points_of(parse_curve(data)))[1].max() <= farthest + 1e-11
        assert farthest < 1e-3
        assert len(data) < 3000
