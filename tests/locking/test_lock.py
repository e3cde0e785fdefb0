"""How motions end: by flaps, by a clash, by a crease, or not at all."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brute_force import exact_contacts, first_crossing
from orishell.design import Design
from orishell.design_file import read_design_file
from orishell.families.longitudinal_linear_repeating import (
    LongitudinalPattern,
    RowKind,
    design_longitudinal_linear_repeating,
)
from orishell.locking import find_lock, lock_without_clash
from orishell.motion import corrugation_depth
from orishell.shell.designed import designed
from planted import PLANTED, ring
from samples import thorough
from strategies import graph

EXAMPLES = Path(__file__).parents[2] / "examples"


def example(figure: str) -> Design:
    file = read_design_file(EXAMPLES / f"{figure}.toml")
    return file.pattern.design(file.f, file.g)


@pytest.mark.parametrize("figure", ["figure1", "figure2"])
def test_the_paper_says_that_figures_1_and_2_lock_by_their_flaps(figure: str) -> None:
    # "The rigid folding motion halts at the final rigidly folded states due to clashing of
    # panels": the paper's introduction.
    lock = find_lock(example(figure))
    assert (lock.cause, lock.drive, lock.early, lock.touching_at_end) == ("flaps", np.pi, False, ())
    contact = lock.first_contact
    assert contact is not None
    assert (contact.kind, contact.panels) == ("flap on flap", ((0, 0), (1, 0)))
    assert contact.clear_until == pytest.approx(np.pi, rel=2e-6)
    assert lock.warnings == ()


@pytest.mark.parametrize("figure", ["figure1", "figure2", "figure3"])
def test_exact_predicates_see_nothing_before_the_figures_meet_their_targets(figure: str) -> None:
    mechanism = example(figure).mechanism
    for drive in np.linspace(0, 0.999 * mechanism.target_drive, 41):
        pairs = exact_contacts(mechanism.positions(drive), mechanism.grid.faces_vertices())
        assert not len(pairs), f"at drive {drive}"


def test_figure_3_meets_its_target_and_then_rolls_up_until_its_rims_meet() -> None:
    design = example("figure3")
    lock = find_lock(design)
    assert lock.cause == "clash"
    assert not lock.early
    assert lock.target_drive == design.mechanism.target_drive
    assert lock.drive is not None
    assert lock.drive > 2 * lock.target_drive
    assert lock.first_contact is not None
    (above, _), (below, _) = lock.first_contact.panels
    assert (above, below) == (0, design.mechanism.grid.rows - 2)
    expected = first_crossing(design.mechanism, 0.12, 200)
    assert expected == pytest.approx(lock.drive, abs=1e-6)


def test_a_path_that_was_not_examined_is_not_said_to_be_clear() -> None:
    contact = lock_without_clash(example("figure1")).first_contact
    assert contact is not None
    assert contact.clear_until == 0


@pytest.mark.parametrize(("first_row", "columns"), [("F", 2), ("F", 3), ("S", 4)])
def test_a_longitudinal_sheet_has_no_flaps(first_row: RowKind, columns: int) -> None:
    # With one row the creases at its sides can reach pi together: all creases of an F row do.
    design = design_longitudinal_linear_repeating(
        graph("-0.3*x**2", -1, 1),
        graph("0*x", 0, 1),
        LongitudinalPattern(
            rows=1, columns=columns, first_row=first_row, sector_deg=[85, 80, 95, 100]
        ),
    )
    assert lock_without_clash(design).cause == "crease"
    contact = find_lock(design).first_contact
    assert contact is not None
    assert contact.kind in {"neighbours", "at the sheet's edge"}


def test_a_crease_folded_flat_ends_the_motion_where_nothing_clashes() -> None:
    # Known: for the paper's angles an S row's crease reaches pi at v_1 = 119.747 degrees.
    lock = lock_without_clash(example("figure3"))
    assert lock.cause == "crease"
    assert lock.drive == pytest.approx(np.deg2rad(119.747), abs=1e-5)
    assert lock.first_contact is not None
    assert lock.first_contact.kind == "neighbours"


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("spiral", "flap on panel"),
        ("ring", "opposite flaps"),
        ("waist", "at the sheet's edge"),
        pytest.param("wide flaps", "opposite flaps", marks=thorough),
        pytest.param("deep", "opposite flaps", marks=thorough),
    ],
)
def test_kinds_of_planted_clashes(name: str, kind: str) -> None:
    design = PLANTED[name]()
    lock = find_lock(design)
    contact = lock.first_contact
    assert contact is not None
    assert (lock.early, contact.kind) == (True, kind)
    depth = corrugation_depth(design.mechanism.positions(contact.drive))
    assert contact.corrugation_depth == pytest.approx(depth)
    (warning,) = lock.warnings
    assert str(list(contact.panels[0])) in warning


def test_flaps_only_leaves_other_contacts_out() -> None:
    assert find_lock(PLANTED["waist"](), flaps_only=True).cause == "flaps"
    assert find_lock(PLANTED["wide flaps"](), flaps_only=True).early


def test_a_wider_tolerance_touches_earlier_by_the_time_that_it_takes() -> None:
    design = PLANTED["waist"]()
    drives = [find_lock(design, tolerance=tolerance).drive for tolerance in (1e-12, 1e-6, 1e-4)]
    assert all(drive is not None for drive in drives)
    exact, wide, wider = (float(drive or 0) for drive in drives)
    assert exact > wide > wider
    # Distance shrinks smoothly, so the lead grows with the tolerance.
    assert (exact - wider) / (exact - wide) == pytest.approx(100, rel=0.1)


def test_panels_that_meet_at_the_target_unasked_are_named() -> None:
    # A closed circle without flaps: the last column of the shell comes to lie on the first, slowly,
    # so that it is within the tolerance a little earlier; exact predicates see no crossing. It
    # could close further but for that: one column is in the other's way.
    design = ring(flap=0.0)
    mechanism = design.mechanism
    lock = find_lock(design)
    assert (lock.cause, lock.early) == ("clash", False)
    assert lock.drive == lock.target_drive == mechanism.target_drive < mechanism.end_drive
    assert lock.first_contact is not None
    assert lock.first_contact.drive == lock.target_drive
    assert lock.first_contact.clear_until == pytest.approx(lock.target_drive, rel=2e-6)
    assert lock.touching_at_end
    last = mechanism.grid.columns - 2
    assert all({a[1], b[1]} == {0, last} for a, b in lock.touching_at_end)
    (warning,) = lock.warnings
    assert "touch at the target" in warning
    faces = mechanism.grid.faces_vertices()
    for drive in np.linspace(0, lock.target_drive * (1 - 1e-6), 30):
        assert not len(exact_contacts(mechanism.positions(drive), faces))
    assert len(exact_contacts(mechanism.positions(lock.target_drive * (1 + 1e-4)), faces))


@pytest.mark.parametrize("figure", ["figure1", "figure2", "figure3", "sectors"])
def test_no_crease_is_folded_flat_before_the_end(figure: str) -> None:
    # The proof of the path leaves panels that share a vertex to this (theory/locking-and-clash).
    file = read_design_file(EXAMPLES / f"{figure}.toml")
    design = designed(file)
    mechanism = design.mechanism
    drives = np.append(np.linspace(0, 0.999, 200), 1 - 1e-6) * mechanism.end_drive
    angles = mechanism.fold_angles(drives)
    assert max(np.abs(angles.row).max(), np.abs(angles.column).max()) < np.pi
    assert np.abs(mechanism.fold_angles(mechanism.end_drive).row).max() == pytest.approx(np.pi)
