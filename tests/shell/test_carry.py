"""A design that carries, found from one that does not: typed in, it does; else what was tried."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from command_line import orishell
from orishell.cli import carry as carry_cli
from orishell.conventions.errors import DesignError, Remedy
from orishell.conventions.progress import no_progress
from orishell.conventions.quantities import SPACE
from orishell.design_file import DesignFile, read_design_file
from orishell.shell import (
    carry,
    carry_boards,
    carry_change,
    carry_feet,
    carry_state,
    carry_steps,
    carry_strengths,
    make_shell,
)
from orishell.shell.carry import find_carrying
from orishell.shell.carry_change import Change
from orishell.shell.carry_found import Carrying, CarrySearch
from orishell.shell.instead import shell_of, trying
from orishell.shell.load_trials import LOADED, LoadTrials, Refused
from orishell.shell.steps import MEASURES, Step
from orishell.structure.materials import materials
from orishell.structure.plausibility import panel_widths
from orishell.structure.results import Analysis
from samples import thorough
from small_arch import SMALL_ARCH

ARCH = (
    f"# a small arch\n{SMALL_ARCH}"
    + """[deployment]
from = "pack"
[panel]
thickness = {thickness}
construction = "bevel"
gap = 0.002
[structure]
material = "birch plywood"
crease_stiffness = "free"
tie_stiffness = 1e6
tie_strength = {tie_strength}
line_strength = {lines}
edge_strength = 150e3
cells = 2
supports = [{{ at = "feet", kind = "pinned" }}]
[[load_case]]
name = "snow"
snow = {{ ground = {snow}, arrangement = "undrifted" }}
"""
)


def arch(
    directory: Path,
    thickness: float = 0.004,
    snow: float = 2000,
    lines: float = 150e3,
    tie_strength: float = 20e3,
) -> DesignFile:
    path = directory / "arch.toml"
    text = ARCH.format(thickness=thickness, snow=snow, lines=lines, tie_strength=tie_strength)
    path.write_text(text, encoding="utf-8")
    return read_design_file(path)


TRIAL = re.compile(r"(?P<number>\d+) = (?P<added>(?P<base>the file|\d+) [+-] [^:]+): ")


def no_clock() -> float:
    raise AssertionError("a clock was asked what is to be tried")


@pytest.fixture(scope="module")
def weak(tmp_path_factory: pytest.TempPathFactory) -> tuple[DesignFile, Analysis]:
    """The arch, and what is found of it as it is."""
    file = arch(tmp_path_factory.mktemp("weak"))
    analysis = shell_of(file, trying(no_progress, "", LOADED)).analysis
    assert analysis is not None
    return file, analysis


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> tuple[DesignFile, CarrySearch]:
    file = arch(tmp_path_factory.mktemp("arch"))
    with pytest.MonkeyPatch.context() as patched:
        for clock in ("thread_time", "process_time", "monotonic"):
            patched.setattr(f"time.{clock}", no_clock)
        # Some steps of one order, so that it does not take long.
        some = (
            carry_steps.ties_across_folds,
            carry_steps.flaps,
            carry_boards.thicker,
            carry_steps.more_rows,
        )
        patched.setattr(carry, "BUILDER", some)
        patched.setattr(carry, "DESIGNER", ())
        return file, find_carrying(file)


def test_what_is_found_carries_once_it_is_typed_in(found: tuple[DesignFile, CarrySearch]) -> None:
    """As whole designs, contact included; no clock decides."""
    file, search = found
    assert search.begun.carries is False
    assert search.found
    for each in search.found:
        skip: tuple[Step, ...] = ("verification", "remedies", "stock", *MEASURES)
        made = make_shell(file.changed(each.change.values), skip=skip)
        assert made.analysis is not None
        assert made.analysis.carries is True
        assert made.analysis.model.mass == pytest.approx(each.mass)
        assert each.parts >= 1 + len(made.report.deployment.ties)
        # What its own warnings, or its verdict, ask for then is said with what carries.
        held = made.report.deployment
        assert ("opening" in each.left) == (held.opening is None)
        assert ("closing" in each.left) == (held.closing is None)
        opens = [note for note in made.report.warnings if "opens under its own weight" in note]
        assert not opens or "opening" in each.left
    masses = [each.mass or 0.0 for each in search.found]
    assert masses == sorted(masses)
    # None is as heavy, in as many parts and with as many changes as another that is lighter.
    assert len({repr(each.change.values) for each in search.found}) == len(search.found)
    for number, each in enumerate(search.found):
        for other in search.found[:number]:
            assert not other.beats(each.mass or 0.0, each.parts, len(each.changes))


def test_what_was_tried_is_said(found: tuple[DesignFile, CarrySearch]) -> None:
    """Each trial once, as what it adds to which earlier one; what is offered, as the file asks."""
    _, search = found
    assert all(": " in each for each in search.tried)
    first, *others = search.tried
    assert first.startswith("the file: ")
    said = [TRIAL.match(each) for each in others]
    trials = [each for each in said if each is not None]
    numbers = [int(each["number"]) for each in trials]
    assert numbers == list(range(1, len(trials) + 1))
    for each in trials:
        assert each["base"] == "the file" or int(each["base"]) < int(each["number"])
    assert len({each["added"] for each in trials}) == len(trials)
    confirmed = [each for each, trial in zip(others, said, strict=True) if trial is None]
    assert all(" with cells as the file asks: " in each for each in confirmed)
    assert sum(": carries: " in each for each in confirmed) == len(search.found)


@thorough
def test_what_only_just_carries_with_few_cells_is_not_the_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where nothing carries with the file's cells, what spares some with fewer is looked for."""
    confirmed, asked = carry._Search._confirmed, list[list[carry_state.State]]()

    def in_vain_at_first(search: carry._Search) -> tuple[Carrying, ...]:
        asked.append(list(search.carrying))
        return confirmed(search) if len(asked) > 1 else ()

    monkeypatch.setattr(carry._Search, "_confirmed", in_vain_at_first)
    monkeypatch.setattr(carry, "SPARING", 0.095)  # the first that carries uses 10.8 %
    order = (carry_steps.flaps, *[carry_boards.thicker] * 2)
    monkeypatch.setattr(carry, "BUILDER", order)
    monkeypatch.setattr(carry, "DESIGNER", ())
    search = find_carrying(arch(tmp_path, snow=1900, lines=1e7))
    just, spared = asked
    assert max(each.lacks[-1] for each in spared) <= 0.095 < just[-1].lacks[-1] <= 1
    assert search.found
    assert not search.ended


