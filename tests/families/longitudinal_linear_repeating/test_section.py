"""How a sheet rolls up, looked at along the line."""

import numpy as np
import pytest

from orishell.families.longitudinal_linear_repeating import RowKind, Sectors, find_solutions
from orishell.families.longitudinal_linear_repeating.motion.mechanism import crease_end
from orishell.families.longitudinal_linear_repeating.section import Section, turnings
from orishell.families.longitudinal_linear_repeating.tessellation.columns import repeat_columns


@pytest.mark.parametrize("rows", range(1, 8))
@pytest.mark.parametrize("first_row", ["F", "S"])
@pytest.mark.parametrize("degrees", [(85, 80, 95, 100), (88, 91.5, 87, 92)])
def test_three_rows_tell_how_much_all_turn(
    rows: int, first_row: RowKind, degrees: tuple[float, ...]
) -> None:
    columns = repeat_columns(find_solutions(Sectors.from_degrees(degrees))[0], 5)
    drives = np.array([1e-3, 0.2, 0.99]) * crease_end(columns, rows, first_row)
    for side in (1, -1):
        whole = [
            Section.of(columns, rows, first_row, float(drive), side).turning for drive in drives
        ]
        found = turnings(columns, rows, first_row, drives, side)
        np.testing.assert_allclose(found, np.abs(whole), rtol=1e-10)
