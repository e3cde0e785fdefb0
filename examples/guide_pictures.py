"""The pictures of the guide: what each family's parameters do, drawn from the families' own code.

Run it with ``python examples/guide_pictures.py [DIRECTORY]``; it writes docs/images/guide.
"""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from orishell import (
    Curve,
    Design,
    FoldingMotion,
    LongitudinalPattern,
    OrthodiagonalPattern,
    ParallelRepeatingPattern,
    THedralPattern,
    curve_from_formulas,
    design_longitudinal_linear_repeating,
    design_orthodiagonal,
    design_parallel_repeating,
    parse_formula,
)
from orishell.conventions.colours import LIGHT
from orishell.curves import trace_curve
from orishell.design import PanelSpec
from orishell.design_file.file import check_design
from orishell.document.from_design import document_of_motion
from orishell.families.longitudinal_linear_repeating import Sectors
from orishell.locking import find_lock
from orishell.motion import Mechanism
from orishell.motion.second_skin import Skinned
from orishell.plot import DrawnContact, find_hinge_section, plot_overview, plot_tradeoff
from orishell.plot.hinge_picture import draw_hinge_section, section_height
from orishell.plot.scene import WIDTH
from orishell.polylines import fit_staircase, place_zigzags
from orishell.shell import make_shell
from orishell.shell.steps import MEASURES
from orishell.shell.tolerance import meet_tolerance
from orishell.solids import build_boards, largest_folds
from orishell.workshop import Drawing, Workshop
from orishell.workshop.kit.line_drawing import draw_lines
from orishell.workshop.palettes import load_palette
from orishell.workshop.sheets import draw_sheet_files

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

DIRECTORY = Path(__file__).parents[1] / "docs" / "images" / "guide"
F_COLOUR, LINE_COLOUR, OTHER_COLOUR = LIGHT["curve-f"], "#1f5fbf", "#d62728"
XI = np.deg2rad(50)
SHARES = (1.0, 0.7, 0.5, 0.35, 0.25, 0.12, 0.05)


def graph(text: str, start: float, stop: float) -> Curve:
    """The graph of a formula."""
    return curve_from_formulas(None, parse_formula(text), start, stop)


def pair(x: str, y: str, start: float, stop: float) -> Curve:
    """A curve x(t), y(t)."""
    return curve_from_formulas(parse_formula(x), parse_formula(y), start, stop)


def near_90(share: float) -> Sectors:
    """The paper's sector angles, nearer to 90 degrees by a share."""
    return Sectors.from_degrees(90 + share * np.array([-5.0, -10.0, 5.0, 10.0]))


def longitudinal(share: float, columns: int = 9) -> Design:
    """A half circle swept along a line by 7 rows, with those sector angles."""
    return design_longitudinal_linear_repeating(
        pair("cos(t)", "sin(t)", 0.3, 2.8416),
        graph("0*x", 0, 2.93),
        LongitudinalPattern(rows=7, columns=columns, sector_deg=near_90(share).degrees),
    )


