"""Examples as shells whose kits are written, and what is read back of a kit."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Iterable
from functools import lru_cache
from pathlib import Path

import ezdxf
from ezdxf.document import Drawing
from ezdxf.entities.lwpolyline import LWPolyline
from kept import kept
from pypdf import PdfReader

from design_tables import Tables, formula
from documents import EXAMPLES
from orishell.design_file import check_design, read_design_file
from orishell.shell import Shell, make_shell
from orishell.shell.steps import MEASURES

CARD_SHELL = "figure1_card"
"""48 panels of card on paper, with flaps that are clipped on; four seconds."""


STIFFENED = "stiffened"
"""36 boards and 15 gussets, tied at its feet; two seconds."""
OF_STEEL = "stiffened_of_steel"
"""48 boards on a membrane, and 15 gussets of thinner steel, bolted on; two seconds."""
_ARCH: Tables = {
    "shell": {"family": "orthodiagonal", "unit": "m"},
    "target": {"f": formula("-x**2", -1, 1), "g": formula("0.1*cos(2*pi*x)", 0, 2)},
    "pattern": {"rows": 5, "columns": 5, "flap": 0, "heading_deg": 90, "spacing": "equal"},
    "motion": {"frames": 3},
    "panel": {"construction": "bevel", "thickness": 0.01, "gap": 0.004, "density": 500},
    "deployment": {"from": "pack", "ties": "feet"},
    "stiffeners": {"kind": "gussets"},
    "workshop": {"stock": [2.44, 1.22], "spacing": 0.01},
}
BOXED, BOXED_ON_MEMBRANE = "boxed", "boxed_on_membrane"
"""Three box girders and six plates: 24 solid boards and 24 of strips; or twice as many, glued on a
membrane. Two seconds each."""
_LAMINATED = {"construction": "sandwich", "thickness": 0.01, "membrane": 0.001}
_BOXES = {"kind": "boxes", "share": "auto", "columns": 4}
SKINNED = "skinned"
"""A second skin of 24 boards below as many, on six walls of four. Three seconds."""
_STIFFENED = {
    SKINNED: {
        "shell": {"family": "parallel-repeating", "unit": "m"},
        "target": {
            "f": {"formula": "-0.35*x**2", "range": [-2, 2]},
            "g": {"formula": "0.4*sin(x)", "range": [0, 4]},
        },
        "pattern": {"rows": 5, "columns": 5, "flap": 0, "xi_deg": 60},
        "panel": {"construction": "bevel", "thickness": 0.012, "gap": 0.004, "density": 500},
        "stiffeners": {"kind": "skin", "gap": 0.15},
    },
    STIFFENED: _ARCH,
    BOXED: {**_ARCH, "stiffeners": _BOXES},
    BOXED_ON_MEMBRANE: {
        **_ARCH,
        "panel": {**_LAMINATED, "density": 500, "membrane_density": 900},
        "stiffeners": _BOXES,
    },
    OF_STEEL: {
        **_ARCH,
        "panel": {**_LAMINATED, "density": 500, "membrane_density": 900},
        "stiffeners": {
            **{"kind": "gussets", "thickness": 0.004, "material": "steel"},
            "bolts": {"hole": 0.008, "spacing": 0.08},
        },
    },
}


@kept
def shell_of(name: str) -> Shell:
    """An example, with its pack and quantities; distances from its target are not measured."""
    skip = {*MEASURES} - {"pack", "weight", "stock"}
    if name in _STIFFENED:
        return make_shell(check_design(_STIFFENED[name], Path(f"{name}.toml")), skip=skip)
    return make_shell(read_design_file(EXAMPLES / f"{name}.toml"), skip=skip)


def rows_of(file: Path) -> list[dict[str, str]]:
    """Rows of a table; none if there is no such table."""
    if not file.exists():
        return []
    with file.open(newline="") as stream:
        return [*csv.DictReader(stream)]


def read_sound(file: Path) -> Drawing:
    """A drawing in which ezdxf's audit finds nothing; read once as long as it is not rewritten."""
    return _read_sound(file, file.stat().st_mtime_ns)


@lru_cache(maxsize=64)
def _read_sound(file: Path, _: int) -> Drawing:
    drawing = ezdxf.readfile(file)
    auditor = drawing.audit()
    assert not auditor.errors
    assert not auditor.fixes
    return drawing


def names_in(files: Iterable[Path], layer: str = "ENGRAVE") -> Counter[str]:
    """How often each name is written in drawings, on what is cut."""
    return Counter(
        text.dxf.text
        for file in files
        for text in read_sound(file).modelspace().query(f'TEXT[layer=="{layer}"]')
    )


def outlines_in(files: Iterable[Path]) -> int:
    """How many closed lines are cut in drawings."""
    return sum(
        entity.closed
        for file in files
        for entity in read_sound(file).modelspace().query('LWPOLYLINE[layer=="CUT"]')
        if isinstance(entity, LWPolyline)
    )


def booklet_counts(file: Path) -> dict[str, int]:
    """What the page of parts says: counts by the name that stands below each."""
    text = PdfReader(file).pages[1].extract_text()
    return {name: int(count) for count, name in re.findall(r"(\d+) x\n(.+)", text)}
