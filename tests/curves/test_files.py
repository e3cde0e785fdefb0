"""Points from text files."""

from pathlib import Path

import numpy as np
import pytest

from orishell.conventions.errors import InputError
from orishell.curves import read_points


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
    "text",
    [
        "sep=;\r\nx;y\r\n0;0\r\n0,5;0,75\r\n1;1\r\n",  # as Excel begins a file for any country
        '"sep=|"\nx|y\n0|0\n0.5|0.75\n1|1\n',
        "x;y;\n0;0;\n;;\n0,5;0,75;\n1;1;\n;;\n",  # rows that were emptied
        "Nr;x;y\n1;0;0\n2;0,5;0,75\n3;1;1\n",
        "Punkt;Rechts;Hoch\n1;0;0\n2;0,5;0,75\n3;1;1\n",
        "A1 0 0 edge\nA2 0.5 0.75 crown\nA3 1 1 edge\n",
        "X,Y,Z\n0,0.0,0\n0.5,0.0,0.75\n1,0.0,1\n",  # a section, drawn upright
        "y,z,x\n0,0,7\n0.5,0.75,7\n1,1,7\n",
        "7,0,0\n7,0.5,0.75\n7,1,1\n",
        "id,z,weight,x\n1,0,8,0\n2,0.75,9,0.5\n3,1,7,1\n",
        '"0","0"\n"0,5","0,75"\n"1","1"\n',  # as Google Sheets writes decimal commas
        'x,y\n"0,0","0,0"\n"0,5","0,75"\n"1,0","1,0"\n',
        "{0, 0, 0}\n{0.5, 0, 0.75}\n{1, 0, 1}\n",  # a panel of Grasshopper
        "Count,Name,Position X,Position Y,Position Z\n"  # as AutoCAD extracts data
        "1,Point,0,0,0\n1,Point,0.5,0,0.75\n1,Point,1,0,1\n",
    ],
)
def test_the_columns_that_are_meant_are_taken(tmp_path: Path, text: str) -> None:
    path = tmp_path / "points.csv"
    for encoding in ("utf-8", "utf-8-sig", "utf-16", "cp1252"):
        path.write_text(text, encoding=encoding, newline="")
        np.testing.assert_array_equal(read_points(path), [[0, 0], [0.5, 0.75], [1, 1]])


def test_a_straight_line_has_two_columns(tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    for varying, expected in enumerate(([1, 0], [0, 1], [0, 1])):
        path.write_text(f"x,y,z\n0,0,0\n{','.join('1' if k == varying else '0' for k in range(3))}")
        assert read_points(path).tolist() == [[0, 0], expected]


def test_a_header_of_windows_states_its_unit(tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    path.write_bytes("Länge (m);Höhe (m)\r\n0;0\r\n0,5;0,75\r\n".encode("cp1252"))
    np.testing.assert_allclose(read_points(path, into="mm"), [[0, 0], [500, 750]])


@pytest.mark.parametrize(
    ("text", "remedy"),
    [
        ("0,5,0,75\n0,6,0,80\n0,7,0,90\n", "separate columns by semicolons"),
        ("0,0\n0,5,0,75\n1,1\n", "separate columns by semicolons"),
        ("0,0\n0,5,2\n1,1\n", "separate columns by semicolons"),
        ("x;y\n0;0\n1.234,5;2\n", "nothing between their thousands"),
        ("x;y\n0;0\n1 234,5;2\n", "nothing between their thousands"),
        ("x,y\n0,0\nend of part 1\n1,1\n", "begin it with #"),
        ("x,y\nmm,mm\n0,0\n1,1\n", "begin it with #"),
        ("1,2,3,4.5\n2,3,4,5.5\n", "call two columns x and y"),
    ],
)
def test_what_would_be_mistaken_is_refused_with_what_to_write(
    tmp_path: Path, text: str, remedy: str
) -> None:
    """Numbers with decimal commas between commas are never taken for others."""
    path = tmp_path / "points.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_points(path)
    assert remedy in caught.value.remedy


@pytest.mark.parametrize("text", ["1,0,0\n2,0.5,0.75\n3,1,1\n", "x,y,z\n0,0,0\n1,2,3\n2,3,1\n"])
def test_columns_that_nobody_knows_are_asked_for(tmp_path: Path, text: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(text)
    with pytest.raises(InputError, match="call two columns x and y in a first line") as refused:
        read_points(path)
    assert "which columns are x and y" in str(refused.value)
    body = text.removeprefix("x,y,z\n")
    path.write_text(f"a,x,y\n{body}")
    assert read_points(path).shape == (3, 2)


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


METRES = [[0.0, 0.0], [0.001, 0.0025], [0.003, 0.004]]


@pytest.mark.parametrize(
    "text",
    [
        "x [mm], y [mm]\n0,0\n1,2.5\n3,4\n",
        "x_mm;y_mm\n0;0\n1;2,5\n3;4\n",
        "x (mm)\ty (mm)\n0\t0\n1,0\t2,5\n3\t4\n",
        '"X in mm";"Y in mm";"note"\n0;0;a\n1;2,5;b\n3;4;c\n',
        "station/millimetres,height\n0,0\n1,2.5\n3,4\n",
        "x_cm y_cm\n0 0\n0.1 0.25\n0.3 0.4\n",
        "x [inches],y [inches]\n0,0\n0.03937007874015748,0.0984251968503937\n"
        "0.11811023622047244,0.15748031496062992\n",
    ],
)
def test_units_that_the_header_states(tmp_path: Path, text: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(text, encoding="utf-8")
    np.testing.assert_allclose(read_points(path, into="m"), METRES, rtol=1e-14)
    # The key unit overrides the header.
    assert read_points(path, into="m", unit="m")[2, 0] == pytest.approx(read_points(path)[2, 0])


@pytest.mark.parametrize("header", ["", "x,y\n", "east,north\n", "x (to the right),y (up)\n"])
def test_without_a_unit_the_numbers_are_taken_as_they_are(tmp_path: Path, header: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(header + "0,0\n1,2\n")
    assert read_points(path, into="ft")[1].tolist() == [1, 2]
    assert read_points(path, into="mm", unit="cm")[1].tolist() == [10, 20]


@pytest.mark.parametrize(
    ("header", "says"),
    [("x [mm],y [cm]", "different units"), ("x [yd],y [yd]", "unit that is not known")],
)
def test_headers_that_make_no_sense(tmp_path: Path, header: str, says: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(f"# points\n{header}\n0,0\n1,2\n")
    with pytest.raises(InputError, match=rf"points\.csv line 2: .*{says}"):
        read_points(path, into="m")
    assert read_points(path, into="m", unit="cm")[1] == pytest.approx([0.01, 0.02])


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("0,5 1,2\n1,5 1,7\n", r"line 1: this line is not a point.*semicolons"),
        ("x,y\n0,5,1,2\n1,5,1,7\n", r"line 2: .* twice as many columns .*semicolons"),
    ],
)
def test_decimal_commas_between_commas(tmp_path: Path, text: str, says: str) -> None:
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
    for content in (b"PK\x03\x04\x14\x00", b"\xff\xfe\x00", b"x;y\n0;\x81\n"):
        binary.write_bytes(content)
        with pytest.raises(
            InputError, match=r"cannot be read.*Remedy: save the table as CSV UTF-8"
        ):
            read_points(binary)


def test_the_largest_numbers_do_not_overflow(tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    path.write_text("1e308,5,1e308\n-1e308,5,-1e308\n")
    assert read_points(path).tolist() == [[1e308, 1e308], [-1e308, -1e308]]
