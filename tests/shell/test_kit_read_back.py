"""Kits are read back: every part is counted once in drawings, tables, booklet, README and STEP."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from ezdxf.entities.circle import Circle
from pypdf import PdfReader

from cad_tools import require_build123d
from kits import (
    BOXED,
    BOXED_ON_MEMBRANE,
    CARD_SHELL,
    OF_STEEL,
    SKINNED,
    STIFFENED,
    booklet_counts,
    names_in,
    outlines_in,
    read_sound,
    rows_of,
    shell_of,
)
from orishell.conventions.quantities import plain
from orishell.io import Settings
from orishell.io.formats import find_formats
from orishell.shell import write_format, write_kit
from samples import thorough

KITS = ["shelter", "shelter_boards", "shelter_hinged", "dome", "dome_locked", "tunnel"]
KIT = pytest.mark.parametrize(
    "name",
    [
        *(CARD_SHELL, STIFFENED, OF_STEEL, BOXED, BOXED_ON_MEMBRANE, SKINNED),
        *(pytest.param(name, marks=thorough) for name in KITS),
    ],
    scope="module",  # tests of one kit come one after the other
)
SIDES = {"Upper boards": "top", "Lower boards": "bottom", "Boards": "panel"}
"""What the booklet calls boards, and the tables their side."""
HUNG = {"box ": 1, "wall ": 2}
"""What panels are called that hang on others, and on how many lines each does."""
SHEETS = ("Sheet with creases", "Parts of the sheet", "Membrane", "Parts of the membrane")


@pytest.fixture(scope="module")
def kit_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The kit of a shell by its name, written once."""

    @cache
    def kit(name: str) -> Path:
        place = tmp_path_factory.mktemp(name) / "kit"
        write_kit(shell_of(name), place)
        return place

    return kit


@KIT
def test_every_part_is_counted_once_in_all_files(name: str, kit_of: Callable[[str], Path]) -> None:
    # Counted anew in each: names in drawings, rows of tables, words of the booklet.
    kit = kit_of(name)
    counts = booklet_counts(kit / "booklet/booklet.pdf")
    assert counts
    _require_boards(kit, counts)
    _require_fittings(kit, counts)
    _require_sheet(kit, counts)
    _require_lines(kit, counts)
    ties = rows_of(kit / "ground/ties.csv")
    assert counts.get("Ties", 0) == len({row["tie"] for row in ties}) == len(ties)
    creases = rows_of(kit / "hinges/schedule.csv")
    numbers = [row["crease"] for row in creases]
    assert len(numbers) == len({*numbers})
    assert {row["crease"] for row in rows_of(kit / "hinges/creases.csv")} <= {*numbers}
    feet = rows_of(kit / "ground/ground.csv")
    assert len(feet) == names_in([kit / "ground/ground.dxf"], "CUT").total()
    readme = (kit / "README.md").read_text()
    listed = dict(re.findall(r"^\| ([a-z ]+) \| (\d+) \|$", readme, re.MULTILINE))
    assert listed == {part.lower(): str(count) for part, count in counts.items()}


def _require_boards(kit: Path, counts: dict[str, int]) -> None:
    boards = rows_of(kit / "cut/boards.csv")
    sides = Counter(row["side"] for row in boards)
    # Gussets of a stock of their own are not counted among boards.
    own = {row["panel"] for row in boards if row["sheet"] in _sheets_of_gussets(kit)}
    said = Counter({SIDES[key]: count for key, count in counts.items() if key in SIDES})
    assert said + Counter(panel=len(own)) == sides
    drawings = names_in(
        file for file in (kit / "cut").glob("pattern-*.dxf") if "arms" not in file.stem
    )
    gussets = {row["panel"] for row in boards if row["panel"].startswith("gusset ")}
    assert counts.get("Gussets", 0) == len(gussets)
    parts = [row["part"] for row in boards]
    assert {part: drawings[part] for part in parts} == dict.fromkeys(parts, 1)


def _sheets_of_gussets(kit: Path) -> set[str]:
    """Numbers of the sheets that gussets alone are cut from."""
    return {file.stem.rpartition("-")[2] for file in (kit / "cut").glob("pattern-gussets-*.dxf")}


