"""What a shell stands on, found on its rows, and where that puts it."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from orishell.cli.main import app
from orishell.conventions.errors import InputError
from orishell.conventions.record import as_table
from orishell.deployment.feet import find_feet, stand
from orishell.deployment.verdict import feet_rows
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.design_file.file import check_design
from orishell.families.orthodiagonal import OrthodiagonalPattern, design_orthodiagonal
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.io import read_fold
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from samples import led_by
from strategies import graph, pair

EXAMPLES = Path(__file__).parents[2] / "examples"
G = graph("0.3*sin(pi*x/5)", 0, 10)


def parallel(f: Any, **options: Any) -> Design:
    return design_parallel_repeating(
        f,
        G,
        ParallelRepeatingPattern(rows=9, columns=7, flap=0.2, xi_deg=np.rad2deg(1.0), **options),
    )


def shell(f: str, ends: list[float], **table: Any) -> Shell:
    tables = {
        "shell": {"family": "parallel-repeating", "unit": "m", **table},
        "target": {
            "f": {"formula": f, "range": ends},
            "g": {"formula": "0.3*sin(pi*x/5)", "range": [0, 10]},
        },
        "pattern": {"rows": 9, "columns": 7, "flap": 0.2, "xi_deg": 57},
        "motion": {"frames": 5},
    }
    return make_shell(check_design(tables, Path("x.toml")), clash="unexamined", skip=MEASURES)


def test_an_arch_stands_level_on_the_ends_of_its_columns() -> None:
    design = parallel(graph("-0.7*x**2", -1, 1))
    feet = find_feet(design)
    assert feet is not None
    design, _ = stand(design, feet)
    assert feet.rows == (0, 10)
    assert feet.level
    world = design.mechanism.positions(np.pi) + design.origin
    np.testing.assert_allclose(world[[0, -1]][..., 2], 0, atol=1e-14)
    assert world[..., 2].min() > -1e-14


def test_ends_at_different_heights_are_said_to_be_uneven() -> None:
    design = parallel(graph("-0.7*x**2", -1, 0.7))
    feet = find_feet(design)
    assert feet is not None
    # f's ends differ by 0.7 (1 - 0.49), and the staircase follows them to its own rise.
    assert feet.uneven == pytest.approx(0.7 * (1 - 0.49), abs=1e-6)
    assert not feet.level
    lowest = (stand(design, feet)[0].origin + design.mechanism.positions(np.pi))[..., 2].min()
    assert lowest == pytest.approx(0, abs=1e-14)


def test_flaps_that_reach_below_the_feet_are_named_with_them() -> None:
    """Feet are level all the same: flaps are none of them, however little they reach below."""
    f, g = graph("-2*x**2", -0.5, 1.5), graph("0*x", 0, 4)
    found = []
    for side in ("start", "end"):
        pattern = OrthodiagonalPattern(
            rows=9, columns=2, depth="auto", flap=0.4, flap_side=[side, side]
        )
        design = design_orthodiagonal(f, g, pattern)
        feet = find_feet(design)
        assert feet is not None
        placed = design.mechanism.positions(design.mechanism.target_drive)[..., 2]
        inner = placed[:, design.mechanism.inner_columns]
        assert feet.below == pytest.approx(inner.min() - placed.min(), abs=1e-12)
        (row,) = feet_rows(feet, "m", on_f=True)
        assert ("; flaps reach" in row.finding) == (feet.below > 0)
        found.append(feet.below > 0)
    assert found == [False, True]


@pytest.mark.parametrize(
    "f",
    [
        graph("0.7*x**2", -1, 1),  # a trough
        graph("-0.7*x**2", 0, 1),  # half an arch: it would fall over
        graph("0.5*x", -1, 1),  # a slope
        graph("0*x", -1, 1),  # a slab
        graph("0.25*cos(2*pi*x)", -1, 1),  # lowest between its ends
    ],
)
def test_what_cannot_stand_stays_where_g_puts_it(f: Any) -> None:
    design = parallel(f)
    assert find_feet(design) is None
    assert stand(design, None) == (design, None)


def test_a_wall_cannot_stand() -> None:
    """f upright: the shell is a screen along g, with one row at its foot."""
    f = pair("0.1*sin(3*t)", "t", 0, 2)
    design = design_orthodiagonal(f, graph("0*x", 0, 4), OrthodiagonalPattern(rows=9, columns=3))
    assert find_feet(design) is None


def test_the_lowest_row_is_a_foot_though_it_is_not_the_last() -> None:
    """This arch ends on the upper side of its corrugation."""
    design = parallel(graph("-0.3*x**2", -1, 1))
    feet = find_feet(design)
    assert feet is not None
    assert feet.rows == (1, 9)
    assert feet.level
    height = design.mechanism.positions(np.pi)[:, design.mechanism.inner_columns, 2]
    assert height[[0, -1]].min() > feet.z + 0.1
    assert feet.z == height.min()


def test_an_arch_lower_than_its_corrugation_does_not_stand_on_its_ends() -> None:
    f = graph("-0.05*x**2", -1, 1)
    design = design_parallel_repeating(
        f, G, ParallelRepeatingPattern(rows=3, columns=7, flap=0.2, xi_deg=np.rad2deg(1.0))
    )
    height = design.mechanism.positions(np.pi)[:, design.mechanism.inner_columns, 2]
    assert height.min(axis=1).argmin() == 2  # the middle row
    assert find_feet(design) is None


def test_ends_that_no_plane_trims_are_uneven_by_what_their_rows_are() -> None:
    g = graph("0.25*sin(pi*x/2)", 0, 4)
    design = design_orthodiagonal(
        graph("-x**2", -1, 1), g, OrthodiagonalPattern(rows=19, columns=13, depth=0.06)
    )
    assert design.parameters["ends"] == ["untrimmed", "untrimmed"]
    feet = find_feet(design)
    assert feet is not None
    height = design.mechanism.positions(np.pi)[:, design.mechanism.inner_columns, 2]
    assert feet.uneven == np.ptp(height[list(feet.rows)]) > 0.01


def test_the_whole_motion_moves_by_the_same_height() -> None:
    drawn, standing = (shell("-0.7*x**2", [-1, 1], ground=ground) for ground in ("as-drawn", "z0"))
    stands = drawn.report.stands
    assert stands is not None
    assert stands.z == pytest.approx(-drawn.report.deployed.height)
    meant = {"rows": [0, 10], "z": 0.0, "uneven": stands.uneven, "level": True, "points": []}
    meant["below"] = 0.0
    assert as_table(standing.report.stands) == meant
    up = standing.design.origin - drawn.design.origin
    assert up[2] > 0
    for before, after in zip(drawn.document.states, standing.document.states, strict=True):
        np.testing.assert_array_equal(before.positions, after.positions)
        moved = standing.document.in_world(after.positions) - before.positions
        np.testing.assert_allclose(moved, np.broadcast_to(up, moved.shape), atol=1e-14)


def test_ground_is_z0_unless_said() -> None:
    assert shell("-0.7*x**2", [-1, 1]).file.ground == "z0"
    with pytest.raises(InputError, match="ground"):
        shell("-0.7*x**2", [-1, 1], ground="floor")


def test_curves_and_surface_are_raised_with_the_shell(tmp_path: Path) -> None:
    import rhino3dm

    from orishell.io.format import Settings
    from orishell.io.formats.rhino import write_rhino

    standing = shell("-0.7*x**2", [-1, 1])
    write_rhino(tmp_path / "shell.3dm", standing.document, Settings())
    model = rhino3dm.File3dm.Read(str(tmp_path / "shell.3dm"))
    table: Any = model.Objects
    objects = [table[number] for number in range(len(table))]
    (curve,) = [each.Geometry for each in objects if each.Attributes.Name == "g"]
    assert curve.PointAtStart.Z == standing.design.origin[2] > 0


@pytest.mark.parametrize(
    ("name", "says"),
    led_by(
        [
            ("figure1", "feet      level on z = 0, on rows 0 and 10"),
            ("figure3", "feet      on rows 0 and 8, from z = 0 up to 0.433 m above"),
            ("canopy", "feet      nowhere: f's ends are not its lowest part"),
        ]
    ),
)
def test_summary_says_what_a_shell_stands_on(name: str, says: str, tmp_path: Path) -> None:
    arguments = ["design", str(EXAMPLES / f"{name}.toml"), "--out", str(tmp_path / "out")]
    result = CliRunner().invoke(app, [*arguments, "--no-clash-test"])
    assert result.exit_code == 0
    assert says in result.stdout
    lowest = read_fold(tmp_path / "out" / "shell.fold").frames[-1].positions[:, 2].min()
    stands = read_design_file(EXAMPLES / f"{name}.toml").ground == "z0" and name != "canopy"
    assert (abs(lowest) < 1e-12) == stands
