"""Mutated design files of all tables: each is made, or refused with one message, and no more.

The good files have, between them, every key of every table: those that the starter files show, the
forms of a curve, and a search. They are mutated by a generator of a fixed seed, as values (other
types, sizes and keys) and as text (bytes, words and lines). Each is read, and where that succeeds
designed by the command, in a process of its own with a limit of time and memory: this file as a
script, which forks.
"""

from __future__ import annotations

import contextlib
import copy
import importlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
import pytest

from orishell.conventions.errors import InputError, OrishellError
from orishell.design_file import starter_file
from orishell.design_file.tables import FileTable
from orishell.families.flat_foldable.pattern import FlatFoldablePattern
from orishell.families.registry import FAMILIES
from samples import THOROUGH
from test_malformed_inputs import GENTLE, HARSH
from timing import HANGS

SEED = 26
FILES = 3000 if THOROUGH else 20
READING = HANGS
"""Most processor time that reading a file may take (seconds)."""
MAKING = 8.0
"""Then a design is given up: large sheets are legal, and take their time (the same)."""
MEMORY = 4 * 2**30
PRELOADED = (
    "orishell.shell.export",
    "orishell.shell.make",
    "orishell.shell.pictures",
    "orishell.search.problem",
    "orishell.cli.main",
    "orishell.cli.design",
    "matplotlib.backends.backend_agg",
)
"""What a process would import else; each file's process has it from the one it is forked from."""
REPORTED, MADE = 12, 1 if THOROUGH else 3
"""One of so many files is designed and written by the command, and of so many without writing, as
its pictures take the most time; the others are read."""
WARNINGS = re.compile(r"^orishell: warning: .*\n", re.MULTILINE)
LONGEST = 4000
"""Characters of a message, at most."""

Generator = np.random.Generator
Tables = dict[str, Any]

EXAMPLES = Path(__file__).parents[2] / "examples"
DRAWN = {"f.svg": "profile.svg", "f.dxf": "profile.dxf"}
CURVES: list[Tables] = [
    {"formula": "-x**2", "range": [-1, 1]},
    {"formula": ["cos(t)", "sin(t)"], "range": ["pi/6", "5*pi/6"], "scale": [1.1, 0.9]},
    {"points": [[-1, -1], [-0.4, -0.2], [0, 0], [0.4, -0.2], [1, -1]], "smooth": True},
    {"points": "f.csv", "unit": "m", "reverse": True},
    {"path": "M 0 0 C 0.3 0.6 0.9 0.6 1.2 0", "part": [0.1, "1.3"]},
    {"svg": "f.svg", "id": "profile"},
    {"dxf": "f.dxf", "layer": "PROFILE"},
]
SEARCH: Tables = {
    "variables": {
        "pattern.rows": [3, 5],
        "pattern.flap": {"low": 0.1, "high": 0.3, "step": 0.05},
        "target.f": [{"points": "f.csv"}, {"formula": "-x**2", "range": [-1, 1]}],
    },
    "minimise": ["panels", "deviation"],
    "subject_to": {"packed_volume": {"most": 3.0}},
    "evaluations": 8,
    "population": 4,
    "seed": 3,
    "method": "nsga2",
}
ODD: list[Any] = [
    *(0, -1, 1, 2, 3, 10**9, 2**63 - 1, -(2**63), 2**63, 10**400),
    *(0.0, -0.0, 0.5, 5e-324, 1e-300, 1e-9, 1e9, 1e300, -1e300, np.nan, np.inf, -np.inf),
    *(True, False, "", "auto", "none", "x", "f.csv", "../f.csv", "/dev/zero", ".", "a\0b", "\n"),
    *("\u202e", "é€🙂", "\x1b[2J", "=1+1", "a" * 100_000, "1" * 5000, "x**x", "1/0", "sqrt(-1)"),
    *([], [[]], {}, {"": 0}, [0, 1], [1, 0], [np.nan, 1], ["auto", "auto"], [0] * 1000),
    *([{}], {"low": 0, "high": 5e-324}, {"low": 0, "high": 1}, [np.inf, 5], [1, 2, 3, 4]),
]
FIT: Tables = {"rows": 5, "columns": 6, "edge_ratio": 10, "direction_deg": 0, "border": "free"}
FITTED: list[Tables] = [
    {"pattern": FIT, "target": {"surface": surface}}
    for surface in (
        {"formula": "1 - 0.2*x**2 - 0.3*y**2", "x": [-1, 1], "y": ["-pi/3", 1], "scale": 2.0},
        {"formula": "0.1*x*y", "centre": [0, 0.1], "size": [2, 3], "turn_deg": 30},
        {"formula": ["u", "-cos(v)", "sin(v)"], "u": [0, 2], "v": [0.5, 2.5]},
    )
]
NUMBERS = [each for each in ODD if isinstance(each, int | float) and not isinstance(each, bool)]
KEYS = ["", "a.b", "rows", "formula", "\n", "é", "a" * 1000, "0", "__class__", "name"]


