"""T-hedral shells through the whole design: how near they come, what they are made of."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from design_tables import formula, tables
from orishell.conventions.errors import DesignError, InputError
from orishell.curves import Curve
from orishell.design_file import check_design
from orishell.deviation import measure_deviation
from orishell.families.parallel_repeating import ParallelRepeatingPattern, design_parallel_repeating
from orishell.families.t_hedral import THedralPattern, design_t_hedral
from orishell.io import read_fold
from orishell.io.fold import document_of_fold
from orishell.motion.as_made import in_strips, panels_laid_flat
from orishell.motion.quads import grid_corners
from orishell.shell.designed import designed
from orishell.shell.export import write_shell
from orishell.shell.make import Shell, make_shell
from orishell.shell.pictures import lay_surface
from strategies import graph

ARCH, WAVE = graph("-0.5*x**2", -1, 1), graph("0.2*sin(x)", 0, 6)
ROWS = (7, 15, 31, 63)


def order(distances: list[float]) -> float:
    """The power of one over the number of edges by which distances fall, from first to last."""
    edges = np.log([rows + 1 for rows in ROWS])
    return float(-np.polyfit(edges, np.log(distances), 1)[0])


def test_distance_from_f_falls_with_the_square_of_its_edges() -> None:
    """Beside parallel repeating's, whose staircase falls with their number (docs/limits.md)."""

    def off(curve: Curve) -> tuple[float, float]:
        near, stairs = (
            [pattern(rows=rows, columns=5).distance_from_f(curve) for rows in ROWS]
            for pattern in (THedralPattern, ParallelRepeatingPattern)
        )
        return order(near), order(stairs)

    square, linear = off(ARCH)
    assert square == pytest.approx(2, abs=0.1)
    assert linear == pytest.approx(1, abs=0.1)


def test_the_shell_comes_nearer_than_a_staircase() -> None:
    near = design_t_hedral(ARCH, WAVE, THedralPattern(rows=15, columns=21, flap=0))
    pattern = ParallelRepeatingPattern(rows=15, columns=21, flap=0)
    stairs = design_parallel_repeating(ARCH, WAVE, pattern)
    assert measure_deviation(near).max < measure_deviation(stairs).max / 10


def test_vertices_of_columns_lie_on_f() -> None:
    design = design_t_hedral(ARCH, WAVE, THedralPattern(rows=9, columns=5, flap=0))
    target = design.mechanism.positions(design.mechanism.target_drive)
    across = np.linalg.norm(target[:, 0, :2] - target[5, 0, :2], axis=-1)
    np.testing.assert_allclose(target[:, 0, 2], -0.5 * across**2, atol=1e-12)


def test_strips_are_the_panels_laid_flat() -> None:
    pattern = THedralPattern(rows=7, columns=5, flap=0.2, depth=0.2)
    mechanism = design_t_hedral(ARCH, graph("0", 0, 4), pattern).mechanism
    corners = grid_corners(mechanism.positions(0.3 * mechanism.end_drive))
    flat = panels_laid_flat(mechanism).reshape(*corners.shape[:-1], 2)
    for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3)):
        one, other = (
            np.linalg.norm(each[..., a, :] - each[..., b, :], axis=-1) for each in (flat, corners)
        )
        np.testing.assert_allclose(one, other, rtol=1e-12)
    strips = in_strips(mechanism)
    np.testing.assert_array_equal(
        strips.flat[strips.mesh.faces].shape, (*flat[..., 0, 0].ravel().shape, 4, 2)
    )
    # They are apart: each has a range of x of its own.
    low, high = flat[..., 0].min(axis=(0, 2)), flat[..., 0].max(axis=(0, 2))
    assert (low[1:] > high[:-1]).all()
    # And lie where they lay, if flaps are left out.
    alone = panels_laid_flat(mechanism.without_flaps()).reshape(len(flat), -1, 4, 2)
    np.testing.assert_allclose(alone, flat[:, 1:-1], atol=1e-12)


def vault(**pattern: Any) -> dict[str, Any]:
    design = tables("t-hedral", formula("-0.5*x**2", -1.5, 1.5), formula("0", 0, 4))
    design["pattern"] = {"rows": 7, "columns": 9, "flap": 0, "depth": 0.15, **pattern}
    design["deployment"], design["motion"] = {"from": "pack"}, {"frames": 5}
    return design


