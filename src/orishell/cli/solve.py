"""``orishell solve``: the columns that can follow one with given sector angles."""

from __future__ import annotations

import json
from typing import Annotated

import typer

from orishell.cli.files import say

SECOND = ("alpha_2", "beta_2", "gamma_2", "delta_2")


def solve(
    alpha: Annotated[float, typer.Argument(help="alpha_1 in degrees.")],
    beta: Annotated[float, typer.Argument(help="beta_1 in degrees.")],
    gamma: Annotated[float, typer.Argument(help="gamma_1 in degrees.")],
    delta: Annotated[float, typer.Argument(help="delta_1 in degrees.")],
    json_report: Annotated[
        bool, typer.Option("--json", help="Print the solutions as JSON.")
    ] = False,
) -> None:
    """List all solutions of equation (4) for four sector angles.

    They are those of column 1, alpha, beta, gamma and delta.
    """
    from orishell.families.longitudinal_linear_repeating import SEARCHED, describe_solutions

    found = describe_solutions([alpha, beta, gamma, delta])
    if json_report:
        say(json.dumps(found, indent=2))
        return
    for number, entry in enumerate(found["solutions"]):
        angles = ", ".join(
            f"{name} = {angle:.4f}"
            for name, angle in zip(SECOND, entry["second_sector_deg"], strict=True)
        )
        size = entry["largest_square"]
        largest = f"{size} x {size}" if size < SEARCHED else f"{size} x {size} or more"
        say(f"solution {number} ({entry['version']} version): {angles}")
        say(
            f"  c = {entry['c']:.12g}; v_1 from 0 to {entry['motion_end_deg']:.4f} degrees; "
            f"largest square sheet {largest} inner vertices"
        )
