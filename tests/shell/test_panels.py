"""The table [panel]: what is refused at the command line, and shells that boards end or mend."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from pypdf import PdfReader

from command_line import orishell
from design_tables import Tables, formula, made, mended, refused, tables
from orishell.conventions.errors import InputError
from orishell.design_file import check_design, read_design_file
from orishell.motion import largest_fold
from orishell.shell.candidate import ended
from orishell.shell.designed import designed
from orishell.shell.kit import write_kit
from orishell.shell.make import Shell, design_shell, make_shell
from orishell.shell.steps import Work
from samples import thorough

EXAMPLES = Path(__file__).parents[2] / "examples"
CARD = EXAMPLES / "figure1_card.toml"
SECTORS = (EXAMPLES / "sectors.toml").read_text()
SANDWICH = "thickness = 4.2\nmembrane = 0.2\n"
BEVEL = 'thickness = 4.2\nconstruction = "bevel"\ngap = 0.4\n'


def with_panel(panel: str) -> str:
    head, rest = CARD.read_text().split("[panel]")
    return f"{head}[panel]\n{panel}\n[motion]{rest.split('[motion]')[1]}"


@pytest.mark.parametrize(
    ("panel", "key", "got", "expected"),
    [
        ("thickness = -1\nmembrane = 0.2", "thickness", "-1", "at least 0"),
        ("thickness = nan\nmembrane = 0.2", "thickness", "nan", "a finite number"),
        ("thickness = inf\nmembrane = 0.2", "thickness", "inf", "a finite number"),
        ('thickness = "thick"', "thickness", "'thick'", "a number"),
        ("thickness = true", "thickness", "True", "a number"),
        ("thickness = 4.2", "membrane", "0.0", 'Without one, construction = "bevel"'),
        ('thickness = 4.2\nconstruction = "bevel"', "gap", "0.0", "a gap above 0"),
        ("thickness = 0.2\nmembrane = 0.2", "membrane", "0.2", "below thickness (0.2)"),
        ("thickness = 0.2\nmembrane = 0.3", "membrane", "0.3", "below thickness (0.2)"),
        ("membrane = 0.2", "thickness", "0", "because membrane says"),
        ("stop_deg = 0", "thickness", "0", "because stop_deg says"),
        ("thickness = 0\ngap = 1", "thickness", "0", "because gap says"),
        (SANDWICH + "colour = 1", "colour", "", "unknown key"),
        (SANDWICH + "largest_setback = {shares = 0.3}", "shares", "", "Did you mean share?"),
        (SANDWICH + "largest_setback = {share = 0}", "share", "0", "greater than 0"),
        (SANDWICH + "largest_setback = {share = 1}", "share", "1", "less than 1"),
        (SANDWICH + "largest_setback = {share = 1.5}", "share", "1.5", "less than 1"),
        (SANDWICH + "largest_setback = {share = nan}", "share", "nan", "a finite number"),
        (SANDWICH + "largest_setback = {length = 0}", "length", "0", "greater than 0"),
        (SANDWICH + "largest_setback = {length = nan}", "length", "nan", "a finite number"),
        (SANDWICH + "largest_setback = {length = inf}", "length", "inf", "a finite number"),
        (SANDWICH + "largest_setback = 0.3", "largest_setback", "0.3", "a table"),
        (SANDWICH + "stop_deg = -1", "stop_deg", "-1", "at least 0 or 'auto'"),
        (SANDWICH + "stop_deg = 46", "stop_deg", "46", "at most 45 or 'auto'"),
        (SANDWICH + 'stop_deg = "no"', "stop_deg", "'no'", "a number or 'auto'"),
        (SANDWICH + 'construction = "bevel"\ngap = 1', "membrane", "0.2", "panels are solid"),
        (BEVEL + "membrane_density = 5", "membrane_density", "5.0", "panels are solid"),
        (
            SANDWICH + 'construction = "foam"',
            "construction",
            "'foam'",
            "'sandwich', 'bevel' or 'hinged'",
        ),
        (SANDWICH + 'sides = "outside"', "sides", "'outside'", "'both', 'top' or 'bottom'"),
        (BEVEL + 'sides = "top"', "sides", "'top'", "boards on a membrane may be on one"),
        ('sides = "top"', "thickness", "0", "because sides says"),
        (SANDWICH + "gap = -1", "gap", "-1", "at least 0"),
        (SANDWICH + "density = inf", "density", "inf", "a finite number"),
    ],
)
def test_bad_values_are_one_message_and_nothing_is_written(
    tmp_path: Path, panel: str, key: str, got: str, expected: str
) -> None:
    (tmp_path / "card.toml").write_text(with_panel(panel))
    done = orishell("design", "card.toml", "--out", "out", cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("orishell:") == 1
    assert "[panel] " in done.stderr
    assert f"{key}: " in done.stderr
    assert expected in done.stderr
    assert not got or f"got {got}, expected" in done.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["card.toml"]


@pytest.mark.parametrize(
    ("panel", "says", "offers"),
    [
        ("thickness = 30\nmembrane = 0.2", "boards on flaps would stand", ["panel.thickness"]),
        # The membrane is thicker than panels may be: it is made thinner with them.
        ("thickness = 30\nmembrane = 25", "leave room for", ["panel.thickness", "panel.membrane"]),
        (SANDWICH + "gap = 40", "the gap between panels takes more", ["panel.gap"]),
        pytest.param(
            BEVEL.replace("0.4", "40"),
            "the gap between panels takes more",
            ["panel.gap"],
            marks=thorough,
        ),
        (SANDWICH + "stop_deg = 45", "stop", ["panel.stop_deg"]),
        (
            'sides = "top"\nthickness = 30\nmembrane = 0.2',
            "boards on flaps would stand",
            ["panel.thickness"],
        ),
        pytest.param(
            'sides = "bottom"\nthickness = 30\nmembrane = 25',
            "leave room for",
            ["panel.thickness", "panel.membrane"],
            marks=thorough,
        ),
    ],
)
def test_what_is_offered_for_too_much_works(panel: str, says: str, offers: list[str]) -> None:
    design = tables(
        "parallel-repeating",
        {**formula("-x**2", -1, 1), "scale": 26},
        {**formula("5*sin(pi*x/10)", 0, 5), "scale": 26},
        rows=5,
        columns=4,
        flap=11,
        xi_deg=50,
    )
    design["shell"]["unit"] = "mm"  # a model of card
    design["panel"] = _values(panel)
    error = refused(design)
    assert error is not None
    assert says in str(error)
    assert "No value was found" not in str(error)
    assert set(offers) <= set(error.remedies[0].changes)
    for remedy in error.remedies:
        assert refused(mended(design, remedy)) is None


THIN: Tables = {"thickness": 0.0105, "membrane": 0.0005, "density": 680}
LAMP: Tables = {
    "shell": {"family": "orthodiagonal", "unit": "m"},
    "target": {"f": formula("-x**2", -1, 1), "g": formula("0.1*cos(2*pi*x)", 0, 2)},
    "pattern": {"rows": 5, "columns": 5, "flap": 0, "heading_deg": 90, "spacing": "equal"},
    "motion": {"frames": 3},
}


@pytest.mark.parametrize(
    ("side", "letter", "step"), [("top", "T", "on top"), ("bottom", "B", "turn the membrane over")]
)
def test_boards_on_one_side_are_half_of_all(
    tmp_path: Path, side: str, letter: str, step: str
) -> None:
    """Those that there are on that side of a membrane with boards of 10 mm on both, and no others.

    Its drawings, bill and booklet have one board for every panel, and the back of the membrane
    where these are below.
    """
    shell, whole = (
        make_shell(check_design({**LAMP, "panel": {**THIN, **more}}, tmp_path / "lamp.toml"))
        for more in ({"sides": side}, {"thickness": 0.0205})
    )
    assert shell.document.boards is not None
    assert whole.document.boards is not None
    sign = 1 if side == "top" else -1
    assert set(shell.document.boards.sides) == {sign}
    alike = whole.document.boards.chosen(whole.document.boards.sides == sign)
    assert list(shell.document.boards.panels) == list(alike.panels)
    np.testing.assert_allclose(shell.document.boards.outlines, alike.outlines, atol=1e-12)
    assert shell.report.panel is not None
    assert shell.report.panel.boards == len(alike)
    assert shell.report.panel.path is not None

    write_kit(shell, tmp_path / "kit")
    names = {path.name for path in (tmp_path / "kit").rglob("*.dxf")}
    assert ("pattern-back.dxf" in names) == (side == "bottom")
    assert {f"pattern-{each}.dxf" in names for each in ("top", "bottom") if each == side} == {True}
    assert not {f"pattern-{each}.dxf" for each in ("top", "bottom") if each != side} & names
    words = " ".join(
        " ".join(page.extract_text().split())
        for page in PdfReader(tmp_path / "kit" / "booklet" / "booklet.pdf").pages
    )
    assert f"its column, and {letter}." in words
    assert step in words
    rows = list(csv.DictReader((tmp_path / "kit" / "cut" / "boards.csv").read_text().splitlines()))
    assert len(rows) == len(alike)


@pytest.mark.parametrize(
    ("table", "value"),
    [
        (
            "structure",
            {"material": "birch plywood", "supports": [{"at": "feet", "kind": "pinned"}]},
        ),
        ("stiffeners", {"kind": "gussets"}),
    ],
)
def test_boards_on_one_side_bear_no_loads(tmp_path: Path, table: str, value: object) -> None:
    panel = {**THIN, "sides": "top"}
    with pytest.raises(InputError, match=r"one side|both sides") as refusal:
        check_design({**LAMP, "panel": panel, table: value}, tmp_path / "lamp.toml")
    assert refusal.value.keys == ("panel.sides", table)


def test_too_thick_names_the_crease_and_the_largest_that_works() -> None:
    design = tables(
        "parallel-repeating",
        formula("-x**2", -1, 1),
        formula("5*sin(pi*x/10)", 0, 10),
        rows=5,
        columns=7,
        flap=0,
        xi_deg=50,
    )
    design["shell"]["unit"] = "mm"
    design["panel"] = {"thickness": 3.0, "membrane": 0.01}
    error = refused(design)
    assert error is not None
    assert "at the target, at the crease of row " in error.place
    most = float(error.size.split()[4])
    offered = error.remedies[0].changes["panel.thickness"]
    assert offered == pytest.approx(0.99 * most, rel=1e-3)
    design["panel"]["thickness"] = offered
    assert refused(design) is None
    design["panel"]["thickness"] = 1.001 * most
    assert refused(design) is not None


def _values(panel: str) -> dict[str, float | str]:
    pairs = (line.split(" = ") for line in panel.splitlines() if line)
    return {key: text.strip('"') if '"' in text else float(text) for key, text in pairs}


def shell_of(directory: Path, text: str) -> Shell:
    path = directory / "sheet.toml"
    path.write_text(text)
    return design_shell(path)


THICK = "\n[panel]\nthickness = 0.2\nmembrane = 0.001\n"


def test_without_a_target_boards_end_the_motion(tmp_path: Path) -> None:
    # Without boards the sheet rolls up until panels meet, beyond 8.7 degrees.
    shell = shell_of(tmp_path, SECTORS + THICK)
    lock, panel = shell.lock, shell.report.panel
    assert lock.cause == "boards"
    assert lock.built is not None
    assert lock.target_drive == lock.closes_to < np.deg2rad(8)
    assert panel is not None
    assert shell.design.panel is not None
    room = 0.5 * shell.design.panel.thickness * np.tan(panel.largest_fold / 2)
    assert panel.largest_setback == pytest.approx(room, rel=1e-12)


def test_without_a_target_hinges_end_the_motion(tmp_path: Path) -> None:
    shell = shell_of(tmp_path, SECTORS + "\n[deployment]\nlargest_fold_deg = 40\n")
    assert shell.lock.cause == "hinges"
    fold = largest_fold(shell.design.mechanism, np.array([shell.lock.target_drive]))
    np.testing.assert_allclose(np.rad2deg(fold), 40, rtol=1e-9)


@thorough
def test_a_motion_that_is_cut_short_keeps_its_panels_and_hinges(tmp_path: Path) -> None:
    # Thin boards: panels of the rolled sheet meet first, boards a little before.
    path = tmp_path / "sheet.toml"
    thin = "\n[panel]\nthickness = 0.01\nmembrane = 0.001\n"
    path.write_text(SECTORS + thin + "\n[deployment]\nlargest_fold_deg = 179\n")
    file = read_design_file(path)
    design = designed(file)
    sheet, lock = ended(file, design, Work())
    assert lock.cause == "boards"
    assert lock.first_contact is not None
    assert lock.target_drive == lock.first_contact.clear_until
    assert sheet.mechanism.target_drive == lock.target_drive
    assert sheet.panel == design.panel
    assert sheet.largest_fold == design.largest_fold == np.deg2rad(179)
    assert lock.built is not None


@thorough
@pytest.mark.parametrize("thickness", [1e-9, 1e-13])
def test_boards_thinner_than_what_counts_as_contact(tmp_path: Path, thickness: float) -> None:
    # Panels touch within 1.3e-8 here: corners are cut off so that boards keep more than that.
    panel = f"\n[panel]\nthickness = {thickness}\nmembrane = {0.1 * thickness}\n"
    report = shell_of(tmp_path, SECTORS + panel).report.panel
    assert report is not None
    assert report.corners_cut == 45


@thorough
def test_flaps_of_no_given_width_are_narrowed_for_boards() -> None:
    # A horseshoe whose two flaps meet in its mouth if they carry boards of 0.15.
    g = formula(["2*sin(t)", "-2*cos(t)"], 0.25, 6.03)
    design = tables(
        "parallel-repeating",
        formula("-0.15*x**2", -1, 1),
        g,
        rows=3,
        columns=25,
        xi_deg=50,
        flap="auto",
    )
    bare = made(design).report.parameters["flap"]
    design["panel"] = {"thickness": 0.15, "construction": "bevel", "gap": 0.002}
    shell = made(design)
    flap = shell.report.parameters["flap"]
    assert isinstance(bare, float)
    assert isinstance(flap, float)
    assert flap < 0.999 * bare
    assert shell.lock.cause == "flaps"


@pytest.mark.usefixtures("unpictured")
def test_reports_have_finite_numbers_only(tmp_path: Path) -> None:
    # Flaps that fold flat carry no boards there: their set-backs are infinite.
    (tmp_path / "card.toml").write_text(
        with_panel(SANDWICH + "stop_deg = 0").replace('"clipped"', '"folded"')
    )
    assert orishell("design", "card.toml", "--out", "out", cwd=tmp_path).returncode == 0
    text = (tmp_path / "out" / "report.json").read_text()
    assert json.loads(text, parse_constant=pytest.fail)["panel"]["stop_deg"] == 0
