"""Flaps as wide as meet nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brute_force import crosses, not_designed
from design_tables import Tables, formula, tables
from orishell.conventions.errors import ClashError, Remedy
from orishell.design_file import DesignFile, check_design
from orishell.locking import find_lock, reaches_target
from orishell.shell import remedies
from orishell.shell.candidate import ended
from orishell.shell.designed import designed
from orishell.shell.make import make_shell
from orishell.shell.steps import Work
from samples import thorough


def asked_for(f: Tables, g: Tables, flap: Any, **keys: Any) -> DesignFile:
    design = tables("parallel-repeating", f, g, flap=flap, **keys)
    return check_design(design, Path("shell.toml"))


def bend(flap: Any, rows: int = 3, columns: int = 10) -> DesignFile:
    """Flaps across an almost closed bend."""
    f, g = formula("-x**2", -1, 1), formula(["2.2*cos(t)", "2.2*sin(t)"], 0, 5.5)
    return asked_for(f, g, flap, rows=rows, columns=columns, xi_deg=50, flap_side="start")


def refusal(asked: DesignFile) -> ClashError:
    with pytest.raises(ClashError) as caught:
        make_shell(asked)
    return caught.value


def mended(asked: DesignFile) -> Remedy:
    (remedy,) = refusal(asked).remedies
    return remedy


def works(asked: DesignFile) -> bool:
    return reaches_target(designed(asked), asked.contact_tolerance)


@thorough
def test_too_wide_a_flap_is_told_the_widest_that_works() -> None:
    assert "opposite flaps" in str(refusal(bend(4.0)))
    widest = float(str(mended(bend(4.0)).changes["pattern.flap"]))
    asked = bend(widest)
    _, lock = ended(asked, designed(asked), Work())
    assert lock.cause == "flaps"
    assert not works(bend(1.01 * widest))


@pytest.mark.parametrize("slow", [False, True])
def test_no_flaps_are_offered_where_no_width_is_found_in_time(
    monkeypatch: pytest.MonkeyPatch, slow: bool
) -> None:
    """Widths take long to prove where panels have boards: that none do is known before."""

    def over(*_: Any) -> Any:
        raise remedies._OutOfTimeError

    monkeypatch.setattr(remedies, "_coarsely" if slow else "largest_quotable", over)
    monkeypatch.setattr(remedies, "LONGER", 1e6 if slow else 0.0)
    remedy = mended(bend(4.0))
    assert remedy.changes == {"pattern.flap": 0.0}
    assert make_shell(bend(0.0)).report.feasible


@pytest.mark.slow
def test_brute_force_agrees_that_the_widest_flaps_meet_nothing() -> None:
    widest = float(str(mended(bend(4.0)).changes["pattern.flap"]))
    narrow, wide = (designed(bend(share * widest)).mechanism for share in (1, 1.02))
    counts = not_designed(narrow.grid)
    drives = np.linspace(0, 0.9999 * np.pi, 150)
    assert not any(crosses(narrow, float(drive), counts) for drive in drives)
    assert any(crosses(wide, float(drive), counts) for drive in drives)


def test_flaps_of_no_given_width_are_as_wide_as_is_useful() -> None:
    # The mean crease of column 1, unless it meets something.
    asked = bend("auto", 9, 24)
    design, lock = ended(asked, designed(asked), Work())
    assert lock.cause == "flaps"
    assert design.parameters["flap"] == designed(asked).parameters["flap"]


def test_flaps_of_no_given_width_are_narrowed_until_they_meet_nothing() -> None:
    # Ends of a bend so near that flaps of useful width would meet.
    asked = asked_for(
        formula("-0.3*x**2", -0.7, 0.7),
        formula(["1.6*cos(t)", "1.6*sin(t)"], 0, 5.5),
        "auto",
        rows=3,
        columns=16,
        xi_deg=100,
        flap_side="start",
    )
    useful = designed(asked)
    assert find_lock(useful).early
    design, lock = ended(asked, useful, Work())
    assert lock.cause == "flaps"
    width, most = design.parameters["flap"], useful.parameters["flap"]
    assert isinstance(width, float)
    assert isinstance(most, float)
    assert 0 < width < most
    assert not works(asked.changed({"pattern.flap": 1.01 * width}))


@thorough
@pytest.mark.parametrize(
    ("g", "key"),
    [
        (formula(["(2+0.25*t)*cos(t)", "(2+0.25*t)*sin(t)"], 0, 9), "target.f.scale"),
        (formula(["4*cos(t)", "4*sin(t)"], 0, 2 * np.pi), "target.g.range"),
    ],
)
def test_other_remedies_work_too(g: Tables, key: str) -> None:
    asked = asked_for(formula("-0.9*x**2", -1, 1), g, 0.3, rows=5, columns=40, xi_deg=50)
    assert "degrees" in refusal(asked).place
    remedy = mended(asked)
    assert list(remedy.changes) == [key]
    changed = asked.changed(remedy.changes)
    _, lock = ended(changed, designed(changed), Work())
    assert lock.cause == "flaps"
    value = remedy.changes[key]
    assert isinstance(value, float | list)
    farther = (
        1.05 * value
        if isinstance(value, float)
        else [0.0, min(1.05 * float(str(value[1])), asked.g.stop)]
    )
    assert not works(asked.changed({key: farther}))


def test_a_clash_can_be_allowed() -> None:
    asked = bend(4.0)
    design, lock = ended(asked, designed(asked), Work(clash="allowed"))
    assert lock.early
    assert design.parameters["flap"] == 4.0