def _require_fittings(kit: Path, counts: dict[str, int]) -> None:
    hinges, arms = rows_of(kit / "hinges/hinges.csv"), rows_of(kit / "cut/arms.csv")
    assert counts.get("Hinges", 0) == len(hinges) == len({row["hinge"] for row in hinges})
    kinds = Counter(row[key] for row in hinges for key in ("kind_1", "kind_2") if row[key])
    assert kinds == {row["kind"]: int(row["count"]) for row in arms}
    assert counts.get("Arms", 0) == kinds.total()
    in_boards = sum(2 * int(row["holes"]) for row in hinges)
    in_fins = sum(int(row["count"]) * int(row["holes_in_fin"]) for row in arms)
    assert counts.get("Screws", 0) == in_boards + in_fins
    drilled = [
        each
        for file in (kit / "cut").glob("pattern-panels*.dxf")
        for each in read_sound(file).modelspace().query("CIRCLE")
    ]
    assert all(isinstance(each, Circle) for each in drilled)
    assert len(drilled) == in_boards
    bolted = [
        each.dxf.radius
        for file in (kit / "cut").glob("pattern-gussets*.dxf")
        for each in read_sound(file).modelspace().query('CIRCLE[layer=="CUT"]')
    ]
    assert counts.get("Brackets", 0) == len(bolted)
    assert not bolted or {*bolted} == {0.004}
    ordered = [row["what"] for row in rows_of(kit / "order.csv") if row["item"] == "brackets"]
    count = len(bolted)
    said = f"{count} brackets, {2 * count} bolts for holes of 8 mm"
    assert ordered == ([said] if bolted else [])
    plan = names_in((kit / "hinges").glob("pattern.dxf"))
    names = [row["hinge"] for row in hinges]
    assert {name: plan[name] for name in names} == dict.fromkeys(names, 1)


def _require_sheet(kit: Path, counts: dict[str, int]) -> None:
    """Numbers on parts that are cut, or their outlines where they have no numbers."""
    sheet = sum(counts.get(key, 0) for key in SHEETS)
    cut = [*(kit / "fabric").glob("pattern-[0-9]*.dxf")]
    numbers = {name: n for name, n in names_in(cut).items() if name.isdecimal()}
    if not cut:
        flaps = counts.get("Flaps to clip on", 0) if sheet else 0
        assert outlines_in((kit / "fabric").glob("pattern.dxf")) == sheet + flaps
        return
    said = PdfReader(kit / "booklet/booklet.pdf").pages[1].extract_text()
    last = max([sheet, *map(int, re.findall(r"numbers \d+ to\s+(\d+)", said))])
    assert numbers == dict.fromkeys(map(str, range(1, last + 1)), 1)


def _require_lines(kit: Path, counts: dict[str, int]) -> None:
    """As many lines as strips have panels, two of those of walls, each on a board with its name."""
    lines = rows_of(kit / "hinges/lines.csv")
    hung = counts.get("Box girders", 0) + counts.get("Walls", 0)
    assert hung == len({row["part"] for row in lines})
    boards = rows_of(kit / "cut/boards.csv")
    plates = {row["panel"] for row in boards if row["panel"].startswith("plate ")}
    assert counts.get("Plates", 0) == len(plates)
    strips = [{row["panel"] for row in boards if row["panel"].startswith(k)} for k in HUNG]
    assert len(lines) == sum(
        k * len(panels) for k, panels in zip(HUNG.values(), strips, strict=True)
    )
    drawn = names_in((kit / "cut").glob("pattern-*.dxf"))
    solid = {row["side"] for row in boards} == {"panel"}
    letters = {"top": " T", "bottom": " B"} if solid else {"top": "", "bottom": ""}
    named = Counter(row["part"] + letters[row["side"]] for row in lines)
    assert {name: drawn[name] for name in named} == named


