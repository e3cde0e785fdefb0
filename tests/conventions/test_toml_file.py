"""TOML from anybody: read soon, or refused soon."""

from pathlib import Path

import pytest

from orishell.conventions.errors import InputError
from orishell.conventions.toml_file import DEEPEST, MAX_BYTES, parse_toml, read_toml


@pytest.mark.parametrize(
    "text",
    [
        # 150 s in Python 3.11, which takes the square of the length
        "a." * (MAX_BYTES // 2 - 1) + "b=1",
        "[" + "a . " * (MAX_BYTES // 4) + "b]",
        "x = {" + "'a'." * (MAX_BYTES // 5) + "b=1}",
        "a = " + "[" * MAX_BYTES,
        "a = " + "{a=" * (MAX_BYTES // 3),
        '# "\n' + '[["' + '".".' * 1000,
    ],
)
def test_what_nests_too_deeply_is_refused_before_it_is_parsed(text: str) -> None:
    with pytest.raises(InputError, match=r"nested too deeply, at line \d; expected at most"):
        parse_toml(text)


@pytest.mark.parametrize("quote", ['"', "'", '"""', "'''"])
def test_what_stands_in_texts_and_comments_does_not_nest(quote: str) -> None:
    words = "[{." * 100
    escaped = r"\"" + words if quote == '"' else words
    text = f"a = {quote}{escaped}{quote} # {words}\nb = 1"
    assert parse_toml(text) == {"a": escaped.replace("\\", ""), "b": 1}


@pytest.mark.parametrize(
    ("text", "remedy", "shown"),
    [
        ("a = 1\nb = 2,5", "numbers have a decimal point: write 2.5", "b = 2,5"),
        ("b = -2,5 # half", "numbers have a decimal point: write -2.5", "b = -2,5 # half"),
        ("unit = mm", 'put texts in quotes: "mm"', "unit = mm"),
        ("a = [1, 2", "a bracket or a quote is opened and never closed", None),
        ("a b = 1", "a key is one word: a_b = 1", "a b = 1"),
        ("a b c", "", "a b c"),
        ("x = \x07" + " " * 10**6, "", None),
    ],
)
def test_what_is_no_toml_is_shown(text: str, remedy: str, shown: str | None) -> None:
    with pytest.raises(InputError, match="this is not TOML") as caught:
        parse_toml(text)
    assert caught.value.remedy == remedy
    assert caught.value.detail.isprintable() or caught.value.detail.count("\n") == 1
    assert len(caught.value.detail) < 250
    if shown is not None:
        assert caught.value.detail.splitlines()[0].strip() == shown


@pytest.mark.parametrize(
    ("line", "remedy"),
    [
        ("rows: 5", "write rows = 5"),
        ("rows := 5", "write rows = 5"),
        ("rows 5", "write rows = 5"),
        ("reverse = Yes", "write true"),
        ("flap = .3", "write 0.3"),
        ("flap =", "a value is missing: write it behind flap ="),
        ("xi_deg = 50\u00b0", "write 50, without a unit"),
        ("width = 30 cm", "write 0.3, without a unit: lengths are in m"),
        ("range = -1..1", "lists have square brackets, and commas between entries: [-1, 1]"),
        ("range = [-1 1]", "lists have square brackets, and commas between entries: [-1, 1]"),
        ("range = (-1,1)", "lists have square brackets, and commas between entries: [-1, 1]"),
        ("rows = 5;", "write rows = 5, without what follows it"),
        ("rows = 5 // odd", "comments begin with #: rows = 5  #odd"),
        ("[target f]", "write [target.f]"),
        ("pattern:", "write [pattern]"),
        ("[[load_case]", "write [[load_case]]"),
        ("unit = \u201ccm\u201d", 'write straight quotes: unit = "cm"'),
        ('svg = "C:\\Users\\a.svg"', "in single quotes, or C:/Users/a.svg"),
        ('a = "b', "close the quotes"),
        ("a = -x**2 + 1", 'put texts in quotes: "-x**2 + 1"'),
    ],
)
def test_what_to_write_instead_is_said(line: str, remedy: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_toml(f'unit = "m"\n{line}\nlast = 1\n')
    assert caught.value.where == "line 2"
    assert caught.value.remedy.endswith(remedy)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_files_as_notepad_writes_them(encoding: str, tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes('# f\u00fcr\r\na = "\u03c0"\r\n'.encode(encoding))
    assert read_toml(tmp_path / "a.toml") == {"a": "\u03c0"}


@pytest.mark.parametrize("head", ["{", "<!DOCTYPE html>", "PK\x03\x04"])
def test_what_it_looks_like_is_said(head: str) -> None:
    with pytest.raises(InputError, match=r"this is not TOML\. Remedy: this looks like"):
        parse_toml(head)


def test_a_design_nests_as_deep_as_it_needs_to() -> None:
    text = "x = " + "[" * (DEEPEST - 1) + "1.5, 2.5, 1979-05-27T07:32:00.5" + "]" * (DEEPEST - 1)
    assert list(parse_toml(text)) == ["x"]
    many = "".join(f"[t.u{k}]\nv.w = [[1.5, 2.5]]\n" for k in range(1000))
    assert len(parse_toml(many)["t"]) == 1000


@pytest.mark.parametrize(
    ("number", "got"),
    [
        ("0x" + "f" * 20_000, "80000 bits"),
        ("9" * 20_000, "more than 4300 digits"),
        (str(2**63), "64 bits"),
        (str(-(2**63) - 1), "64 bits"),
    ],
)
def test_whole_numbers_have_64_bits(number: str, got: str) -> None:
    with pytest.raises(InputError, match=f"a whole number is too large; got {got}"):
        parse_toml(f"[pattern]\nrows = [[{number}]]")
    assert parse_toml(f"a = {2**63 - 1}\nb = {-(2**63)}") == {"a": 2**63 - 1, "b": -(2**63)}


def test_the_place_is_said(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text("[pattern]\nrows = 0x" + "f" * 5000)
    with pytest.raises(InputError, match=r"a\.toml: pattern\.rows: a whole number"):
        read_toml(tmp_path / "a.toml")
