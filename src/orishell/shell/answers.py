"""What a design file left open, and what was found for it."""

from __future__ import annotations

from orishell.conventions.record import record
from orishell.shell.family_choice import FamilyChoice
from orishell.shell.fit.report import FittedSize
from orishell.shell.size_trials import Choice
from orishell.shell.turn_search import TurnChoice


@record
class Answers:
    """What was found for each question that a design file left open; None where it was not."""

    families: FamilyChoice | None = None  # what each family makes of the target
    turned: TurnChoice | None = None  # how its rectangle is turned
    choice: Choice | None = None  # how rows and columns were chosen, by its tolerance
    fitted: FittedSize | None = None  # how its target was scaled to the sizes asked for
