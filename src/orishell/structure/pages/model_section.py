"""What is analysed, on the page on a shell as a structure: so that it can be calculated by hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from orishell.conventions.quantities import Quantities, figure, quantity
from orishell.io.sections import Paragraph, Section, Table
from orishell.structure.carried import plates_across
from orishell.structure.changes import STOPPED, missing_in_words
from orishell.structure.grain import BOTH_WAYS
from orishell.structure.hinge_lines import DIRECTIONS, LineStrength
from orishell.structure.materials import DURATIONS
from orishell.structure.model import Model
from orishell.structure.settings import Support
from orishell.structure.stiffness import Stiffness

RESTRAINED = {
    "pinned": "held in place",
    "fixed": "held in place, and all panels there clamped",
    "sliding": "held up only",
    "friction": "on the ground, which pushes only, with friction of",
}


def model_section(model: Model, said: Quantities) -> Section:
    """The model: materials, sections, creases, ties, supports and the mesh."""
    supports = [(_place(each, said), _held(each)) for each in model.structure.supports]
    return Section(
        "Model",
        (
            Table((), list(_rows(model, said))),
            Paragraph(_sections_in_words(model, said), "soft"),
            Table(("Supports", "how"), supports),
        ),
    )


def _rows(model: Model, said: Quantities) -> Iterator[tuple[str, str]]:
    asked, (low, high) = model.structure, model.crease_stiffness
    yield "Unit of length", said.unit
    yield "Height between its flaps", said.length(model.height)
    yield "Mass of panels", quantity(model.mass, "kg")
    yield "Thickness of panels, t", said.displacement(model.thickness)
    if asked.material is not None:
        yield "Material", asked.material
    core = asked.sandwich
    yield f"Young\u2019s modulus{' of faces' if core else ''}, E", said.stress(asked.modulus)
    yield "Poisson\u2019s ratio, \u03bd", figure(asked.poisson)
    if core is not None:
        yield from _core(model, said)
    if asked.membrane_modulus:
        yield "Young\u2019s modulus of the membrane", said.stress(asked.membrane_modulus)
    if asked.has_grain:
        yield "Grain of panels", asked.grain or "not given: as weak either way as the weaker"
        yield from _grain_strengths(model, said)
    else:
        yield f"Strength of {'faces' if core else 'panels'}", _strength(model, said)
    if model.design.panel is not None and model.design.panel.membrane:
        yield "Strength of the membrane", _known(asked.membrane_strength, said.stress)
    yield (
        "Stiffness of sections in their plane",
        _from_to(model.membrane_stiffness, said.per_length),
    )
    yield "Stiffness of sections in bending", _from_to(model.bending_stiffness, said.bending)
    if model.shear_stiffness is not None:
        yield "Stiffness of sections in shear", _from_to(model.shear_stiffness, said.per_length)
    stiffness = _stiffness(low)
    if low != high:
        stiffness += f", and {_stiffness(high)}: all is found for both"
    yield "Creases", stiffness
    yield "Strength of creases", _known(asked.crease_strength, said.moment)
    yield "Strength of crease lines", _lines(asked.line_strength, said)
    if model.stiffened.has_plates:
        yield "Strength of edges of gussets and plates", _lines(asked.edge_strength, said)
    if high:
        yield "Lever arm of what locks creases", said.displacement(model.lever)
    if model.design.panel is not None and model.design.panel.construction == "hinged":
        yield "Young\u2019s modulus of arms", _known(asked.arm_modulus, said.stress, "rigid")
        yield "Strength of arms", _known(asked.arm_strength, said.stress)
    stretch = model.tie_stiffness
    yield "Ties", "do not stretch" if stretch is None else quantity(stretch, "N by strain")
    yield (
        "Strength of ties",
        _known(asked.tie_strength, lambda force: quantity(force, "N")),
    )
    yield from _stiffeners(model, said)
    if asked.rail is not None:
        of = model.rails
        length, count = (
            sum(rail.lengths.sum() for rail in of),
            sum(len(rail.lengths) for rail in of),
        )
        yield (
            "Base rail",
            f"{asked.rail.in_words(said.unit)}: {count} bars between neighbouring feet, "
            f"{said.length(length)} in all",
        )
    yield (
        "Mesh",
        f"{model.triangles} triangles, {model.nodes} nodes, {model.freedoms} degrees of freedom",
    )
    yield "Refinement", _changes_in_words(model)


def _stiffeners(model: Model, said: Quantities) -> Iterator[tuple[str, str]]:
    """What stiffens it."""
    if model.design.plates:
        yield "Gussets", _plates_in_words(model, said)
    if model.design.boxes:
        yield "Box girders", _boxes_in_words(model)
    if model.has_skin:
        yield "Second skin", _skin_in_words(model)


def _boxes_in_words(model: Model) -> str:
    """Which rows are closed to box girders."""
    rows = [str(each.sleeve.row) for each in model.design.boxes]
    strips = sum(len(each.names) for each in model.design.boxes)
    of = f"row{'s' * (len(rows) > 1)} {', '.join(rows)}"
    plates = len(plates_across(model.design, 0)[1])
    across = f", {plates} plate{'s' * (plates > 1)} across" if plates else ""
    return f"{of}: {strips} panels{across}, made as those of the sheet, on hinges that turn freely"


def _skin_in_words(model: Model) -> str:
    """How many panels a second skin and its walls have."""
    skin, *walls = model.design.carried
    panels = sum(len(each.names) for each in walls)
    on = f"{len(walls)} wall{'s' * (len(walls) > 1)} of {panels}"
    return (
        f"{len(skin.names)} panels on {on}, made as those of the sheet, on hinges that turn freely"
    )


def _plates_in_words(model: Model, said: Quantities) -> str:
    """How many plates stiffen it, and what they are made of."""
    plates, own = model.design.plates, model.stiffened.of_plates
    first = plates[0]
    if first.panel == model.design.panel and not first.material:
        return f"{len(plates)}, made as panels are"
    assert first.panel is not None
    of = f" of {first.material}" if first.material else ""
    return (
        f"{len(plates)}, {said.displacement(first.panel.board)} thick{of}; Young\u2019s modulus "
        f"{said.stress(own.modulus)}"
    )


def _changes_in_words(model: Model) -> str:
    """How figures changed with the mesh, and why it is no finer."""
    shares = (model.change.displacement, model.change.stress, model.change.buckling)
    moved, stress, buckling = (quantity(100 * share, "%", 2) for share in shares)
    text = (
        f"from the next coarser mesh displacements changed by {moved}, stress by {stress}, "
        f"buckling factors by {buckling}"
    )
    stopped = "" if model.stopped is None else STOPPED[model.stopped]
    return "; ".join(filter(None, (text, missing_in_words(model.cells), stopped)))


def _sections_in_words(model: Model, said: Quantities) -> str:
    """How the stiffness of sections comes from thickness and modulus."""
    layup, thick = model.structure.layup, model.thickness
    solid = layup.plane * float(layup.inertia(thick))
    least, most = model.bending_stiffness
    area, inertia, what = "t", "t³/12", "A solid panel"
    if layup.core is not None:
        area, inertia, what = "2 f", "(f d²/2 + f³/6)", "A panel with faces f and d = t \u2212 f"
    flat = said.per_length(layup.plane * float(layup.area(thick)))
    text = (
        f"{what} has E {area}/(1 \u2212 \u03bd²) = {flat} in its plane and "
        f"E {inertia}/(1 \u2212 \u03bd²) = {said.bending(solid)} in bending."
    )
    if max(abs(least - solid), abs(most - solid)) <= 1e-9 * solid:
        return text
    return text + (
        " Of two boards with a membrane between them each, of thickness b and its middle d away "
        "from that of the panel, adds E b and E (b³/12 + b d²), over 1 \u2212 \u03bd²; the "
        "membrane adds what it has by itself. Beside creases, where one board or none is left, "
        "sections are less stiff: triangles take the mean of what covers them."
    )


def _place(support: Support, said: Quantities) -> str:
    if isinstance(support.at, str):
        words = {"feet": "feet", "ends": "first and last columns"}[support.at]
    else:
        words = "vertices " + ", ".join(f"{row},{column}" for row, column in support.at)
    if support.edges:
        return f"{words}, and edges between them"
    if support.patch:
        return f"{words}, and what is within {said.length(support.patch)} of each"
    return words


def _held(support: Support) -> str:
    words = RESTRAINED[support.kind]
    if support.ballast:
        rubs = f", friction {figure(support.friction)}" if support.friction else ""
        return f"{words} by ballast of {quantity(support.ballast, 'kg')} each{rubs}"
    return f"{words} {figure(support.friction)}" if support.kind == "friction" else words


def _stiffness(stiffness: Stiffness) -> str:
    if isinstance(stiffness, str):
        return {"free": "free hinges", "rigid": "rigid"}[stiffness]
    return quantity(stiffness, "N m/m by radian")


def _from_to(values: tuple[float, float], said: Callable[[float], str]) -> str:
    low, high = map(said, values)
    return low if low == high else f"from {low} to {high}"


def _strength(model: Model, said: Quantities) -> str:
    """What panels bear, by the duration of loads where that matters."""
    asked = model.structure
    values = {each: asked.bears(each, model.site.unit) for each in DURATIONS}
    if len(set(values.values())) == 1:
        return _known(values["permanent"], said.stress)
    words = (f"{_known(value, said.stress)} {name}" for name, value in values.items())
    return f"by duration of loads, service class {asked.service_class}: {', '.join(words)}"


def _core(model: Model, said: Quantities) -> Iterator[tuple[str, str]]:
    """Faces and core of a sandwich."""
    core, made = model.structure.layup.core, model.structure.sandwich
    assert core is not None
    assert made is not None
    yield "Thickness of each face, f", said.displacement(core.face)
    yield "Shear modulus of the core", said.stress(core.shear_modulus)
    yield "Strength of the core in shear", _known(made.core_shear_strength, said.stress)
    yield "Young\u2019s modulus of the core", said.stress(core.modulus)
    yield "Faces wrinkle at", said.stress(model.structure.layup.wrinkling or 0.0)


def _grain_strengths(model: Model, said: Quantities) -> Iterator[tuple[str, str]]:
    """What boards bear by their grain, under loads that last; and how much more under others."""
    asked = model.structure
    bears = asked.grain_strength("permanent", model.site.unit)
    assert bears is not None
    for key in BOTH_WAYS:
        along, across = map(said.stress, getattr(bears, key))
        words = f"{along} along the grain, {across} across it"
        yield f"Strength in {key.replace('_', ' ')}", words if along != across else along
    yield "Strength in panel shear", said.stress(bears.panel_shear)
    values = {each: asked.bears(each, model.site.unit) or 0.0 for each in DURATIONS}
    shares = [f"{figure(each / values['permanent'])} {name}" for name, each in values.items()]
    yield (
        "These strengths are for permanent loads",
        f"times, by duration, service class {asked.service_class}: {', '.join(shares)}",
    )


def _lines(strength: LineStrength | None, said: Quantities) -> str:
    """What crease lines bear, by direction."""
    if strength is None:
        return "not given"
    known = {name: getattr(strength, name) for name in DIRECTIONS}
    if len(set(known.values())) == 1:
        return _known(strength.pull, said.per_length)
    words = (f"{name} {_known(each, said.per_length, 'not known')}" for name, each in known.items())
    kind = "" if strength.kind is None else f"{strength.kind}: "
    return f"{kind}{', '.join(words)}"


def _known(value: float | None, said: Callable[[float], str], otherwise: str = "not given") -> str:
    return otherwise if value is None else said(value)
