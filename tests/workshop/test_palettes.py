import tomllib
from importlib.resources import files
from pathlib import Path

import pytest
from ezdxf.colors import aci2rgb

from orishell.conventions.errors import InputError
from orishell.workshop.palettes import LAYERS, load_palette, palette_names

GOOD = """
[mine]
note = "my laser"
CUT = { colour = "#FF0000", aci = 1, width_mm = 0.01 }
MOUNTAIN = { colour = "#0000ff", aci = 5, width_mm = 0.01 }
VALLEY = { colour = "#0000ff", aci = 5, width_mm = 0.01 }
ENGRAVE = { colour = "#000000", aci = 7, width_mm = 1 }
LABEL = false
"""


@pytest.mark.parametrize("name", palette_names())
def test_every_palette_cuts_and_its_two_notations_of_a_colour_look_alike(name: str) -> None:
    palette = load_palette(name)
    assert {"CUT", "MOUNTAIN", "VALLEY", "ENGRAVE"} <= set(palette.pens)
    for pen in palette.pens.values():
        shown = tuple(int(pen.colour[k : k + 2], 16) for k in (1, 3, 5))
        indexed = aci2rgb(pen.aci)
        black_on_white = pen.aci == 7 and shown == (0, 0, 0)
        assert black_on_white or max(abs(a - b) for a, b in zip(shown, indexed, strict=True)) < 96


def test_what_is_cut_has_a_colour_of_its_own_in_every_palette() -> None:
    for name in palette_names():
        colours = [load_palette(name).pens[layer].colour for layer in load_palette(name).pens]
        cut = load_palette(name).pens["CUT"].colour
        assert colours.count(cut) == 1


def test_all_palettes_are_those_of_the_data_file() -> None:
    text = (files("orishell.workshop") / "palettes.toml").read_text(encoding="utf-8")
    assert palette_names() == tuple(tomllib.loads(text))


def test_hairlines_stay_what_they_are_and_the_preview_grows_with_the_page() -> None:
    assert load_palette("epilog").width_mm("CUT", 10_000) == 0.0254  # 0.001 in
    plain = load_palette("plain")
    assert plain.width_mm("CUT", 420) == plain.width_mm("CUT", 10) == plain.pens["CUT"].width_mm
    assert plain.width_mm("CUT", 4200) == pytest.approx(10 * plain.pens["CUT"].width_mm)


def test_an_unknown_name_is_answered_with_the_known_ones() -> None:
    with pytest.raises(InputError) as fault:
        load_palette("lightbrun")
    assert all(name in str(fault.value) for name in palette_names())


def test_a_palette_can_come_from_a_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(GOOD)
    palette = load_palette(str(path))
    assert (palette.name, palette.note) == ("mine", "my laser")
    assert set(palette.pens) == set(LAYERS) - {"LABEL"}
    assert palette.pens["CUT"].colour == "#ff0000"
    assert palette.pens["ENGRAVE"].width_mm == 1.0


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("LABEL = false", "", "names each layer once"),
        ("LABEL = false", "LABEL = true", "or is false"),
        ("#FF0000", "red", "no colour"),
        ("aci = 1", "aci = 256", "no AutoCAD colour"),
        ("aci = 1", "aci = true", "no AutoCAD colour"),
        ("width_mm = 1 ", "width_mm = 0 ", "no length"),
        ("width_mm = 1 ", "width_mm = nan ", "no length"),
        ("width_mm = 1 ", 'width_mm = "1" ', "no length"),
        (", width_mm = 1 ", " ", "has a colour, an aci and a width_mm"),
        ("[mine]", "[mine]\npage_mm = -1", "no length"),
        ("[mine]", "[other]\n[mine]", "one table"),
        ("[mine]", "[mine", "not TOML"),
    ],
)
def test_faults_of_a_palette_file_are_said(tmp_path: Path, old: str, new: str, said: str) -> None:
    path = tmp_path / "mine.toml"
    assert old in GOOD
    path.write_text(GOOD.replace(old, new))
    with pytest.raises(InputError, match=said) as fault:
        load_palette(str(path))
    assert str(path) in str(fault.value)


def test_a_file_that_is_not_there_is_an_input_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="does not exist"):
        load_palette(str(tmp_path / "none.toml"))