def new_figure(width: float, height: float, count: int) -> tuple[Figure, list[Axes]]:
    """A figure of so many axes side by side."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    FigureCanvasAgg(figure)
    return figure, list(figure.subplots(1, count, squeeze=False)[0])


def save(figure: Figure, path: Path) -> None:
    """Write a picture that is the same every time."""
    figure.savefig(path, dpi=130, metadata={"Software": None})


def to_scale(axes: Axes, title: str) -> None:
    """Show curves to scale, without a frame."""
    # Axes whose limits are not given are as high as their neighbours: titles stand in one line.
    axes.set_aspect("equal", adjustable="datalim" if axes.get_autoscaley_on() else "box")
    axes.axis("off")
    axes.set_title(title)


def draw_staircases(path: Path) -> None:
    """Staircases of f = -x**2 for three angles, and their distances."""
    trace = trace_curve(graph("-x**2", -1, 1))
    figure, axes = new_figure(12, 3.6, 4)
    for place, degrees in zip(axes, (20, 35, 50), strict=False):
        staircase = fit_staircase(trace, np.deg2rad(degrees), 10)
        place.plot(*trace.points.T, color=F_COLOUR, linewidth=2)
        place.plot(*staircase.vertices.T, color=LINE_COLOUR, marker="o", markersize=3)
        place.set_ylim(-1.2, 0.45)
        to_scale(place, f"xi_deg = {degrees}\ndistance {staircase.distance:.3f}")
    angles = np.linspace(10, 53, 30)
    for rows, colour in ((9, LINE_COLOUR), (19, OTHER_COLOUR)):
        distances = [fit_staircase(trace, a, rows + 1).distance for a in np.deg2rad(angles)]
        axes[-1].plot(angles, distances, color=colour, label=f"{rows} rows")
    axes[-1].axvline(53.13, color="black", linestyle=":", label="limit, 53.13")
    axes[-1].set(xlabel="xi_deg", ylabel="distance from f", ylim=(0, None))
    axes[-1].legend(frameon=False)
    save(figure, path)


def draw_planes(path: Path) -> None:
    """Locked shells seen from above, square and oblique to g."""
    figure, axes = new_figure(12, 4.2, 3)
    g = pair("8*cos(t)", "8*sin(t)", 0.2, 1.6)
    for place, degrees in zip(axes, (90, 75, 60), strict=True):
        design = design_parallel_repeating(
            graph("-x**2", -1, 1),
            g,
            ParallelRepeatingPattern(
                rows=9, columns=15, xi_deg=np.rad2deg(XI), plane_deg=degrees, flap=0
            ),
        )
        locked = design.mechanism.positions(design.mechanism.target_drive)
        for lines in (locked, locked.swapaxes(0, 1)):
            place.plot(lines[..., 0].T, lines[..., 1].T, color="0.35", linewidth=0.7)
        place.plot(*design.targets["g"][:, :2].T, color=LIGHT["curve-g"], linewidth=2)
        scales = design.parameters["column_scale"]
        assert isinstance(scales, list)
        low, high = (f"{scale:.2f}" for scale in scales)
        to_scale(place, f"plane_deg = {degrees}\nf stretched {low} to {high} times")
    save(figure, path)


def draw_zigzags(path: Path) -> None:
    """Zigzags of f of three depths, and the admissible headings by depth."""
    f, g = graph("-x**2", -1, 1), graph("0.25*sin(pi*x/2)", 0, 4)
    trace = trace_curve(f)
    figure, axes = new_figure(12, 3.6, 4)
    for place, depth in zip(axes, (0.06, 0.12, 0.2), strict=False):
        taken = design_orthodiagonal(
            f, g, OrthodiagonalPattern(rows=9, columns=13, depth=depth)
        ).parameters["zigzag_deg"]
        zigzag = min(
            place_zigzags(trace, 9, depth),
            key=lambda each: np.abs(np.rad2deg(each.angles) - taken).max(),
        )
        place.plot(*trace.points.T, color=F_COLOUR, linewidth=2)
        place.plot(*zigzag.vertices.T, color=LINE_COLOUR, marker="o", markersize=3)
        place.set_ylim(-1.1, 0.3)
        to_scale(place, f"depth = {depth}\nmean angle {np.rad2deg(zigzag.angles.mean()):.0f}°")
    depths = np.linspace(0.04, 0.3, 27)
    for rows, colour in ((9, LINE_COLOUR), (19, OTHER_COLOUR)):
        ends = []
        for depth in depths:
            design = design_orthodiagonal(
                f,
                g,
                OrthodiagonalPattern(
                    rows=rows, columns=13, depth=float(depth), flap=0, heading_deg="auto"
                ),
            )
            ends.append(design.parameters["heading_interval_deg"])
        low, high = np.array(ends).T
        axes[-1].fill_between(depths, low, high, color=colour, alpha=0.35, label=f"{rows} rows")
    axes[-1].set(xlabel="depth", ylabel="admissible heading_deg")
    axes[-1].legend(frameon=False)
    save(figure, path)


def draw_sections(path: Path) -> None:
    """Sections of shells of the third family, and what smaller deviations from 90 do."""
    figure, axes = new_figure(12, 3.8, 3)
    for place, share in zip(axes, (1.0, 0.25), strict=False):
        design = longitudinal(share)
        shell = design.mechanism.positions(design.mechanism.target_drive)
        across = shell[:, design.mechanism.inner_columns][..., 1:]
        for k in range(across.shape[1]):
            place.plot(*across[:, k].T, color=str(0.15 + 0.08 * k), linewidth=0.9)
        place.plot(*design.targets["f"][:, 1:].T, color=F_COLOUR, linewidth=2)
        shown = ", ".join(f"{angle:g}" for angle in near_90(share).degrees)
        growth = design.parameters["radius_growth"]
        to_scale(place, f"sector_deg = [{shown}]\nradius times {growth:.2f}")
    designs = [longitudinal(share) for share in SHARES]
    largest = [10 * share for share in SHARES]
    growths = [design.parameters["radius_growth"] for design in designs]
    ratios = [design.parameters["longest_to_shortest"] for design in designs]
    axes[-1].plot(largest, growths, "o-", color=LINE_COLOUR, label="radius, last to first")
    axes[-1].set(xlabel="largest deviation of a sector angle from 90 (degrees)", ylim=(0, 1))
    right = axes[-1].twinx()
    right.plot(largest, ratios, "s--", color=OTHER_COLOUR, label="longest crease to shortest")
    right.set_ylim(0, None)
    figure.legend(loc="outside lower right", ncols=2, frameon=False)
    save(figure, path)


def draw_choice(path: Path) -> None:
    """Designs that were tried for a tolerance of 0.1."""
    tables = {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": {"formula": "-x**2", "range": [-1, 1]},
            "g": {"formula": "5*sin(pi*x/10)", "range": [0, 20]},
        },
        "tolerance": {"surface": 0.1},
    }
    file = check_design(tables, Path("shell.toml"))
    assert file.tolerance is not None
    _, choice = meet_tolerance(file, file.tolerance)
    trials = (*choice.tradeoff, choice.trial)
    *points, chosen = [(t.panels, t.error, f"{t.rows} × {t.columns}") for t in trials]
    plot_tradeoff(path, points, chosen, file.tolerance.surface, file.unit)


def draw_drawing(axes: Axes, drawing: Drawing) -> None:
    """A drawing for a machine, in the colours of the plain palette."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline
    from matplotlib.textpath import TextPath

    pens = load_palette("plain").pens
    for line in drawing.lines:
        points = np.concatenate([line.points, line.points[: int(line.closed)]])
        axes.plot(*points.T, color=pens[line.layer].colour, linewidth=0.7)
    for text in drawing.texts:
        if text.layer == "ENGRAVE":
            shape = TextPath((0, 0), text.words, size=text.height / 0.73)  # capitals
            size = shape.get_extents()
            moved = shape.vertices - [0.5 * (size.x0 + size.x1), 0.5 * (size.y0 + size.y1)]
            turned = (moved @ [1, 1j]) * np.exp(1j * text.angle)
            points = np.stack([turned.real + text.x, turned.imag + text.y], axis=-1)
            axes.add_patch(PathPatch(Outline(points, shape.codes), color="0.3", linewidth=0))
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])
    axes.plot(*(corners * [drawing.width, drawing.height]).T, color="0.8", linewidth=0.8)