def test_a_file_that_carries_is_left_alone(tmp_path: Path) -> None:
    search = find_carrying(arch(tmp_path, thickness=0.02, snow=60))
    assert search.begun.carries is True
    assert not search.found
    assert not search.tried


def test_the_search_ends_after_its_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(carry, "WORK", 1e-9)
    search = find_carrying(arch(tmp_path))
    assert search.ended
    assert not search.found
    assert search.nearest is not None


def test_changes_that_change_the_same_are_said_once() -> None:
    first = Change({"pattern.rows": 7, "deployment.ties": "folds"}, {"rows": "7 rows", "t": "ties"})
    both = first | Change({"pattern.rows": 9}, {"rows": "9 rows"})
    assert both.words == "9 rows, ties"
    assert both.values == {"pattern.rows": 9, "deployment.ties": "folds"}


def test_steps_propose_what_a_file_lacks(tmp_path: Path, weak: tuple[DesignFile, Analysis]) -> None:
    """And nothing where it has it: each change is a value that the file takes."""
    file, begun = weak
    for step in {*carry_steps.BUILDER, *carry_steps.DESIGNER}:
        for change in step(file, begun):
            changed = file.tried(change.values)
            assert changed.tables != file.tables
    held = file.tried(next(carry_feet.held_edges(file, begun)).values)
    assert not list(carry_feet.held_edges(held, begun))
    tied = file.tried(carry_steps.FOLDS)
    assert not list(carry_steps.ties_across_folds(tied, begun))
    rows = [each.values["deployment.ties"] for each in carry_steps.fewer_ties(tied, begun)]
    assert rows == ["feet", {"folds": [2, 5]}, {"folds": [2, 4]}]
    # A number is what its user knows of crease lines: no kind takes its place.
    assert not list(carry_steps.named_lines(file, begun))


