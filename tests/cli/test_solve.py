"""``orishell solve`` as a user meets it."""

import json

import pytest

from command_line import orishell, orishell_process


def test_the_papers_angles() -> None:
    done = orishell_process("solve", "85", "80", "95", "100")
    assert done.returncode == 0
    lines = done.stdout.splitlines()
    assert lines[0] == (
        "solution 0 (cosine version): alpha_2 = 91.2289, beta_2 = 86.2289, "
        "gamma_2 = 106.2289, delta_2 = 76.2289"
    )
    assert "c = 0.169947530529" in lines[1]
    assert "v_1 from 0 to 119.7471 degrees" in lines[1]
    assert "35 x 35" in lines[1]
    assert lines[2].startswith("solution 1 (sine version): alpha_2 = 179.9118")


def test_json() -> None:
    found = json.loads(orishell("solve", "85", "80", "95", "100", "--json").stdout)
    assert found["sector_deg"] == [85, 80, 95, 100]
    assert found["searched_up_to"] == 60
    first = found["solutions"][0]
    assert first["c"] == pytest.approx(0.169947530529, abs=1e-12)
    assert first["largest_square"] == 35


def test_near_90_degrees_the_search_has_an_end() -> None:
    assert "60 x 60 or more" in orishell("solve", "89.95", "89.9", "90.05", "90.1").stdout


@pytest.mark.parametrize(
    ("angles", "status", "says"),
    [
        (("70", "80", "100", "75"), 1, "Nearest found that works: sector_deg = [70, 80, 100, 7"),
        (("200", "80", "95", "100"), 2, "alpha is out of range"),
        (("85", "80", "95", "nan"), 2, "delta is out of range"),
        (("85", "80", "95"), 2, "Missing argument"),
        (("85", "80", "95", "x"), 2, "Invalid value"),
    ],
)
def test_faults(angles: tuple[str, ...], status: int, says: str) -> None:
    done = orishell("solve", *angles)
    assert done.returncode == status
    assert says in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