def draw_sheets(path: Path) -> None:
    """Figure 2's sheet split over stock, tabs on the parts."""
    design = design_orthodiagonal(
        graph("-x**2", -1, 1),
        graph("0.25*sin(pi*x/2)", 0, 4),
        OrthodiagonalPattern(rows=9, columns=13, depth=0.12),
    )
    document = document_of_motion(
        FoldingMotion(design.mechanism, 2), "m", title="shell", curves=design.targets
    )
    workshop = Workshop(stock=(2.5, 2.5), margin=0.05, spacing=0.05)
    drawings = list(draw_sheet_files(Path("pattern.svg"), document, workshop))[1:]
    figure, axes = new_figure(13, 3.8, len(drawings))
    for place, (name, drawing) in zip(axes, drawings, strict=True):
        draw_drawing(place, drawing)
        to_scale(place, name.name)
    save(figure, path)


def draw_layers(path: Path) -> None:
    """The membrane of a sheet of card with its glue areas, its upper boards, and solid panels."""
    figure, axes = new_figure(18, 3.6, 3)
    design = design_parallel_repeating(
        graph("-x**2/25", -25, 25),
        graph("125*sin(pi*x/250)", 0, 250),
        ParallelRepeatingPattern(rows=5, columns=5, xi_deg=np.rad2deg(XI), flap=0),
    )
    sheet = design.mechanism
    folds = largest_folds(sheet, sheet.target_drive)
    for build, shown in (
        (
            PanelSpec(thickness=3.2, construction="sandwich", membrane=0.2),
            ("pattern.svg", "pattern-top.svg"),
        ),
        (
            PanelSpec().replace_unchecked(thickness=3.2, construction="bevel"),
            ("pattern-panels.svg",),
        ),
    ):
        document = document_of_motion(
            FoldingMotion(sheet, 2),
            "mm",
            panel=build,
            boards=build_boards(sheet.positions(0.0), sheet.grid, build, folds),
        )
        workshop = Workshop(title_block=False)
        for name, drawing in draw_sheet_files(Path("pattern.svg"), document, workshop):
            if name.name in shown:
                place = axes.pop(0)
                draw_drawing(place, drawing)
                to_scale(place, name.name)
    save(figure, path)


