"""Distances between a shell and a surface: exact, from samples, both ways, and signed.

From every sample of either the distance to the nearest point of the other is exact, but for the
sagitta of the surface's mesh. Between samples it is known by how far they are apart
(:mod:`~orishell.deviation.triangles`).
"""

from __future__ import annotations

import numpy as np

from orishell.conventions.record import record
from orishell.design import AskedSurface, Design
from orishell.deviation.branch_and_bound import Cells, find_largest
from orishell.deviation.scattered import Scattered
from orishell.deviation.triangles import (
    Nearest,
    Patch,
    Triangles,
    mesh_shell,
    mesh_surface,
    triangles_of,
)
from orishell.motion.hinges import Hinges
from orishell.numerics.arrays import Array, Integers

Mesh = tuple[Array, Integers]
"""Vertices (V, 3), and triangles (T, 3) of them."""


def locked_shell(design: Design) -> Array:
    """Vertices (rows, n, 3) of the shell that meets the surface: columns 1 ... n.

    Flaps and border strips are not part of it: they stand beyond the ends of g.
    """
    mechanism = design.mechanism
    return mechanism.positions(mechanism.target_drive)[:, mechanism.inner_columns]


def drawn_shell(design: Design) -> Array:
    """Vertices (rows, n, 3) of the shell in pictures: of whole boards those between them."""
    mechanism = design.mechanism
    drawn = design.hinges.vertices(mechanism.positions(mechanism.target_drive))
    return drawn[:, mechanism.inner_columns]