def test_every_step_is_proposed_in_the_order_of_a_builder(
    weak: tuple[DesignFile, Analysis],
) -> None:
    """To pinned feet of whose crease lines nothing is known; rails and ballast are for others."""
    file, begun = weak
    bare = file.tried({"structure.line_strength": None, "structure.crease_strength": 1e3})
    steps = dict.fromkeys(carry_steps.BUILDER)
    proposed = [step for step in steps if list(step(bare, begun))]
    others = {carry_feet.base_rail, carry_feet.more_ballast, carry_feet.anchored}
    assert set(proposed) == set(steps) - others
    places = [list(steps).index(each) for each in (
        carry_feet.held_edges,
        carry_feet.base_rail,
        carry_steps.ties_across_folds,
        carry_steps.flaps,
        carry_boards.thicker,
        carry_boards.other_materials,
        carry_steps.gussets,
        carry_steps.box_girders,
        carry_steps.more_rows,
        carry_steps.deeper_waves,
        carry_steps.locked_creases,
    )]  # fmt: skip
    assert places == sorted(places)


def test_nothing_is_proposed_that_bears_nobody_knows_what(
    weak: tuple[DesignFile, Analysis],
) -> None:
    """Ties and locks without a strength; kinds of hinges where a membrane is the hinge."""
    file, begun = weak
    bare = file.tried({"structure.tie_strength": None, "structure.line_strength": None})
    assert not list(carry_steps.ties_across_folds(bare, begun))
    assert not list(carry_steps.locked_creases(bare, begun))
    assert list(carry_steps.named_lines(bare, begun))
    # A kind by name gives way to one that bears more in all directions, and to no other.
    piano, bolted = (
        list(carry_steps.named_lines(bare.tried({"structure.line_strength": kind}), begun))
        for kind in ({"kind": "piano hinge"}, {"kind": "bolted hinge"})
    )
    assert [each.words for each in piano] == ["bolted hinge along every crease"]
    assert not bolted
    film = bare.tried(ON_MEMBRANE)
    assert not list(carry_steps.named_lines(film, begun))


ON_MEMBRANE: dict[str, Any] = {
    "panel.construction": "sandwich", "panel.membrane": 0.0005, "panel.membrane_density": 1000,
}  # fmt: skip
NOT_GIVEN: dict[str, dict[str, Any]] = {
    "lines": {"structure.line_strength": None},
    "lines that bear no push": {"structure.line_strength": {"kind": "coated fabric"}},
    "creases": {"structure.crease_stiffness": ["free", "rigid"]},
    "ties": {"structure.tie_strength": None, "deployment.ties": "feet"},
    "membrane": ON_MEMBRANE,
}


@pytest.mark.parametrize("changes", NOT_GIVEN.values(), ids=NOT_GIVEN)
def test_strengths_that_are_not_given_come_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any]
) -> None:
    """What does without them is tried before any step; then all that is loaded is known.

    Feet slide, so that ties between them are taut.
    """
    supports = [{"at": "feet", "kind": "sliding"}] if "deployment.ties" in changes else None
    held = {} if supports is None else {"structure.supports": supports}
    file = standing(tmp_path, RIGID_FEET, "rigid" if supports else "free")
    given = {} if supports is None else {"structure.crease_strength": 1e6}
    file = file.tried({**given, **held, **changes})
    (missing, *_) = carry_strengths.not_given(file)
    asked: list[DesignFile] = []

    def first_step(file: DesignFile, _: Analysis) -> Iterator[Change]:
        asked.append(file)
        yield from ()

    monkeypatch.setattr(carry, "BUILDER", (first_step,))
    monkeypatch.setattr(carry, "DESIGNER", ())
    search = find_carrying(file)
    said = carry_strengths.in_words([missing])
    assert search.tried[1].startswith(said.partition(" and ")[0])
    assert asked
    assert all(not carry_strengths.not_given(each) for each in asked)
    assert search.nearest is not None
    _, analysis = search.nearest
    assert all(case.equilibrium is None or not case.equilibrium.unknown for case in analysis.cases)


