"""The summary that ``orishell design`` prints."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from orishell.cli.files import lines_of, shortened

if TYPE_CHECKING:
    from orishell.shell.make import Shell


def summarize(shell: Shell, written: list[Path], removed: list[Path]) -> Iterator[str]:
    """Lines that say what was designed, what was found, and which files were written."""
    report = shell.report
    bill = report.quantities
    clipped = f", {bill.clipped} of them clipped on" if bill.clipped else ""
    yield (
        f"{report.family}: {report.rows} x {report.columns} inner vertices, "
        f"{bill.panels} panels{clipped}"
    )
    if report.chosen is not None:
        yield (
            f"chosen for {report.chosen.tolerance:g} {report.unit} from the surface, with the "
            f"fewest panels of {report.chosen.designs_tried} designs tried{_on_stock(shell)}"
        )
    for row in report.verdict:
        yield from lines_of(row)
    yield from (f"wrote     {text}" for text in shortened(written))
    yield from (f"removed   {text}, from an earlier run" for text in shortened(removed))


def _on_stock(shell: Shell) -> str:
    """That panels were chosen to fit the stock, without its margins."""
    from orishell.workshop.layout import usable_stock

    workshop = shell.file.workshop
    if workshop.stock is None:
        return ""
    wide, high = usable_stock(workshop)
    unit = shell.report.unit
    return f" whose panels fit {wide:g} x {high:g} {unit}, the stock without its margins"
