"""Numbers and quantities as pages show them."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from orishell.conventions.quantities import Quantities, area, box, figure, plain, quantity, size

RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@given(st.floats(-1e30, 1e30), st.integers(1, 6))
def test_a_plain_number_is_read_as_it_was_rounded(value: float, digits: int) -> None:
    text = plain(value, digits)
    assert math.isclose(float(text), float(f"{value:.{digits}g}"), rel_tol=1e-12)
    assert "e+" not in text
    assert ("e" in text) == (value != 0 and not 1e-4 <= abs(float(text)) < 1e7)


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (1537.2, 3, "1540"),
        (139_219.4, 4, "139200"),
        (124.0, 2, "120"),
        (-0.25, 4, "-0.25"),
        (-1e-300 * 1e-300, 4, "0"),
        (2.7e8, 4, "2.7e8"),
        (5e-16, 3, "5e-16"),
        (math.inf, 4, "inf"),
        (math.nan, 4, "nan"),
    ],
)
def test_how_plain_numbers_look(value: float, digits: int, text: str) -> None:
    assert plain(value, digits) == text


def read(text: str) -> float:
    plain = text.replace("\u202f", "").replace("\u2212", "-").translate(RAISED)
    return float(plain.replace("\u00b710", "e"))


@given(st.floats(-1e30, 1e30), st.integers(2, 6))
def test_a_number_is_read_as_it_was_rounded(value: float, digits: int) -> None:
    assert math.isclose(read(figure(value, digits)), float(f"{value:.{digits}g}"), rel_tol=1e-12)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (1.0, "1"),
        (-0.25, "\u22120.25"),
        (1234.56, "1235"),
        (12345.6, "12\u202f350"),
        (2.5e6, "2\u202f500\u202f000"),
        (0.00012344, "0.0001234"),
        (1.5e-12, "1.5\u00b710⁻¹²"),
        (2.7e8, "2.7\u00b710⁸"),
        (9.99999e6, "1\u00b710⁷"),
    ],
)
def test_how_numbers_look(value: float, text: str) -> None:
    assert figure(value) == text


def test_a_unit_stays_with_its_number() -> None:
    assert quantity(3.0, "kg") == "3\u00a0kg"


@pytest.mark.parametrize(("unit", "metres"), [("mm", 1e-3), ("m", 1.0), ("in", 0.0254)])
def test_quantities_mean_the_same_in_every_unit(unit: str, metres: float) -> None:
    """A panel of 10 mm with E = 210 GPa under 1 kPa, in newtons and the unit."""
    said = Quantities(unit)
    assert said.stress(210e9 * metres**2) == "210\u202f000\u00a0MPa"
    assert said.pressure(1e3 * metres**2) == "1\u00a0kN/m²"
    assert said.per_length(2.1e9 * metres) == "2\u202f100\u202f000\u00a0kN/m"
    assert said.bending(17500 / metres) == "17\u202f500\u00a0N m"
    assert said.moment(5.0) == "5\u00a0N m/m"
    if unit != "in":
        assert said.displacement(0.01 / metres) == "10\u00a0mm"
    else:
        assert said.displacement(1.0) == "1\u00a0in"
    assert said.length(2.5) == f"2.5\u00a0{unit}"


@pytest.mark.parametrize(
    ("said", "text"),
    [
        (size(4.6218, "m"), "4.62 m"),
        (size(0.1, "m"), "0.1 m"),
        (size(0.0999, "m"), "99.9 mm"),
        (size(-0.012345, "m"), "-12.3 mm"),
        (size(1.2e-8, "m"), "less than 0.001 mm"),
        (size(0.0, "m"), "0 m"),
        (size(0.5, "cm"), "5 mm"),
        (size(0.05, "ft"), "0.6 in"),
        (size(0.05, "in"), "0.05 in"),
        (size(0.00012, "mm"), "less than 0.001 mm"),
        (size(391.27, "mm"), "391 mm"),
        (size(0.1331, "m", bound=True), "0.134 m"),
        (size(0.134, "m", bound=True), "0.134 m"),
        (size(9.991, "m", bound=True), "10 m"),
        (size(0.0123, "m", bound=True), "12.3 mm"),
        (area(43.541, "m"), "43.5 m2"),
        (area(139_200, "mm"), "0.139 m2"),
        (area(0.002, "m"), "20 cm2"),
        (area(12.0, "mm"), "12 mm2"),
        (area(3.25, "ft"), "3.25 ft2"),
        (area(0.0, "m"), "0 m2"),
        (box((6.0, 3.3137, 0.05), "m"), "6 x 3.31 x 0.05 m"),
    ],
)
def test_sizes_are_said_in_the_unit_that_suits_them(said: str, text: str) -> None:
    assert said == text