def test_what_is_not_known_of_an_analysis_is_not_given_in_its_file(
    tmp_path: Path,
) -> None:
    """The file is asked, and not the analysis, as a shell that moves has no forces."""
    file = standing(tmp_path, RIGID_FEET, "rigid").tried({"structure.line_strength": None})
    for changes in ({}, ON_MEMBRANE):
        other = file.tried(changes)
        made = shell_of(other, trying(no_progress, "", LOADED)).analysis
        assert made is not None
        (case,) = made.cases
        assert case.equilibrium is not None
        assert set(case.equilibrium.unknown) == set(carry_strengths.not_given(other))


def test_a_strength_that_only_its_user_knows_ends_it_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Panels of one's own modulus: nothing is analysed, and what is to be given is named."""
    own = {"structure.material": None, "structure.modulus": 9e9}
    monkeypatch.setattr(carry, "shell_of", no_clock)
    with pytest.raises(DesignError, match=r"strength of panels is not .*give strength in"):
        find_carrying(arch(tmp_path).tried(own))


def test_changes_that_are_no_longer_needed_are_taken_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A rail beside feet that are anchored after it; what is left carries, typed in."""
    file = standing(tmp_path, SLIDING).tried(
        {
            "panel.thickness": 0.021,
            "deployment.ties": "folds",
            "load_case": [{"name": "snow", "snow": {"ground": 200, "arrangement": "undrifted"}}],
        }
    )
    monkeypatch.setattr(carry, "BUILDER", (railed, carry_feet.anchored))
    monkeypatch.setattr(carry, "DESIGNER", ())
    monkeypatch.setattr(carry, "LIGHTER", ())
    monkeypatch.setattr(carry_state.State, "is_nearer", lambda *_: True)
    search = find_carrying(file)
    assert any(" - a rail: carries: " in each for each in search.tried)
    for each in search.found:
        assert "rail" not in each.words
        assert each.changes.keys() == {"structure.supports"}
    assert search.found


def railed(_: DesignFile, __: Analysis) -> Iterator[Change]:
    """A base rail that is not enough."""
    sides = {"material": "steel", "width": 0.03, "height": 0.03, "wall": 0.002}
    yield Change({"structure.rail": sides}, {"rail": "a rail"})


def test_thicker_panels_weigh_more_where_the_file_says_what_they_weigh(
    tmp_path: Path, weak: tuple[DesignFile, Analysis]
) -> None:
    """In proportion; other boards weigh no more, or are the lightest sold."""
    _, begun = weak
    file = arch(tmp_path).tried({"workshop.areal_density": 5.0})
    (change,) = carry_boards.thicker(file, begun)
    before, after = 0.004, change.values["panel.thickness"]
    heavier = change.values["workshop.areal_density"]
    assert heavier == pytest.approx(5.0 * after / before, rel=1e-3)
    others = list(carry_boards.other_materials(file, begun))
    assert others
    sold = materials()
    for each in others:
        made, thickness = sold[each.values["structure.material"]], each.values["panel.thickness"]
        assert thickness in made.sold
        weighs = made.density_of(thickness) * thickness
        assert each.values["workshop.areal_density"] == pytest.approx(max(5.0, weighs))
        assert weighs <= 5.0 or thickness == made.sold[0]


def test_panels_are_as_thick_as_boards_are_sold(
    tmp_path: Path, weak: tuple[DesignFile, Analysis]
) -> None:
    """Rounded up, in the unit of the file; beyond the thickest it is said, and not tried."""
    file, begun = weak
    sold = materials()["birch plywood"].sold
    (change,) = carry_boards.thicker(file, begun)
    assert change.values["panel.thickness"] in sold
    offered = carry_boards.offer(file, begun.model)
    assert (offered.at_least(0.0091), offered.at_most(0.0119)) == (0.012, 0.009)
    assert offered.at_most(0.001) is None
    thickest = file.tried({"panel.thickness": 0.04})
    made = replace(begun, model=replace(begun.model, design=replace(
        begun.model.design, panel=thickest.panel
    )))  # fmt: skip
    (beyond,) = carry_boards.thicker(thickest, made)
    assert "no thicker board of birch plywood is on the market (40 mm)" in beyond.refused.replace(
        SPACE, " "
    )
    foam = file.tried({"structure.material": "GFRP skins on foam", "panel.thickness": 0.023})
    assert carry_boards.offer(foam, begun.model).at_least(0.0231) == 0.028
    # Two boards of 4 mm on a membrane of 0.5 mm.
    on_membrane = file.tried({
        "panel.construction": "sandwich", "panel.membrane": 0.0005, "panel.gap": None
    })  # fmt: skip
    assert carry_boards.offer(on_membrane, begun.model).at_least(0.0075) == 0.0085


def test_panels_of_ones_own_make_stay_plates(
    tmp_path: Path, weak: tuple[DesignFile, Analysis]
) -> None:
    """Where nobody knows what is sold, a tenth of the width of a panel is the most."""
    file, begun = weak
    own = file.tried({"structure.material": None, "structure.modulus": 9e9})
    offered = carry_boards.offer(own, begun.model)
    width = float(np.median(panel_widths(begun.model)))
    assert offered.at_least(1.0) == pytest.approx(0.1 * width, rel=0.05)
    assert "makes no plate" in offered.end


def test_what_a_refusal_offers_is_rounded_to_what_is_sold(
    weak: tuple[DesignFile, Analysis],
) -> None:
    """Panels of 13.37 mm are bought as 12 mm; of 1 mm there are none."""
    file, begun = weak
    offered = carry_boards.offer(file, begun.model)
    fits = Change({"panel.thickness": 0.01337}, {"thickness": "thickness = 0.01337 in [panel]"})
    bought = carry_boards.as_sold(file, offered, fits)
    assert bought is not None
    assert bought.values == {"panel.thickness": 0.012}
    assert bought.words.replace(SPACE, " ") == "panels 12 mm thick"
    assert carry_boards.as_sold(file, offered, Change({"panel.thickness": 0.001}, {})) is None
    metal = Change(
        {"structure.material": "steel", "panel.thickness": 0.004},
        {"material": "made of steel", "thickness": "panels 4 mm thick"},
    )
    thinner = metal.fitted(Remedy({"panel.thickness": 0.0031}), "panel.thickness")
    assert thinner is not None
    bought = carry_boards.as_sold(file, carry_boards.offer(file, begun.model, "steel"), thinner)
    assert bought is not None
    assert bought.words.replace(SPACE, " ") == "made of steel, panels 3 mm thick"
    assert carry_boards.as_sold(file, offered, Change(carry_steps.FOLDS, {})) is not None


def test_a_thickness_that_is_not_sold_is_said_and_not_made(
    weak: tuple[DesignFile, Analysis], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Cardboard under the snow of a mountain."""
    file, _ = weak
    made = materials()["corrugated cardboard"].sold
    cardboard = file.tried({
        "structure.material": "corrugated cardboard", "panel.thickness": made[-1]
    })  # fmt: skip
    monkeypatch.setattr(carry, "BUILDER", (carry_boards.thicker,))
    monkeypatch.setattr(carry, "DESIGNER", ())
    search = find_carrying(cardboard)
    _, *tried = search.tried  # the file itself
    assert tried
    end = "cannot be made, as no thicker board of corrugated cardboard is on the market (15 mm)"
    assert all(end in each.replace(SPACE, " ") for each in tried)


