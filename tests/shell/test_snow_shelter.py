"""The example that carries snow with free hinges: what it says of itself."""

from __future__ import annotations

import pytest

from documents import EXAMPLES
from orishell.design_file import read_design_file
from orishell.shell.instead import shell_of
from orishell.shell.steps import MEASURES, Work
from samples import thorough

FILE = EXAMPLES / "shelter_snow.toml"
README = " ".join((EXAMPLES.parent / "README.md").read_text(encoding="utf-8").split())
PLAN = 3.0 * 6.0
"""Of f and g (m2)."""


def test_its_hinges_by_hand() -> None:
    """By the formulas that its remark names, N and mm: half of a board of 9 mm, bolts of 5 mm."""
    structure = read_design_file(FILE).structure
    assert structure is not None
    lines = structure.line_strength
    assert lines is not None
    bolt = 0.4 * 0.11 * (1 - 0.01 * 5) * 630 * 4.5 * 5 * 0.65 / 1.3
    leaf = 235 * 1.5**2 / 6
    assert leaf / (2 + 0.75) / 2 > bolt / 25
    for value in (lines.pull, lines.push, lines.along):
        assert value is not None
        assert 0.98 < value / 1e3 / (bolt / 25) < 1.002
    assert lines.across is not None
    assert 0.98 < lines.across / 1e3 / (leaf / 10) < 1.002


@thorough
@pytest.mark.slow
def test_it_carries_all_combinations_with_free_hinges() -> None:
    """Hinges and ties are weighed, and ties are proved slack on the way."""
    file = read_design_file(FILE)
    assert file.structure is not None
    assert file.structure.crease_stiffness == (0.0, 0.0)
    work = Work(clash="unexamined", skip=(*MEASURES, "stock", "verification"))
    found = shell_of(file, work)
    analysis = found.analysis
    assert analysis is not None
    assert len(analysis.cases) == 95
    assert analysis.carries is True
    assert analysis.governs is not None
    assert analysis.governs.part == "lines"
    assert analysis.governs.utilisation == pytest.approx(0.92, abs=0.02)
    ties = found.deployment.ties
    assert all(tie.slack for tie in ties)
    rope = 0.0154 * sum(tie.length for tie in ties)
    assert analysis.model.mass is not None
    by_plan = (analysis.model.mass + rope) / PLAN
    assert 19 < by_plan < 20
    for words in (
        f"all {len(analysis.cases)} combinations",
        f"at {by_plan:.1f} kg/m2",
        f"used to {100 * analysis.governs.utilisation:.0f} %",
    ):
        assert words in README
