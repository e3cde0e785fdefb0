"""What is asked of a shell, in a form in which single values can be changed and tried."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal, Self

import numpy as np

from orishell.conventions.formatting import in_degrees, in_one_line, rounded
from orishell.curves import Curve, curve_from_formulas, parse_formula
from orishell.design import Design, PanelBuild
from orishell.errors import DesignError, Remedy, Value
from orishell.families.pattern import Pattern
from orishell.families.registry import FAMILIES
from orishell.locking.lock import CONTACT_TOLERANCE
from orishell.motion import drive_at_fold, largest_fold
from orishell.solids import drive_for_height, find_room, find_stop, thinner, wide_gap

ROUNDING = 1e-9
"""By so much a fold angle at the target may exceed what hinges allow (radians)."""
LEAST = 1e-3
"""A sheet without a target is folded this share of the way at least, or refused."""
UP = 5e-4
"""A fold angle that is offered is so much above what is needed (degrees)."""


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """The family's parameters, the target curves, and the distance at which panels touch.

    Parameters
    ----------
    pattern
        The family's parameters.
    target
        The target curves f and g, or None.
    tolerance
        Distance at which panels touch, relative to the diagonal of the flat sheet.
    clipped
        Whether flaps are clipped on at the target, and no part of the folding sheet.
    largest_fold
        How far hinges close (radians).
    from_pack
        Whether the shell is to be opened from a pack, beyond its target.
    panel
        What panels are made of; None if they have no thickness.
    """

    pattern: Pattern
    target: tuple[Curve, Curve] | None
    tolerance: float = CONTACT_TOLERANCE
    clipped: bool = False
    largest_fold: float = np.pi
    from_pack: bool = False
    panel: PanelBuild | None = None

    __repr__ = in_one_line

    @property
    def quick(self) -> bool:
        """Whether rows and columns are known without a search."""
        return True

    def sized(self) -> Request:
        """The request with its rows and columns settled: here they are given."""
        return self

    def designed(self) -> Design:
        """The design that is asked for, before its path is examined for contact.

        Raises
        ------
        DesignError
            If the family cannot make it, or hinges or boards do not close as far as its target
            asks, also where flaps with boards stop short of folding flat.
        """
        design = (
            self.pattern.design_without_target()
            if self.target is None
            else self.pattern.design(*self.target)
        )
        design = replace(design, largest_fold=self.largest_fold)
        if self.panel is not None:
            reach: Literal["target", "pack"] = "pack" if self.from_pack else "target"
            design = _with_panels(design, replace(self.panel, reach=reach))
        design = design.with_clipped_flaps() if self.clipped else design
        design = _as_far_as_it_goes(design)
        _require_hinges(design, self.from_pack)
        _require_room(design)
        return design

    def changed(self, remedy: Remedy) -> Self:
        """The request with other values at keys of the design file."""
        tables: dict[str, dict[str, Value | None]] = {}
        for key, value in remedy.changes.items():
            table, _, name = key.rpartition(".")
            tables.setdefault(table, {})[name] = value
        family = tables.get("shell", {}).get("family")
        model = type(self.pattern) if family is None else FAMILIES[str(family)].pattern
        deployment = tables.get("deployment", {})
        fold = deployment.get("largest_fold_deg", np.rad2deg(self.largest_fold))
        assert isinstance(fold, float | int)
        return replace(
            self,
            clipped=deployment.get("flap_attachment", None) == "clipped" or self.clipped,
            largest_fold=float(np.deg2rad(fold)),
            from_pack=self.from_pack and deployment.get("from") != "flat",
            panel=_changed_panel(self.panel, tables.get("panel", {})),
            pattern=self.pattern.changed(tables.get("pattern", {}), model),
            target=self.target
            and (
                _changed(self.target[0], tables.get("target.f", {})),
                _changed(self.target[1], tables.get("target.g", {})),
            ),
        )


def _as_far_as_it_goes(design: Design) -> Design:
    """The design, ended where hinges or boards let it go no further, if nothing else ends it."""
    if design.ending_at is None:
        return design
    mechanism, build = design.mechanism, design.panel
    end = drive_at_fold(mechanism, design.largest_fold)
    if build is not None:
        end = drive_for_height(
            mechanism, build.height, end, build.share, build.setback, gap=build.gap
        )
    target = mechanism.target_drive
    return design if end >= target else design.ended_at(max(end, LEAST * target))


def _require_hinges(design: Design, from_pack: bool) -> None:
    """Refuse hinges that do not close as far as the target asks; a pack asks for more."""
    mechanism, limit = design.mechanism, design.largest_fold
    if limit >= np.pi:
        return
    needed = float(largest_fold(mechanism, np.array([mechanism.target_drive]))[0])
    if needed <= limit + ROUNDING:
        return
    clipped = [Remedy({"deployment.flap_attachment": "clipped"})] if mechanism.flap_columns else []
    asked = 180.0 if from_pack else rounded(float(np.rad2deg(needed)) + UP, 6)
    raise DesignError(
        "hinges do not close as far as the target asks",
        keys=("deployment.largest_fold_deg",),
        size=f"a crease folds by {in_degrees(needed)} degrees there, hinges by at most "
        f"{in_degrees(limit)}",
        candidates=[*clipped, Remedy({"deployment.largest_fold_deg": min(asked, 180.0)})],
        excess=(needed - limit) / np.pi,
    )


def _with_panels(design: Design, panel: PanelBuild) -> Design:
    """The design with panels of a thickness: its flaps stop where their boards meet."""
    flaps = design.mechanism.flap_columns
    stop = 0.0 if not flaps else panel.stop
    if stop is None:
        stop = find_stop(design.mechanism, panel)
    return replace(design.with_stop(stop), panel=replace(panel, stop=stop))


def _require_room(design: Design) -> None:
    """Refuse boards so thick that they take too much of a panel at the target."""
    build = design.panel
    if build is None:
        return

    sheet = design.clipped or design.mechanism
    room = find_room(sheet, build)
    if build.thickness <= room.thickness:
        return
    place = f"at the target, {room.crease}"
    if not room.thickness and find_room(sheet, replace(build, gap=0.0)).thickness:
        raise wide_gap(build, place, lambda other: find_room(sheet, other).thickness)
    earlier = [Remedy({"panel.stop_deg": "auto"})] if room.on_flap else []
    raise DesignError(
        "boards would take more of a panel than set-backs may",
        place=place,
        keys=("panel.thickness",),
        size=f"panels may be {room.thickness:.4g} thick, and are {build.thickness:.4g}",
        candidates=[*earlier, *thinner(build, room.thickness)],
        excess=build.thickness / room.thickness - 1 if room.thickness else None,
    )


def _changed_panel(
    panel: PanelBuild | None, values: Mapping[str, Value | None]
) -> PanelBuild | None:
    if panel is None:
        return None
    for name, value in values.items():
        if name == "stop_deg":
            stop = None if value == "auto" else float(np.deg2rad(_number(value)))
            panel = replace(panel, stop=stop)
        elif name == "gap":
            panel = replace(panel, gap=_number(value))
        elif name == "membrane":
            panel = replace(panel, membrane=_number(value))
        else:
            assert name == "thickness"
            panel = replace(panel, thickness=_number(value))
    return panel


def _number(value: Value | None) -> float:
    assert isinstance(value, float | int)
    return float(value)


def _changed(curve: Curve, values: Mapping[str, Value | None]) -> Curve:
    if "formula" in values:
        formula, ends = values["formula"], values["range"]
        assert isinstance(formula, str)
        assert isinstance(ends, list)
        drawn = curve_from_formulas(None, parse_formula(formula), *map(float, ends))
        return drawn.scaled(curve.scale)
    for name, value in values.items():
        if name == "scale":
            assert isinstance(value, float | int | list)
            along_x, along_y = value if isinstance(value, list) else (value, value)
            was = curve.scale
            curve = curve.scaled((float(along_x) / was[0], float(along_y) / was[1]))
        else:
            assert name == curve.key
            assert isinstance(value, list)
            start, stop = value
            curve = curve.part_of_drawn(float(start), float(stop))
    return curve
