"""Which pictures a shell gets."""

import re
from pathlib import Path
from typing import Any

import pytest

from design_tables import formula, tables
from orishell.conventions.formatting import tidy_degrees
from orishell.design_file import check_design
from orishell.plot import overview
from orishell.shell.export import write_shell
from orishell.shell.make import make_shell
from orishell.shell.pictures import weight_of
from samples import led_by

ARCH, BOWL = ("-x**2", -1, 1), ("x**2", -1, 1)


@pytest.mark.parametrize("panel", [{}, {"thickness": 0.02, "membrane": 0.001}])
def test_the_overview_has_the_sizes_of_the_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, panel: dict[str, float]
) -> None:
    """Those of boards, where panels have some, with the word that says so."""
    design = tables(
        "parallel-repeating", formula(*ARCH), formula("x**2/60", 0, 6), rows=5, columns=5, xi_deg=50
    )
    design["motion"]["frames"] = 3
    design["pattern"]["flap"] = 0
    if panel:
        design["panel"] = panel
    file = check_design(design, Path("shell.toml"))
    shell = make_shell(file, skip=("remedies", "verification", "deviation", "stock"))
    titles = []
    monkeypatch.setattr(overview, "set_title", lambda _, title: titles.append(title))
    write_shell(shell, tmp_path)
    rows = {row.subject: row.finding for row in shell.report.verdict}
    flat, folded = (re.split(r",\s", title)[-1].replace(" × ", " x ") for title in titles[:2])
    assert rows["sheet"].startswith(flat)
    assert rows["deployed"].startswith(folded)
    assert ("of its boards" in folded) == bool(panel)


@pytest.mark.parametrize(
    ("f", "deployment", "drawn"),
    led_by(
        [
            (ARCH, {}, False),
            (ARCH, {"ties": "feet"}, True),
            (ARCH, {"from": "flat"}, False),
            (ARCH, {"from": "pack"}, True),
            (BOWL, {"from": "pack"}, False),  # it has no feet
        ],
        2,
    ),
)
def test_own_weight_is_drawn_for_who_asks(
    tmp_path: Path, f: tuple[str, float, float], deployment: dict[str, Any], drawn: bool
) -> None:
    design = tables(
        "parallel-repeating", formula(*f), formula("x**2/60", 0, 6), rows=5, columns=5, xi_deg=50
    )
    design["motion"]["frames"] = 3
    design["deployment"] = deployment
    file = check_design(design, Path("shell.toml"))
    shell = make_shell(file, skip=("remedies", "verification", "deviation", "stock"))
    names = {path.name for path in write_shell(shell, tmp_path)}
    assert ("weight.png" in names) == drawn
    weight = weight_of(shell.report.deployment, shell.lock)
    if drawn:
        assert weight is not None
        assert weight.unit == "share of its weight"
        assert weight.largest >= 1
        assert weight.marked_deg["target"] == tidy_degrees(shell.report.lock.target_drive)
        assert ("pack" in weight.marked_deg) == (deployment.get("from") == "pack")