RIGID_FEET = '[{ at = "feet", kind = "pinned", edges = true }]'
SLIDING = '[{ at = "feet", kind = "friction", friction = 0.4 }]'
BALLAST = '[{ at = "feet", kind = "pinned", friction = 0.4, ballast = 5 }]'


def standing(directory: Path, supports: str, creases: str = "free") -> DesignFile:
    """The arch on other feet."""
    text = arch(directory).path.read_text(encoding="utf-8")
    text = text.replace('crease_stiffness = "free"', f'crease_stiffness = "{creases}"')
    old = '[{ at = "feet", kind = "pinned" }]'
    assert text.count(old) == 1
    path = directory / "standing.toml"
    path.write_text(text.replace(old, supports), encoding="utf-8")
    return read_design_file(path)


def test_feet_that_slide_are_joined_by_a_rail_or_anchored(
    tmp_path: Path, weak: tuple[DesignFile, Analysis]
) -> None:
    """Sections in the unit of the file, of EN 10219-2. Pinned feet need neither."""
    file, begun = weak
    assert not [*carry_feet.base_rail(file, begun), *carry_feet.anchored(file, begun)]
    slides = standing(tmp_path, SLIDING)
    assert not list(carry_feet.held_edges(slides, begun))
    first, second = carry_feet.base_rail(slides, begun)
    railed = slides.tried(first.values)
    assert railed.structure is not None
    rail = railed.structure.rail
    assert rail is not None
    assert (rail.material, rail.width, rail.height, rail.wall) == ("steel", 0.06, 0.04, 0.003)
    assert second.words.replace(SPACE, " ") == "a steel base rail, 100 mm x 60 mm x 4 mm"
    assert not list(carry_feet.base_rail(railed, begun))
    anchors = list(carry_feet.anchored(slides, begun))
    assert [each.words for each in anchors] == [
        "feet anchored along their edges",
        "feet anchored at points",
    ]
    for held, edges in zip(anchors, (True, False), strict=True):
        anchored = slides.tried(held.values).structure
        assert anchored is not None
        (support,) = anchored.supports
        assert (support.at, support.kind, support.edges) == ("feet", "pinned", edges)
        assert support.friction == 0