@KIT
def test_masses_are_those_of_the_bill(name: str, kit_of: Callable[[str], Path]) -> None:
    kit, found = kit_of(name), shell_of(name).report.quantities
    whole = found.mass_kg if found.built is None else found.built.mass_kg.total
    rows = [row for row in rows_of(kit / "order.csv") if row["item"] != "ties"]
    text = PdfReader(kit / "booklet/booklet.pdf").pages[0].extract_text()
    readme = (kit / "README.md").read_text()
    if whole is None:
        assert not all(row["mass_kg"] for row in rows)
        assert "Mass" not in text + readme
        return
    # Hinges in creases, and brackets, weigh what nobody says, and are not in the whole.
    known = [row for row in rows if row["mass_kg"] or row["item"] not in ("hinges", "brackets")]
    assert sum(float(row["mass_kg"]) for row in known) == pytest.approx(whole, rel=1e-9)
    assert f"Mass: {plain(whole, 3)} kg" in text
    assert f"- Mass: {plain(whole, 3)} kg" in readme
    ordered = {row["item"]: float(row["mass_kg"]) for row in known}
    for item, table in (("boards", "cut/boards.csv"), ("hinges", "hinges/hinges.csv")):
        weighed = [float(row["mass_kg"]) for row in rows_of(kit / table)]
        of_item = sum(mass for key, mass in ordered.items() if key.endswith(item))
        assert sum(weighed) == pytest.approx(of_item, rel=1e-9)
    of_arms = sum(
        int(row["count"]) * float(row["mass_kg"]) for row in rows_of(kit / "cut/arms.csv")
    )
    assert of_arms == pytest.approx(ordered.get("arms", 0.0), rel=1e-9)


def test_gussets_of_steel_are_cut_and_weighed_apart(kit_of: Callable[[str], Path]) -> None:
    """4 mm of 7850 kg/m3 (EN 1991-1-1, table A.4: 77 to 78.5 kN/m3), of the area in boards.csv."""
    kit = kit_of(OF_STEEL)
    boards = rows_of(kit / "cut/boards.csv")
    own = [row for row in boards if row["panel"].startswith("gusset ")]
    assert {row["sheet"] for row in own} == _sheets_of_gussets(kit)
    assert not {row["sheet"] for row in boards if row not in own} & _sheets_of_gussets(kit)
    assert booklet_counts(kit / "booklet/booklet.pdf")["Brackets"] > 2 * len(own)
    cut = names_in((kit / "cut").glob("pattern-gussets-*.dxf"))
    assert cut == Counter(row["part"] for row in own)
    covered = sum(float(row["area_m2"]) for row in own)
    order = {row["item"]: row for row in rows_of(kit / "order.csv")}
    ordered = order["gusset boards"]
    assert float(ordered["used"]) == pytest.approx(covered, rel=1e-9)
    assert float(ordered["mass_kg"]) == pytest.approx(7850 * 0.004 * covered, rel=1e-9)
    assert "4 mm thick of steel" in ordered["what"]
    membrane = sum(part.areas().sum() for part in shell_of(OF_STEEL).document.parts[:1])
    assert float(order["membrane"]["mass_kg"]) == pytest.approx(900 * 0.001 * membrane, rel=1e-9)
    text = " ".join(PdfReader(kit / "booklet/booklet.pdf").pages[1].extract_text().split())
    assert "4 mm thick, of steel" in text


@thorough
@pytest.mark.parametrize(
    "name",
    [
        *(CARD_SHELL, STIFFENED, OF_STEEL, BOXED, BOXED_ON_MEMBRANE, SKINNED),
        *("shelter_boards", "shelter_hinged", "dome"),
    ],
)
def test_the_solids_of_step_are_the_parts_of_the_tables(
    name: str, tmp_path: Path, kit_of: Callable[[str], Path]
) -> None:
    require_build123d()
    kit = kit_of(name)
    (step,) = find_formats(["step"])
    write_format(shell_of(name), step, tmp_path, Settings())
    text = (tmp_path / step.file).read_text()
    _, *solids = re.findall(r"PRODUCT\('([^']*)'", text)  # the first is all of them
    assert text.count("MANIFOLD_SOLID_BREP(") == len(solids) == len({*solids})
    arms = [solid for solid in solids if " arm" in solid]
    assert len(arms) == sum(int(row["count"]) for row in rows_of(kit / "cut/arms.csv"))
    boards = rows_of(kit / "cut/boards.csv")
    names = {f"{row['panel']} {row['side']}".removesuffix(" panel") for row in boards}
    assert {*solids} - {*arms} == names
    assert len(names) == len(boards)