def locked_boards(design: Design) -> Mesh | None:
    """Whole boards of the locked shell, half way up, where they lie beside its panels; or None."""
    if not isinstance(design.hinges, Hinges):
        return None
    mechanism = design.mechanism
    inner = mechanism.inner_columns
    boards = design.hinges.boards(mechanism.positions(mechanism.target_drive))
    corners = boards[:, inner.start : inner.stop - 1].reshape(-1, 3)
    first = 4 * np.arange(len(corners) // 4)[:, None]
    return corners, (first + np.array([0, 1, 2, 0, 2, 3])).reshape(-1, 3)


SAMPLES = 15_000
"""Samples each way by default: a fifth of a second for sheets of some hundred panels."""
SEARCHED = 2
"""Points spent in search of the largest distance, at most, for each sample."""
COARSE = 3_000
"""Samples each way for a first look: a twentieth of a second, for sheets of some hundred panels."""
SHARE = 0.95
"""The share of the area that is nearer than ``p95``."""


@record
class Distances:
    """Distances from all of one surface to the nearest points of another (length)."""

    max: float  # the largest
    # root mean square, mean, and the distance below which 95 % of the area lies
    rms: float
    mean: float
    p95: float
    # what is not known: the largest distance lies between max - sample_spacing and max +
    # sample_spacing
    sample_spacing: float
    grid_spacing: float  # the same for rms, mean and p95; in practice these are far better known


@record
class Deviation:
    """Distances between a shell and a surface, both ways (length)."""

    REPORTED = (
        "max",
        "rms",
        "mean",
        "p95",
        "sample_spacing",
        "shell_to_surface",
        "surface_to_shell",
    )

    shell_to_surface: Distances  # from all points of the shell to the surface
    surface_to_shell: Distances  # from all points of the surface to the shell

    def __repr__(self) -> str:
        known = f"known to {self.sample_spacing:.2g}"
        return f"{type(self).__name__}(max {self.max:.4g} ({known}), rms {self.rms:.4g}, both ways)"

    @property
    def max(self) -> float:
        """The Hausdorff distance: the largest of both ways."""
        return max(each.max for each in self._ways)

    @property
    def rms(self) -> float:
        """Root mean square, the larger of both ways."""
        return max(each.rms for each in self._ways)

    @property
    def mean(self) -> float:
        """Mean, the larger of both ways."""
        return max(each.mean for each in self._ways)

    @property
    def p95(self) -> float:
        """The distance below which 95 % of the area lies, the larger of both ways."""
        return max(each.p95 for each in self._ways)

    @property
    def sample_spacing(self) -> float:
        """By how much the largest distance may be off."""
        return max(each.max + each.sample_spacing for each in self._ways) - self.max

    @property
    def _ways(self) -> tuple[Distances, Distances]:
        return self.shell_to_surface, self.surface_to_shell


def measure_deviation(design: Design, *, samples: int = SAMPLES) -> Deviation:
    """Return distances of the locked shell of a design, flaps left out, from its surface.

    Parameters
    ----------
    samples
        Samples each way, about: all corners, edges and insides of panels are sampled at least.

    Raises
    ------
    InputError
        If the design has no target.

    Examples
    --------
    >>> from orishell import (
    ...     ParallelRepeatingPattern, curve_from_formulas, design_parallel_repeating,
    ...     parse_formula,
    ... )
    >>> f = curve_from_formulas(None, parse_formula("-x**2"), -1, 1)
    >>> g = curve_from_formulas(None, parse_formula("5*sin(pi*x/10)"), 0, 20)
    >>> design = design_parallel_repeating(
    ...     f, g, ParallelRepeatingPattern(rows=9, columns=11, xi_deg=50)
    ... )
    >>> round(measure_deviation(design, samples=COARSE).max, 2)
    0.23
    """
    shell, boards = locked_shell(design), locked_boards(design)
    return measure_distance(shell, design.surface, samples=samples, boards=boards)


def measure_approach(design: Design, *, samples: int = SAMPLES) -> Deviation | None:
    """Return distances of the locked shell from the surface that its family approaches, if known.

    Parameters
    ----------
    samples
        Samples each way, about.
    """
    if design.approached is None or design.approached.surface is None:
        return None
    shell, boards = locked_shell(design), locked_boards(design)
    return measure_distance(shell, design.approached.surface, samples=samples, boards=boards)


def measure_distance(
    shell: Array, surface: AskedSurface, *, samples: int = SAMPLES, boards: Mesh | None = None
) -> Deviation:
    """Return distances of panels from a surface, both ways.

    Parameters
    ----------
    shell
        Vertices (rows, columns, 3) of plane panels.
    samples
        Samples each way, about.
    boards
        Whole boards that lie beside the panels, and are measured instead.
    """
    both = _both_ways(shell, surface, samples, boards=boards)
    there, back = (_measure(way, samples) for way in both)
    return Deviation(there, back)


def find_excess(design: Design, limit: float, *, samples: int) -> float:
    """Return a distance that shows whether a shell is farther from its surface than a limit.

    It is attained, either way, however coarse the surface's mesh is. If it exceeds the limit, so
    does the largest one; if not, none was found that does.

    Parameters
    ----------
    limit
        The limit (length).
    samples
        Samples each way, about.
    """
    shell, boards = locked_shell(design), locked_boards(design)
    ways = _both_ways(shell, design.surface, samples, least=1, boards=boards)
    attained = [float(way.found.distances.max()) - way.sagitta for way in ways]
    for number, way in enumerate(ways):
        if max(attained) > limit:
            break
        attained[number] = way.search(SEARCHED * samples, limit + way.sagitta)[0] - way.sagitta
    return max(attained)


@record
class _Way:
    """Samples of one surface, and the points of the other that are nearest to them.

    The triangles of the other may leave it by a sagitta.
    """

    patch: Patch | Scattered
    other: Triangles
    found: Nearest
    sagitta: float

    def search(self, samples: int, limit: float | None = None) -> tuple[float, float]:
        """See :func:`~orishell.deviation.branch_and_bound.find_largest`."""
        patch = self.patch
        if isinstance(patch, Scattered):
            cells = patch.cells(self.found)
        else:
            cells = Cells.of_lattice(patch.u, patch.v, patch.points, self.found)
        attained = float(self.found.distances.max())
        return find_largest(cells, patch.at, self.other, attained, samples, limit=limit)


def _both_ways(
    shell: Array,
    surface: AskedSurface,
    samples: int,
    *,
    least: int = 2,
    boards: Mesh | None = None,
) -> tuple[_Way, _Way]:
    """Samples of the shell with the nearest points of the surface, and the other way round."""
    of_shell: Patch | Scattered
    if boards is None:
        of_shell, panels = Patch.of_shell(shell, samples, least=least), mesh_shell(shell)
    else:
        of_shell, panels = Scattered.of(*boards, samples), Triangles.scattered(*boards)
    known = triangles_of(surface)
    of_surface = (
        Patch.of_surface(surface, samples, shell)
        if known is None
        else Scattered.of(*known, samples)
    )
    mesh, sagitta = mesh_surface(surface, samples)
    there = _Way(of_shell, mesh, mesh.nearest(of_shell.points), sagitta)
    return there, _Way(of_surface, panels, panels.nearest(of_surface.points), 0.0)


def _measure(way: _Way, samples: int) -> Distances:
    """The distances one way, and how exactly they are known."""
    patch = way.patch
    inside, share = patch.spread(way.found.distances)
    order = np.argsort(inside, kind="stable")
    place = int(np.searchsorted(np.cumsum(share[order]), SHARE))
    largest, beyond = way.search(SEARCHED * samples)
    return Distances(
        max=largest,
        rms=float(np.sqrt(share @ inside**2)),
        mean=float(share @ inside),
        p95=float(inside[order[min(place, len(order) - 1)]]),
        sample_spacing=beyond + way.sagitta + patch.left_out,
        grid_spacing=patch.radius() + way.sagitta + patch.left_out,
    )