def test_a_canopy_is_anchored_at_its_ends(
    tmp_path: Path, weak: tuple[DesignFile, Analysis]
) -> None:
    """Where it stands, and not at feet that it has not; a rail is for rows of feet."""
    _, begun = weak
    ends = standing(tmp_path, SLIDING.replace("feet", "ends"))
    assert not list(carry_feet.base_rail(ends, begun))
    held = next(carry_feet.anchored(ends, begun))
    assert held.words == "ends anchored along their edges"
    (support,) = held.values["structure.supports"]
    assert support == {"at": "ends", "kind": "pinned", "edges": True}
    both = standing(tmp_path, f"{SLIDING[:-1]}, {{ at = [[1, 1]], kind = 'sliding' }}]")
    assert next(carry_feet.anchored(both, begun)).words == "supports anchored along their edges"


def test_ballast_grows_to_what_the_feet_need(tmp_path: Path) -> None:
    """Pushed aside by half of what presses on it, at friction of 0.4: L/4h of a parabola.

    One foot uses most of its ballast, another may then need more.
    """
    file = standing(tmp_path, BALLAST, "rigid")
    masses = [5.0]
    for _ in range(4):
        made = shell_of(file, trying(no_progress, "", LOADED)).analysis
        assert made is not None
        change = next(carry_feet.more_ballast(file, made), None)
        if change is None:
            break
        (support,) = change.values["structure.supports"]
        masses.append(support["ballast"])
        file = file.tried(change.values)
    assert len(masses) > 1
    assert masses == sorted(set(masses))
    assert change is None
    assert made is not None
    # Anchors take its place, in words as well.
    heavy = Change({}, {"ballast": "ballast of 9 kg at every foot"})
    for each in carry_feet.anchored(file, made):
        assert "ballast" not in each.values["structure.supports"][0]
        assert (heavy | each).words == each.words
    assert all(each.kind not in ("lifts off", "slips") for each in made.cases[0].findings)


