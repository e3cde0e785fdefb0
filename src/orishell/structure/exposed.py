"""A meshed shell as loads see it: where it stands, and what it weighs there."""

from __future__ import annotations

import numpy as np

from orishell.deployment import Site
from orishell.design import Design
from orishell.motion import Mechanism, area_of
from orishell.motion.grid import Grid
from orishell.numerics.arrays import Array
from orishell.structure.flaps import hung_area
from orishell.structure.loads import Exposure
from orishell.structure.mesh.sheet import SheetMesh


def expose(
    design: Design, site: Site, mesh: SheetMesh, inner: tuple[Mechanism, int], more: Array
) -> Exposure:
    """The mesh as loads see it.

    inner: The sheet without its flaps, and the number of columns of folded ones before its first.
    more: Masses (N,) of base rails and box girders at nodes (kg).
    """
    (sheet, before), facets, mass = inner, mesh.facets, site.areal_mass
    grid = sheet.grid
    if design.has_whole_boards:  # with nothing in the gaps between them
        mass *= area_of(sheet) / float(facets.areas().sum())
    points = facets.points[grid.vertices()[list(site.rows or (0, -1))]]
    span = float(np.linalg.norm(np.diff(points.mean(axis=1), axis=0)))
    standing = site.rows is not None
    hung = mass * hung_area(design.flapped, grid, len(facets.points))
    hung += _attached_masses(design, site, mass, (grid, before), len(facets.points))
    return Exposure(
        mesh=facets,
        panels=mesh.panels,
        grid=grid,
        before=before,
        areal_mass=np.full(len(facets.triangles), mass),
        hung=hung + more,
        unit=site.unit,
        ground=float(
            points[..., 2].min() if standing else facets.points[facets.triangles, 2].min()
        ),
        span=span if standing else None,
        feet=site.rows,
    )


def _attached_masses(
    design: Design, site: Site, areal_mass: float, sheet: tuple[Grid, int], count: int
) -> Array:
    """Mass (N,) at nodes of the other parts that go with the sheet, where these are borne."""
    found, (grid, before) = np.zeros(count), sheet
    for part in design.attached:
        if part.borne_at is None:  # it stands on the ground
            continue
        rows, columns = part.borne_at.T
        nodes = grid.vertices()[rows, columns - before]
        shares = 1 / len(nodes) if part.borne_shares is None else part.borne_shares
        found[nodes] += part.mass(areal_mass, site.metres) * shares
    return found
