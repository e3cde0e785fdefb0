"""500 damaged files: each is read, or refused with one clear message, soon and with little memory.

`make test` has the first 200 of them.

The damage is done to good files by a generator of a fixed seed, so that it is the same in every
run. The files of a kind are read by one process of bounded memory, which is this file as a script.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from samples import THOROUGH
from timing import HANGS

SEED = 20240607
FILES = 100 if THOROUGH else 40
SECONDS = HANGS
"""Most processor time that a file may take."""
MEMORY = 3 * 2**30
"""Address space of the process that reads."""
GROWTH = 400 * 2**20
"""Most memory that reading may take beyond what the program takes by itself."""
REFUSED = 0.55 * FILES
"""So many files of each kind must in fact be refused: otherwise the damage tests nothing."""

ABSURD = [b"1e999", b"nan", b"inf", b"9" * 400, b"", b"0x1F", b"1,5", b"--3", b"\xff\xfe", b"\x00"]
ABSURD += [b"0x" + b"f" * 20_000, b"9" * 20_000, b"\x1b]0;title\x07", b'"\\u001b[2J" = 1']
LEGAL = [b"0", b"-1", b"1e308", b"-1e308", b"1e15", b"1e-320", b"99999999999999999999", b"2.5"]
"""Numbers that no one means, and such as are numbers nevertheless."""
NESTS = {
    "svg": [b"<g>" * 3000, b'<svg viewBox="0 0 1 1">' * 250, b"</g>" * 10, b"<!ENTITY a 'b'>"],
    "dxf": [b"  0\nINSERT\n  2\nA\n" * 300, b"102\n{ACAD\n" * 500, b"  0\nSECTION\n" * 50],
    "csv": [b"(" * 3000, b'"' * 3001, b";" * 3000, b"\n1,2,3" * 30],
    "toml": [b"a = " + b"[" * 3000, b"{x = " * 900, b"[a" + b".b" * 400_000 + b"]\n", b'"""'],
    "fold": [b"[" * 100_000, b'{"a":' * 20_000, b"[[0,1]," * 500, b"}"],
}

Generator = np.random.Generator
Damage = Callable[[bytes, Generator, str], bytes]