def test_gussets_are_few_first_then_more(weak: tuple[DesignFile, Analysis]) -> None:
    """Every fourth column, every second, all, then all rows; none beside hinges of whole boards."""
    file, begun = weak
    places = []
    for _ in range(4):
        change = next(carry_steps.gussets(file, begun))
        file = file.tried(change.values)
        asked = file.stiffeners
        assert asked is not None
        places.append((asked.rows, asked.columns))
    assert places == [("valleys", 4), ("valleys", 2), ("valleys", 1), ("all", "all")]
    assert not list(carry_steps.gussets(file, begun))
    whole = weak[0].tried({"panel.construction": "hinged", "panel.gap": None})
    assert not list(carry_steps.gussets(whole, begun))


def test_gussets_are_said_by_place_and_column(weak: tuple[DesignFile, Analysis]) -> None:
    file, begun = weak
    said = []
    for _ in range(4):
        change = next(carry_steps.gussets(file, begun))
        file = file.tried(change.values)
        said.append(change.words)
    assert said == [
        "gussets in the valleys, every 4th column",
        "gussets in the valleys, every 2nd column",
        "gussets in the valleys, every column",
        "gussets in the valleys and on the crests, every column",
    ]


def test_box_girders_take_the_place_of_gussets(weak: tuple[DesignFile, Analysis]) -> None:
    """With nothing of what gussets only have; and gussets that of no girders."""
    file, begun = weak
    own = {"stiffeners.kind": "gussets", "stiffeners.share": 0.5, "stiffeners.thickness": 0.01}
    held = file.tried(own)
    said, places = [], []
    for _ in range(4):
        change = next(carry_steps.box_girders(held, begun))
        held = held.tried(change.values)
        asked = held.stiffeners
        assert asked is not None
        assert (asked.kind, asked.share, asked.thickness) == ("boxes", "auto", None)
        said.append(change.words)
        places.append((asked.rows, asked.columns))
        assert not list(carry_steps.gussets(held, begun))
    assert places == [("valleys", 4), ("valleys", 2), ("valleys", 1), ("all", "all")]
    assert said[0] == "box girders over the valleys, plates at every 4th column"
    assert not list(carry_steps.box_girders(held, begun))


def test_stiffeners_come_with_what_holds_them(weak: tuple[DesignFile, Analysis]) -> None:
    """The strongest kind of which all is known, said, where the file gives less than all."""
    file, begun = weak
    fixed = {"structure.edge_strength": {"kind": "bolted hinge"}}
    for step in (carry_steps.gussets, carry_steps.box_girders):
        for given in (None, {"pull": 150e3, "along": 150e3}):
            change = next(step(file.tried({"structure.edge_strength": given}), begun))
            assert change.values.items() >= fixed.items()
            assert change.words.endswith("bolted hinge along edges of gussets and plates")
        assert "structure.edge_strength" not in next(step(file, begun)).values


def test_what_holds_gussets_comes_first(weak: tuple[DesignFile, Analysis]) -> None:
    """Of a file that has them already, and of plates across girders; not where there are none."""
    file, begun = weak
    stiffened = file.tried({"stiffeners.kind": "gussets", "structure.edge_strength": None})
    assert carry_strengths.not_given(stiffened) == ["plate_edges"]
    ((step, _),) = [each for each in carry_strengths.MAKES_KNOWN if "plate_edges" in each[1]]
    held = stiffened.tried(next(step(stiffened, begun)).values)
    assert not carry_strengths.not_given(held)
    kinds = {"stiffeners.kind": "boxes", "stiffeners.columns": "none"}
    assert not carry_strengths.not_given(stiffened.tried(kinds))
    assert carry_strengths.not_given(stiffened.tried({"stiffeners.kind": "boxes"}))


