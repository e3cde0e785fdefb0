"""Where a person is worst: one place after the other, all with one factorisation.

Who of ties, flaps and feet acts is taken from own weight, u_0; then what a force F at a place adds
is linear, and all places of a sheet are right-hand sides of the same equations:

    u = u_0 + F A^-1 (f + B^T p).

The place is the one where u uses most: of the strength of the panel that bears the person, of that
of ties, or of the displacement that is allowed, as far as these are known. It is then a case as any
other, whose conditions are found anew.

Of a sheet of many panels every third, or ninth, is tried, and then those around the worst: so the
work grows with the sheet, and not faster.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from orishell.conventions.quantities import plain
from orishell.conventions.record import record
from orishell.numerics.arrays import Array, Integers
from orishell.numerics.equals import SOLVED, first_largest
from orishell.structure.equilibrium import COLLAPSED
from orishell.structure.load_settings import LoadCase, Side, WorstPlace
from orishell.structure.loads.person import force_at
from orishell.structure.loads.weight import self_weight
from orishell.structure.materials import Duration
from orishell.structure.mesh.sheet import SheetMesh
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.mesh.triangle import Facets
from orishell.structure.model import Model
from orishell.structure.solve.active_set import respond
from orishell.structure.solve.factorised import Factorised

MOST = 400
"""Places that are tried at a time, at most."""
TOGETHER = 32
"""Right-hand sides that are solved for together: more take memory, and no less time."""
CLOSER = 3
"""The next round tries so many times as many panels of a row."""


class Place(NamedTuple):
    """A place: a panel as the grid counts it, and the middle of it or of a side."""

    panel: int
    side: Side


def placed(model: Model, structure: Factorised, known: Sequence[LoadCase]) -> tuple[LoadCase, ...]:
    """All cases, with the worst place for persons who have none."""
    if not any(case.person is not None and case.person.at is None for case in known):
        return tuple(known)
    search = _Search(model, structure)
    return tuple(
        case.replace_unchecked(person=search.worst(case, known))
        if case.person is not None and case.person.at is None
        else case
        for case in known
    )


class _Search:
    """What persons are tried on: a shell under its own weight."""

    def __init__(self, model: Model, structure: Factorised) -> None:
        self.model, self.structure = model, structure
        own = structure.free_loads(self_weight(model.exposure, True).forces)
        found = respond(structure, own) if own.any() else None
        count = len(structure.springs)
        if found is None or found.moves is not None:  # everything that can act does
            self.active = np.ones(count, dtype=bool)
            self.moved, self.borne = np.zeros(len(own)), np.zeros(count)
            self.motions = np.zeros((len(own), 0))
        else:
            self.active, self.motions = found.active, found.motions
            self.moved, self.borne = found.displacements, found.forces
        self.law = structure.reaction_operator(self.active)
        self.dofs, self.arms = model.mesh.dofs(), model.mesh.arms()

    def worst(self, case: LoadCase, known: Sequence[LoadCase]) -> WorstPlace:
        """The worst place for the person of a case."""
        person, model = case.person, self.model
        assert person is not None
        shares = self._shares(case.lasts(known))
        rows, columns = range(model.grid.rows - 1), range(model.grid.columns - 1)
        step = 1
        while len(self._places(rows, columns, step)) > MOST:
            step *= CLOSER
        tried: dict[Place, float] = {}
        while True:
            places = self._places(rows, columns, step)
            used = self._used(places, person.force, shares)
            tried |= dict(zip(places, used.tolist(), strict=True))
            worst = list(tried)[first_largest(np.array(list(tried.values())), SOLVED)]
            if step == 1:
                break
            row, column = divmod(worst.panel, model.grid.columns - 1)
            rows, columns = _around(row, step, rows), _around(column, step, columns)
            step //= CLOSER
        return WorstPlace(
            force=person.force,
            at=model.panel_at(worst.panel),
            side=worst.side,
            found=f"the worst of {len(tried)} places beside own weight, where "
            f"{plain(100 * tried[worst], 3)} % are used of {shares.words}",
        )

    def _shares(self, duration: Duration) -> _Shares:
        """What is compared from place to place."""
        asked, model = self.model.structure, self.model
        limit = model.displacement_limit
        return _Shares(
            limit or COLLAPSED * model.height,
            asked.bears(duration, model.site.unit),
            asked.tie_strength if model.site.ties else None,
            limited=limit is not None,
        )

    def _places(self, rows: range, columns: range, step: int) -> list[Place]:
        """Middles of panels in some rows and columns, and of their sides on the border."""
        grid = self.model.grid
        last_row, last_column = grid.rows - 2, grid.columns - 2
        found = []
        for row, column in product(_steps(rows, step), _steps(columns, step)):
            panel = row * (grid.columns - 1) + column
            sides: dict[Side, bool] = {
                "middle": True,
                "left": column == 0,
                "bottom": row == last_row,
                "right": column == last_column,
                "top": row == 0,
            }
            found += [Place(panel, side) for side, there in sides.items() if there]
        return found

    def _used(self, places: Sequence[Place], force: float, shares: _Shares) -> Array:
        """What of the shares is used most with a force at each of some places (p,) (N)."""
        found = []
        for first in range(0, len(places), TOGETHER):
            some = places[first : first + TOGETHER]
            forces = [force_at(self.model.exposure, *each) for each in some]
            added, borne = self._responses(forces)
            moved = self.moved + force * added
            used = np.array([self.structure.furthest(each) for each in moved])
            used /= shares.displacement
            if shares.strength is not None:
                panels = np.array([each.panel for each in some])
                used = np.maximum(used, self._stresses(moved, panels) / shares.strength)
            if shares.ties is not None:
                ties = (self.borne + force * borne)[:, : len(self.model.site.ties)]
                used = np.maximum(used, ties.max(axis=1) / shares.ties)
            found.append(used)
        return np.concatenate(found)

    def _responses(self, forces: Sequence[Array]) -> tuple[Array, Array]:
        """Displacements (p, n) and forces of rows (p, M) by forces (p) on points (N, 3)."""
        structure = self.structure
        loads = np.stack([structure.free_loads(each) for each in forces], axis=1)
        direct = structure.quick_solve(loads)
        opened = structure.rows @ direct
        p = self.law @ opened
        moved = direct + structure.spread @ p
        moved -= self.motions @ (self.motions.T @ moved)
        parted = opened + structure.flexibility @ p
        springs = structure.springs[:, None]
        return moved.T, np.where(self.active[:, None], springs * parted - p, 0.0).T

    def _stresses(self, moved: Array, panels: Integers) -> Array:
        """The largest stress (p,) of one panel each (p,), by displacements (p, n) of free dofs."""
        mesh, count = self.model.mesh, len(panels)
        each = len(mesh.places) // len(mesh.nodes)
        triangles = (panels[:, None] * each + np.arange(each)).ravel()
        every = np.stack([self.structure.moved(one) for one in moved])
        own = every[np.repeat(np.arange(count), each)[:, None], self.dofs[triangles]]
        corners = own.reshape(-1, 3, 6).copy()
        corners[..., :3] += np.cross(corners[..., 3:], self.arms[triangles])
        facets = Facets(mesh.facets.points, mesh.facets.triangles[triangles])
        # Each panel by itself, also where it has several places.
        size = mesh.nodes[0].size
        apart = np.repeat((np.arange(count) - panels) * size, each)[:, None]
        part = SheetMesh(facets, mesh.seats[panels], mesh.places[triangles] + apart)
        section = self.model.section.of(triangles)
        borne = facet_stresses(facets, section, corners.reshape(-1, 18))
        found = panel_stresses(part, section, borne).von_mises()
        return np.asarray(found.reshape(count, -1).max(axis=1))


@record
class _Shares:
    """What of which shares are compared."""

    displacement: float  # what is allowed, or makes it another shell (length)
    strength: float | None  # of panels; None if it is not known (force per area)
    ties: float | None  # what ties bear; None if there are none, or that is not known (N)
    limited: bool  # whether a displacement is allowed by the one who asks

    @property
    def words(self) -> str:
        """Of what shares are."""
        of = ["the strength of the panel there"] if self.strength is not None else []
        of += ["that of ties"] if self.ties is not None else []
        height = f"{100 * COLLAPSED:g} % of the shell\u2019s height as displacement"
        of.append("the displacement that is allowed" if self.limited else height)
        return " or ".join(of)


def _steps(some: range, step: int) -> list[int]:
    """Every so many of some rows or columns, and the last."""
    return sorted({*some[::step], some[-1]})


def _around(middle: int, step: int, some: range) -> range:
    """Rows or columns nearer to one than a step, of some."""
    return range(max(some[0], middle - step + 1), min(some[-1], middle + step - 1) + 1)
