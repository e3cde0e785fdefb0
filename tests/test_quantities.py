"""Lengths, areas and mass against sums over panels, one by one."""

from dataclasses import replace

import pytest

from documents import FAMILIES, demo_document
from orishell.quantities import describe_quantities, measure_quantities
from orishell.workshop import Workshop


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
    creases = found.mountain + found.valley + found.unfolded
    assert 2 * creases + found.outline == pytest.approx(perimeter, rel=1e-12)
    assert found.waste.cut_length == pytest.approx(found.outline, rel=1e-9)


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
    waste = describe_quantities(found)["stock"]
    assert waste["sheets"] >= 2
    assert waste["stock_area"] == pytest.approx(80.0 * waste["sheets"])
    assert waste["used_area"] > found.area  # with tabs
    assert waste["waste"] == pytest.approx(1 - waste["used_area"] / waste["stock_area"])