def shown(family: str) -> Tables:
    """The tables of a family's starter file, with those that it shows as comments."""
    text = starter_file(family)
    tables = re.split(r"\n(?=(?:# )?\[)", text)
    comment = re.compile("^# ?", re.MULTILINE)
    shown = (comment.sub("", each) if each.startswith("# [") else each for each in tables)
    return tomllib.loads("\n".join(shown))


def hints() -> dict[str, list[Any]]:
    """Values that comments of starter files show for keys, by key."""
    found: dict[str, list[Any]] = {}
    for family in FAMILIES:
        for line in starter_file(family).splitlines():
            with contextlib.suppress(tomllib.TOMLDecodeError):
                for key, value in tomllib.loads(line.removeprefix("#").strip()).items():
                    found.setdefault(key, []).append(value)
    return found


HINTS = {**hints(), "flap_side": ["start", "end", "auto"]}


BOARDS = [("sandwich", "grain"), ("sandwich", "strength"), ("material", "grain", "service_class")]
"""Keys of the starter file without which boards are alike all through, of plywood by its grain, or
of faces on a core: it shows all three."""


def good(number: int, rng: Generator) -> Tables:
    """A good design, or one whose tables do not suit each other: small, of any family."""
    family = [*FAMILIES][number % len(FAMILIES)]
    every = shown(family)
    tables: Tables = {
        name: every.pop(name) for name in ("shell", "target", "pattern") if name in every
    }
    tables["motion"] = {"frames": 3}
    drawn = family == "pattern"  # and has its rows and columns
    tables["pattern"] |= {} if drawn else {"rows": 5, "columns": 6}
    if family == "flat-foldable":
        tables |= copy.deepcopy(pick([{}, {"pattern": listed()}, *FITTED], rng))
    elif not drawn and rng.random() < 0.25:
        tables["target"][str(rng.choice(["f", "f", "g"]))] = copy.deepcopy(pick(CURVES, rng))
    if family.startswith("long") and rng.random() < 0.2:
        del tables["target"]
    optional = [name for name in every if name != "motion"]
    for name in rng.permutation(optional)[: rng.integers(0, 4)]:
        tables[str(name)] = every[str(name)]
    if "structure" in tables or "load_case" in tables:
        tables["structure"] = every["structure"] | {"cells": 1}
        for key in ("arm_modulus", "arm_strength", *pick(BOARDS, rng)):
            tables["structure"].pop(key, None)
        if "panel" not in tables:
            tables["structure"].pop("membrane_strength", None)
        # Those of the starter file are all loads at once, and factors of what is not there.
        case = every["load_case"][0]
        loads = ("pressure", "snow", "wind", "points", "person")
        chosen = str(rng.choice(loads))
        cases = [{"name": "dead", "self_weight": True}, {"name": "snow", chosen: case[chosen]}]
        tables["load_case"] = [*cases, {"name": "both", "combine": case["combine"]}]
        tables["workshop"] = {"areal_density": 2.0, **tables.get("workshop", {})}
    if "panel" in tables:
        tables.get("structure", {}).pop("thickness", None)
    if "workshop" in tables:
        tables["workshop"]["stock"] = [25.0, 5.0]
    if "tolerance" in tables:
        tables["tolerance"] |= {"surface": 1.0, "panel_max": 20}
        for key in ("rows", "columns"):
            del tables["pattern"][key]
    if rng.random() < 0.15:
        tables["search"] = copy.deepcopy(SEARCH)
    return tables


@cache
def listed() -> Tables:
    """A flat-foldable sheet by its lists."""
    design = FlatFoldablePattern(rows=5, columns=6, sheet="arch").design_without_target()
    keys = FlatFoldablePattern.model_fields.keys() & design.parameters.keys()
    lists = {
        key: design.parameters[key]
        for key in sorted(keys)  # places are drawn by their number
        if isinstance(design.parameters[key], list)
    }
    return {"rows": 5, "columns": 6, **lists, "sheet": "lists"}