def _flip(data: bytes, rng: Generator, _: str) -> bytes:
    """Single bits of a byte in a hundred, and of three at least."""
    array = np.frombuffer(data, np.uint8).copy()
    at = rng.integers(0, len(array), max(3, len(array) // 100))
    array[at] ^= (1 << rng.integers(0, 8, len(at))).astype(np.uint8)
    return array.tobytes()


def _cut_off(data: bytes, rng: Generator, _: str) -> bytes:
    return data[: rng.integers(0, len(data))]


def _chunk(data: bytes, rng: Generator) -> tuple[int, int]:
    begin = int(rng.integers(0, len(data)))
    return begin, begin + int(rng.integers(1, max(2, len(data) // 4)))


def _duplicate(data: bytes, rng: Generator, _: str) -> bytes:
    begin, end = _chunk(data, rng)
    return data[:end] + data[begin:end] + data[end:]


def _delete(data: bytes, rng: Generator, _: str) -> bytes:
    begin, end = _chunk(data, rng)
    return data[:begin] + data[end:]


def _swap(data: bytes, rng: Generator, _: str) -> bytes:
    """Numbers in each other's places, or words."""
    kind = rb"-?\b\d+(?:\.\d+)?\b" if rng.integers(2) else rb"[A-Za-z_]\w+"
    found = list(re.finditer(kind, data))
    chosen = np.sort(rng.choice(len(found), min(len(found), 2 + len(found) // 20), replace=False))
    texts = [found[k][0] for k in rng.permutation(chosen)]
    for k, text in reversed(list(zip(chosen, texts, strict=True))):
        data = data[: found[k].start()] + text + data[found[k].end() :]
    return data


def _numbers(values: list[bytes]) -> Damage:
    def damage(data: bytes, rng: Generator, _: str) -> bytes:
        numbers = list(re.finditer(rb"-?\b\d+(\.\d+)?\b", data))
        chosen = rng.choice(len(numbers), min(len(numbers), 3), replace=False)
        for k in sorted(chosen, reverse=True):
            value = values[rng.integers(len(values))]
            data = data[: numbers[k].start()] + value + data[numbers[k].end() :]
        return data

    return damage


def _lines(data: bytes, rng: Generator, _: str) -> bytes:
    """Whole lines left out, twice, or in another's place."""
    lines = data.split(b"\n")
    for _time in range(1 + len(lines) // 50):
        at, to = rng.integers(0, len(lines), 2)
        match rng.integers(3):
            case 0 if len(lines) > 1:
                del lines[at]
            case 1:
                lines.insert(to, lines[at])
            case _:
                lines[at], lines[to] = lines[to], lines[at]
    return b"\n".join(lines)


def _nest(data: bytes, rng: Generator, kind: str) -> bytes:
    at = int(rng.integers(0, len(data)))
    return data[:at] + NESTS[kind][rng.integers(len(NESTS[kind]))] + data[at:]


GENTLE: list[Damage] = [_swap, _numbers(LEGAL), _lines]
"""These leave the syntax as it is, mostly, so that what comes after it is tested too."""
HARSH: list[Damage] = [_flip, _cut_off, _duplicate, _delete, _nest, _numbers(ABSURD)]
"""Six files in ten get one of these first."""


def _svg() -> bytes:
    return b"""<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
 width="210mm" height="100mm" viewBox="0 0 210 100">
 <defs><path id="part" d="M 60,30 L 70,40 80,30"/></defs>
 <g id="layer" transform="translate(5, 3) rotate(2)">
  <g style="fill:none;stroke:#000" transform="matrix(1 0.1 -0.1 1 0 0)">
   <path d="M 10,50 C 20,10 40,20 50,35 S 55,20 60,30"/>
   <use xlink:href="#part" x="0" y="0"/>
   <path d="m 80,30 a 20 10 15 0 1 25 5 q 5 3 10 -5 t 10 3 h 5 v 4"/>
   <polyline points="130,37 140,45 150,30 160,33"/>
   <line x1="160" y1="33" x2="170mm" y2="20"/>
  </g>
 </g>
</svg>
"""


def _dxf() -> bytes:
    """The sections that matter, without the tables that a damage would hardly ever hurt."""
    vertices = [(5, 0, 0.3), (7, -1, 0), (9, 0.5, -0.4), (10, 0, 0)]
    spline = [(11, 3), (12, 4), (13, 1), (14, 3)]
    tags: list[tuple[int, object]] = [
        *((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015")),
        *((9, "$INSUNITS"), (70, 4), (0, "ENDSEC"), (0, "SECTION"), (2, "BLOCKS")),
        *((0, "BLOCK"), (8, 0), (2, "A"), (70, 0), (10, 0), (20, 0), (30, 0)),
        *((0, "LINE"), (8, 0), (10, 0), (20, 0), (30, 0), (11, 1), (21, 1), (31, 0)),
        *((0, "ARC"), (8, 0), (10, 1), (20, 2), (30, 0), (40, 1), (50, 270), (51, 90)),
        *((0, "ENDBLK"), (8, 0), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")),
        *((0, "INSERT"), (8, "P"), (2, "A"), (10, 10), (20, 0), (30, 0), (50, 0)),
        *((0, "LINE"), (8, "P"), (10, 0), (20, 0), (30, 0), (11, 5), (21, 1), (31, 0)),
        *((0, "ARC"), (8, "P"), (10, 5), (20, 0.5), (30, 0), (40, 0.5), (50, 270), (51, 90)),
        *((0, "LWPOLYLINE"), (100, "AcDbEntity"), (8, "P"), (100, "AcDbPolyline")),
        *((90, len(vertices)), (70, 0)),
        *((code, value) for v in vertices for code, value in zip((10, 20, 42), v, strict=True)),
        *((0, "SPLINE"), (100, "AcDbEntity"), (8, "P"), (100, "AcDbSpline")),
        *((70, 8), (71, 2), (72, 7), (73, 4), (74, 0)),
        *((40, k) for k in (0, 0, 0, 1, 2, 2, 2)),
        *((code, value) for x, y in spline for code, value in ((10, x), (20, y), (30, 0))),
        *((0, "ENDSEC"), (0, "EOF")),
    ]
    return "".join(f"{code:3d}\n{value}\n" for code, value in tags).encode()


def _csv() -> bytes:
    x = np.linspace(0, 3, 40)
    rows = "".join(f"{a:.4f};{np.sin(a):.4f}\n" for a in x)
    return f"# a profile\nx [mm];y [mm]\n{rows}".encode()


def _toml() -> bytes:
    return b"""[shell]
family = "parallel-repeating"
unit = "m"

[target.f]
formula = ["t", "-0.5*t**2 + 0.1*sin(3*t)"]
range = [-1, 1.5]
scale = 1.25

[target.g]
formula = "5*sin(pi*x/10)"
range = [0, 20]

[pattern]
flap = 0.3
xi_deg = 50
spacing = "curvature"

[tolerance]
surface = 0.05
panel_min = 0.1
panel_max = 2.0

[motion]
frames = 25
"""


def _fold() -> bytes:
    n = 4
    x, y = (
        each.ravel().tolist() for each in np.meshgrid(np.arange(n), np.arange(n), indexing="xy")
    )
    across = [[r * n + c, r * n + c + 1] for r in range(n) for c in range(n - 1)]
    down = [[r * n + c, r * n + c + n] for r in range(n - 1) for c in range(n)]
    inner = ["B" if e[1] < n or e[0] >= n * (n - 1) else "M" for e in across]
    sides = ["B" if e[0] % n in {0, n - 1} else "V" for e in down]
    faces = [
        [k, k + 1, k + n + 1, k + n] for r in range(n - 1) for k in range(r * n, r * n + n - 1)
    ]
    key = {
        "file_spec": 1.2,
        "frame_classes": ["creasePattern"],
        "frame_unit": "m",
        "vertices_coords": [list(p) for p in zip(x, y, strict=True)],
        "edges_vertices": across + down,
        "edges_assignment": inner + sides,
        "edges_foldAngle": [0.0] * len(across + down),
        "faces_vertices": faces,
        "orishell:grid_shape": [n, n],
        "file_frames": [
            {
                "frame_classes": ["foldedForm"],
                "frame_parent": 0,
                "frame_inherit": True,
                "vertices_coords": [[*p, 0.0] for p in zip(x, y, strict=True)],
                "edges_foldAngle": [0.0] * len(across + down),
            }
        ],
    }
    return json.dumps(key, indent=1).encode()


GOOD = {"svg": _svg, "dxf": _dxf, "csv": _csv, "toml": _toml, "fold": _fold}


def damaged(kind: str, number: int) -> bytes:
    """A good file with one or two damages."""
    rng = np.random.default_rng([SEED, sorted(GOOD).index(kind), number])
    harsh = HARSH[number % 10] if number % 10 < len(HARSH) else _gently
    data = harsh(GOOD[kind](), rng, kind)
    return _gently(data, rng, kind) if rng.integers(2) and data else data


def _gently(data: bytes, rng: Generator, kind: str) -> bytes:
    """A damage of what is said, not of how; of DXF, where a line in two is a code, the other."""
    damage = GENTLE[rng.integers(3)]
    if kind != "dxf":
        return damage(data, rng, kind)
    lines = data.split(b"\n")
    if damage is _lines:
        tags = b"\n".join(b"\r".join(lines[k : k + 2]) for k in range(0, len(lines), 2))
        return damage(tags, rng, kind).replace(b"\r", b"\n")
    lines[1::2] = damage(b"\n".join(lines[1::2]), rng, kind).split(b"\n")
    return b"\n".join(lines)


def read(kind: str, path: Path) -> None:
    """What the program does with a file of its kind."""
    from orishell.curves import curve_from_points, read_dxf, read_points, read_svg
    from orishell.design_file import read_design_file
    from orishell.io import read_fold

    if kind == "toml":
        read_design_file(path)
    elif kind == "fold":
        read_fold(path)
    elif kind == "csv":
        try_curve(path, lambda: curve_from_points(read_points(path, into="m"), smooth=True))
    else:
        chain = (read_svg if kind == "svg" else read_dxf)(path, into="m")
        try_curve(path, chain.curve)
        try_curve(path, chain.spline)


def try_curve(path: Path, make: Callable[[], Any]) -> None:
    """Make and follow a curve; a design file would stand in front of what goes wrong."""
    from orishell.conventions.errors import InputError
    from orishell.curves import trace_curve

    try:
        trace_curve(make())
    except InputError as error:
        raise error.located(f"{path}:") from None


def main(kind: str, directory: str) -> None:
    """Read the files one after the other and print what became of each, a line of JSON for each."""
    import resource
    import signal
    import time

    from orishell.conventions.errors import InputError

    def too_slow(*_: object) -> None:
        raise TimeoutError

    good = Path(directory) / f"good.{kind}"
    read(kind, good)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    signal.signal(signal.SIGVTALRM, too_slow)
    for number in range(FILES):
        path = Path(directory) / f"damaged-{number}.{kind}"
        begin = time.process_time()
        message, fault = "", ""
        signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
        try:
            read(kind, path)
        except InputError as error:
            message = str(error)
        except BaseException as error:  # this is what is looked for
            fault = f"{type(error).__name__}: {error}"
        finally:
            signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        seconds = time.process_time() - begin
        growth = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        line = {"message": message, "fault": fault, "seconds": seconds, "growth": growth * 1024}
        sys.stdout.write(json.dumps(line) + "\n")


@pytest.mark.parametrize("kind", sorted(GOOD))
def test_damaged_files_are_read_or_refused(kind: str, tmp_path: Path) -> None:
    (tmp_path / f"good.{kind}").write_bytes(GOOD[kind]())
    for number in range(FILES):
        (tmp_path / f"damaged-{number}.{kind}").write_bytes(damaged(kind, number))
    script = [sys.executable, "-W", "error", __file__, kind, str(tmp_path)]
    done = subprocess.run(
        script, capture_output=True, text=True, timeout=FILES * SECONDS, check=False
    )
    assert done.returncode == 0, done.stderr
    results = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(results) == FILES
    faults = {k: each["fault"] for k, each in enumerate(results) if each["fault"]}
    assert not faults
    slow = {k: each["seconds"] for k, each in enumerate(results) if each["seconds"] > SECONDS}
    assert not slow
    assert max(each["growth"] for each in results) < GROWTH
    refused = [(k, each["message"]) for k, each in enumerate(results) if each["message"]]
    for number, message in refused:
        assert f"damaged-{number}.{kind}" in message
        assert len(message) < 2000
        assert all(line.isprintable() for line in message.split("\n"))
    assert REFUSED <= len(refused) < FILES


def test_the_damage_is_the_same_in_every_run() -> None:
    for kind in GOOD:
        assert damaged(kind, 3) == damaged(kind, 3)
        assert damaged(kind, 3) != damaged(kind, 10)


if __name__ == "__main__":
    main(*sys.argv[1:])
