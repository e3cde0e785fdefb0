"""The picture of the architecture: packages on their layers, and which imports which.

Layers are those of the import contract in ``pyproject.toml``, arrows the imports in the sources. An
arrow that follows from others is left out: what imports ``shell`` has all that ``shell`` imports.
"""

from __future__ import annotations

import ast
import textwrap
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "orishell"
PICTURE = ROOT / "docs" / "images" / "architecture.svg"
WIDTH, WIDEST, HEIGHT, STEP, GAP, LETTER = 1080, 246, 62, 92, 8, 5.7
"""Of the picture, the widest box, its height, from layer to layer, between boxes, a letter (px)."""
STYLE = """
.package { fill: #f5f1e8; stroke: #1f4e79; }
.name { font: bold 14px monospace; fill: #1f4e79; }
.what { font: 10.5px sans-serif; fill: #333333; }
.asks { fill: none; stroke: #8a8a8a; marker-end: url(#tip); }
"""


def read_layers() -> list[list[str]]:
    """Packages layer by layer, the top layer first."""
    with (ROOT / "pyproject.toml").open("rb") as stream:
        contracts = tomllib.load(stream)["tool"]["importlinter"]["contracts"]
    layers = next(each["layers"] for each in contracts if each["name"] == "Layers point one way")
    return [[name.strip().removeprefix("orishell.") for name in row.split("|")] for row in layers]


def read_packages() -> dict[str, list[Path]]:
    """The files of every package: all but the modules of ``orishell`` that import them."""
    packages = {}
    for path in sorted(PACKAGE.iterdir()):
        if path.suffix == ".py" and not path.stem.startswith("__"):
            packages[path.stem] = [path]
        elif (path / "__init__.py").exists():
            packages[path.name] = sorted(path.rglob("*.py"))
    return packages


def read_imports() -> dict[str, set[str]]:
    """The other packages that each imports, by their names."""
    packages = read_packages()
    return {
        package: {
            name.split(".")[1]
            for path in paths
            for name in _imported(path)
            if name.startswith("orishell.") and name.split(".")[1] in packages
        }
        - {package}
        for package, paths in packages.items()
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

    def reached(package: str) -> set[str]:
        return asks[package].union(*(reached(each) for each in asks[package]))

    return {
        package: {each for each in asked if not any(each in reached(other) for other in asked)}
        for package, asked in asks.items()
    }


def draw_architecture() -> str:
    """The picture as SVG."""
    layers, packages = read_layers(), read_packages()
    places = {
        package: ((k + 0.5) * WIDTH / len(row), layer * STEP + 8)
        for layer, row in enumerate(layers)
        for k, package in enumerate(row)
    }
    widths = {package: min(WIDEST, WIDTH // len(row) - GAP) for row in layers for package in row}
    parts = []
    for package, asked in sorted(leave_out_what_follows(read_imports()).items()):
        x, y = places[package]
        for other in sorted(asked):
            u, v = places[other]
            middle = (y + HEIGHT + v) / 2
            parts.append(
                f'<path class="asks" d="M{x:.0f} {y + HEIGHT:.0f}C{x:.0f} {middle:.0f} {u:.0f} '
                f'{middle:.0f} {u:.0f} {v:.0f}"/>'
            )
    for package, (x, y) in places.items():
        left = x - widths[package] / 2
        parts.append(
            f'<rect class="package" x="{left:.0f}" y="{y:.0f}" width="{widths[package]}" '
            f'height="{HEIGHT}" rx="3"/>'
        )
        parts.append(f'<text class="name" x="{left + 8:.0f}" y="{y + 17:.0f}">{package}</text>')
        what = ast.get_docstring(ast.parse(packages[package][0].read_text(encoding="utf-8"))) or ""
        lines = textwrap.wrap(what.splitlines()[0], int(widths[package] / LETTER))
        for k, line in enumerate(lines):
            parts.append(
                f'<text class="what" x="{left + 8:.0f}" y="{y + 32 + 12 * k:.0f}">{line}</text>'
            )
    height = len(layers) * STEP - STEP + HEIGHT + 16
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}">\n'
        f"<style>{STYLE}</style>\n"
        '<marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
        'orient="auto"><path d="M0 0 8 4 0 8Z" fill="#8a8a8a"/></marker>\n'
        '<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(parts) + "\n</svg>\n"
    )


def upward(layers: list[list[str]], asks: dict[str, set[str]]) -> list[tuple[str, str]]:
    """Arrows that do not lead down."""
    level = {package: k for k, row in enumerate(layers) for package in row}
    return [
        (package, other) for package, asked in asks.items() for other in asked
        if level[other] <= level[package]
    ]  # fmt: skip