def pick(values: list[Any], rng: Generator) -> Any:
    return values[rng.integers(len(values))]


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where every value of tables is."""
    inside: Iterator[tuple[Any, Any]] = iter(())
    if isinstance(value, dict):
        inside = iter(value.items())
    elif isinstance(value, list):
        inside = iter(enumerate(value))
    for key, inner in inside:
        yield (*path, key)
        yield from places(inner, (*path, key))


def at(tables: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        tables = tables[key]
    return tables


def odd_value(old: Any, rng: Generator) -> Any:
    """Another value, odd, or the old one in another form."""
    if rng.integers(3) == 0:
        return pick([[old], {"x": old}, [old, old], str(old), {"low": old, "high": old}], rng)
    return copy.deepcopy(pick(ODD, rng))


def like(old: Any, key: Any, rng: Generator) -> Any:
    """Another value of the same kind, which a file may well have: what comes later has to cope."""
    if isinstance(old, bool) or not isinstance(old, int | float):
        return copy.deepcopy(pick(HINTS.get(key, [old]), rng))
    if rng.integers(4) == 0:
        return pick(NUMBERS, rng)
    changed = old * pick([-1, 0, 1e-9, 1e-3, 0.1, 0.5, 0.99, 1.01, 2, 10, 1e3, 1e9], rng)
    return int(changed) if isinstance(old, int) and rng.integers(4) else float(changed)


def mutate(tables: Tables, rng: Generator) -> None:
    """Change tables at one place."""
    all_places = [*places(tables)]
    if not all_places:
        return
    path = pick(all_places, rng)
    outer, key = at(tables, path[:-1]), path[-1]
    match rng.integers(14):
        case 0:
            del outer[key]
        case 1 if isinstance(outer, dict):
            outer[pick(KEYS, rng)] = copy.deepcopy(outer[key])
        case 1:
            outer.insert(key, copy.deepcopy(outer[key]))
        case 2:
            other = pick(all_places, rng)
            outer[key] = copy.deepcopy(at(tables, other))
        case 3 if isinstance(outer, dict):
            name = pick([*HINTS], rng)
            outer[name] = copy.deepcopy(pick(HINTS[name], rng))
        case 4 | 5:
            outer[key] = odd_value(outer[key], rng)
        case _:
            single = [each for each in all_places if not isinstance(at(tables, each), dict | list)]
            path = pick(single or all_places, rng)
            outer, key = at(tables, path[:-1]), path[-1]
            outer[key] = like(outer[key], key, rng)


def as_toml(value: Any) -> str:
    """A value as TOML, in one line."""
    match value:
        case dict():
            inner = ", ".join(
                f"{as_toml(str(key))} = {as_toml(each)}" for key, each in value.items()
            )
            return f"{{{inner}}}"
        case list():
            return f"[{', '.join(map(as_toml, value))}]"
        case str():
            return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
        case bool():
            return str(value).lower()
    return repr(value)


def mutated(number: int) -> bytes:
    """A good file that was changed once to three times."""
    rng = np.random.default_rng([SEED, number])
    tables = good(number, rng)
    as_text = rng.random() < 0.25
    for _ in range(0 if as_text else 1 + rng.integers(8) // 5 + rng.integers(8) // 6):
        mutate(tables, rng)
    text = "".join(
        f"[{as_toml(name)}]\n"
        + "".join(f"{as_toml(key)} = {as_toml(each)}\n" for key, each in table.items())
        if isinstance(table, dict)
        else ""
        for name, table in tables.items()
    )
    others = (item for item in tables.items() if not isinstance(item[1], dict))
    data = ("".join(f"{as_toml(key)} = {as_toml(each)}\n" for key, each in others) + text).encode()
    if as_text:
        harsh = [*GENTLE, *GENTLE, *HARSH]
        data = pick(harsh, rng)(data, rng, "toml")
    return data


def main(directory: str, first: str, last: str) -> None:
    """Read and make the files, each in a process of its own; print what became of each."""
    for module in PRELOADED:
        importlib.import_module(module)
    os.chdir(directory)
    beside = set(os.listdir())
    for number in range(int(first), int(last)):
        path, out = Path(f"mutated-{number}.toml"), Path(f"out-{number}")
        path.write_bytes(mutated(number))
        process = os.fork()
        if process == 0:
            make(path, out, to_do(number))
        status = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
        said = Path("said.err").read_text(encoding="utf-8", errors="replace")
        written = sorted(each.name for each in out.iterdir()) if out.exists() else []
        shutil.rmtree(out, ignore_errors=True)
        for name in (path, "said.out", "said.err"):
            os.remove(name)
        left = sorted(set(os.listdir()) - beside)
        done = to_do(number)
        line = {"status": status, "said": said, "done": done, "written": written, "left": left}
        print(json.dumps(line), flush=True)  # noqa: T201


def to_do(number: int) -> str:
    """What is done with a file, if it can be read."""
    return "written" if number % REPORTED == 0 else "made" if number % MADE == 0 else "read"


def make(path: Path, out: Path, done: str) -> NoReturn:
    """Read a file and do with it what is to be done; this ends the process."""
    from orishell.cli.main import run
    from orishell.design_file import read_design_file
    from orishell.shell.make import make_shell

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    signal.setitimer(signal.ITIMER_PROF, MAKING)  # nothing catches it: the process ends
    for stream, name in ((1, "said.out"), (2, "said.err")):
        os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), stream)
    sys.argv = ["orishell", "design", str(path), "--out", str(out)]
    status: Any = 70
    try:
        refusal = read(path)
        if done == "written":
            run()
        if refusal is None and done == "made":
            make_shell(read_design_file(path))
        status = tell(refusal)
    except OrishellError as error:
        status = tell(error)
    except SystemExit as end:
        status = end.code or 0
    except BaseException as error:  # this is what is looked for
        sys.stderr.write(f"Traceback: {type(error).__name__}: {error}\n")
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def tell(error: OrishellError | None) -> int:
    """Say what the command says of an error, and return its exit status."""
    if error is None:
        return 0
    sys.stderr.write(f"orishell: {error}\n")
    return error.exit_status


def read(path: Path) -> OrishellError | None:
    """Read a file, also its table [search], which the command that designs does not."""
    from orishell.search.problem import read_problem

    begin = time.process_time()
    try:
        read_problem(path)
    except InputError as error:
        return None if "nothing to search" in str(error) else error
    finally:
        if time.process_time() - begin > READING:
            sys.stderr.write("Traceback: reading takes too long\n")
    return None


def wrong(result: dict[str, Any]) -> list[str]:
    """What is wrong with what became of a file."""
    status, written = result["status"], result["written"]
    said = WARNINGS.sub("", result["said"])
    refused, given_up = status in (1, 2), status == -signal.SIGPROF
    message = said.startswith("orishell: ") and said.count("orishell: ") == 1
    found = {
        "a status of its own": not (refused or given_up or status == 0),
        "a fault": any(each in said for each in ("Traceback", "fault of the program", "Warning")),
        "nothing written": status == 0
        and result["done"] == "written"
        and "report.json" not in written,
        "something written": refused and bool(written),
        "something left beside it": bool(result["left"]),
        "not one message": (refused and not message) or (status == 0 and bool(said)),
        "a long message": len(said) > LONGEST,
        "control characters": not all(line.isprintable() for line in said.split("\n")),
    }
    return [what for what, applies in found.items() if applies]


@pytest.mark.slow
def test_mutated_files_are_made_or_refused(tmp_path: Path) -> None:
    for name, source in DRAWN.items():
        shutil.copy(EXAMPLES / source, tmp_path / name)
    (tmp_path / "f.csv").write_text("x [m], y [m]\n-1, -1\n-0.4, -0.2\n0, 0\n0.4, -0.2\n1, -1\n")
    done = subprocess.run(
        [sys.executable, "-W", "default", __file__, str(tmp_path), "0", str(FILES)],
        capture_output=True,
        env=os.environ | {"PYTHONPATH": str(Path(__file__).parents[1])},
        text=True,
        timeout=FILES * (HANGS + MAKING),
        check=False,
    )
    assert done.returncode == 0, done.stderr
    results = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(results) == FILES
    faults = {
        k: (each["status"], wrong(each), each["said"][:600])
        for k, each in enumerate(results)
        if wrong(each)
    }
    assert not faults
    ended = [each["status"] for each in results]
    # Otherwise the mutations test nothing, or nothing but the first line.
    assert ended.count(0) > 0.1 * FILES
    assert ended.count(2) > 0.3 * FILES
    assert ended.count(-signal.SIGPROF) < 0.05 * FILES


def test_the_good_files_have_every_key_between_them() -> None:
    seen: set[str] = set()
    for number in range(200):
        for path in places(good(number, np.random.default_rng(number))):
            seen.add(".".join("*" if isinstance(key, int) else key for key in path[:2]))
    assert set(FileTable.model_fields) <= seen
    for family in FAMILIES.values():
        keys = {field.alias or key for key, field in family.pattern.model_fields.items()}
        assert {f"pattern.{key}" for key in keys} - seen <= {f"pattern.{key}" for key in HINTS}


def test_the_mutations_are_the_same_in_every_run() -> None:
    assert mutated(7) == mutated(7)
    assert mutated(7) != mutated(10)


if __name__ == "__main__":
    main(*sys.argv[1:])
