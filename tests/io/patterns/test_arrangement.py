"""Panels between lines, against GEOS's own polygons and against patterns that are known."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from orishell.conventions.errors import InputError
from orishell.io.patterns.arrangement import arrange
from orishell.io.patterns.lines import Lines
from orishell.motion.crease_pattern import CreasePattern, signed_areas
from orishell.numerics.arrays import Array
from patterns import SAMPLES, Sample
from samples import examples

BOX = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])


def lines_of(ends: Array, letters: list[str] | None = None) -> Lines:
    count = len(ends)
    return Lines(
        ends,
        np.array(letters or ["U"] * count),
        np.full(count, np.nan),
        np.arange(count),
        tuple(f"line {k}" for k in range(count)),
    )


def chords(rng: np.random.Generator, count: int) -> Array:
    """Lines from side to side of the unit square: from random places on its border."""
    place, side = rng.uniform(0.01, 0.99, (count, 2)), rng.integers(0, 4, (count, 2))
    side[:, 1] = (side[:, 0] + 1 + rng.integers(0, 3, count)) % 4
    start, way = BOX[side], BOX[(side + 1) % 4] - BOX[side]
    return np.asarray(start + place[..., None] * way)


def border() -> Array:
    return np.stack([BOX, np.roll(BOX, -1, axis=0)], axis=1)


@pytest.mark.parametrize("seed", range(examples(40)))
def test_chords_of_a_square_part_it_as_geos_says(seed: int) -> None:
    """And as Euler does: one panel more for every chord and every crossing."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(1, 40))
    ends = chords(rng, count)
    lines = lines_of(np.concatenate([border(), ends]), ["B"] * 4 + ["V"] * count)
    found = arrange(lines, 1e-10)  # the usual weld joins crossings of one chord in some of these
    crossings = sum(
        shapely.LineString(ends[i]).intersects(shapely.LineString(ends[j]))
        for i in range(count)
        for j in range(i)
    )
    areas = signed_areas(found.pattern.vertices, found.pattern.faces)
    network = shapely.unary_union(shapely.linestrings(np.concatenate([border(), ends])))
    wanted = [each.area for each in shapely.polygonize([network]).geoms]
    assert len(areas) == 1 + count + crossings
    np.testing.assert_allclose(np.sort(areas), np.sort(wanted), atol=1e-9)  # welds move as much
    assert areas.sum() == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize("share", [0.0, 0.3])
@pytest.mark.parametrize("sample", SAMPLES.values(), ids=SAMPLES)
def test_ends_may_miss_each_other_by_less_than_the_weld(sample: Sample, share: float) -> None:
    """Every line with ends of its own, in any order and direction."""
    pattern = sample.make()
    rng = np.random.default_rng(1)
    ends = pattern.vertices[pattern.edges]
    weld = 1e-4 * float(np.ptp(ends.reshape(-1, 2), axis=0).max())
    ends = ends + rng.uniform(-share, share, ends.shape) * weld
    order = rng.permutation(len(ends))
    ends = np.where(rng.integers(2, size=(len(ends), 1, 1)) == 1, ends, ends[:, ::-1])[order]
    found = arrange(lines_of(ends, pattern.letters[order].tolist()), weld).pattern
    assert counts(found) == counts(pattern)


@pytest.mark.parametrize("share", [2e-5, 2e-4, 2e-3])
@pytest.mark.parametrize("name", ["Miura", "Yoshimura", "Resch"])
def test_the_tolerance_that_joins_loose_ends_is_found(name: str, share: float) -> None:
    """Ends that miss by some shares of the shortest edge: the same sheet, and it is said.

    What is said is the largest distance that was bridged: no more than two ends can be apart.
    """
    pattern = SAMPLES[name].make()
    rng = np.random.default_rng(2)
    ends = pattern.vertices[pattern.edges]
    shortest = np.hypot(*(ends[:, 1] - ends[:, 0]).T).min()
    reach = share * float(np.hypot(*np.ptp(pattern.vertices, axis=0)))
    assert reach < shortest / 30
    moved = ends + reach * rng.uniform(-0.35, 0.35, ends.shape)  # 0.99 times that, at most, apart
    found = arrange(lines_of(moved, pattern.letters.tolist()))
    assert counts(found.pattern) == counts(pattern)
    (note,) = (each for each in found.notes if "joined" in each)
    said = float(note.split()[3])
    assert 0.3 * reach < said <= reach
    again = arrange(lines_of(moved, pattern.letters.tolist()), float(note.split()[-1][:-1]))
    np.testing.assert_array_equal(again.pattern.vertices, found.pattern.vertices)


