"""What there is in a shell as it is moved far: forces, stresses and what holds it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from orishell.numerics.arrays import Array
from orishell.structure.crease_forces import moments
from orishell.structure.equilibrium import Equilibrium
from orishell.structure.feet import Foot, moved_feet
from orishell.structure.footings import to_nearest
from orishell.structure.held_panels import hold_moved_panels
from orishell.structure.load_path import LoadPath
from orishell.structure.loads import vector
from orishell.structure.mesh.corotational import Corotational, Moved
from orishell.structure.mesh.hinges import Folds
from orishell.structure.mesh.rotations import logarithms
from orishell.structure.mesh.stresses import facet_stresses, panel_stresses
from orishell.structure.model import Model
from orishell.structure.negligible import borne_by
from orishell.structure.plates import plate_forces, stresses_in_plates
from orishell.structure.solve.contacts import Feet, Links
from orishell.structure.solve.path import Point


def still(point: Point, motions: Array) -> Array:
    """Displacements (D,) at a point, less those along motions (n, k) that nothing resists.

    Linear theory leaves them out in the same way.
    """
    moving, moved = point.moving, point.moved
    every = moved.displacements.copy()
    every[moving.spins] = logarithms(moved.rotations)
    every[moving.free] -= motions @ (motions.T @ every[moving.free])
    return every


def deformed(
    linear: Equilibrium, point: Point, loads: tuple[Array, Array], path: LoadPath
) -> Equilibrium:
    """What there is in the shell at a point of its path.

    loads: On nodes, and on panels.
    """
    model, moved, moving = linear.model, point.moved, point.moving
    mesh, (on_nodes, on_panels) = model.mesh, loads
    panels, *others = moving.parts
    assert isinstance(panels, Corotational)
    places = mesh.facets.points + moved.displacements[mesh.translations()]
    in_place = _in_place(panels, moved)
    stresses = panel_stresses(
        mesh, model.section, facet_stresses(mesh.facets, model.section, in_place)
    )
    at_nodes, reaction, residual = _reactions(model, point, on_nodes, places)
    total = point.factor * float(np.linalg.norm(on_nodes, axis=1).sum())
    turning = next((each.forces(moved) for each in others if isinstance(each, Folds)), None)
    plates = [each for each in others if isinstance(each, Corotational)]
    forces = [each.forces(moved) for each in (panels, *plates)]
    moved_plates = [each.places(moved.displacements) for each in model.plates]
    borne_by_all = forces, turning, places, moved_plates
    rounded = moving.noise(moved)
    held = hold_moved_panels(model, borne_by_all, point.factor * on_panels, total, rounded)
    on_plates = plate_forces(model, [_in_place(each, moved) for each in plates])
    borne = np.zeros(len(model.site.ties) + len(model.flaps))
    feet: tuple[Foot, ...] = ()
    for part in others:
        if isinstance(part, Links):
            borne = part.bears(moved)
        if isinstance(part, Feet):
            feet = moved_feet(part, moved, tuple(model.grounded))
    ties = len(model.site.ties)
    factors = () if path.carries or not path.reached else (path.reached,)
    return replace(
        linear,
        support_forces=to_nearest(mesh.facets.points, model.supports.at, at_nodes),
        reaction=vector(reaction),
        residual=residual,
        feet=feet,
        tie_forces=borne_by(borne[:ties], total),
        flap_forces=borne_by(borne[ties:], total),
        edges=replace(held.edges, factor=point.factor),
        held_plates=held.plates,
        panel_residual=held.residual,
        crease_moments=moments(model, held.edges),
        stresses=stresses.von_mises(),
        principal=stresses.principal(),
        in_patches=stresses,
        buckling_factors=factors,
        buckling_modes=np.zeros((0, *places.shape)),
        buckling_at_points=len(factors) * (0.0,),
        path=path,
        in_plates=stresses_in_plates(model, on_plates),
    )


def _in_place(triangles: Corotational, moved: Moved) -> Array:
    """What triangles are strained by: displacements and rotations (T, 18), where they were."""
    strained = triangles.seen(moved)[2].reshape(-1, 6, 3)
    return np.asarray(np.einsum("tji,tkj->tki", triangles.axes, strained).reshape(-1, 18))


def _reactions(
    model: Model, point: Point, loads: Array, places: Array
) -> tuple[Array, Array, float]:
    """Forces (N, 3) of supports, their sum, and the share of the loads that they miss."""
    mesh, moved = model.mesh, point.moved
    taken = point.moving.forces(moved)
    taken[: loads.size] -= point.factor * loads.ravel()
    supported = model.supports.dofs(mesh)
    bearing = np.zeros(mesh.count)
    bearing[supported] = taken[supported]
    at_nodes = bearing[mesh.translations()]
    for part in point.moving.parts:
        if isinstance(part, Feet):
            at_nodes[model.supports.ground] += part.pushes(moved)
    turning = bearing[mesh.rotations().reshape(-1, 3)].sum(axis=0)
    both = point.factor * loads + at_nodes
    moment = np.cross(places - places.mean(axis=0), both).sum(axis=0) + turning
    worst = max(float(np.linalg.norm(both.sum(axis=0))), float(np.linalg.norm(moment)) / model.size)
    scale = point.factor * float(np.linalg.norm(loads, axis=1).sum())
    return at_nodes, at_nodes.sum(axis=0), worst / scale if scale else 0.0