def made(design: dict[str, Any]) -> Shell:
    return make_shell(check_design(design, Path("vault.toml")))


def test_a_vault_folds_flat_and_has_files_of_its_strips(tmp_path: Path) -> None:
    shell = made(vault())
    rows = {row.subject: row for row in shell.report.verdict}
    assert rows["folds"].sign == "holds"
    assert "from open to 180 degrees (proved" in rows["folds"].finding
    assert rows["sheet"].finding.startswith("8 strips, up to ")
    assert shell.report.degrees_of_freedom == 1
    formats = ["fold", "dxf", "svg", "glb", "obj", "pdf", "csv", "booklet"]
    write_shell(shell, tmp_path, formats=formats)
    fold = json.loads((tmp_path / "shell.fold").read_text("utf-8"))
    assert len(fold["vertices_coords"]) == 9 * 9  # joined, as they fold
    assert "creasePattern" not in fold.get("frame_classes", [])
    assert shell.document.state("open").drive_deg == 0
    with pytest.raises(InputError, match="no such state"):
        shell.document.state("flat")  # and not the pack, which is the first
    lying = shell.document.as_cut()
    np.testing.assert_array_equal(lying.state("flat").positions[:, :2], lying.require_flat())
    with pytest.raises(InputError, match="made of strips"):
        write_shell(shell, tmp_path, formats=["origami-simulator"])


def test_flaps_lock_it() -> None:
    design = vault(flap=0.2)
    design["deployment"] = {"from": "flat"}
    rows = {row.subject: row for row in made(design).report.verdict}
    assert "its flaps stop it closing" in rows["locks"].finding


def test_what_it_cannot_be_is_refused() -> None:
    design = vault()
    design["panel"] = {"thickness": 0.01, "construction": "hinged"}
    with pytest.raises(DesignError, match="flat in no state") as found:
        designed(check_design(design, Path("vault.toml")))
    (offered,) = found.value.candidates
    changed = check_design(design, Path("vault.toml")).changed(offered.changes)
    assert designed(changed).panel is not None
    level = THedralPattern(rows=3, columns=5, flap=0, spacing="equal")
    with pytest.raises(DesignError, match="level at the target"):
        design_t_hedral(graph("0", 0, 4), WAVE, level)


def test_views_have_its_strips_with_distances_of_their_vertices() -> None:
    shell = made(vault())
    document = lay_surface(shell.document, shell.design)
    cut, mesh = document.as_cut(), document.mesh
    assert document.distances is not None
    assert cut.distances is not None
    assert len(cut.distances) == cut.mesh.vertex_count > mesh.vertex_count
    np.testing.assert_array_equal(cut.shell.positions, document.shell.positions[document.cut_from])
    np.testing.assert_array_equal(cut.distances[cut.mesh.faces], document.distances[mesh.faces])
    assert cut.as_cut() is cut


def test_states_in_fold_have_their_own_names(tmp_path: Path) -> None:
    """Without a flat sheet the first state is the key frame, and all others come after it."""
    shell = made(vault())
    write_shell(shell, tmp_path, formats=["fold"])
    read = document_of_fold(read_fold(tmp_path / "shell.fold"))
    for name in ("pack", "target", "open"):
        found, expected = (each.state(name).positions for each in (read, shell.document))
        np.testing.assert_array_equal(found, shell.document.in_world(expected))


@pytest.mark.slow
def test_a_depth_that_is_too_large_is_refused_with_one_that_works() -> None:
    """No plane_deg is offered: these planes cannot be turned."""
    along_a_wave = vault(depth=20.0)
    along_a_wave["target"]["g"] = formula("0.3*sin(x)", 0, 6)
    with pytest.raises(DesignError) as refused:
        made(along_a_wave)
    assert "plane_deg" not in str(refused.value)
    [remedy] = refused.value.remedies
    along_a_wave["pattern"]["depth"] = remedy.changes["pattern.depth"]
    made(along_a_wave)


def test_errors_of_cutting_are_said_to_be_unmeasured() -> None:
    """Their measure takes vertices of one flat sheet."""
    cut = vault()
    cut["workshop"] = {"cutting_error": 0.001}
    report = made(cut).report
    assert report.cutting is None
    assert any("cutting" in each for each in report.not_checked)
