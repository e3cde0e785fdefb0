"""The guide's pictures of components in Grasshopper, drawn from what Hops is told of their ports.

``python tests/hops_pictures.py`` writes them anew.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from orishell.studio.hops.protocol import GIVEN

PLACE: Final = Path(__file__).parents[1] / "docs" / "images" / "guide"
ROW, HEAD, LETTER, MARGIN = 18, 24, 6.3, 16
STYLE: Final = (
    "text{font:11px system-ui,sans-serif;fill:#1b1b1b}.name{font-weight:600}.end{text-anchor:end}"
    ".box{fill:#f4f1ea;stroke:#1d3d5c;stroke-width:1.2}.given{fill:#e3edf7}"
    "path{fill:none;stroke:#1d3d5c;stroke-width:1.6}circle{fill:#fff;stroke:#1d3d5c}"
    ".back{fill:#ffffff}"
)
Wire = tuple[str, str]
PICTURES: Final[dict[str, tuple[dict[str, tuple[int, int]], dict[str, str], list[Wire]]]] = {
    "grasshopper-state.svg": (
        {
            "Curve f": (0, 20),
            "Curve g": (0, 62),
            "Panel: xi_deg = 50": (0, 126),
            "Slider: 0 to 1": (330, 146),
            "curves": (190, 0),
            "state": (500, 40),
        },
        {"Curve f": "", "Curve g": "", "Panel: xi_deg = 50": "", "Slider: 0 to 1": ""},
        [
            ("Curve f.", "curves.f"),
            ("Curve g.", "curves.g"),
            ("Panel: xi_deg = 50.", "curves.keys"),
            ("curves.design", "state.design"),
            ("Slider: 0 to 1.", "state.drive"),
        ],
    ),
    "grasshopper-workshop.svg": (
        {
            "File Path": (0, 24),
            "Slider: 0 to 1": (230, 232),
            "File Path: kit": (230, 312),
            "Toggle": (272, 344),
            "file": (120, 0),
            "pattern": (470, 0),
            "verdict": (470, 118),
            "boards": (470, 200),
            "files": (470, 282),
        },
        dict.fromkeys(("File Path", "Toggle", "File Path: kit", "Slider: 0 to 1"), ""),
        [
            ("File Path.", "file.path"),
            ("file.design", "boards.design"),
            ("Slider: 0 to 1.", "boards.drive"),
            ("file.design", "pattern.design"),
            ("file.design", "verdict.design"),
            ("file.design", "files.design"),
            ("File Path: kit.", "files.folder"),
            ("Toggle.", "files.write"),
        ],
    ),
}
"""Where components and what is connected to them stand, and the wires between their ports."""


def draw(name: str) -> str:
    """A picture, by the name of its file."""
    places, own, wires = PICTURES[name]
    ends: dict[str, tuple[float, float]] = {}
    boxes: list[str] = []
    for each, (x, y) in places.items():
        left = [] if each in own else [*GIVEN[each]["inputs"]]
        right = [""] if each in own else [*GIVEN[each]["outputs"]]
        title = each if each in own else GIVEN[each]["name"]
        most = max(len(a) + len(b) for a in (*left, "") for b in right)
        width = max(LETTER * len(title) + 20, LETTER * most + 44)
        head = 0 if each in own else HEAD
        height = head + ROW * max(len(left), len(right)) + 6
        kind = "box given" if each in own else "box"
        boxes.append(
            f'<rect class="{kind}" x="{x}" y="{y}" width="{width:g}" height="{height}" rx="5"/>'
        )
        boxes.append(f'<text class="name" x="{x + 8}" y="{y + 16}">{title}</text>')
        for side, ports, at in (("", left, float(x)), (' class="end"', right, x + width)):
            for number, port in enumerate(ports):
                level = y + head + ROW * number + 12
                ends[f"{each}.{port}"] = at, level
                boxes.append(f'<circle cx="{at:g}" cy="{level}" r="3.5"/>')
                inside = at + (-9 if side else 9)
                boxes.append(f'<text{side} x="{inside:g}" y="{level + 4}">{port}</text>')
    lines = []
    for first, last in wires:
        (x0, y0), (x1, y1) = ends[first], ends[last]
        bend = max(40.0, abs(x1 - x0) / 2)
        lines.append(f'<path d="M{x0:g} {y0}C{x0 + bend:g} {y0} {x1 - bend:g} {y1} {x1:g} {y1}"/>')
    wide = max(x for x, _ in ends.values()) + 2 * MARGIN
    high = max(y for _, y in ends.values()) + 3 * MARGIN
    box = f"{-MARGIN} {-MARGIN} {wide:g} {high:g}"
    whole = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="{wide:g}">'
    back = f'<rect class="back" x="{-MARGIN}" y="{-MARGIN}" width="{wide:g}" height="{high:g}"/>'
    return "\n".join([whole, f"<style>{STYLE}</style>", back, *lines, *boxes, "</svg>", ""])


if __name__ == "__main__":
    for name in PICTURES:
        (PLACE / name).write_text(draw(name), encoding="utf-8")
