"""One form for every message."""

from orishell.conventions.errors import DesignError, FormulaError, InputError, Remedy, printable


def test_input_error_says_all_it_knows() -> None:
    error = InputError("this is wrong", where="rows", got="8", expected="odd", remedy="write 9")
    assert str(error.located("shell.toml:")) == (
        "shell.toml: rows: this is wrong; got 8, expected odd. Remedy: write 9."
    )
    assert error.exit_status == 2


def test_bare_messages() -> None:
    assert str(InputError("this is wrong")) == "this is wrong."
    assert str(DesignError("it cannot be")) == "it cannot be."


def test_a_file_alone_is_a_place_with_one_colon() -> None:
    assert str(InputError("this is no file").located("a.fold:")) == "a.fold: this is no file."
    inner = InputError("too small", where="[pattern] rows")
    assert str(inner.located("a.toml:")) == "a.toml: [pattern] rows: too small."


def test_design_error_says_where_how_much_and_what_works() -> None:
    one = Remedy({"pattern.xi_deg": 50.0})
    other = Remedy({"target.f.scale": 0.5, "pattern.flap": "auto"})
    error = DesignError("too large", place="at row 3", size="by 2", remedies=(one, other))
    assert str(error) == (
        "too large, at row 3: by 2. Nearest found that works: xi_deg = 50, or scale = 0.5 in "
        '[target.f] with flap = "auto".'
    )
    assert error.exit_status == 1


def test_caret_stands_under_the_fault_also_in_long_formulas() -> None:
    text = "x + " * 40 + "$"
    lines = str(FormulaError("this is wrong", text, len(text) - 1)).splitlines()
    assert lines[1][lines[2].index("^")] == "$"


def test_a_long_name_is_cut() -> None:
    said = str(InputError("it cannot be read", where="x" * 5000, got="Name too long"))
    assert len(said) < 300
    assert said.endswith("...: it cannot be read; got Name too long.")


def test_nothing_in_a_message_gives_orders_to_a_terminal() -> None:
    hostile = "a\x1b[2J\r\n\x9b31m\x07\u202eb\ud800"
    error = InputError(hostile, where=hostile, got=hostile, expected=hostile, remedy=hostile)
    assert str(error).isprintable()
    assert r"\x1b[2J\r\n\x9b31m\x07\u202eb\ud800" in str(error)
    assert printable("Größe 3 µm – “f”") == "Größe 3 µm – “f”"