def draw_hinge(path: Path, build: PanelSpec) -> None:
    """A section through a hinge of Figure 1, its panels thicker than they should be."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        graph("5*sin(pi*x/10)", 0, 20),
        ParallelRepeatingPattern(rows=9, columns=11, xi_deg=np.rad2deg(XI), flap=0),
    )
    sheet = design.mechanism
    folds = largest_folds(sheet, sheet.target_drive)
    boards = build_boards(sheet.positions(0.0), sheet.grid, build, folds)
    boards = boards.chosen(~boards.arms)
    section = find_hinge_section(FoldingMotion(sheet, 2), boards, build)
    assert section is not None
    figure = Figure(figsize=(WIDTH, section_height(section)), facecolor="white")
    FigureCanvasAgg(figure)
    draw_hinge_section(figure, section, "m")
    save(figure, path)


def draw_clash(path: Path) -> None:
    """Flaps across an almost closed bend meet half way."""
    from PIL import Image

    design = design_parallel_repeating(
        graph("-x**2", -1, 1),
        pair("2.2*cos(t)", "2.2*sin(t)", 0, 5.5),
        ParallelRepeatingPattern(
            rows=9, columns=24, flap=4.0, flap_side=["start", "start"], xi_deg=np.rad2deg(XI)
        ),
    )
    contact = find_lock(design).first_contact
    assert contact is not None
    plot_overview(
        path,
        FoldingMotion(design.mechanism, 3),
        design.targets,
        title="Flaps that meet before the shell locks",
        last="The target, which it does not reach",
        unit="m",
        contact=DrawnContact(contact.drive, contact.panels),
    )
    with Image.open(path) as picture:
        smaller = picture.convert("RGB").reduce(2)
    smaller.save(path, optimize=True)


def draw_skin(path: Path) -> None:
    """Column 1 of a shell with a second skin, from half folded to nearly shut."""
    f, g = graph("-0.35*x**2", -2, 2), graph("0.4*sin(x)", 0, 5)
    pattern = ParallelRepeatingPattern(rows=7, columns=6, flap=0, xi_deg=60)
    sheet = design_parallel_repeating(f, g, pattern).mechanism
    named = {"half of the target": 0.5, "target": 1.0, "beyond it": 1.25}
    draw_column(path, sheet, {name: k * sheet.target_drive for name, k in named.items()}, 0.15)


def draw_skin_below(path: Path) -> None:
    """Column 1 of the vault of the guide's page with a second skin straight below it."""
    page = path_of_guide("second-skin.md").read_text(encoding="utf-8")
    tables = tomllib.loads(page.split("```toml\n")[3].split("```")[0])
    shell = make_shell(check_design(tables, Path("vault.toml")), skip=MEASURES)
    sheet = shell.design.mechanism
    named = {"open": 0.0, "target": sheet.target_drive, "near the pack": 0.97 * sheet.end_drive}
    draw_column(path, sheet, named, 0.15)


def draw_column(path: Path, sheet: Mechanism, named: Mapping[str, float], gap: float) -> None:
    """Column 1 of a sheet, its second skin and walls, at drives that have names (radians)."""
    assert isinstance(sheet, Skinned)
    skin = sheet.second_skin(slice(0, sheet.grid.columns), gap)
    below, *walls = skin.carried(skin.walls())
    figure, frames = new_figure(11, 3.4, 3)
    column = sheet.positions(np.array([*named.values()]))[:, :, 0]
    widest = 0.53 * float(np.linalg.norm(column[:, -1] - column[:, 0], axis=-1).max())
    for axes, (name, drive) in zip(frames, named.items(), strict=True):
        middle = sheet.positions(drive)[:, 0].mean(axis=0)
        along = sheet.positions(drive)[-1, 0] - sheet.positions(drive)[0, 0]
        along = along / np.linalg.norm(along)
        kinds = [(sheet, "#333333", 1.8), (below, LINE_COLOUR, 1.8)]
        kinds += [(wall, OTHER_COLOUR, 1.3) for wall in walls]
        for each, colour, width in kinds:
            line = each.positions(drive)[:, 0] - middle
            axes.plot(line @ along, line[:, 2], color=colour, linewidth=width)
        axes.set_xlim(-widest, widest)
        to_scale(axes, f"{name}, {np.rad2deg(drive):.0f} degrees")
    save(figure, path)


