"""``orishell design``: from a design file to a verified shell and its files."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer

from orishell.io import OutputDirectory
from orishell.motion import FoldedState, FoldingMotion
from orishell.report import Shell, design_shell, write_shell

QUIET_BELOW = 1_000_000
"""Vertices times states below which no progress bar is worth showing (less than a second)."""


def design(
    file: Annotated[Path, typer.Argument(help="The design file (TOML).")],
    out: Annotated[Path, typer.Option(help="Directory for the files; made if needed.")],
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the report as JSON instead of a summary.")
    ] = False,
) -> None:
    """Design a shell, verify its motion, write shell.fold, report.json and overview.png."""
    OutputDirectory(out).require_usable()
    shell = design_shell(file, _watched)
    for warning in shell.design.warnings:
        typer.echo(f"orishell: warning: {warning}", err=True)
    written = write_shell(shell, out, _watched)
    if json_report:
        typer.echo(json.dumps({**shell.report, "seconds": shell.seconds}, indent=2))
    else:
        _print_summary(shell, written)


def _watched(motion: FoldingMotion, what: str) -> Iterator[FoldedState]:
    """Show a progress bar on standard error while the states go by."""
    if len(motion) * motion.mechanism.grid.vertex_count < QUIET_BELOW or not sys.stderr.isatty():
        yield from motion
        return
    from rich.console import Console
    from rich.progress import track

    yield from track(motion, description=what, console=Console(stderr=True), transient=True)


def _print_summary(shell: Shell, written: list[Path]) -> None:
    report, unit = shell.report, shell.file.unit
    sheet, deployed, residuals = report["sheet"], report["deployed"], report["residuals"]
    grid = shell.motion.mechanism.grid
    lines = [
        f"{report['family']}: {report['rows']} x {report['columns']} inner vertices, "
        f"{grid.panel_count} panels",
        f"sheet     {sheet['width']:.4g} x {sheet['height']:.4g} {unit}, "
        f"area {sheet['area']:.4g} {unit}2",
        f"deployed  {deployed['width']:.4g} x {deployed['depth']:.4g} x "
        f"{deployed['height']:.4g} {unit}",
        f"deviation f {report['deviation']['f']['max']:.4g} {unit}, "
        f"g {report['deviation']['g']['max']:.4g} {unit}",
        f"rigid     panel lengths to {residuals['panel_length']:.1e}, fold angles to "
        f"{residuals['fold_angle_rad']:.1e} rad over {len(shell.motion)} states",
        "not checked: " + "; ".join(report["not_checked"]),
        *(f"wrote     {path}" for path in written),
    ]
    for line in lines:
        typer.echo(line)
