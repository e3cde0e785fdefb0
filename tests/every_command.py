"""Every command once, with the Python that runs this: a short look at an environment.

``.ci/least`` calls it with the least versions of what the package needs, and with the newest. It
needs nothing of the tests but httpx.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

import httpx

from hops_client import Document, running_hops
from studio_server import running_studio

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
SEARCH = """
[shell]
family = "parallel-repeating"
unit = "m"

[target]
f = { formula = "-x**2", range = [-1, 1] }
g = { formula = "0.1*x", range = [0, 2] }

[pattern]
rows = 3
columns = 2
xi_deg = 50

[search]
minimise = ["panels", "sheet_area"]
evaluations = 8
population = 4
method = "nsga2"
variables."pattern.rows" = [3, 5, 7, 9, 11]
variables."pattern.columns" = [2, 3, 4]
"""
COMMANDS = (
    "new arch new.toml",
    "design new.toml --out new",
    "design @tunnel.toml --out tunnel --write all",
    "design @figure1_card.toml --out card --write all",
    "design @free_roof.toml --out roof --no-clash-test",
    "design @from_dxf.toml --out drawn",
    "kit @figure1_card.toml --out kit",
    "kit @figure1_card.toml --out model --paper",
    "structure @arch_pattern.toml --out arch",
    "search search.toml --out found --processes 1 --write html",
    "check tunnel/shell.fold",
    "check @arch_pattern.svg",
    "fold @arch_pattern.svg --out folded --unit mm",
    "convert tunnel/shell.fold tunnel.dxf",
    "solve 70 100 80 110",
)
"""Commands that end with status 0; @ stands for the examples."""
SHOWN = ("numpy", "scipy", "pydantic", "typer", "rhino3dm")


def commands() -> set[str]:
    """The commands that are tried, by their names."""
    return {line.partition(" ")[0] for line in COMMANDS} | {*SERVERS}


def failure(line: str, place: Path) -> str:
    """What is wrong with a command that is called in a folder; empty if nothing is."""
    arguments = line.replace("@", f"{EXAMPLES}/").split()
    done = subprocess.run(
        [sys.executable, "-m", "orishell", *arguments],
        cwd=place,
        capture_output=True,
        text=True,
        check=False,
        timeout=1200,
    )
    wrong = done.returncode != 0 or "a fault of the program" in done.stderr
    return f"status {done.returncode}\n{done.stdout}{done.stderr}" if wrong else ""


def studio_failure() -> str:
    """What is wrong with the studio; empty if it answers with its page and its information."""
    with running_studio() as studio, httpx.Client(cookies=studio.cookies, timeout=60) as client:
        answers = {
            path: client.get(studio.address + path).status_code for path in ("/", "/api/info")
        }
    return "" if set(answers.values()) == {200} else f"answers {answers}"


def hops_failure() -> str:
    """What is wrong with Grasshopper's components; empty if they make a design and a state."""
    with running_hops() as address, httpx.Client(base_url=f"{address}/", timeout=60) as client:
        document = Document(client)
        design = document.solve("file", path=str(EXAMPLES / "vault.toml"))["design"]
        return "" if document.solve("state", design=design)["mesh"] else "no mesh"


SERVERS = {"studio": studio_failure, "hops": hops_failure}
"""Commands that serve, and what is wrong with them."""


def main() -> None:
    """Try all, and say which failed; status 1 if any did."""
    where = ".".join(map(str, sys.version_info[:3]))
    print(f"Python {where}:", ", ".join(f"{name} {version(name)}" for name in SHOWN), flush=True)  # noqa: T201
    failed = 0
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "search.toml").write_text(SEARCH)
        for line in (*COMMANDS, *SERVERS):
            wrong = SERVERS[line]() if line in SERVERS else failure(line, Path(place))
            failed += bool(wrong)
            print("x" if wrong else "v", "orishell", line, wrong, flush=True)  # noqa: T201
    raise SystemExit(int(failed > 0))


if __name__ == "__main__":
    main()
