"""Figures are numbers of the report, and nothing that they need is left out."""

from __future__ import annotations

import pytest

from orishell.conventions.errors import InputError
from orishell.design_file import check_design
from orishell.search.evaluate import evaluate, job_of
from orishell.search.figures import NAMES, figure
from orishell.search.problem import parse_problem
from orishell.shell.make import make_shell
from orishell.shell.report import Report
from samples import thorough
from search.problems import PATH, loaded_tables

KEYS = (
    "deviation.surface.p95",
    "deviation.f.max",
    "deployment.packed.height",
    "deployment.largest_thickness",
    "deployment.weight.raise_from_flat",
    "sheet.width",
    "structure.model.mass",
    "structure.governs.utilisation",
    "residuals.panel_length",
    "lock.target_drive_deg",
    "quantities.crease_length.mountain",
)
TABLES = loaded_tables(
    variables={"pattern.depth": [0.12]},
    minimise=["panels"],
    subject_to={name: {"least": -1e9} for name in (*NAMES, *KEYS)},
)


@pytest.fixture(scope="module")
def report() -> Report:
    """Of the shell with nothing left out."""
    return make_shell(check_design(TABLES, PATH)).report


@thorough
def test_what_a_search_leaves_out_changes_no_figure(report: Report) -> None:
    (outcome,) = evaluate(job_of(parse_problem(TABLES, PATH)), [{}])
    assert outcome.figures == {name: figure(name).read(report) for name in (*NAMES, *KEYS)}


@pytest.mark.slow
def test_each_figure_needs_what_it_says() -> None:
    for name in ("panels", "mass", "deviation", "packed_volume", "deflection.snow", *KEYS):
        raw = loaded_tables(variables={"pattern.depth": [0.12]}, minimise=[name])
        raw["pattern"]["columns"] = 3
        raw["target"]["g"]["range"] = [0, 1]
        if figure(name).part != "structure":  # that would be analysed for its limits
            del raw["structure"], raw["load_case"]
        (outcome,) = evaluate(job_of(parse_problem(raw, PATH)), [{}])
        assert not outcome.reason, name


def test_figures_with_a_name_are_those_of_the_report(report: Report) -> None:
    packed, structure = report.deployment.packed, report.structure
    assert packed is not None
    assert structure is not None
    assert report.deviation is not None
    assert report.deviation.surface is not None
    height = max(packed.height, packed.layers * 0.01)  # panels of 10 mm
    standing = [
        (case.name, case.equilibrium) for case in structure.cases if case.equilibrium is not None
    ]
    moved = [(name, stands.displacement.size) for name, stands in standing]
    expected = {
        "panels": report.quantities.panels,
        "deviation": report.deviation.surface.max,
        "mass": report.quantities.mass_kg,
        "packed_volume": packed.length * packed.width * height,
        "cut_length": report.quantities.outline_length,
        "deflection": max(size for _, size in moved),
        "deflection.dead": max(size for name, size in moved if name == "dead"),
        "tie_force.snow": max(
            tie.force for name, stands in standing if name == "snow" for tie in stands.ties
        ),
    }
    assert len(standing) == 4  # each case with the least and the largest stiffness of creases
    for name, value in expected.items():
        assert figure(name).read(report) == value, name
    assert max(size for _, size in moved) > max(size for name, size in moved if name == "dead")


def test_a_case_that_there_is_not_has_no_deflection(report: Report) -> None:
    assert figure("deflection.wind").read(report) is None


def test_labels() -> None:
    assert figure("packed_volume").label("mm") == "packed volume (mm³)"
    assert figure("deflection.snow").label("m") == "deflection under snow (m)"
    assert figure("deviation.f.max").label("m") == "deviation.f.max"


@pytest.mark.parametrize(
    ("name", "remedy"),
    [
        ("pannels", "did you mean panels?"),
        ("deviation.surface.rmss", "did you mean deviation.surface.rms?"),
        ("warnings", ""),
        ("structure.cases", ""),
        ("", ""),
    ],
)
def test_a_figure_that_the_report_lacks_is_refused(name: str, remedy: str) -> None:
    with pytest.raises(InputError, match="no such figure") as error:
        figure(name)
    assert error.value.remedy.startswith(remedy)
