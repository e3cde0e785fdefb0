"""Points from text files."""

from pathlib import Path

import numpy as np
import pytest

from orishell.curves import read_points
from orishell.errors import InputError


@pytest.mark.parametrize(
    "text",
    [
        "0,0\n1,2\n3,4.5\n",
        "x,y\n0,0\n1,2\n3,4.5\n",
        "x;y\n0;0\n1;2\n3;4.5\n",
        "# profile\n\n0\t0\n1\t2\n3\t4.5",
        "0 0\n1  2\n 3 4.5 \n",
        '"0","0"\r\n"1","2"\r\n"3","4.5"\r\n',
        "\ufeffx,y,z\n0,0,9\n1,2,9\n3,4.5,9\n",
    ],
)
def test_reads_the_usual_spellings(tmp_path: Path, text: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(text, encoding="utf-8", newline="")
    np.testing.assert_array_equal(read_points(path), [[0, 0], [1, 2], [3, 4.5]])


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "too few points"),
        ("x,y\n", "too few points"),
        ("1,2\n", "too few points"),
        ("0,0\n1,2\nthree,4\n", "line 3"),
        ("0,0\n1\n", "line 2"),
        ("0,0\n1,nan\n", "not finite"),
        ("0,0\ninf,1\n", "not finite"),
        ("a,b\nc,d\n1,2\n3,4\n", "line 2"),
        ("O.0,0\n1,2\n3,4\n", "line 1"),
        ("1,2\n" + "9" * 200_000 + ",1\n", "not finite"),
    ],
)
def test_refuses_what_is_not_points(tmp_path: Path, text: str, says: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=says):
        read_points(path)


def test_missing_and_unreadable_files(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        read_points(tmp_path / "none.csv")
    with pytest.raises(InputError, match="not a file"):
        read_points(tmp_path)
    with pytest.raises(InputError, match="not a file"):
        read_points(Path("/dev/zero"))
    with pytest.raises(InputError, match="cannot be read"):
        read_points(tmp_path / "a\0b.csv")
    binary = tmp_path / "binary.csv"
    binary.write_bytes(b"\xff\xfe\x00\x81")
    with pytest.raises(InputError, match="cannot be read"):
        read_points(binary)
