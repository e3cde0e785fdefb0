"""What a family hands over when a design succeeds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field, replace
from typing import Any, Literal

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.formatting import tidy_degrees
from orishell.conventions.record import record
from orishell.conventions.row import Note
from orishell.curves.nearest import Closeness
from orishell.design.asked import AskedSurface
from orishell.design.boxes import Box
from orishell.design.carried import CarriedPart
from orishell.design.end_walls import BuiltEndWall
from orishell.design.panel import PanelSpec
from orishell.design.part import Part
from orishell.motion import Mechanism
from orishell.motion.complex import Complex
from orishell.motion.hinge_lines import IN_CREASES, HingeLines
from orishell.motion.layout import has_flaps
from orishell.numerics.arrays import Array

FlapSide = Literal["start", "end"]
"""To which end of f a flap folds."""

Fixing = Literal["any", "all"]
"""Whether each of several parts does something by itself, or all of them together."""

Parameter = float | int | str | list[float] | list[str]


@record
class Approached:
    """The surface that finer and finer shells approach, where that is not f swept along g."""

    what: str  # A sentence that says what it is, with its sizes in the unit of the curves
    surface: AskedSurface | None  # the surface, or None where it has no simple form


@record
class Design:
    """A design that can be made: the folding sheet, its target, and what was chosen for it."""

    mechanism: Mechanism
    # What the family used and found, as the report says it: degrees (``_deg``) and the unit of the
    # curves. What others need of them are properties: ``flap``, ``flap_sides``, ``offset``.
    parameters: Mapping[str, Parameter]
    # the target curves "f" and "g" (N, 3), placed as the locked shell meets them; empty without a
    # target
    targets: Mapping[str, Array]
    # distance of the polylines the shell locks on to the target curves, by the same names
    closeness: Mapping[str, Closeness]
    # the surface asked for: f swept along g, placed as the locked shell meets it, formulas or a
    # mesh; None without a target
    swept: AskedSurface | None
    # sentences a user should read: the design is made, but may not be what was meant
    warnings: tuple[str, ...]
    # what the family approaches instead of the surface, if it does
    approached: Approached | None = None
    # how f or g lie in the surface asked for otherwise than they are drawn, in words; empty where
    # they lie as drawn
    tilted: str = ""
    # what a fit found, with which that of a surface nearby may begin; None where none was made
    fitted: object | None = None
    # where the frame of all these coordinates stands in the world (3,): it is added when world
    # coordinates are written, so that a shell far from the origin keeps its digits until then
    origin: Array = field(default_factory=lambda: np.zeros(3))
    # The sheet with the flaps that are clipped on at the target; None if there are none. They are
    # no part of ``mechanism``.
    clipped: Mechanism | None = None
    # other parts that go with the sheet, each with the states in which it is there
    attached: tuple[Part, ...] = ()
    # whether plates among them keep the whole sheet still at its target: any one of them alone, or
    # all together; None if it is not known that they do
    fixed_by: Fixing | None = None
    # what moves with the sheet: sleeves that close rows of it to box girders, or a second skin
    carried: tuple[CarriedPart, ...] = ()
    # walls among them that close its ends once it stands
    end_walls: tuple[BuiltEndWall, ...] = ()
    largest_fold: float = np.pi  # how far its hinges close (radians)
    # what its panels are made of, which limits how far they fold; None if they have no thickness
    panel: PanelSpec | None = None
    # where the hinges are: in the creases, or beside them where panels are whole boards
    hinges: HingeLines = IN_CREASES
    # how far boards stand off sides of panels (F, 4) at least (length); None: as creases ask for
    stand_off: Array | None = None
    # vertices (rows, columns, 3) of the sheet without a thickness that meets the target, where
    # whole boards were fitted to it instead; None for others
    meant: Array | None = None
    # whether boards are set back for the way to the pack, and not to the target alone
    opens_from_pack: bool = False
    may_stand: bool = False  # whether its first and last rows may be feet although it has no f
    # the design with its motion ending at a drive (radians), where neither a target nor a stage
    # says where it ends; otherwise None
    ending_at: Callable[[float], Design] | None = None
    # the sheet with its rim moved to level feet, by the value of ground in [pattern] that asks for
    # it; raises DesignError if that has none. None if the family cannot.
    grounded: Callable[[Literal["corners", "level"]], Mechanism] | None = None
    # the key of [pattern] that says how far it is folded at its target, where it has none to meet:
    # its drive, or its largest fold angle
    folded_by: Literal["stage_deg", "fold_deg"] = "fold_deg"
    # what would make its flat sheet smaller, and what may level its feet, in words; "" where the
    # family knows nothing
    smaller_by: str = ""
    levelled_by: str = ""
    # Where f and g were fitted to a surface: values of keys of the design file with which it asks
    # for the same shell by f and g in place of the surface. None removes a key.
    by_curves: Mapping[str, Any] = field(default_factory=dict)

    @property
    def flap(self) -> float:
        """Width of its flaps in the unit of the curves, 0 if it has none."""
        return self._figure("flap") or 0.0

    @property
    def flap_sides(self) -> tuple[str, ...]:
        """The ends of f to which the left and the right flap fold; none where that is no choice."""
        sides = self.parameters.get("flap_side", ())
        assert isinstance(sides, list | tuple)
        return tuple(map(str, sides))

    @property
    def stop_deg(self) -> float:
        """By how much its flaps stop short of folding flat at the target (degrees)."""
        return self._figure("stop_deg") or 0.0

    @property
    def offset(self) -> float | None:
        """How far crests lie above the surface, and valleys below it, in the unit of the curves.

        None where they follow no surfaces beside it.
        """
        return self._figure("offset")

    def _figure(self, name: str) -> float | None:
        """A number among the parameters, or None if it is none of them."""
        found = self.parameters.get(name)
        assert found is None or isinstance(found, float | int)
        return None if found is None else float(found)

    def with_clipped_flaps(self) -> Design:
        """The design whose flaps are no part of the folding sheet: clipped on at the target."""
        if not has_flaps(self.mechanism):
            return self
        bare = self.mechanism.without_flaps()
        return replace(self, mechanism=bare, clipped=self.mechanism)

    def with_stop(self, stop: float) -> Design:
        """The design whose flaps stop short of folding flat at the target (radians).

        Raises
        ------
        DesignError
            If the sheet cannot have such flaps.
        """
        mechanism = self.mechanism.with_stop(stop)
        if not stop or not has_flaps(mechanism):
            return replace(self, mechanism=mechanism)
        parameters = {**self.parameters, "stop_deg": tidy_degrees(stop)}
        return replace(self, mechanism=mechanism, parameters=parameters)

    def ended_at(self, drive: float) -> Design:
        """The design with its motion ending at a drive, where nothing says where it ends (radians).

        Its hinges and panels stay what they are.
        """
        assert self.ending_at is not None
        return replace(
            self.ending_at(drive),
            largest_fold=self.largest_fold,
            panel=self.panel,
            hinges=self.hinges,
            opens_from_pack=self.opens_from_pack,
        )

    @property
    def has_whole_boards(self) -> bool:
        """Whether its panels are whole boards on hinges beside the creases."""
        return self.panel is not None and self.panel.construction == "hinged"

    @property
    def set_back(self) -> PanelSpec | None:
        """What its panels are made of, if boards stand back from creases and meet about them."""
        return None if self.has_whole_boards else self.panel

    @property
    def flapped(self) -> Mechanism:
        """The sheet with all its flaps, those that are clipped on at the target as well."""
        return self.clipped or self.mechanism

    @property
    def moving(self) -> Mechanism:
        """All that folds: the sheet, and strips that it carries."""
        if not self.carried:
            return self.mechanism
        return Complex(self.mechanism, tuple(each.strips for each in self.carried))

    @property
    def boxes(self) -> tuple[Box, ...]:
        """Box girders among what it carries."""
        return tuple(each for each in self.carried if isinstance(each, Box))

    @property
    def plates(self) -> tuple[Part, ...]:
        """Parts that stiffen it: plates hinged on the sheet at its target."""
        return tuple(part for part in self.attached if part.plate is not None)

    @property
    def in_pieces(self) -> bool:
        """Whether whole boards fold in pieces, which are joined at the target."""
        return bool(self.hinges.joint_rows)

    @property
    def surface(self) -> AskedSurface:
        """The surface asked for: f swept along g, or that of [target.surface].

        Raises
        ------
        InputError
            If the design has no target.
        """
        if self.swept is None:
            raise InputError(
                "a design without a target has no surface to be compared with",
                remedy="give f and g, or a surface",
            )
        return self.swept

    def __repr__(self) -> str:
        near = ", ".join(f"{name} to {near.max:.4g}" for name, near in self.closeness.items())
        met = f"; meets {near}" if near else ""
        count = len(self.warnings)
        warned = f"; {count} warning{'s' * (count > 1)}" if count else ""
        return f"{type(self).__name__}({self.mechanism!r}{met}{warned})"


def warn_of_no_lock(flap: float) -> tuple[str, ...]:
    """Warn of a shell whose flaps have no width: nothing stops it at its target.

    Parameters
    ----------
    flap
        Width of the flaps, in the unit of the curves; 0 if there are none.
    """
    if flap:
        return ()
    return (
        Note(
            "without flaps (flap = 0) nothing but its supports keeps the shell from closing beyond "
            "its target",
            "no flaps",
        ),
    )
