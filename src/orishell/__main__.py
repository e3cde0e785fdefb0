"""The command ``orishell``: first of all it can be stopped, then it is imported and runs."""

from orishell.stopping import stop_quietly


def main() -> None:
    """Run the command line."""
    stop_quietly()
    from orishell.cli.main import run

    run()


if __name__ == "__main__":
    main()
