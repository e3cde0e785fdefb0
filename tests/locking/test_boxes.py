"""Box girders on random shells: manifold3d finds nothing before the proved ends of the motion."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest

from design_tables import Tables, made, mended
from mechanisms import flat_foldable, random_net, sleeves_of
from orishell.conventions.errors import DesignError, InputError
from orishell.design import Design
from orishell.design.stiffeners import Stiffeners
from orishell.document import Document
from orishell.families.flat_foldable.named import graded_net
from orishell.locking import lock_without_clash
from orishell.locking.boxes import NARROWEST, BoxPlace
from orishell.locking.carry import with_carried
from orishell.locking.result import Contact
from orishell.motion.complex import Complex
from orishell.motion.layout import has_flaps, points_of
from orishell.motion.sizes import CONTACT_TOLERANCE
from orishell.motion.sleeves import Sleeve, SleeveForms
from orishell.shell.make import Shell
from orishell.solids.carried import moving_boards
from overlaps import NOTHING, solids
from rigid_rank import freedoms_of_complex
from samples import THOROUGH, thorough
from stiffened import bodies, common, random_design, shell_of, thin_solids

QUICK, ALL = (1, 2, 5, 8, 9), 60
STATES, FEW = 40, 8
BEYOND = np.deg2rad(0.5)


@cache
def boxed(number: int) -> tuple[Tables, Shell | DesignError]:
    """The first random design of a number with box girders, and its shell or why there is none."""
    for attempt in itertools.count():
        design = random_design(number, attempt)
        draw = np.random.default_rng([number, attempt, 7])
        design["stiffeners"] = {
            "kind": "boxes",
            "rows": str(draw.choice(["valleys", "crests", "all"])),
            "share": "auto" if draw.integers(2) else round(float(draw.uniform(0.2, 0.95)), 3),
            "columns": ["all", 2, "none"][draw.integers(3)],
        }
        design["motion"] = {"frames": STATES if THOROUGH else FEW}
        if design.get("deployment", {}).get("flap_attachment") == "clipped":
            design["deployment"]["from"] = "pack"
        if "panel" in design:
            design["panel"]["thickness"] = round(0.3 * design["panel"]["thickness"], 6)
        try:
            return design, shell_of(design)
        except InputError:
            continue
        except DesignError as error:
            if any(key.startswith("stiffeners.") for key in error.keys):
                return design, error
    raise AssertionError


def test_random_designs_have_box_girders_or_a_reason() -> None:
    """So the test below sees some of each."""
    found = [boxed(number)[1] for number in QUICK]
    assert sum(isinstance(each, Shell) for each in found) >= len(QUICK) // 2


@pytest.mark.parametrize("number", range(ALL) if THOROUGH else QUICK)
def test_nothing_meets_where_the_motion_is_proved(number: int) -> None:
    """Volume that strips have in common with others, in states between both ends of the proof."""
    design, shell = boxed(number)
    if isinstance(shell, DesignError):
        require_reason(design, shell)
        return
    motion, document = shell.lock.boxes, shell.document
    assert motion is not None
    assert shell.design.boxes
    looked = 0
    # Panels without a thickness lie on each other where they are shut.
    shut = 1e-5 if document.boards is None else -1e-9
    for state in states_between(document, motion.joined_from, shell.lock.closes_to * (1 - shut)):
        names, found = bodies(document, state)
        total = sum(each.volume() for each in found)
        assert max(common(names, found, "box").values(), default=0.0) < NOTHING * total
        looked += 1
    assert looked
    if shell.report.deployment.plates:
        require_plates(shell)


@thorough
@pytest.mark.parametrize("number", range(ALL))
def test_what_is_named_has_volume_in_common(number: int) -> None:
    """Half a degree beyond where two panels are said to meet; none where that is proved clear.

    What is not proved names what could not be told apart: there is nothing to be found of that.
    """
    shell = boxed(number)[1]
    if isinstance(shell, DesignError):
        return
    motion = shell.lock.boxes
    assert motion is not None
    for met in (motion.opening, motion.closing):
        if met is not None and met.apart is None and not any("flap" in each for each in met.names):
            away = np.copysign(BEYOND, met.drive - shell.lock.target_drive)
            assert pair_volume(shell, met, met.drive + away) > 0
            assert pair_volume(shell, met, met.clear_until) == 0


def pair_volume(shell: Shell, met: Contact, drive: float) -> float:
    """Volume in common of two panels of sheet and strips in a state, as a share of both."""
    whole, built = shell.design.moving, shell.lock.built
    assert isinstance(whole, Complex)
    names = [f"panel {each}" for each in whole.layout.names[: whole.grid.panel_count].tolist()]
    names += [name for box in shell.design.boxes for name in box.names]
    both = [names.index(each) for each in met.names]
    faces, points = whole.layout.faces, points_of(whole, drive)
    if built is None:
        return volume_of(thin_solids(points, faces[both]))
    every = moving_boards(built.boards, whole, shell.design.boxes)
    corners = every.carried(faces, points_of(whole, 0.0)[:, :2], points)
    shares = []
    for first, other in itertools.product(*(np.flatnonzero(every.panels == each) for each in both)):
        own = np.array([first, other])
        shares.append(volume_of(solids(corners[own], every.chosen(own))))
    return max(shares)


def volume_of(found: list[Any]) -> float:
    """What two solids have in common, as a share of both."""
    first, other = found
    return float((first ^ other).volume() / (first.volume() + other.volume()))


def require_plates(shell: Shell) -> None:
    """Plates have no volume in common with anything, and hold what they are said to hold."""
    names, found = bodies(shell.document)
    total = sum(each.volume() for each in found)
    assert max(common(names, found, "plate").values(), default=0.0) < NOTHING * total
    whole = shell.design.moving
    assert isinstance(whole, Complex)
    rows = [sleeve.row for sleeve in sleeves_of(whole)]
    at = [
        each.split(" ")[1].split(",") for part in shell.design.attached for each in part.names
        if part.kind == "plate"
    ]  # fmt: skip
    plates = [(rows.index(int(r)), int(c) - whole.strips[0].columns.start) for r, c in at]
    assert len(plates) == shell.report.deployment.plates
    target = whole.target_drive
    if has_flaps(whole.sheet):
        return  # creases of flaps that are shut do not turn to first order
    together = freedoms_of_complex(whole, target, plates)
    assert (together == 0) == (shell.design.fixed_by is not None)
    if shell.design.fixed_by == "any":
        assert not any(freedoms_of_complex(whole, target, [each]) for each in plates[::5])


def require_reason(design: Tables, error: DesignError) -> None:
    """It says where; what the program offers, having tried it, works."""
    assert error.place
    try:
        made(design)
    except DesignError as refused:
        for remedy in refused.remedies:
            assert shell_of(mended(design, remedy)).design.boxes


def states_between(document: Document, start: float, stop: float) -> Iterator[int]:
    """Numbers of the states whose drives (radians) are in a range."""
    for number, state in enumerate(document.states):
        assert state.drive_deg is not None
        if np.rad2deg(start) <= state.drive_deg <= np.rad2deg(stop):
            yield number


@pytest.mark.parametrize("share", [0.4, 0.9])
def test_vectors_accelerate_no_more_than_edges_in_between(share: float) -> None:
    """Of any two vertices of a sheet with sleeves, by differences; the claim of the proof's bounds.

    A vector between vertices of two panels accelerates no more than the edges of the sheet along
    rows and down columns from the first to the last of both, added up.
    """
    whole = flat_foldable(random_net(6, 5, 2))
    forms = [SleeveForms.of(whole, row, slice(0, 7)) for row in range(1, 7)]
    sleeves = [Sleeve.over(whole, each, min(share, each.largest(0.05))) for each in forms]
    both = Complex(whole, tuple(sleeves))
    step, layout = 1e-3, both.layout
    for drive in (0.4, 1.2, both.target_drive):
        near = [points_of(both, drive + k * step) for k in (-1.0, 0.0, 1.0)]
        swing = (near[0] - 2 * near[1] + near[2]) / step**2
        along, down = both.edge_accelerations(*(np.array([drive + k * step]) for k in (-1.0, 1.0)))
        first, last = layout.first, layout.last
        low = np.minimum(first[:, None], first)
        high = np.maximum(last[:, None], last)
        sums = [np.concatenate([[0.0], np.cumsum(each[0])]) for each in (down, along)]
        bound = sum(each[high[..., k]] - each[low[..., k]] for k, each in enumerate(sums))
        corners = swing[layout.faces]
        apart = corners[:, None, :, None] - corners[None, :, None, :]
        found = np.linalg.norm(apart, axis=-1).max(axis=(2, 3))
        assert (found <= np.asarray(bound) * (1 + 1e-5) + 1e-6).all()


def test_bad_rows_and_whole_boards_are_refused() -> None:
    design: dict[str, Any] = random_design(2, 0)
    design["stiffeners"] = {"kind": "boxes", "rows": [99]}
    with pytest.raises(InputError, match="row"):
        shell_of(design)


def converging() -> tuple[Design, BoxPlace, Stiffeners]:
    """A sheet whose columns run together in some rows, asked for sleeves out of proportion."""
    net = graded_net(
        4, 4, folds=[0.4696, 2.4258], sectors=[1.4466, 1.3419],
        row_lengths=[1.7633, 0.7314], column_lengths=[1.9514, 1.3053],
    )  # fmt: skip
    design = Design(flat_foldable(net), {}, {}, {}, None, ())
    asked = Stiffeners(kind="boxes", rows="all", share=0.98)
    lock = lock_without_clash(design)
    return design, BoxPlace(design, lock, asked, CONTACT_TOLERANCE), asked


def test_a_share_that_columns_leave_no_room_for_is_refused_with_one_that_works() -> None:
    """A strip's sides would be narrow, or cross; a row has what it has room for at the most."""
    design, place, asked = converging()
    with pytest.raises(DesignError, match="narrower") as caught:
        with_carried(design, place.lock, asked, CONTACT_TOLERANCE)
    offered = next(iter(caught.value.candidates)).changes["stiffeners.share"]
    assert isinstance(offered, float)
    most = place.narrowest().largest(NARROWEST)
    assert most * (1 - 1e-3) < offered <= most
    for share, shares in ((offered, 1), (0.98, 2)):
        sleeves = place.sleeves(share)
        assert min(each.widths.min() for each in sleeves) == pytest.approx(NARROWEST, rel=1e-2)
        assert len({each.share for each in sleeves}) >= shares
        assert max(each.share for each in sleeves) == pytest.approx(share)
    bare = Sleeve.over(design.mechanism, place.narrowest(), 0.98)
    assert bare.widths.min() < NARROWEST
