"""Targets from drawings: which keys go together, units, and the same shell as from a formula."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
from ezdxf.filemanagement import new

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.toml_file import parse_toml
from orishell.curves import Curve, trace_curve
from orishell.design_file import DesignFile, read_design_file
from orishell.design_file.target import Target
from orishell.motion import FoldingMotion
from orishell.shell.make import make_shell
from orishell.shell.steps import MEASURES

EXAMPLES = Path(__file__).parents[2] / "examples"
HALF_ANGLE = 0.6
"""The profile of these tests: an arc of a circle with radius 2 m, 0.6 rad to both sides."""
FORMULA = f'formula = ["2*sin(t)", "2*cos(t) - 2"]\nrange = [{-HALF_ANGLE}, {HALF_ANGLE}]'
SHELL = """
[shell]
family = "parallel-repeating"
unit = "{unit}"
[target.f]
{f}
[target.g]
formula = "{size}*sin(x/({size}*2))"
range = [0, {length}]
[pattern]
rows = 5
columns = 7
flap = {flap}
xi_deg = 50
"""


def design_file(directory: Path, f: str, unit: str = "m") -> DesignFile:
    size = {"m": 1.0, "mm": 1000.0, "ft": 1 / 0.3048}[unit]
    text = SHELL.format(f=f, unit=unit, size=size, length=10 * size, flap=0.2 * size)
    path = directory / "shell.toml"
    path.write_text(text)
    return read_design_file(path)


def profile(directory: Path, f: str, unit: str = "m") -> Curve:
    return design_file(directory, f, unit).f


@pytest.fixture
def drawings(tmp_path: Path) -> Path:
    """The profile in millimetres as SVG, DXF and CSV."""
    t = np.linspace(-HALF_ANGLE, HALF_ANGLE, 81)
    points = np.stack([2000 * np.sin(t), 2000 * np.cos(t) - 2000], axis=1).tolist()
    (_, y), (x, _) = points[0], points[-1]
    (tmp_path / "arc.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="4000mm" height="2000mm" '
        'viewBox="0 0 4000 2000">'
        f'<path id="arc" d="M {-x!r} {-y!r} A 2000 2000 0 0 1 {x!r} {-y!r}"/></svg>'
    )
    document = new("R2000", units=4)
    document.modelspace().add_arc(
        (0, -2000),
        2000,
        90 - np.rad2deg(HALF_ANGLE),
        90 + np.rad2deg(HALF_ANGLE),
        dxfattribs={"layer": "ARC"},
    )
    document.saveas(tmp_path / "arc.dxf")
    rows = "\n".join(f"{x!r},{y!r}" for x, y in points)
    (tmp_path / "arc.csv").write_text(f"x [mm],y [mm]\n{rows}\n")
    segments = " ".join(f"{x!r},{-y!r}" for x, y in points)
    (tmp_path / "segments.svg").write_text(
        '<svg viewBox="0 0 40 20" width="40mm" xmlns="http://www.w3.org/2000/svg">'
        f'<polyline points="{segments}"/></svg>'
    )
    return tmp_path


SOURCES = {
    "formula": (FORMULA, 1e-15),
    "svg": ('svg = "arc.svg"', 1e-12),
    "svg by id": ('svg = "arc.svg"\nid = "arc"', 1e-12),
    "dxf": ('dxf = "arc.dxf"\nlayer = "arc"', 1e-12),
    "points": ('points = "arc.csv"', 1e-6),
    "path": (
        f'path = "M{-2 * np.sin(HALF_ANGLE):.17g} {2 * np.cos(HALF_ANGLE) - 2:.17g} '
        f'A2 2 0 0 0 {2 * np.sin(HALF_ANGLE):.17g} {2 * np.cos(HALF_ANGLE) - 2:.17g}"\nunit = "m"',
        1e-12,
    ),
    "segments, smoothed": ('svg = "segments.svg"\nsmooth = true', 1e-6),
}


@pytest.mark.parametrize("name", SOURCES)
@pytest.mark.parametrize("unit", ["m", "ft"])
def test_a_drawn_profile_is_the_circle_in_the_unit_of_the_shell(
    drawings: Path, name: str, unit: str
) -> None:
    source, error = SOURCES[name]
    metre = 1.0 if unit == "m" else 1 / 0.3048
    scale = f"\nscale = {metre!r}" if name == "formula" else ""
    curve = profile(drawings, source + scale, unit)
    points = trace_curve(curve).points / metre
    np.testing.assert_allclose(np.hypot(*(points - [0, -2]).T), 2, rtol=0, atol=error)
    assert trace_curve(curve).length / metre == pytest.approx(4 * HALF_ANGLE, abs=max(error, 1e-9))


@pytest.mark.parametrize("name", ["svg", "dxf", "points", "segments, smoothed"])
def test_a_shell_from_a_drawing_is_the_shell_from_the_formula(drawings: Path, name: str) -> None:
    source, error = SOURCES[name]
    locked = []
    for f in (FORMULA, source):
        file = design_file(drawings, f)
        design = file.pattern.design(file.f, file.g)
        locked.append(list(FoldingMotion(design.mechanism, 2))[-1].positions)
    np.testing.assert_allclose(locked[1], locked[0], rtol=0, atol=max(1e3 * error, 1e-9))


def test_scale_comes_after_the_unit(drawings: Path) -> None:
    curve = profile(drawings, 'dxf = "arc.dxf"\nscale = 0.5', "mm")
    points = trace_curve(curve).points
    np.testing.assert_allclose(np.hypot(*(points - [0, -1000]).T), 1000, rtol=1e-12)


@pytest.mark.parametrize("name", SOURCES)
def test_a_pair_of_scales_makes_a_circle_an_ellipse(drawings: Path, name: str) -> None:
    source, error = SOURCES[name]
    points = trace_curve(profile(drawings, f"{source}\nscale = [0.5, 3]")).points
    x, y = (points / [0.5, 3]).T
    np.testing.assert_allclose(np.hypot(x, y + 2), 2, rtol=0, atol=error)


@pytest.mark.parametrize("name", ["svg", "dxf", "points"])
def test_what_a_file_draws_takes_the_place_of_its_name(drawings: Path, name: str) -> None:
    for options in ("", 'reverse = true\npart = [0.1, 2]\nunit = "cm"\nscale = [1, 2]'):
        text = f"{SOURCES[name][0]}\n{options}"
        table = Target.model_validate(parse_toml(text)).without_files(drawings, "m")
        assert not {"svg", "dxf"} & set(table)
        curves = [Target.model_validate(table).curve(None, "m"), profile(drawings, text)]
        start, stop = curves[1].start, curves[1].stop
        assert (curves[0].start, curves[0].stop) == pytest.approx((start, stop), rel=1e-9)
        found, wanted = (curve.position(np.linspace(start, stop, 50)) for curve in curves)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-9)


HALVES = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="4000mm" height="1000mm" '
    'viewBox="0 0 4000 1000"><g fill="none" stroke="#000">'
    '<path d="M0 900Q1000 100 2000 100"/><path d="M{} 100Q3000 100 4000 900"/></g></svg>'
)


def test_how_a_drawing_was_read_is_a_warning_of_its_shell(tmp_path: Path) -> None:
    """Ends that were joined, which curve they are of, and by how much they were apart."""
    (tmp_path / "halves.svg").write_text(HALVES.format(2000.4))
    file = design_file(tmp_path, 'svg = "halves.svg"\nscale = [0.5, 0.4]\nreverse = true')
    told = "f: ends up to 0.4 mm apart were joined"
    assert file.notes == (told,)
    assert told in make_shell(file, clash="unexamined", skip=MEASURES).report.warnings
    assert design_file(tmp_path, FORMULA).notes == ()


@pytest.mark.parametrize("unit", ["", '\nunit = "cm"'])
def test_a_wider_gap_is_joined_by_the_key_that_the_message_offers(
    tmp_path: Path, unit: str
) -> None:
    (tmp_path / "halves.svg").write_text(HALVES.format(2030))
    source = f'svg = "halves.svg"{unit}'
    with pytest.raises(InputError, match="the nearest ends 30 apart") as caught:
        profile(tmp_path, source)
    assert caught.value.remedy.startswith("join = ")
    typed = caught.value.remedy.split(" joins")[0]
    curve = profile(tmp_path, f"{source}\n{typed}")
    ends = curve.position(np.array([curve.start, curve.stop]))
    assert np.ptp(ends[:, 0]) == pytest.approx(40 if unit else 4)
    table = Target.model_validate(parse_toml(f"{source}\n{typed}")).without_files(tmp_path, "m")
    assert set(table) == {"path"}


def test_unit_overrides_what_the_file_says(drawings: Path) -> None:
    for source in ('dxf = "arc.dxf"', 'svg = "arc.svg"', 'points = "arc.csv"'):
        curve = profile(drawings, f'{source}\nunit = "cm"', "m")
        assert np.ptp(trace_curve(curve).points[:, 0]) == pytest.approx(40 * np.sin(HALF_ANGLE))


def test_reverse_turns_any_source_round(drawings: Path) -> None:
    for source, _ in SOURCES.values():
        ends = [
            [curve.position(curve.start), curve.position(curve.stop)]
            for curve in (profile(drawings, source), profile(drawings, f"{source}\nreverse = true"))
        ]
        np.testing.assert_allclose(ends[1], ends[0][::-1], atol=1e-12)


def test_a_range_takes_formulas_of_constants(drawings: Path) -> None:
    curve = profile(drawings, 'formula = "cos(x)"\nrange = ["-pi/2", "2*pi/3 + 0.5"]')
    assert (curve.start, curve.stop) == (-np.pi / 2, 2 * np.pi / 3 + 0.5)
    part = profile(drawings, 'dxf = "arc.dxf"\npart = ["1/3", "pi/2"]')
    assert (part.start, part.stop) == (1 / 3, np.pi / 2)


@pytest.mark.parametrize("name", SOURCES)
@pytest.mark.parametrize("options", ["", "reverse = true", "scale = 0.5\nreverse = true"])
@pytest.mark.parametrize("unit", ["m", "ft"])
def test_what_messages_quote_is_typed_and_gives_that_part(
    drawings: Path, name: str, options: str, unit: str
) -> None:
    """Parameters of a traced curve, whichever way it runs, as the key of its source takes them."""
    source = "\n".join(
        line for line in SOURCES[name][0].splitlines() if not line.startswith("range")
    )
    whole = profile(drawings, f"{SOURCES[name][0]}\n{options}", unit)
    for trace in (trace_curve(whole), trace_curve(whole).reversed()):
        ends = trace.t[[len(trace.t) // 5, len(trace.t) // 2]]
        low, high = trace.curve.drawn_part(*ends)
        typed = f"{source}\n{whole.key} = [{low!r}, {high!r}]\n{options}"
        part = profile(drawings, typed, unit)
        found = part.position(np.array([part.start, part.stop]))
        wanted = trace.curve.position(ends)
        forwards = trace.curve.drawn == whole.drawn
        np.testing.assert_allclose(found if forwards else found[::-1], wanted, atol=1e-9)


WAVE = 'formula = ["t", "t**3 - 0.2*t**2"]\nrange = [-0.6, 1]'
SPIRAL = 'formula = ["(3 + t/9)*cos(t)", "(3 + t/9)*sin(t)"]\nrange = [1, 6]'
TURNING = {
    "parallel-repeating": ("f", SPIRAL, 'theta_deg = "auto"\nxi_deg = 60\nflap = 0'),
    "orthodiagonal": ("g", SPIRAL, 'heading_deg = "auto"\nflap = 0'),
    "longitudinal-linear-repeating": ("f", WAVE, "sector_deg = [85, 80, 95, 100]\ncolumns = 2"),
}


@pytest.mark.parametrize("options", ["", "scale = 1.5\nreverse = true"])
@pytest.mark.parametrize("drawn", [False, True], ids=["range", "part"])
@pytest.mark.parametrize("family", TURNING)
def test_an_offered_part_is_the_part_that_was_meant(
    tmp_path: Path, family: str, drawn: bool, options: str
) -> None:
    """A curve that turns too far, from its formula and from points along it, either way round:
    what the message quotes, typed into its key, is made."""
    name, curve, pattern = TURNING[family]
    if drawn:
        (tmp_path / "curve.toml").write_text(
            SHELL.format(f=curve, unit="m", size=1, length=10, flap=0.2)
        )
        points = trace_curve(read_design_file(tmp_path / "curve.toml").f).points[::8]
        curve = f"points = {points.tolist()}"
    other = {"f": "g", "g": "f"}[name]
    text = (
        f'[shell]\nfamily = "{family}"\nunit = "m"\n[pattern]\nrows = 3\n{pattern}\n'
        + ("" if "columns" in pattern else "columns = 5\n")
        + f'[target.{other}]\nformula = "{"0*x" if other == "g" else "-0.1*x**2"}"\n'
        + f"range = [0, {0.4 if family.startswith('long') else 2}]\n[target.{name}]\n{options}\n"
    )
    path = tmp_path / "shell.toml"
    path.write_text(f"{text}{curve}")
    file = read_design_file(path)
    with pytest.raises(DesignError) as caught:
        file.pattern.design(file.f, file.g)
    key = "part" if drawn else "range"
    changes = (each.changes for each in caught.value.candidates)
    quoted = next(each[place] for each in changes if (place := f"target.{name}.{key}") in each)
    kept = "\n".join(line for line in curve.splitlines() if not line.startswith("range"))
    path.write_text(f"{text}{kept}\n{key} = {quoted}")
    file = read_design_file(path)
    file.pattern.design(file.f, file.g)


def test_an_end_quoted_in_few_digits_is_the_end(drawings: Path) -> None:
    whole = profile(drawings, 'points = "arc.csv"').stop
    for typed in (whole * (1 + 5e-6), whole):  # as six digits may round it
        assert profile(drawings, f'points = "arc.csv"\npart = [0, {typed!r}]').stop == whole


def test_drawings_are_taken_as_drawn_and_points_are_smoothed_unless_told(drawings: Path) -> None:
    assert len(profile(drawings, 'svg = "segments.svg"').breaks) == 79
    assert profile(drawings, 'svg = "segments.svg"\nsmooth = true').breaks == ()
    assert profile(drawings, 'points = "arc.csv"').breaks == ()
    assert len(profile(drawings, 'points = "arc.csv"\nsmooth = false').breaks) == 79


FAULTS = {
    "no source": ("scale = 2", "[target.f]", "none of them"),
    "two sources": ('svg = "a.svg"\ndxf = "b.dxf"', "[target.f]", "svg and dxf"),
    "a formula and a file": (f'{FORMULA}\nsvg = "a.svg"', "[target.f]", "formula and svg"),
    "a range for a file": (
        'svg = "a.svg"\nrange = [0, 1]',
        "[target.f] range",
        "goes with formula",
    ),
    "an id for a dxf": ('dxf = "a.dxf"\nid = "x"', "[target.f] id", "goes with svg, not with dxf"),
    "a part of a formula": (
        f"{FORMULA}\npart = [0, 1]",
        "[target.f] part",
        "goes with points or svg",
    ),
    "a path of two": ('path = "M0 0L1 1M2 2L3 3"', "[target.f] character 9 of path", "only M"),
    "a closed path": ('path = "M0 0L1 1L2 0Z"', "[target.f] character 13 of path", "no Z"),
    "a path of a point": ('path = "M1 2L1 2"', "[target.f]", "a single point"),
    "no path": ('path = "1 2"', "[target.f] character 1 of path", "the first one M"),
    "a scale of 0": (f"{FORMULA}\nscale = [1, 0]", "[target.f] scale", "greater than 0"),
    "three scales": (f"{FORMULA}\nscale = [1, 1, 1]", "[target.f] scale", "2"),
    "a reversed part": ('dxf = "arc.dxf"\npart = [2, 1]', "[target.f] part", "within [0, 2.4]"),
    "an empty part": ('svg = "arc.svg"\npart = [1, 1]', "[target.f] part", "within [0, 2.4]"),
    "a part beyond": ('svg = "arc.svg"\npart = [1, 2.5]', "[target.f] part", "within [0, 2.4]"),
    "a part before": ('dxf = "arc.dxf"\npart = [-1, 1]', "[target.f] part", "within [0, 2.4]"),
    "a variable in a range": (
        'formula = "x"\nrange = [0, "x"]',
        "[target.f] range[1]",
        "a formula of constants",
    ),
    "no number in a range": (
        'formula = "x"\nrange = ["1/0", 1]',
        "[target.f] range[0]",
        "no number",
    ),
    "no formula in a range": (
        'formula = "x"\nrange = ["2~3", 9]',
        "[target.f] range[0]",
        "character 2",
    ),
    "a variable in a part": ('svg = "arc.svg"\npart = ["t", 1]', "[target.f] part[0]", "constants"),
    "a layer for an svg": ('svg = "a.svg"\nlayer = "0"', "[target.f] layer", "goes with dxf"),
    "a gap to join for points": (
        'points = "arc.csv"\njoin = 1',
        "[target.f] join",
        "goes with svg or dxf, not with points",
    ),
    "no gap to join": ('svg = "arc.svg"\njoin = 0', "[target.f] join", "greater than 0"),
    "a unit for a formula": (f'{FORMULA}\nunit = "mm"', "[target.f] unit", "points or svg or dxf"),
    "smooth for a formula": (f"{FORMULA}\nsmooth = true", "[target.f] smooth", "not with formula"),
    "layer and handle": (
        'dxf = "a.dxf"\nlayer = "0"\nhandle = "2F"',
        "[target.f] handle",
        "its layer or its handle",
    ),
    "an unknown unit": ('svg = "arc.svg"\nunit = "yd"', "[target.f] unit", "'ft'"),
    "an unknown key": ('svg = "arc.svg"\nlayr = "x"', "[target.f] layr", "Did you mean layer?"),
    "no such file": ('svg = "none.svg"', "none.svg", "does not exist"),
    "no such id": ('svg = "arc.svg"\nid = "arch"', "[target.f]", "one of arc"),
    "no such layer": ('dxf = "arc.dxf"\nlayer = "arch"', "[target.f]", "one of ARC"),
    "points cut off": ('points = "shell.toml"', "shell.toml line", "not a point"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_faults(drawings: Path, name: str) -> None:
    f, where, says = FAULTS[name]
    with pytest.raises(InputError) as caught:
        profile(drawings, f)
    message = str(caught.value)
    assert "shell.toml: " in message
    assert where in message
    assert says in message
    assert caught.value.exit_status == 2


def test_the_examples_are_profiles_of_a_shell(tmp_path: Path) -> None:
    """Both example drawings lead to the same locked shell, on the arch that they draw."""
    locked = []
    for source in (
        f'svg = "{EXAMPLES / "profile.svg"}"\nid = "profile"',
        f'dxf = "{EXAMPLES / "profile.dxf"}"\nlayer = "PROFILE"',
    ):
        file = design_file(tmp_path, source)
        design = file.pattern.design(file.f, file.g)
        locked.append(list(FoldingMotion(design.mechanism, 2))[-1].positions)
    np.testing.assert_allclose(locked[1], locked[0], rtol=0, atol=1e-8)


def test_messages_stay_short(drawings: Path) -> None:
    """Thousands of faults, and names as long as a file: what matters is said, the rest counted."""
    with pytest.raises(InputError) as caught:
        profile(drawings, "\n".join(f"key{k} = {k}" for k in range(3000)))
    assert str(caught.value).endswith("and 2980 more")
    assert str(caught.value).count("\n") == 20
    for old in ('family = "', "[target.f]\n"):
        text = SHELL.format(f=FORMULA, unit="m", size=1, length=10, flap=0.2)
        (drawings / "long.toml").write_text(text.replace(old, old + "x" * 10_000, 1))
        with pytest.raises(InputError) as caught:
            read_design_file(drawings / "long.toml")
        assert len(str(caught.value)) < 500 + len(str(drawings))


def test_the_same_table_gives_the_same_curve(tmp_path: Path) -> None:
    # So that what is remembered of a curve serves the next request of the studio, too.
    assert profile(tmp_path, FORMULA) is profile(tmp_path, FORMULA)
    assert profile(tmp_path, FORMULA) is not profile(tmp_path, FORMULA + "\nscale = 2")
    assert profile(tmp_path, FORMULA) is not profile(tmp_path, FORMULA, "mm")
    inline = "points = [[0, 0], [1, 0.2], [2, 0]]"
    assert profile(tmp_path, inline) is profile(tmp_path, inline)
    (tmp_path / "profile.csv").write_text("0, 0\n1, 0.2\n2, 0\n")
    file = 'points = "profile.csv"'
    before = profile(tmp_path, file)
    (tmp_path / "profile.csv").write_text("0, 0\n1, 0.3\n2, 0\n")
    assert profile(tmp_path, file).position(1.0)[1] != before.position(1.0)[1]


def test_a_drawn_sheet_is_asked_for_where_it_is_missing(tmp_path: Path) -> None:
    """Not f and g, which its family does not take; with a sheet in its place the file is read."""
    path = tmp_path / "x.toml"
    path.write_text('[shell]\nfamily = "pattern"\nunit = "m"\n')
    with pytest.raises(InputError) as refused:
        read_design_file(path)
    said = str(refused.value)
    assert 'pattern = "sheet.svg" in [target]' in said
    assert "f =" not in said
    assert "range" not in said
    shutil.copy(EXAMPLES / "arch_pattern.svg", tmp_path / "sheet.svg")
    path.write_text(path.read_text() + '[target]\npattern = "sheet.svg"\n')
    assert read_design_file(path).drawing is not None
