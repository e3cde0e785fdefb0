"""Importing this module imports all that answers need; processes are copies of one that has."""

from __future__ import annotations

from orishell.conventions.progress import no_progress
from orishell.studio.tasks import answer

answer("warm_up", {}, no_progress)
