"""All loads of a case as forces on nodes, and where each comes from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeVar

import numpy as np

from orishell.conventions.errors import InputError
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.numerics.arrays import Array
from orishell.structure.load_settings import LOADS, LoadCase
from orishell.structure.loads.exposure import Exposure, Vector, vector

if TYPE_CHECKING:
    LoadKind = str
else:
    LoadKind = Literal[tuple(LOADS)]


@record
class Load:
    """What one kind of load adds to a case."""

    REPORTED = ("case", "factor", "kind", "pressure", "rule", "force")

    case: str  # the case that has it: another one where that is combined
    factor: float  # by which it is combined
    kind: LoadKind  # what it is
    forces: Array  # on nodes (N, 3), times the factor (N)
    # what it comes from: the pressure, snow on the ground, wind's peak velocity pressure; None for
    # own weight and forces at points
    pressure: float | None
    rule: str  # how it comes from that, in words
    caution: str  # what an engineer should read of it; empty if nothing

    @property
    def force(self) -> Vector:
        """Sum of its forces, times the factor."""
        return vector(self.forces.sum(axis=0))


class Effect(NamedTuple):
    """What a load does; the fields are those of :class:`Load`."""

    forces: Array
    pressure: float | None
    rule: str
    caution: str = ""


class Scale(NamedTuple):
    """What the numbers of a load are compared with, to doubt them."""

    area: float  # square metres in a square of the design's unit
    weight: float  # of all panels (N); 0 if it is not known

    def per_area(self, size: float) -> str:
        """A force per area, as others know it."""
        return f"{plain(size / self.area)} N/m2; 1 kN/m2 is {plain(1e3 * self.area)} here"


Doubt = Callable[[Any, Scale], str]
"""Why the values of a load can hardly be meant, in words; empty if they can."""
EFFECTS: dict[str, Callable[[Exposure, Any], Effect]] = {}
"""What a load does, by the key of a case that asks for it."""
KINDS: dict[str, str] = {}
"""What loads are called, by the same keys."""
DOUBTS: dict[str, Doubt] = {}
"""What is said of values that can hardly be meant, by the same keys."""
Effects = TypeVar("Effects", bound=Callable[..., Effect])


def load(words: str, doubt: Doubt) -> Callable[[Effects], Effects]:
    """Register what the load of a function's name does, what it is called, and what is doubted."""

    def register(effect: Effects) -> Effects:
        name = effect.__name__
        EFFECTS[name], KINDS[name], DOUBTS[name] = effect, words, doubt
        return effect

    return register


def no_doubt(_: Any, __: Scale) -> str:
    """What can be meant, whatever it is."""
    return ""


def require_effects(loads: Iterable[str]) -> None:
    """Refuse loads of which nothing says what they do."""
    if missing := [name for name in loads if name not in EFFECTS]:
        raise TypeError(f"no module of structure/loads has @load for {', '.join(missing)}")


class CaseLoads:
    """Loads of cases; those that several cases combine are found once."""

    def __init__(self, exposure: Exposure, cases: Iterable[LoadCase]) -> None:
        """Loads of ``cases``, all that may be combined."""
        self.exposure = exposure
        self._named = {each.name: each for each in cases}
        self._found: dict[str, tuple[Load, ...]] = {}

    def of(self, case: LoadCase) -> tuple[Load, ...]:
        """All loads of a case, also of those that it combines.

        Raises InputError: If a vertex or a row of panels is not there, zones of wind leave one out,
        or snow on a cylinder is asked for where there is no span.
        """
        if case.combine:
            return tuple(
                replace(load, factor=factor, forces=factor * load.forces)
                for name, factor in case.combine.items()
                for load in self.of(self._named[name])
            )
        if case.name not in self._found:
            self._found[case.name] = tuple(self._own(case))
        return self._found[case.name]

    def _own(self, case: LoadCase) -> Iterator[Load]:
        try:
            for kind in LOADS:
                if asked := getattr(case, kind):
                    yield Load(case.name, 1.0, kind, *EFFECTS[kind](self.exposure, asked))
        except InputError as error:
            raise error.at_key("load_case", f'[[load_case]] "{case.name}":') from None

    def forces(self, case: LoadCase) -> Array:
        """Forces (N, 3) of all loads of a case on the nodes (N)."""
        return sum_forces(self.exposure, self.of(case))


def case_loads(exposure: Exposure, case: LoadCase, cases: Sequence[LoadCase]) -> tuple[Load, ...]:
    """All loads of a case, also of those among all ``cases`` that it combines.

    Raises InputError: As :meth:`CaseLoads.of` does.
    """
    return CaseLoads(exposure, cases).of(case)


def sum_forces(exposure: Exposure, loads: Sequence[Load]) -> Array:
    """Forces (N, 3) of all loads on the nodes (N)."""
    return np.asarray(sum((load.forces for load in loads), np.zeros_like(exposure.mesh.points)))
