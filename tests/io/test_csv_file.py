"""Tables that a spreadsheet may open without computing what stands in them."""

import csv
from pathlib import Path

from orishell.io.formats.tables import write_csv


def test_texts_that_are_formulas_have_a_quote_and_numbers_have_none(tmp_path: Path) -> None:
    hostile = ["=1+1", "+SUM(A1)", "-2+3", "@x", "\t=1", "\n=1", '=HYPERLINK("a","b")', "-"]
    fine = ["-2.5", "+3e-7", "-1e+300", "-inf", "a=b", "0,-1T", "", "é€", "'=1", '["=1"]']
    numbers = [-2.5, -3, 1e-9]
    path = tmp_path / "a.csv"
    write_csv(path, ["=head", "b"], [hostile, fine, numbers])
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    write_csv(tmp_path / "b.csv", ["\r=1"], [["a\rb"]])
    assert (tmp_path / "b.csv").read_text(encoding="utf-8") == " =1\na b\n"
    assert rows == [
        ["'=head", "b"],
        [f"'{cell}" for cell in hostile],
        fine,
        [repr(number) for number in numbers],
    ]
