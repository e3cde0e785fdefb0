"""The command ``orishell``: first of all it can be stopped, then it is imported and runs."""

import io
import sys
import warnings

from orishell.conventions.progress import stop_quietly


def main() -> None:
    """Run the command line in a process of its own."""
    stop_quietly()
    if not sys.warnoptions:
        # Numbers beyond all measure are refused by what they lead to, not by a library's word.
        warnings.simplefilter("ignore")
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # may know fewer characters than we do
            stream.reconfigure(errors="backslashreplace")
    from orishell.cli.main import run

    run()


if __name__ == "__main__":
    main()
