"""What to order: masses are those of the report, counts and waste those of the layouts."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from boarded import BUILDS, boarded_document
from design_tables import Tables, formula, tables
from documents import EXAMPLES, demo_document
from orishell.conventions.errors import InputError
from orishell.conventions.quantities import GRAVITY
from orishell.design_file import check_design, read_design_file
from orishell.document import Document
from orishell.io.format import Settings
from orishell.io.formats.tables import write_tables
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import STEPS
from orishell.workshop import Workshop
from orishell.workshop.board_sheets import nest_boards
from orishell.workshop.fitting import OversizeError
from orishell.workshop.layout import lay_out, require_stock
from orishell.workshop.order import find_order
from orishell.workshop.order_row import OrderRow
from orishell.workshop.quantities import measure_quantities
from samples import led_by

SHELLS = [
    ("shelter.toml", {}),
    ("shelter_hinged.toml", {}),
    ("shelter_boards.toml", {}),
    ("figure1_card.toml", {}),
    ("dome.toml", {"panel.density": 680, "panel.membrane_density": 900}),
    ("dome_locked.toml", {"panel.density": 680, "panel.membrane_density": 900}),
]


def shell_of(name: str, changes: dict[str, object]) -> Shell:
    file = read_design_file(EXAMPLES / name).changed(changes)
    return make_shell(file, clash="unexamined", skip=STEPS)


def by_item(document: Document, workshop: Workshop) -> dict[str, OrderRow]:
    return {row.item: row for row in find_order(document, workshop)}


@pytest.mark.parametrize(("name", "changes"), led_by(SHELLS, 2))
def test_masses_of_the_order_are_the_mass_of_the_report(
    name: str, changes: dict[str, object]
) -> None:
    """Both add up boards, membrane, arms and hinges, in another order: 1e-12 is rounding."""
    found = shell_of(name, changes).report.quantities
    total = found.mass_kg if found.built is None else found.built.mass_kg.total
    assert total is not None
    assert sum(row.mass_kg or 0.0 for row in found.order) == pytest.approx(total, rel=1e-12)


PANELS: list[Tables] = [
    {"construction": "bevel", "thickness": 0.01, "gap": 0.002, "density": 500},
    {"thickness": 0.01, "membrane": 0.001, "density": 500, "membrane_density": 900},
    {"construction": "hinged", "thickness": 0.006, "gap": 0.002, "density": 500},
    {},
]


@pytest.mark.parametrize("panel", led_by(PANELS, 2))
def test_hinges_and_ties_weigh_by_their_length(panel: Tables) -> None:
    """Lengths from the rows of the order; what folds weighs the sum of all rows but ties.

    Weight is density times area of a sheet whose ties lie on the ground: to rounding.
    """
    whole = panel.get("construction") == "hinged"
    design = tables(
        "parallel-repeating",
        formula("-x**2", -1, 1),
        formula("0.3*sin(pi*x/2)", 0, 3),
        **{"rows": 5, "columns": 5, "flap": 0, **({"plane": "bisector"} if whole else {})},
    )
    workshop: Tables = {"tie_linear_density": 0.5, "tie_end": 0.1}
    if whole:
        panel = {**panel, "hinge": {"linear_density": 0.4}, "arm_density": 2700}
    else:
        workshop |= {"hinge_linear_density": 0.4, "row_hinge": "piano hinge"}
    workshop |= {} if panel else {"areal_density": 5.0}
    design |= {"deployment": {"from": "pack", "ties": "feet"}, "workshop": workshop}
    design["motion"] = {"frames": 3}
    design |= {"panel": panel} if panel else {}
    shell = make_shell(
        check_design(design, Path("shell.toml")),
        clash="unexamined",
        skip=[step for step in STEPS if step != "weight"],
    )
    found = shell.report.quantities
    rows = {row.item: row for row in found.order}
    assert rows["ties"].mass_kg == pytest.approx(0.5 * rows["ties"].used)
    hinges = [rows[item] for item in ("hinges", "piano hinges") if item in rows]
    assert hinges
    assert all(row.mass_kg == pytest.approx(0.4 * row.used) for row in hinges)
    total = found.mass_kg if found.built is None else found.built.mass_kg.total
    masses = {item: row.mass_kg or 0.0 for item, row in rows.items()}
    assert sum(masses.values()) == pytest.approx(total, rel=1e-12)
    weight = shell.report.deployment.weight
    assert weight is not None
    folding = sum(masses.values()) - masses["ties"]
    assert weight.total == pytest.approx(GRAVITY * folding, rel=1e-9)


def test_hinges_and_ties_that_nobody_weighs_have_no_mass() -> None:
    """Null, not 0; a membrane alone has no hinges, and their mass is 0."""
    for build in BUILDS:
        found = measure_quantities(boarded_document(build), Workshop()).built
        assert found is not None
        assert found.mass_kg.hinges == (None if build == "bevel" else 0.0)
        assert found.mass_kg.ties == 0.0


@pytest.mark.parametrize("construction", BUILDS)
def test_counts_and_waste_are_those_of_the_layouts(construction: str) -> None:
    """Sheets of stock by the nests themselves; what is not used is the rest of their area."""
    document = boarded_document(construction, clipped=True)
    workshop = Workshop(stock=(300.0, 200.0), spacing=2.0, stock_price=3.0)
    boards = by_item(document, workshop)["boards"]
    nest = nest_boards(document, workshop)
    assert boards.count == 1 + max(each.sheet for each in nest)
    assert boards.waste == pytest.approx(1 - boards.used / (boards.count * 300 * 200))
    assert boards.least is not None
    assert boards.used / 60_000 <= boards.least <= boards.count
    assert boards.price == 3.0 * boards.count


def test_a_membrane_is_cut_from_its_roll_and_boards_from_stock() -> None:
    document = boarded_document("sandwich")
    workshop = Workshop(stock=(300.0, 200.0), roll=(150.0, 2000.0), roll_price=9.0)
    found = by_item(document, workshop)
    membrane, boards = found["membrane"], found["boards"]
    layout = lay_out(document, workshop)
    assert (membrane.size, membrane.count) == ((150.0, 2000.0), layout.sheets)
    assert membrane.price == 9.0 * layout.sheets
    assert boards.size == (300.0, 200.0)
    for part, placed in zip(layout.parts, layout.placements or (), strict=True):
        low, high = (
            getattr(placed.move(np.concatenate(part.outlines)), name)(axis=0)
            for name in ("min", "max")
        )
        assert (low >= -1e-6).all()
        assert (high <= np.array([150.0, 2000.0]) + 1e-6).all()


def test_what_is_not_known_is_empty() -> None:
    """No density, no stock, no price: nothing of them is 0, in the order nor in its table."""
    document = boarded_document("bevel")
    assert document.panel is not None
    for row in find_order(document, Workshop()):
        assert (row.count, row.waste, row.price, row.size, row.least) == (
            None,
            None,
            None,
            (),
            None,
        )
    (sheet,) = find_order(demo_document(), Workshop())
    assert (sheet.item, sheet.mass_kg) == ("sheet", None)


def test_order_csv_has_the_rows_of_the_report(tmp_path: Path) -> None:
    document = boarded_document("sandwich")
    workshop = Workshop(stock=(300.0, 200.0), row_hinge="piano hinge", hinge_stock=300.0)
    write_tables(tmp_path / "panels.csv", document, Settings(workshop=workshop))
    rows = list(csv.DictReader((tmp_path / "order.csv").read_text().splitlines()))
    said = measure_quantities(document, workshop).order
    assert [row["item"] for row in rows] == [row.item for row in said]
    assert [row["item"] for row in rows] == ["boards", "membrane", "piano hinges"]
    for row, of in zip(rows, said, strict=True):
        assert float(row["used"]) == of.used
        assert row["mass_kg"] == ("" if of.mass_kg is None else repr(of.mass_kg))
        assert int(row["count"]) == of.count
        assert row["price"] == ""


def test_a_roll_that_is_too_narrow_is_offered_wider_and_as_long_as_it_is() -> None:
    """The refusal names the panels; the roll that it offers is enough, and one narrower is not."""
    document = boarded_document("sandwich")
    narrow = Workshop(stock=(300.0, 200.0), roll=(12.0, 2000.0), margin=1.0)
    with pytest.raises(OversizeError, match=r"panels do not fit the roll: 0,0; ") as refused:
        require_stock(document, narrow)
    width, length = refused.value.needed["workshop.roll"]
    assert length == 2000.0
    assert f"at least {width:g} x 2000" in str(refused.value)
    assert lay_out(document, narrow.replace_unchecked(roll=(width, length))).sheets >= 1
    with pytest.raises(OversizeError):
        require_stock(document, narrow.replace_unchecked(roll=(0.98 * width, length)))
    turned = narrow.replace_unchecked(roll=(2000.0, 12.0))
    with pytest.raises(OversizeError) as refused:
        require_stock(document, turned)
    assert refused.value.needed == {"workshop.roll": (length, width)}


def test_hinges_of_whole_boards_have_one_density() -> None:
    """That in [panel.hinge]: another one is refused, and says where to write it."""
    design = tables(
        "parallel-repeating", formula("-x**2", -1, 1), formula("0*x", 0, 3), rows=3, columns=3
    )
    design |= {"panel": PANELS[2], "workshop": {"hinge_linear_density": 0.4}}
    with pytest.raises(InputError, match=r"hinge_linear_density: .*in \[panel\.hinge\]"):
        check_design(design, Path("shell.toml"))
