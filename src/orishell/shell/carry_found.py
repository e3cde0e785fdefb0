"""What a search for designs that carry has found, as files and pages have it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from orishell.conventions.record import record
from orishell.shell.carry_change import Change
from orishell.shell.facts import Facts
from orishell.structure.results import Analysis


@record
class Carrying:
    """A design that carries all its cases, made and analysed as its file asks."""

    REPORTED = ("words", "changes", "mass", "parts", "pack", "used", "governs", "left")

    change: Change  # of the file
    analysis: Analysis
    parts: int  # on the site: pieces, what is clipped on, ties and locks
    pack: tuple[float, float, float] | None  # sides of its pack (length); None without one
    # what nothing but supports does, in words; empty if the shell locks by itself
    left: str

    @property
    def words(self) -> str:
        """What is changed."""
        return self.change.words

    @property
    def changes(self) -> Mapping[str, Any]:
        """Values by key of the design file; None removes a key."""
        return self.change.values

    @property
    def mass(self) -> float | None:
        """Of all that loads it with its own weight (kg); None where that is not known."""
        return self.analysis.model.mass or None

    @property
    def used(self) -> float | None:
        """The share of what is borne that is used by what governs; None if nothing is known."""
        governs = self.analysis.governs
        return None if governs is None else governs.utilisation

    @property
    def governs(self) -> str:
        """What governs, in words; empty if nothing does."""
        if self.analysis.governs is None:
            return ""
        return self.analysis.governing_in_words().partition(" governs")[0]

    def beats(self, mass: float, parts: int, changes: int) -> bool:
        """Whether it is no heavier than another one, in no more parts and with no more changes."""
        others = mass, parts, changes
        own = round(self.mass or 0.0, 3), self.parts, len(self.changes)
        return all(one <= other for one, other in zip(own, others, strict=True))


@record
class CarrySearch:
    """What was found: designs that carry, and what was tried in vain."""

    REPORTED = ("carries", "words", "found", "tried", "near", "ended")

    begun: Analysis  # of the file as it is
    found: tuple[Carrying, ...]  # designs that carry, the lightest first
    tried: tuple[str, ...]  # every trial: what it adds to which, and how it ended
    nearest: tuple[Change, Analysis] | None  # what came nearest, with few cells, if none carries
    ended: bool  # whether more would have taken too long

    @property
    def carries(self) -> bool | None:
        """Whether the file's own design carries; None if that is not known."""
        return self.begun.carries

    @property
    def words(self) -> str:
        """What the file's own design does under its loads."""
        return self.begun.in_words()

    @property
    def near(self) -> str:
        """What came nearest, and how that ended; empty if a design carries."""
        if self.nearest is None:
            return ""
        change, analysis = self.nearest
        return f"{change.words or 'the file as it is'}: {analysis.in_words()}"


def ended(found: Analysis) -> str:
    """How a trial ended, in a line: what governs, or the worst that speaks against it."""
    if found.carries:
        return f"carries: {found.governing_in_words()}"
    worst = found.ranked[0]
    return found.in_words().replace(worst.said, worst.findings[0].text)


def left_to_supports(facts: Facts) -> str:
    """What nothing but supports does for a shell, as its verdict says it; empty if it locks."""
    ways = facts.deployment.left_to_supports
    return f"only its supports stop it {' and '.join(ways)}" if ways else ""


def parts_on_site(facts: Facts) -> int:
    """What is handled on the site: pieces, girders, what is clipped on, ties, locks."""
    design, deployment = facts.found.design, facts.deployment
    grid = design.mechanism.grid
    clipped = 0 if design.clipped is None else 2 * (grid.rows - 1)
    file, locks = facts.found.file, 0
    if file.structure is not None and file.structure.crease_stiffness[0] > 0:
        rows, columns = grid.rows - 1, grid.columns - 1
        locks = (rows - 1) * columns + rows * (columns - 1)
    clipped += sum(len(part.mesh.faces) for part in design.attached)
    pieces = max(1, len(deployment.pieces)) + len(design.boxes)
    return pieces + clipped + len(deployment.ties) + locks
