"""``python -m orishell``."""

from orishell.cli.main import run

run()
