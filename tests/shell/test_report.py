"""What the report says of what was measured."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design_tables import formula, tables
from orishell.cli.design import summarize
from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.record import as_table
from orishell.design import Surface
from orishell.design_file import check_design, read_design_file
from orishell.locking import find_lock
from orishell.motion import diagonal
from orishell.shell import make_shell
from orishell.shell.steps import MEASURES, STEPS, Step
from orishell.structure.load_settings import LoadCase
from orishell.structure.settings import Structure, Support
from orishell.workshop import Workshop
from planted import clear
from samples import THOROUGH

EXAMPLES = Path(__file__).parents[2] / "examples"
UNASKED: tuple[Step, ...] = ("remedies", "verification", "pack", "weight", "stock")
"""Where only the distance from the surface is looked at."""


def test_what_the_report_says_of_a_lock() -> None:
    design = clear()
    said = as_table(find_lock(design))
    assert (said["drive_deg"], said["cause"], said["target_drive_deg"]) == (180, "flaps", 180)
    assert said["first_contact"]["panels"] == [[0, 0], [1, 0]]
    path = said["path"]
    assert path["states"] > 10
    assert path["ranges"] >= path["states"] - 1
    assert path["tests"] > design.mechanism.grid.panel_count
    assert 0 < path["smallest_step_deg"] <= path["largest_step_deg"] <= 180 / 8
    assert path["contact_tolerance"] == 1e-9 * diagonal(design.mechanism.positions(0.0))
    assert "acceleration" in path["bound"]


def test_the_report_says_what_was_left_out() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    file = replace(file, workshop=Workshop(stock=(6.0, 5.0)))
    report = make_shell(file, clash="unexamined", skip=(*MEASURES, "stock")).report
    assert (report.feasible, report.lock.path) == (None, None)
    assert report.deviation is not None
    assert (report.deviation.surface, report.quantities.stock) == (None, None)
    assert report.not_checked == (
        "contact between panels on the way",
        "distance from the surface",
        "the layout on the stock",
    )


@pytest.mark.slow
def test_each_part_is_left_out_by_itself() -> None:
    """Of a small shell with stock, under snow: what each part alone takes from the report."""
    file = read_design_file(EXAMPLES / "figure1.toml")
    file = replace(
        file,
        pattern=file.pattern.model_copy(update={"rows": 3, "columns": 5}),
        workshop=Workshop(stock=(8.0, 8.0), cutting_error=1e-3),
        structure=Structure(
            modulus=1e9,
            poisson=0.3,
            supports=(Support(at="feet", kind="pinned"),),
            cases=(LoadCase(name="snow", pressure=-500.0),),
            thickness=0.02,
            cells=1,
        ),
        frames=2,
    )

    def lacking(*parts: Step) -> set[str]:
        report = make_shell(file, clash="unexamined", skip={"remedies", *parts}).report
        assert report.deviation is not None
        found = {
            "residuals": report.residuals,
            "surface": report.deviation.surface,
            "packed": report.deployment.packed,
            "largest_thickness": report.deployment.largest_thickness,
            "weight": report.deployment.weight,
            "cutting": report.cutting,
            "stock": report.quantities.stock,
            "structure": report.structure,
        }
        return {name for name, value in found.items() if value is None}

    cost: dict[Step, set[str]] = {
        "remedies": set(),
        "verification": {"residuals"},
        "deviation": {"surface"},
        "pack": {"packed", "largest_thickness"},
        "weight": {"weight"},
        "cutting": {"cutting"},
        "stock": {"stock"},
        "structure": {"structure"},
    }
    parts = STEPS if THOROUGH else STEPS[1:-1:2]
    assert {part: lacking(part) for part in parts} == {part: cost[part] for part in parts}
    assert lacking(*STEPS) == set().union(*cost.values())


def test_a_refusal_without_its_remedies() -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    file = file.changed({"pattern.xi_deg": 75.0})
    with pytest.raises(DesignError) as mended:
        make_shell(file)
    with pytest.raises(DesignError) as plain:
        make_shell(file, skip=["remedies"])
    assert plain.value.condition == mended.value.condition
    assert mended.value.remedies
    assert not plain.value.remedies
    assert not plain.value.limit


@pytest.mark.parametrize("skip", [["deviation", "everything"], "everything", "pack"])
def test_a_part_that_there_is_not(skip: list[Step]) -> None:
    file = read_design_file(EXAMPLES / "figure1.toml")
    with pytest.raises(InputError, match=r"skip: there is no such part"):
        make_shell(file, skip=skip)


@pytest.mark.parametrize(
    ("f", "slope"),
    [("x", 1.0), ("-x**2 + 0.1*x", None), ("-x**2", 0.0)],
    ids=["line", "arc", "even"],
)
def test_a_tilted_surface_is_called_so(f: str, slope: float | None) -> None:
    """Beside the distance stands by how much g's plane is tilted in the surface, where it is."""
    design = tables(
        "orthodiagonal", formula(f, -1, 1), formula("0.3*sin(x)", 0, 4), rows=5, columns=7, flap=0
    )
    file = check_design(design, Path("shell.toml"))
    shell = make_shell(file, clash="unexamined", skip=UNASKED)
    deviation, surface = shell.report.deviation, shell.design.surface
    assert deviation is not None
    assert isinstance(surface, Surface)
    u = np.linspace(0.0, surface.rail.stop, 401)
    g = surface.points(u, np.full(len(u), surface.profile.t[0]))
    # The plane of what one point of f is carried along, from its least direction.
    normal = np.linalg.svd(g - g.mean(axis=0))[2][2]
    tilt = np.degrees(np.arccos(min(1.0, abs(normal[2]))))
    assert tilt == pytest.approx(abs(float(str(shell.report.parameters["tilt_deg"]))), abs=1e-6)
    assert slope is None or tilt == pytest.approx(np.degrees(np.arctan(slope)), abs=1e-6)
    if slope == 0:
        assert deviation.tilted == ""
        return
    assert f"tilted by {tilt:.4f}".rstrip("0").rstrip(".") in deviation.tilted
    assert f"g rises by {np.ptp(shell.design.targets['g'][:, 2]):.4g}" in deviation.tilted
    assert any(deviation.tilted in line for line in summarize(shell, [], []))


def test_a_turned_f_is_called_so() -> None:
    design = tables(
        "parallel-repeating",
        formula("exp(x)", -1, 1),
        formula("0*x", 0, 3),
        rows=5,
        columns=3,
        xi_deg=30,
        theta_deg=-20,
        flap=0,
    )
    for theta, words in ((-20, "f is turned in its plane by -20 degrees"), (0, "")):
        design["pattern"]["theta_deg"] = theta
        file = check_design(design, Path("shell.toml"))
        deviation = make_shell(file, clash="unexamined", skip=UNASKED).report.deviation
        assert deviation is not None
        assert deviation.tilted == words
