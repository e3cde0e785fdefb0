"""The picture of the house: rooms of the package on their floors, and what asks what of whom.

Floors are those of the import contract in ``pyproject.toml``, arrows the imports in the sources. An
arrow that follows from others is left out: who asks ``shell`` has all that ``shell`` has.
"""

from __future__ import annotations

import ast
import textwrap
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "orishell"
PICTURE = ROOT / "docs" / "images" / "house.svg"
WIDTH, ROOM, HEIGHT, STEP, GAP, LETTER = 1080, 246, 62, 92, 8, 5.3
"""Of the picture, of a room at most, from floor to floor, between rooms, of a letter (pixels)."""
STYLE = """
.room { fill: #f5f1e8; stroke: #1f4e79; }
.name { font: bold 14px monospace; fill: #1f4e79; }
.what { font: 10.5px sans-serif; fill: #333333; }
.asks { fill: none; stroke: #8a8a8a; marker-end: url(#tip); }
"""


def read_floors() -> list[list[str]]:
    """Rooms floor by floor, the top floor first."""
    with (ROOT / "pyproject.toml").open("rb") as stream:
        contracts = tomllib.load(stream)["tool"]["importlinter"]["contracts"]
    layers = next(each["layers"] for each in contracts if "floors" in each["name"])
    return [[name.strip().removeprefix("orishell.") for name in row.split("|")] for row in layers]


def read_rooms() -> dict[str, list[Path]]:
    """The files of every room: all that stands in the package but its doors."""
    rooms = {}
    for path in sorted(PACKAGE.iterdir()):
        if path.suffix == ".py" and not path.stem.startswith("__"):
            rooms[path.stem] = [path]
        elif (path / "__init__.py").exists():
            rooms[path.name] = sorted(path.rglob("*.py"))
    return rooms


def read_imports() -> dict[str, set[str]]:
    """What each room asks of others, by their names."""
    rooms = read_rooms()
    return {
        room: {
            name.split(".")[1]
            for path in paths
            for name in _imported(path)
            if name.startswith("orishell.") and name.split(".")[1] in rooms
        }
        - {room}
        for room, paths in rooms.items()
    }


def _imported(path: Path) -> list[str]:
    names = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            names.append(node.module)
            names += [f"{node.module}.{each.name}" for each in node.names]
        elif isinstance(node, ast.Import):
            names += [each.name for each in node.names]
    return names


def leave_out_what_follows(asks: dict[str, set[str]]) -> dict[str, set[str]]:
    """The arrows without those that are a way along others."""

    def reached(room: str) -> set[str]:
        return asks[room].union(*(reached(each) for each in asks[room]))

    return {
        room: {each for each in asked if not any(each in reached(other) for other in asked)}
        for room, asked in asks.items()
    }


def draw_house() -> str:
    """The picture as SVG."""
    floors, rooms = read_floors(), read_rooms()
    places = {
        room: ((k + 0.5) * WIDTH / len(row), floor * STEP + 8)
        for floor, row in enumerate(floors)
        for k, room in enumerate(row)
    }
    widths = {room: min(ROOM, WIDTH // len(row) - GAP) for row in floors for room in row}
    parts = []
    for room, asked in sorted(leave_out_what_follows(read_imports()).items()):
        x, y = places[room]
        for other in sorted(asked):
            u, v = places[other]
            middle = (y + HEIGHT + v) / 2
            parts.append(
                f'<path class="asks" d="M{x:.0f} {y + HEIGHT:.0f}C{x:.0f} {middle:.0f} {u:.0f} '
                f'{middle:.0f} {u:.0f} {v:.0f}"/>'
            )
    for room, (x, y) in places.items():
        left = x - widths[room] / 2
        parts.append(
            f'<rect class="room" x="{left:.0f}" y="{y:.0f}" width="{widths[room]}" '
            f'height="{HEIGHT}" rx="3"/>'
        )
        parts.append(f'<text class="name" x="{left + 8:.0f}" y="{y + 17:.0f}">{room}</text>')
        what = ast.get_docstring(ast.parse(rooms[room][0].read_text(encoding="utf-8"))) or ""
        for k, line in enumerate(textwrap.wrap(what.splitlines()[0], int(widths[room] / LETTER))):
            parts.append(
                f'<text class="what" x="{left + 8:.0f}" y="{y + 32 + 12 * k:.0f}">{line}</text>'
            )
    height = len(floors) * STEP - STEP + HEIGHT + 16
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}">\n'
        f"<style>{STYLE}</style>\n"
        '<marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
        'orient="auto"><path d="M0 0 8 4 0 8Z" fill="#8a8a8a"/></marker>\n'
        '<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(parts) + "\n</svg>\n"
    )


def upward(floors: list[list[str]], asks: dict[str, set[str]]) -> list[tuple[str, str]]:
    """Arrows that do not lead down."""
    level = {room: k for k, row in enumerate(floors) for room in row}
    return [
        (room, other) for room, asked in asks.items() for other in asked
        if level[other] <= level[room]
    ]  # fmt: skip
