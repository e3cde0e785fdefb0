"""Shells of the sizes that a design file asks for, measured in the files that are written."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from orishell.conventions.errors import DesignError
from orishell.design_file import check_design
from orishell.io.formats import find_formats
from orishell.shell.export import write_shell
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import MEASURES
from samples import led_by
from sized_shells import DESIGNS, OWN, Tables, sizes

EXACT = 1.0e-3
"""What sizes are kept to: a millimetre, in metres. Most are within 0.02 mm, and 0.5 mm is where the
search ends after a proof."""
SEED = 11


def asking(name: str, **fit: Any) -> Tables:
    """A design that asks for sizes."""
    tables = DESIGNS[name]
    return {**tables, "target": {**tables["target"], "fit": fit}}


def requests(count: int = 30) -> list[tuple[str, Tables]]:
    """Designs of every kind in turn, and sizes about theirs: outside and inside by turns."""
    rng = np.random.default_rng(SEED)
    names = [*DESIGNS]
    found: list[tuple[str, Tables]] = []
    for number in range(count):
        name = names[number % len(names)]
        own = OWN[name]
        of = ("outside", "inside")[(number // len(names) + number) % 2]
        keys = [key for key in own[of] if rng.random() < 0.7] or ["height"]
        if name == "drawn":
            keys = keys[:1]
        fit: Tables = {key: round(own[of][key] * rng.uniform(0.75, 1.35), 2) for key in keys}
        if of == "inside":
            fit["of"] = of
            if set(keys) & {"width", "depth"}:
                headroom = fit.get("height", own[of]["height"])
                fit["head_height"] = round(headroom * rng.uniform(0.5, 0.85), 2)
        found.append((name, fit))
    return found


def measured(shell: Shell, directory: Path, fit: Tables) -> dict[str, float]:
    """Sizes of the OBJ file that is written of a shell."""
    paths = write_shell(shell, directory, formats=find_formats(["obj"]))
    path = next(each for each in paths if each.suffix == ".obj")
    return sizes(path, fit.get("of", "outside"), fit.get("head_height", 2.0))


def made(tables: Tables) -> Shell:
    """The shell of a design, proved."""
    return make_shell(check_design(tables, Path("x.toml")), skip=MEASURES)


@pytest.mark.parametrize(("name", "fit"), led_by(requests(), 0))
def test_a_written_shell_has_the_sizes_asked_for_or_the_nearest_is_told(
    name: str, fit: Tables, tmp_path: Path
) -> None:
    tables = asking(name, **fit)
    try:
        shell = made(tables)
    except DesignError as refusal:
        assert refusal.remedies, str(refusal)
        file = check_design(tables, Path("x.toml")).changed(refusal.remedies[0].changes)
        fit = file.tables["target"].get("fit", {})
        shell = make_shell(file, skip=MEASURES)
    found = measured(shell, tmp_path, fit)
    for key in {"width", "depth", "height"} & fit.keys():
        assert found[key] == pytest.approx(fit[key], abs=EXACT)
