"""Factors of a target with which its shell, before any proof, has the sizes asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import Any

import numpy as np

from orishell.conventions.errors import DesignError, InputError, Remedy
from orishell.conventions.formatting import rounded
from orishell.conventions.progress import Progress
from orishell.conventions.quantities import conversion, plain, size
from orishell.deployment.feet import find_feet
from orishell.design import Design
from orishell.design_file import DesignFile
from orishell.design_file.fit import AXES, FitTable
from orishell.locking import Lock, lock_without_clash
from orishell.numerics.arrays import Array
from orishell.numerics.broyden import MOST_TRIALS, Sizing
from orishell.numerics.equals import largest_of
from orishell.shell.designed import designed
from orishell.shell.fit.built_size import BuiltShell
from orishell.shell.fit.followed import near_fits
from orishell.shell.fit.report import FittedSize, in_words
from orishell.shell.fit.scaling import Scaling, first_factors, scaling_of
from orishell.shell.size_trials import Choice, measure
from orishell.shell.tolerance import meet_tolerance

EXACT = 1.0
"""Sizes may be off by so much (millimetres)."""
FINE, FINER = 0.02, 1e-4
"""By so much before the proof (millimetres), or by this share of the least size if that is less."""
CHOICES = 4
"""So often rows and columns are chosen, at most."""
NEARER = 1.1
"""A distance that is offered where one is not met, relative to what was found."""
HEADROOM = 1.2
"""Headroom that is offered where a room is lower than the head height, relative to that."""
DIGITS = 5
"""Significant digits of sizes that are offered."""


@dataclass(slots=True)
class SizeFit:
    """Looks for factors (k,), one for each size, or one for all of a drawn sheet."""

    file: DesignFile
    fit: FitTable
    progress: Progress
    base: DesignFile = field(init=False)  # without sizes, and with rows and columns
    scaling: Scaling = field(init=False)
    axes: list[int] = field(init=False)  # along which sizes are asked for
    asked: Array = field(init=False)  # those sizes (n,)
    trials: int = 0
    refusals: list[DesignError | InputError] = field(default_factory=list)
    known: dict[str, Array | None] = field(default_factory=dict)  # sizes by what the file says

    def __post_init__(self) -> None:
        alone = self.file.tables["target"].keys() == {"fit"}
        self.base = self.file.changed({"target" if alone else "target.fit": None})
        self.scaling = scaling_of(self.base)
        self.axes = [AXES.index(key) for key in self.fit.asked]
        self.asked = np.array([*self.fit.asked.values()])

    @property
    def exact(self) -> float:
        """By so much sizes may be off, in the design's unit."""
        return EXACT * conversion("mm", self.file.unit)

    def begin_again(self, changes: Mapping[str, Any], before: Design | None = None) -> None:
        """Take another design in place of the one that is scaled.

        before: That with whose sheet fits begin; None for the one with which they began so far.
        """
        self.base = self.base.changed(changes)
        if before is not None:
            self.base = replace(self.base, before=before)
        self.known.clear()

    def begin(self) -> tuple[Array, Choice | None]:
        """Factors of a shell that is not proved, and how rows and columns were chosen.

        These are chosen for the scaled target, whose shell is then scaled again, until one both
        meets the tolerance and has its sizes.
        """
        tolerance, open_file = self.file.tolerance, self.base
        if tolerance is None:
            return self._solved_near(self._first()), None
        factors = self._guess()
        for _ in range(CHOICES):
            scaled = open_file.changed(self._changes(factors))
            sized, choice = meet_tolerance(scaled, tolerance, self.progress)
            self.begin_again({"tolerance": None, "pattern": sized.tables["pattern"]})
            factors = self._solved_near(self._first())
            trial = measure(designed(self.scaled(factors), self.progress), True, tolerance)
            if trial.error <= tolerance.surface and tolerance.allows(trial.shortest, trial.longest):
                chosen = choice.trial
                trial = replace(trial, rows=chosen.rows, columns=chosen.columns)
                return factors, replace(choice, trial=trial)
        raise DesignError(
            f"no shell was found that is within {tolerance.surface:g} of its target and has the "
            "sizes asked for",
            keys=("target.fit", "tolerance.surface"),
            size=f"the last that was tried is {plain(trial.error)} away",
            candidates=[Remedy({"tolerance.surface": rounded(NEARER * trial.error)})],
            excess=trial.error / tolerance.surface - 1,
        )

    def scaled(self, factors: Array) -> DesignFile:
        """The design file with its target scaled."""
        return self.base.changed(self._changes(factors))

    def sizes(self, design: Design, lock: Lock) -> Array:
        """The sizes (n,) of a shell, of those that are asked for."""
        built = BuiltShell.of(design, lock)
        if self.fit.of == "outside":
            return np.asarray(built.outside()[self.axes])
        if find_feet(design) is None:
            raise DesignError(
                "a shell that does not stand on the ground has no room within",
                keys=("target.fit.of",),
                candidates=[Remedy({"target.fit.of": "outside", "target.fit.head_height": None})],
            )
        return np.asarray(built.inside(self.fit.head(self.file.unit))[self.axes])

    def solved(self, start: Array, aims: Array) -> Array:
        """Factors of a shell that has the sizes ``aims`` (n,) before it is proved.

        Raises DesignError if none are found.
        """
        sizing = Sizing(self._measured_all, aims[: len(start)], self._near)
        sizing.run(start)
        best, _ = sizing.found
        found = self._measured(best)
        assert found is not None
        if np.abs(found - aims).max() > self.exact / 2:
            raise self.refused(found)
        return best

    def _solved_near(self, start: Array) -> Array:
        """Factors of a shell that has the sizes asked for before it is proved, from some near it.

        Raises DesignError if none are found.
        """
        refusal: DesignError | None = None
        for near, before in near_fits(self, start):
            self.begin_again({}, before)
            try:
                return self.solved(near, self.asked)
            except DesignError as error:
                refusal = refusal or error
        assert refusal is not None
        raise refusal

    def refused(self, found: Array) -> DesignError:
        """The error for sizes that are not met, with the nearest that were found (n,)."""
        unit, keys = self.file.unit, [AXES[axis] for axis in self.axes]
        nearest = dict(zip(keys, found.tolist(), strict=True))
        fit = {f"target.fit.{key}": each for key, each in nearest.items()}
        free = [Remedy({key: None}) for key in fit] if len(fit) > 1 else []
        what = "factor" if self.scaling.uniform or len(fit) == 1 else "factors"
        return DesignError(
            f"no {what} of the target gave a shell of the sizes asked for",
            keys=tuple(fit),
            size=f"{in_words(self.fit.asked, unit)} {self.fit.of} asked for, the nearest of "
            f"{self.trials} shells tried has {in_words(nearest, unit)}{self._beyond()}",
            candidates=chain(
                [Remedy({key: rounded(each, DIGITS) for key, each in fit.items()})],
                self._beyond_candidates(),
                free,
            ),
            excess=float(np.abs(found / self.asked - 1).max()),
        )

    def _beyond(self) -> str:
        """Why the last shell that was refused is none."""
        match self.refusals[-1:]:
            case [DesignError(condition=why)] | [InputError(what=why)]:
                return f"; beyond it, {why}"
        return ""

    def _beyond_candidates(self) -> Iterator[Remedy]:
        """What may mend the last shell that was refused, but for other curves."""
        match self.refusals[-1:]:
            case [DesignError(candidates=candidates)]:
                for each in candidates:
                    if not any(key.startswith("target.") for key in each.changes):
                        yield each

    def described(self, found: Array, factors: Array) -> FittedSize:
        """What is said of a shell of the sizes ``found`` (n,)."""
        keys = [AXES[axis] for axis in self.axes]
        return FittedSize(
            of=self.fit.of,
            head_height=self.fit.head(self.file.unit) if self.fit.clear else None,
            asked=self.fit.asked,
            found=dict(zip(keys, found.tolist(), strict=True)),
            scales=self._changes(factors),
            trials=self.trials,
        )

    @property
    def _near(self) -> float:
        """By so much sizes may be off before the proof."""
        return min(FINE * conversion("mm", self.file.unit), FINER * float(self.asked.min()))

    def _changes(self, factors: Array) -> dict[str, float | list[float]]:
        return self.scaling.changes(self.axes[: len(factors)], factors)

    def _guess(self) -> Array:
        """Factors with which the target itself has the sizes asked for."""
        count = 1 if self.scaling.uniform else len(self.axes)
        return first_factors(self.scaling, self.axes[:count], self.asked[:count])

    def _first(self) -> Array:
        """Factors of a shell that has sizes at all.

        Raises the first refusal, or DesignError if there is no room within.
        """
        guess, without = self._guess(), None
        for begin in (guess, np.ones_like(guess)):
            start = self._high_enough(begin)
            found = self._measured(start)
            if found is not None and (found > 0).all():
                return start
            if found is not None and without is None:
                without = start
        if without is not None:
            raise self._no_room(without)
        raise self.refusals[0]

    def _high_enough(self, factors: Array) -> Array:
        """Factors of which that of a headroom asked for is found first: low rooms are not clear."""
        if self.fit.of == "outside" or len(factors) < 2 or self.axes[-1] != 2:
            return factors

        def headroom(last: Array) -> Array | None:
            found = self._measured(np.append(factors[:-1], last))
            return None if found is None or found[-1] <= 0 else found[-1:]

        if headroom(factors[-1:]) is None:
            return factors
        sizing = Sizing(headroom, self.asked[-1:], self._near)
        sizing.run(factors[-1:])
        return np.append(factors[:-1], sizing.found[0])

    def _measured_all(self, factors: Array) -> Array | None:
        """As many sizes as there are factors; None if one of them is none."""
        found = self._measured(factors)
        return None if found is None or (found <= 0).any() else found[: len(factors)]

    def _measured(self, factors: Array) -> Array | None:
        """The sizes (n,) of a shell that is not proved; None if there is none."""
        key = repr(self._changes(factors))
        if key not in self.known:
            made = self.tried(self.scaled(factors))
            self.known[key] = None if made is None else made[1]
        return self.known[key]

    def tried(self, file: DesignFile) -> tuple[Design, Array] | None:
        """The shell of a file, not proved, and its sizes (n,); None if there is none."""
        self.trials += 1
        self.progress(min(1.0, self.trials / MOST_TRIALS), "scaling the target to its sizes")
        try:
            design = designed(file)
            return design, self.sizes(design, lock_without_clash(design))
        except (DesignError, InputError) as error:
            self.refusals.append(error)
            return None

    def _no_room(self, factors: Array) -> DesignError:
        """The error for a shell in which no room is clear up to the head height."""
        unit, head = self.file.unit, self.fit.head(self.file.unit)
        design = designed(self.scaled(factors))
        built = BuiltShell.of(design, lock_without_clash(design))
        width, depth, headroom = built.inside(head).tolist()
        keys = tuple(f"target.fit.{key}" for key in self.fit.asked)
        if not headroom:
            what = "the shell has no headroom over its middle, neither along x nor along y"
            return DesignError(what, keys=keys)
        candidates = []
        free = {"width": width, "depth": depth}
        wide = largest_of(free, lambda key: free[key])
        if headroom <= head:
            said = f"its headroom is {size(headroom, unit)}"
            candidates += [
                Remedy({"target.fit.height": rounded(HEADROOM * head)}),
                Remedy({"target.fit.head_height": rounded(headroom / HEADROOM)}),
            ]
        else:
            said = f"its {wide} of {size(free[wide], unit)} is" if free[wide] else "nothing is"
            said += " free through the whole shell"
            if free[wide] and getattr(self.fit, wide) is None:
                other = "depth" if wide == "width" else "width"
                moved = {f"target.fit.{wide}": getattr(self.fit, other)}
                candidates.append(Remedy({**moved, f"target.fit.{other}": None}))
        asked = " and ".join(key for key in self.fit.asked if key != "height")
        return DesignError(
            f"the shell leaves no clear {asked} up to the head height",
            keys=keys,
            size=f"{size(head, unit)} above the ground {said}",
            candidates=candidates,
        )
