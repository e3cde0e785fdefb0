"""The paper reproduced: every figure, and every number that it states beside ours.

Run it with ``make paper`` or ``python examples/paper.py [DIRECTORY]``; it writes the figures,
``table.md`` and ``table.json`` into ``build/paper``. The pictures are those of the gallery's pages.
"""

from __future__ import annotations

import contextlib
import json
import os
import runpy
import sys
from dataclasses import asdict
from pathlib import Path

from orishell.io import OutputDirectory
from paper_numbers import EXACT, Number, all_numbers

EXAMPLES = Path(__file__).parent
DIRECTORY = EXAMPLES.parent / "build" / "paper"


def write_tables(directory: Path, numbers: list[Number]) -> None:
    """Write ``table.md`` and ``table.json``."""
    entries = [{**asdict(each), "difference": each.difference} for each in numbers]
    (directory / "table.json").write_text(json.dumps(entries, indent=2) + "\n", encoding="utf-8")
    lines = [
        "# The paper's numbers beside ours\n",
        "Angles in degrees. A formula of the paper is evaluated; of an equation, the larger of its",
        "two sides' differences is given, which is 0 in the paper. Differences below 1e-9 are",
        "rounding. **Bold**: the two do not agree, and the remark says why.\n",
        "| where | what | paper | ours | difference | remark |",
        "|---|---|---|---|---|---|",
    ]
    for each in numbers:
        ours = f"{each.ours:.10g}" if abs(each.ours) > EXACT else "0"
        shown = f"{each.difference:.2g}" if abs(each.difference) > EXACT else "0"
        if each.within is None:
            ours, shown = f"**{ours}**", f"**{shown}**"
        name = each.name.replace("|", "\\|")
        remark = each.remark.replace("|", "\\|")
        lines.append(f"| {each.where} | {name} | {each.paper:.10g} | {ours} | {shown} | {remark} |")
    (directory / "table.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def draw_figures(directory: Path) -> list[Path]:
    """Run the gallery's pages of the paper's figures and keep their pictures."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    sys.path.insert(0, str(EXAMPLES / "gallery"))  # its pages share drawing.py
    written = []
    for page in sorted((EXAMPLES / "gallery").glob("plot_figure_*.py")):
        plt.close("all")
        with open(os.devnull, "w") as nowhere, contextlib.redirect_stdout(nowhere):
            runpy.run_path(str(page))
        for number in plt.get_fignums():
            figure = plt.figure(number)
            written.append(directory / f"{figure.get_label()}.png")
            figure.savefig(written[-1], dpi=150, metadata={"Software": None})
    plt.close("all")
    return written


def main() -> None:
    """Draw and write everything."""
    directory = Path(sys.argv[1]) if len(sys.argv) > 1 else DIRECTORY
    numbers = all_numbers()
    with OutputDirectory(directory).replacing() as draft:
        write_tables(draft, numbers)
        figures = draw_figures(draft)
    apart = sum(each.within is None for each in numbers)
    print(f"{len(figures)} figures, {len(numbers)} numbers in {directory}")
    print(f"{len(numbers) - apart} are to agree; {apart} are not, and their remarks say why")
    wrong = [each.name for each in numbers if not each.agrees]
    if wrong:
        sys.exit("these do not agree: " + "; ".join(wrong))


if __name__ == "__main__":
    main()