@pytest.mark.parametrize("apart", [2.0, 8.0])
def test_what_may_be_meant_to_be_apart_is_not_joined_unasked(apart: float) -> None:
    """Two creases beside each other, and one that stops short: is it the gap or is it a pleat?"""
    gap = 0.003
    ends = [[[0.5, 0], [0.5, 1 - gap]], [[0.5 + apart * gap, 0], [0.5 + apart * gap, 1]]]
    lines = lines_of(np.concatenate([border(), np.array(ends)]), ["B"] * 4 + ["M", "V"])
    if apart < 4:
        with pytest.raises(InputError, match="ends") as caught:
            arrange(lines)
        weld = float(caught.value.remedy.split()[2])
        assert caught.value.changes == {"weld": weld}
        assert len(arrange(lines, weld).pattern.faces) == 3
    else:
        assert len(arrange(lines).pattern.faces) == 3


def miura_vertex(first: tuple[float, float], second: tuple[float, float]) -> Lines:
    """Four creases that fold at the middle of a square of 1; two of them end somewhat elsewhere."""
    tips = np.array([[0.588163, 0.0], [1.0, 0.681985], [0.5, 1.0], [0.0, 0.588163]])
    middle = np.array([[0.5, 0.5], [0.5, 0.5], first, second])
    ends = np.stack([middle, tips], axis=1)
    return lines_of(np.concatenate([border(), ends]), [*"BBBB", *"VVMV"])


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ((0.50164, 0.501342), (0.5, 0.5)),  # one end is beside a line, 0.0002 from the corner
        ((0.50164, 0.501342), (0.501606, 0.501436)),  # two are nearer to each other than to it
        ((0.501743, 0.50106), (0.501743, 0.50106)),  # two meet beside it, and touch nothing
    ],
)
def test_ends_are_joined_to_the_point_that_they_belong_to(
    first: tuple[float, float], second: tuple[float, float]
) -> None:
    """Not to a line beside it, where an edge as short as the gap is left, nor only to each other,
    where creases bend, which never fold."""
    found = arrange(miura_vertex(first, second))
    assert (len(found.pattern.faces), len(found.pattern.inner)) == (4, 1)
    assert "joined" in found.notes[-1]


def test_a_crease_that_bends_is_left_as_it_is() -> None:
    """It is drawn so: no tolerance makes anything else of it."""
    bent = np.array([[[0.4, 0.0], [0.45, 0.5]], [[0.45, 0.5], [0.4, 1.0]]])
    found = arrange(lines_of(np.concatenate([border(), bent]), [*"BBBB", "V", "V"]))
    assert (len(found.pattern.faces), len(found.pattern.inner)) == (2, 1)
    assert not found.notes


@pytest.mark.parametrize("length", [1e-3, 0.1])
def test_a_mountain_and_a_valley_that_overlap(length: float) -> None:
    """By a little their ends are one; by more it is said how long they lie on each other."""
    ends = [[[0, 0.5], [0.5 + length, 0.5]], [[0.5, 0.5], [1, 0.5]]]
    lines = lines_of(np.concatenate([border(), np.array(ends)]), ["B"] * 4 + ["M", "V"])
    if length < 0.01:
        found = arrange(lines)
        assert sorted(found.pattern.letters[found.pattern.crease].tolist()) == ["M", "V"]
        assert "joined" in found.notes[-1]
    else:
        with pytest.raises(InputError, match=r"lie on each other.*over a length of 0\.1"):
            arrange(lines)


def counts(pattern: CreasePattern) -> tuple[object, ...]:
    corners = np.sort((pattern.faces >= 0).sum(axis=1)).tolist()
    letters = sorted(pattern.letters.tolist())
    return len(pattern.vertices), len(pattern.inner), corners, letters


def test_long_lines_are_parted_at_all_that_cross_them() -> None:
    """As one draws a grid: 100 lines each way, ends of others on them, and diagonals."""
    n = 100
    k = np.arange(n + 1.0)
    rows = np.stack([np.stack([0 * k, k], -1), np.stack([0 * k + n, k], -1)], axis=1)
    columns = rows[..., ::-1]
    diagonal = np.array([[[0.0, 0], [n, n]]])
    letters = ["B"] + ["M"] * (n - 1) + ["B"]
    found = arrange(lines_of(np.concatenate([rows, columns, diagonal]), [*letters, *letters, "V"]))
    assert len(found.pattern.faces) == n**2 + n
    assert len(found.pattern.inner) == (n - 1) ** 2
    assert (found.pattern.letters == "V").sum() == n


def test_overlapping_lines_are_one_and_the_higher_letter_counts() -> None:
    """A crease drawn in parts that overlap, one without a letter; a valley along the border."""
    ends = [[[0.5, 0], [0.5, 0.6]], [[0.5, 0.4], [0.5, 0.9]], [[0.5, 0.8], [0.5, 1]]]
    along = [[[0.2, 0], [0.7, 0]]]
    ends += [[[0.5, 0.2], [0.5, 0.5]]]
    letters = ["B"] * 4 + ["M", "M", "M", "U", "V"]
    found = arrange(lines_of(np.concatenate([border(), np.array(ends + along)]), letters))
    pattern = found.pattern
    assert len(pattern.faces) == 2
    assert sorted(pattern.letters.tolist()) == ["B"] * 6 + ["M"]