@pytest.mark.parametrize("step", [carry_steps.gussets, carry_steps.box_girders])
def test_stiffeners_bring_an_arch_on_free_hinges_nearer(
    weak: tuple[DesignFile, Analysis], step: carry_change.Step
) -> None:
    """Every fourth column is enough for what its worst case uses to fall."""
    file, begun = weak
    change = next(step(file, begun))
    trials = LoadTrials(file, begun, no_progress)
    made = trials.made(change.values, change.words, quick=True)
    assert not isinstance(made, Refused)
    assert made.analysis is not None
    assert made.analysis.model.design.attached
    used = [max(case.used for case in each.cases) for each in (begun, made.analysis)]
    assert used[1] < used[0]


def test_what_a_refusal_offers_takes_the_place_of_a_change() -> None:
    """Of the same table only; a value that is offered for the same key is said instead."""
    ties = Change(carry_steps.FOLDS, {"ties": "ties across the folds"})
    rows = Remedy({"deployment.ties": {"folds": [1, 3]}})
    fitted = ties.fitted(rows)
    assert fitted is not None
    assert fitted.values == rows.changes
    assert fitted.words == "ties = { folds = [1, 3] } in [deployment]"
    assert ties.fitted(Remedy({"pattern.rows": 7})) is None
    plates = Change({"stiffeners.kind": "gussets"}, {"stiffeners": "gussets in every column"})
    smaller = plates.fitted(Remedy({"stiffeners.share": 0.7}))
    assert smaller is not None
    assert smaller.words == "gussets in every column, share = 0.7 in [stiffeners]"


def test_the_command_writes_design_files(
    tmp_path: Path, found: tuple[DesignFile, CarrySearch], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Those of the table, with the comments of the file; of the search itself see above."""
    _, search = found
    arch(tmp_path)
    monkeypatch.setattr(carry, "find_carrying", lambda *_: search)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--out", "out", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Designs that carry, the lightest first" in done.stdout
    for number, each in enumerate(search.found, start=1):
        path = tmp_path / "out" / f"carries-{number}.toml"
        assert path.name in done.stdout.partition("What was tried")[0]
        assert path.read_text(encoding="utf-8").startswith("# a small arch")
        written = read_design_file(path)
        assert written.tables == arch(tmp_path).changed(each.change.values).tables
        assert each.change.words.replace(SPACE, " ") in " ".join(done.stdout.split())
        assert each.left in " ".join(done.stdout.split())
    _, told = done.stdout.split("Designs that carry, the lightest first")
    told = told.partition("wrote ")[0]
    assert all(len(line) <= carry_cli.WIDTH for line in told.splitlines())


def test_where_none_carries_it_ends_with_status_1(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing makes crease lines of a model bear the snow of a mountain."""
    arch(tmp_path, snow=9e4, lines=10.0)
    monkeypatch.setattr(carry, "WORK", 0.05)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--out", "out", cwd=tmp_path)
    assert done.returncode == 1
    assert "No design was found that carries." in done.stdout
    assert "Nearest came" in done.stdout
    assert "more would have taken too long" in done.stdout
    assert not (tmp_path / "out" / "carries-1.toml").exists()


def test_json_has_what_was_found_and_tried(
    tmp_path: Path, found: tuple[DesignFile, CarrySearch], monkeypatch: pytest.MonkeyPatch
) -> None:
    _, search = found
    arch(tmp_path)
    monkeypatch.setattr(carry, "find_carrying", lambda *_: search)
    done = orishell("structure", "arch.toml", "--make-it-carry", "--json", cwd=tmp_path)
    told = json.loads(done.stdout)
    assert [each["changes"] for each in told["found"]] == [
        dict(each.change.values) for each in search.found
    ]
    assert told["tried"] == list(search.tried)
    assert told["carries"] is False
