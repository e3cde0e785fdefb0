"""Heights of hinges: the closed form is the least, and the conditions are independent."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from flat_foldables import random_sheet
from mechanisms import flat_foldable, miura_net, parallel, random_net, upright
from orishell.conventions.errors import DesignError
from orishell.design import PanelSpec
from orishell.motion import find_assignment
from orishell.motion.grid import CreaseValues
from orishell.motion.hinges import Hinges
from orishell.motion.mechanism import Mechanism
from orishell.solids.hinged import find_hinges
from orishell.solids.hinged.conditions import Vertices
from orishell.solids.hinged.heights import closed_form
from orishell.solids.hinged.program import APART, MOST_PANELS, least_arms
from timing import ROOM, seconds

BUILD = PanelSpec(thickness=0.01, construction="hinged")


def vertices_of(mechanism: Mechanism) -> Vertices:
    return Vertices.of(mechanism.positions(0.0), find_assignment(mechanism))


@pytest.mark.parametrize("rows", range(1, 16))
def test_the_closed_form_is_the_least(rows: int) -> None:
    """Rows of Miura-ori alternate, so the arms of columns are as many thicknesses as rows."""
    vertices = vertices_of(flat_foldable(miura_net(rows, 3)))
    found = closed_form(vertices)
    assert found is not None
    assert found.longest_arm == pytest.approx(rows, abs=1e-12)
    # The program keeps all hinges off the faces, which adds up over the rows.
    kept = (2 * rows + 1) * APART
    assert least_arms(vertices).longest_arm == pytest.approx(rows + kept, abs=1e-9)


@pytest.mark.parametrize("seed", range(12))
def test_conditions_are_independent_and_met(seed: int) -> None:
    sheet = random_sheet(seed)
    vertices, hinges = vertices_of(sheet), find_hinges(sheet, BUILD)
    matrix = vertices.conditions().toarray()
    assert np.linalg.matrix_rank(matrix) == 2 * vertices.a.size == len(matrix)
    heights = np.concatenate([hinges.heights.row.ravel(), hinges.heights.column.ravel()])
    assert np.abs(matrix @ heights).max() <= 1e-13 * np.abs(heights).max()


@pytest.mark.parametrize("seed", range(8))
def test_hinges_lie_beyond_the_faces_on_which_their_creases_close(seed: int) -> None:
    sheet = random_sheet(seed)
    hinges, signs = find_hinges(sheet, BUILD), find_assignment(sheet)
    low, t = hinges.levels, hinges.thickness
    for sign, height, beside in (
        (signs.row, hinges.heights.row, (low[:-1], low[1:])),
        (signs.column, hinges.heights.column, (low[:, :-1], low[:, 1:])),
    ):
        for bottom in beside:
            clear = np.where(sign > 0, height - bottom - t, bottom - height)
            assert clear[sign != 0].min(initial=0.0) >= -1e-15
    assert all(each.min() >= -1e-15 for each in hinges.arms)


def test_a_column_that_does_not_fold_has_no_arm() -> None:
    """The crest of this g: the column in its middle stays unfolded."""
    sheet = parallel(plane="bisector", flap=0.0)
    still = find_assignment(sheet).column == 0
    assert still.any()
    hinges = find_hinges(sheet, BUILD)
    assert not hinges.heights.column[still].any()
    assert not hinges.arms[1][:, still].any()


def test_straight_rows_are_straight_columns_turned() -> None:
    sheet = flat_foldable(miura_net(4, 5))
    vertices = vertices_of(sheet)
    turned = Vertices(
        vertices.b.T,
        np.pi - vertices.a.T,
        ~vertices.row_mode.T,
        CreaseValues(vertices.signs.column.T, vertices.signs.row.T),
    )
    found, other = closed_form(vertices), closed_form(turned)
    assert found is not None
    assert other is not None
    assert np.array_equal(found.heights.row, other.heights.column.T)
    assert np.array_equal(found.heights.column, other.heights.row.T)


def levelled(size: int) -> Callable[[], Hinges]:
    net = flat_foldable(miura_net(size, size))
    flat, signs = net.positions(0.0), find_assignment(net)

    def found() -> Hinges:
        levels = closed_form(Vertices.of(flat, signs))
        assert levels is not None
        return levels

    return found


def test_the_time_for_heights_grows_with_the_panels() -> None:
    small, large = levelled(32), levelled(99)
    assert large().levels.size == 10_000
    assert seconds(large) < ROOM * (100 / 33) ** 2 * seconds(small)


def test_a_sheet_that_does_not_fold_flat_is_refused() -> None:
    with pytest.raises(DesignError, match=r"folds flat, at vertex .* miss 180 degrees") as caught:
        find_hinges(upright(flap=0.0), BUILD)
    assert caught.value.excess == pytest.approx(53.45 / 180, rel=1e-3)


def test_arms_that_are_too_long_are_refused_with_the_arm_that_is_needed() -> None:
    sheet = flat_foldable(miura_net(6, 4))
    with pytest.raises(DesignError, match=r"arms of 0.06 are needed, 6 times") as caught:
        find_hinges(sheet, BUILD.replace_unchecked(largest_arm=0.05))
    for remedy in caught.value.candidates:
        changes = {key.removeprefix("panel."): value for key, value in remedy.changes.items()}
        find_hinges(sheet, BUILD.replace_unchecked(**{"largest_arm": 0.05, **changes}))


def test_the_program_is_refused_a_sheet_that_is_too_large() -> None:
    many = int(np.sqrt(MOST_PANELS)) + 1
    with pytest.raises(DesignError, match="so large a sheet"):
        find_hinges(flat_foldable(random_net(many, many, 1)), BUILD)
