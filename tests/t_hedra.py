"""Random T-hedral sheets, for the tests."""

from __future__ import annotations

import numpy as np

from orishell.families.t_hedral import THedral


def random_sheet(seed: int, *, flaps: bool = False, rows: int = 6, columns: int = 9) -> THedral:
    """A sheet of up to so many rows and columns, whose row edges all have some length."""
    random = np.random.default_rng(seed)
    while True:
        edges, count = 2 * int(random.integers(1, rows)), int(random.integers(3, columns))
        slopes = random.uniform(0.1, 3, edges) * random.choice([-1, 1], edges)
        turns = np.cumsum(random.uniform(-0.5, 0.5, count - 1))
        steps = random.uniform(3, 5, count - 1) * np.exp(1j * turns)
        between = 0.5 * (turns[1:] + turns[:-1])
        heading = np.concatenate([turns[:1], between, turns[-1:]])
        heading += random.uniform(-0.3, 0.3, count)
        sheet = THedral(
            lengths=random.uniform(0.2, 1, edges),
            slopes=slopes,
            points=np.append(0, np.cumsum(steps)),
            axes=np.exp(1j * (heading - np.pi / 2)),
            flaps=(0.0, 0.0),
        )
        if min(sheet.row_lengths(row).min() for row in (0, edges)) > 0.05:
            return sheet.with_flaps(0.3) if flaps else sheet
