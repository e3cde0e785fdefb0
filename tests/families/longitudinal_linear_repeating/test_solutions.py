"""Equation (4): all solutions but the degenerate one, and what is said where there is none."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.families.longitudinal_linear_repeating import Sectors, Solution, find_solutions
from orishell.families.longitudinal_linear_repeating.equation.choice import choose_solution
from samples import examples

PAPER = Sectors.from_degrees([85, 80, 95, 100])


def angles(low: float, high: float) -> st.SearchStrategy[list[float]]:
    return st.lists(st.floats(low, high).map(lambda x: round(x, 3)), min_size=4, max_size=4)


def equation_4(solution: Solution) -> list[float]:
    """Residuals of the paper's equation (4) as printed, its last line squared."""
    a1, b1, g1, d1 = np.deg2rad(solution.first.degrees)
    a2, b2, g2, d2 = np.deg2rad(solution.second.degrees)
    function = np.cos if solution.version == "cosine" else np.sin
    c = (function((a1 - b1) / 2) * function((a2 + b2) / 2)) / (
        function((a1 + b1) / 2) * function((b2 - a2) / 2)
    )
    left = c**2 * np.sin(d2 - g2) * np.sin(g1 + d1)
    right = np.sin(d2 + g2) * np.sin(g1 - d1)
    return [
        b1 + a2 - g1 - d2,
        a1 + b2 - g1 - d2,
        np.sin(g1) * np.sin(g2) - np.sin(d1) * np.sin(d2),
        (left - right) / (1 + c**2),
        (c - solution.c) / (1 + abs(c)),
    ]


def test_the_papers_angles() -> None:
    # Figure 3: 91.23, 86.23, 106.23, 76.23; further digits and the sine version: geometry.md 5.
    cosine, sine = find_solutions(PAPER)
    assert (cosine.version, sine.version) == ("cosine", "sine")
    assert np.round(cosine.second.degrees, 2).tolist() == [91.23, 86.23, 106.23, 76.23]
    assert cosine.c == pytest.approx(0.169947530529, abs=1e-12)
    assert sine.second.degrees == pytest.approx([179.9118, 174.9118, 14.9118, 164.9118], abs=1e-4)


@settings(max_examples=examples(60))
@given(st.one_of(angles(10, 170), angles(80, 100)))
def test_solutions_satisfy_the_equation_as_printed(degrees: list[float]) -> None:
    for solution in find_solutions(Sectors.from_degrees(degrees)):
        assert np.abs(equation_4(solution)).max() < 1e-9
        # k: the sign under which the root of the right side is c.
        _, _, g1, d1 = solution.first.deviations
        _, _, g2, d2 = solution.second.deviations
        assert np.sign(solution.c) == np.sign((g1 + d1) * (g2 + d2))
        assert not np.array_equal(solution.second.deviations, solution.first.opposite.deviations)


def test_close_to_the_degenerate_solution_and_yet_another() -> None:
    # gamma_2 + delta_2 is 4.4e-5 degrees from 180; c and the residual of 8e-46 to 50 digits.
    degrees = [90.17410500485727, 90.02745501098471, 90.20103130644854, 89.15155130794687]
    _, sine = find_solutions(Sectors.from_degrees(degrees))
    expected = [0.598087, 0.451437, 179.575533, 0.424511]
    assert sine.second.degrees == pytest.approx(expected, abs=6e-7)
    assert sine.c == pytest.approx(-0.00915871, abs=6e-9)


@settings(max_examples=examples(60))
@given(angles(20, 160))
def test_merged_with_the_degenerate_solution(degrees: list[float]) -> None:
    # The cosine version's solution is the degenerate one exactly where alpha + beta = 2 delta:
    # no angle of two decimals, however it rounds, may leave a copy of it.
    alpha, beta, gamma, _ = (round(angle, 1) for angle in degrees)
    merged = find_solutions(Sectors.from_degrees([alpha, beta, gamma, (alpha + beta) / 2]))
    assert "cosine" not in [each.version for each in merged]
    beside = Sectors.from_degrees([alpha, beta, gamma, (alpha + beta) / 2 + 1e-9])
    for solution in find_solutions(beside):
        assert np.abs(equation_4(solution)).max() < 1e-9


