"""Lengths, areas and mass against sums over panels, one by one."""

from dataclasses import asdict, astuple, replace

import pytest

from documents import FAMILIES, demo_document
from orishell.conventions.errors import InputError
from orishell.workshop import Workshop
from orishell.workshop.quantities import measure_quantities


@pytest.mark.parametrize("family", FAMILIES)
def test_panels_and_creases_one_by_one(family: str) -> None:
    document = demo_document(family)
    assert document.flat is not None
    found = measure_quantities(document, Workshop())
    area = perimeter = 0.0
    for face in document.mesh.faces.tolist():
        corners = [document.flat[vertex].tolist() for vertex in face]
        for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1], strict=True):
            area += (x * v - u * y) / 2
            perimeter += ((x - u) ** 2 + (y - v) ** 2) ** 0.5
    assert found.panels == len(document.mesh.faces)
    assert found.area == pytest.approx(area, rel=1e-12)
    # Every crease is a side of two panels, every edge of the outline of one.
    creases = sum(astuple(found.crease_length))
    assert 2 * creases + found.outline_length == pytest.approx(perimeter, rel=1e-12)
    assert found.stock is not None
    assert found.stock.cut_length == pytest.approx(found.outline_length, rel=1e-9)


def test_mass_and_unit() -> None:
    document = demo_document()
    metres = measure_quantities(document, Workshop(areal_density=1.4))
    assert metres.mass_kg == pytest.approx(1.4 * metres.area)
    feet = measure_quantities(replace(document, unit="ft"), Workshop(areal_density=1.4))
    assert feet.mass_kg == pytest.approx(1.4 * metres.area * 0.3048**2)
    assert measure_quantities(document, Workshop()).mass_kg is None


def test_stock_is_at_least_as_large_as_what_is_cut_from_it() -> None:
    document = demo_document()
    found = measure_quantities(document, Workshop(stock=(10.0, 8.0)))
    stock = found.stock
    assert stock is not None
    assert stock.sheets >= 2
    assert stock.stock_area == pytest.approx(80.0 * stock.sheets)
    assert stock.used_area > found.area  # with tabs
    assert stock.waste == pytest.approx(1 - stock.used_area / stock.stock_area)


def test_without_a_layout_all_but_the_stock_is_known() -> None:
    document, workshop = demo_document(), Workshop(stock=(10.0, 8.0), areal_density=1.4)
    known = measure_quantities(document, workshop, nested=False)
    laid = measure_quantities(document, workshop)
    (row,) = laid.order
    unlaid = replace(row, count=None, least=None, size=(), used=known.area, waste=None)
    unlaid = replace(unlaid, what="sheets")
    assert asdict(known) == asdict(replace(laid, stock=None, order=(unlaid,)))
    for impossible in (Workshop(stock=(1.0, 1.0)), Workshop(stock=(10.0, 6.0), margin=3.0)):
        with pytest.raises(InputError, match="stock"):
            measure_quantities(document, impossible, nested=False)