def draw_end_wall(path: Path) -> None:
    """The shelter of the guide's page, closed behind, and its wall as seen from outside."""
    page = path_of_guide("end-walls.md").read_text(encoding="utf-8")
    tables = tomllib.loads(page.split("```toml\n")[1].split("```")[0])
    shell = make_shell(check_design(tables, Path("bus.toml")), skip=MEASURES)
    figure, (front, behind) = new_figure(11, 4.2, 2)
    seen = draw_lines(shell.document, "target")
    for outline, up, beside in zip(seen.outlines, seen.fronts, seen.beside, strict=True):
        colour = "#9a9a9a" if beside else ("white" if up else "#e2e2e2")
        front.fill(*outline.T, facecolor=colour, edgecolor="#333333", linewidth=0.7)
    to_scale(front, "open in front, closed behind")
    for part, state in shell.document.parts_in("target"):
        if part.kind != "end_wall":
            continue
        strip = state.positions[part.mesh.faces]
        for name, corners in zip(part.names, strip[..., [1, 2]], strict=True):
            behind.fill(*corners.T, facecolor="#d9d9d9", edgecolor="#333333", linewidth=0.9)
            x, y = corners.mean(axis=0).tolist()
            number = name.rpartition(" ")[2]
            behind.text(x, y, number, ha="center", va="center", fontsize=7)
    (wall,) = shell.design.end_walls
    points = shell.document.shell.positions.reshape(*shell.document.grid_shape or (), 3)
    behind.plot(*points[:, wall.laced[0, 1], 1:].T, color=OTHER_COLOUR, linewidth=1.6)
    behind.plot(*points[tuple(wall.laced.T)][:, 1:].T, "o", color=OTHER_COLOUR, markersize=5)
    to_scale(behind, "from outside: strips, the border, and where it is tied")
    save(figure, path)


def draw_strips(path: Path) -> None:
    """The vault of the guide's page: its strips, and how it opens from its pack."""
    from PIL import Image

    page = path_of_guide("t-hedral.md").read_text(encoding="utf-8")
    tables = tomllib.loads(page.split("```toml\n")[1].split("```")[0])
    shell = make_shell(check_design(tables, Path("vault.toml")), skip=MEASURES)
    plot_overview(
        path,
        shell.motion,
        shell.design.targets,
        title="A vault whose columns have their vertices on f",
        last="Folded until it meets the target",
        unit="m",
    )
    with Image.open(path) as picture:
        smaller = picture.convert("RGB").reduce(2)
    smaller.save(path, optimize=True)


def draw_order(path: Path) -> None:
    """Distance from f against rows, of vertices on f and of staircases."""
    f, rows = graph("-0.5*x**2", -1.5, 1.5), [3, 7, 15, 31, 63]
    figure, (axes,) = new_figure(6.4, 4.2, 1)
    for pattern, name, colour in (
        (ParallelRepeatingPattern, "staircase (parallel repeating): 1/rows", OTHER_COLOUR),
        (THedralPattern, "vertices on f (T-hedral): 1/rows\u00b2", LINE_COLOUR),
    ):
        off = [pattern(rows=count, columns=5).distance_from_f(f) for count in rows]
        axes.loglog(rows, off, "o-", color=colour, label=name)
    axes.set_xticks(rows, [str(count) for count in rows])
    axes.minorticks_off()
    axes.set_xlabel("rows")
    axes.set_ylabel("largest distance from f (m), f 3 m wide")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    save(figure, path)


def path_of_guide(name: str) -> Path:
    """A page of the guide."""
    return Path(__file__).parents[1] / "docs" / "guide" / name


PICTURES: Mapping[str, Callable[[Path], None]] = {
    "parallel-xi.png": draw_staircases,
    "parallel-plane.png": draw_planes,
    "orthodiagonal-depth.png": draw_zigzags,
    "longitudinal-angles.png": draw_sections,
    "tolerance.png": draw_choice,
    "thickness-sandwich.png": partial(
        draw_hinge, build=PanelSpec(thickness=0.1, construction="sandwich", membrane=0.01)
    ),
    "thickness-one-side.png": partial(
        draw_hinge, build=PanelSpec(thickness=0.06, sides="top", membrane=0.01)
    ),
    "thickness-bevel.png": partial(
        draw_hinge, build=PanelSpec(thickness=0.1, construction="bevel", gap=0.02)
    ),
    "workshop-sheets.png": draw_sheets,
    "workshop-layers.png": draw_layers,
    "locking-clash.png": draw_clash,
    "second-skin.png": draw_skin,
    "second-skin-vault.png": draw_skin_below,
    "end-walls.png": draw_end_wall,
    "t-hedral.png": draw_strips,
    "t-hedral-order.png": draw_order,
}


def main() -> None:
    """Draw all."""
    directory = Path(sys.argv[1]) if len(sys.argv) > 1 else DIRECTORY
    directory.mkdir(parents=True, exist_ok=True)
    for name, draw in PICTURES.items():
        draw(directory / name)
        print(name)


if __name__ == "__main__":
    main()