def test_angles_near_90_keep_their_digits() -> None:
    # In the limit (4) is homogeneous in the deviations, so c and their ratios tend to constants.
    ratios = []
    for size in (1e-2, 1e-4, 1e-6):
        (solution,) = (
            each
            for each in find_solutions(Sectors.of(size * np.array([-1.0, -2.0, 1.0, 2.0])))
            if each.version == "cosine"
        )
        assert solution.c == pytest.approx(1 / 6, abs=size)
        ratios.append(solution.second.deviations / size)
    np.testing.assert_allclose(ratios[1], ratios[2], atol=1e-7)


def test_equal_gamma_and_delta_is_no_fault() -> None:
    # 0/0 in one of the two fractions for c; the other decides.
    for solution in find_solutions(Sectors.from_degrees([60, 100, 80, 110])):
        assert np.abs(equation_4(solution)).max() < 1e-9
    assert find_solutions(Sectors.from_degrees([60, 70, 80, 80])) == ()
    assert find_solutions(Sectors.from_degrees([80, 80, 80, 80])) == ()


def test_only_the_degenerate_solution() -> None:
    sectors = Sectors.from_degrees([70, 80, 100, 75])
    assert find_solutions(sectors) == ()
    (outside,) = find_solutions(sectors, inside=False)
    assert outside.second.degrees[0] > 180
    with pytest.raises(DesignError, match="degenerate") as caught:
        choose_solution(sectors)
    assert "not all are between 0 and 180" in caught.value.size
    works = next(iter(caught.value.candidates)).changes["pattern.sector_deg"]
    assert isinstance(works, list)
    assert choose_solution(Sectors.from_degrees(works))
    assert np.abs(np.array(works) - sectors.degrees).max() < 1


@pytest.mark.parametrize(
    ("degrees", "why"),
    [
        ([90, 90, 90, 90], "gamma + delta = 180"),
        ([80, 85, 100, 80], "gamma + delta = 180"),
        ([90, 90, 95, 100], "alpha = beta = 90"),
        ([80, 80, 80, 80], "every delta_2 solves it"),
        ([85.3, 74.7, 80, 80], "every delta_2 solves it"),
        ([60, 70, 80, 80], "would not fold"),
        ([70, 80, 100, 75], "only the degenerate one"),
    ],
)
def test_angles_that_fold_nothing(degrees: list[float], why: str) -> None:
    with pytest.raises(DesignError) as caught:
        choose_solution(Sectors.from_degrees(degrees))
    assert why in caught.value.size
    works = next(iter(caught.value.candidates)).changes["pattern.sector_deg"]
    assert works == "auto" or choose_solution(Sectors.from_degrees(np.array(works)))


def test_a_solution_that_is_not_there() -> None:
    with pytest.raises(DesignError, match="no solution = 2") as caught:
        choose_solution(PAPER, 2)
    assert list(caught.value.candidates) == [Remedy({"pattern.solution": 1})]
    assert choose_solution(PAPER, 1).version == "sine"


@pytest.mark.parametrize("degrees", [[0, 80, 95, 100], [85, 180, 95, 100], [85, 80, -1, 100]])
def test_angles_out_of_range(degrees: list[float]) -> None:
    with pytest.raises(InputError, match="between 0 and 180"):
        Sectors.from_degrees(degrees)


def test_four_angles() -> None:
    with pytest.raises(InputError, match="four sector angles"):
        Sectors.from_degrees([85, 80, 95])
    with pytest.raises(InputError, match="delta is out of range"):
        Sectors.from_degrees([85, 80, 95, float("nan")])
