"""How a rectangle in plan is turned, where the design file leaves that open: a few are tried."""

from __future__ import annotations

from collections.abc import Iterator

from orishell.conventions.errors import DesignError, InputError
from orishell.conventions.progress import Progress, stretch
from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.conventions.row import Row
from orishell.design_file import DesignFile
from orishell.deviation import measure_deviation
from orishell.shell.designed import design_of

KEY = "target.surface.turn_deg"
SAMPLES = 1_000
"""Samples each way of a shell that is only compared."""
PANELS = 8
"""Panels along the longer side of a shell that is only compared, at most."""


@record
class TurnTrial:
    """A turn of the rectangle, and what comes of it."""

    turn_deg: float  # from x (degrees)
    # the largest distance between a shell of few panels and the surface, both ways (length); None
    # if there is none
    distance: float | None
    why_not: str = ""  # why there is no shell


@record
class TurnChoice:
    """The turns that were tried, and the one that was taken: the nearest."""

    turn_deg: float  # that was taken (degrees)
    tried: tuple[TurnTrial, ...]

    def rows(self, unit: str) -> Iterator[Row]:
        """A row of the verdict."""
        found, none = [], []
        for each in self.tried:
            if each.distance is None:
                none.append(f"{each.turn_deg:g}")
            else:
                found.append(f"{each.turn_deg:g} ({plain(each.distance)} {unit})")
        finding = f"rectangle turned by {self.turn_deg:g} degrees, the nearest by a coarse shell"
        finding += f" of {', '.join(found)}"
        if none:
            finding += f"; no shell at {', '.join(none)}"
        yield Row("says", "turn", finding)


def choose_turn(file: DesignFile, progress: Progress) -> tuple[DesignFile, TurnChoice | None]:
    """The file with its rectangle turned so that a shell of few panels comes nearest.

    The file itself, and no choice, where nothing about the turn is open.

    Raises
    ------
    DesignError, InputError
        That of the first turn, if no turn gives a shell.
    """
    turns = file.turns
    if not turns:
        return file, None
    size = (file.pattern.rows, file.pattern.columns)
    share = 1.0 if file.tolerance is not None else PANELS / (max(size) + 1)
    rows, columns = (
        PANELS - 1 if file.tolerance is not None else _fewer(each, share) for each in size
    )
    coarse = {"tolerance": None, "pattern.rows": rows, "pattern.columns": columns}
    tried: list[TurnTrial] = []
    refused: DesignError | InputError | None = None
    for number, turn in enumerate(turns):
        told = stretch(progress, number / len(turns), (number + 1) / len(turns))
        try:
            turned = file.changed({**coarse, KEY: turn})
            design = design_of(turned, turned.pattern, told)
            distance = measure_deviation(design, samples=SAMPLES).max
            tried.append(TurnTrial(turn, distance))
        except (DesignError, InputError) as error:
            refused = refused or error
            what = error.condition if isinstance(error, DesignError) else error.what
            tried.append(TurnTrial(turn, None, what))
    made = [(each.distance, each.turn_deg) for each in tried if each.distance is not None]
    if not made:
        assert refused is not None
        raise refused
    turn = min(made)[1]
    return file.changed({KEY: turn}), TurnChoice(turn, tuple(tried))


def _fewer(count: int, share: float) -> int:
    """So many rows or columns of inner vertices, at most as many as there are, and odd."""
    return count if share >= 1 else max(3, 2 * round(0.5 * share * (count + 1)) - 1)
