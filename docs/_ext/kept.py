"""What takes long to make and is asked for more than once, by tests or by pages: made once.

A result is kept in ``build/kept``, for all processes and runs. Its name is a digest of all that it
can depend on: its arguments, the package, the examples, what tests share, the file that makes it,
the libraries, and how the processor is to round. Whoever asks for what another process is just
making waits for it.
"""

from __future__ import annotations

import fcntl
import io
import os
import pickle
import shutil
import sys
import sysconfig
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from functools import cache, wraps
from hashlib import sha256
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

import cloudpickle

from orishell.conventions.progress import Progress, no_progress
from orishell.design.piece import Facets
from orishell.design_file import DesignFile
from orishell.deviation.triangles import Triangles
from orishell.numerics.arrays import Array, Integers
from orishell.shell.make import Shell, make_shell
from orishell.shell.steps import ClashPolicy, Step

ROOT = Path(__file__).parents[2]
PLACE = ROOT / "build" / "kept"
READ = ("src/orishell/**/*.py", "examples/**/*", "tests/*.py", "docs/_ext/*.py")
"""Files that any result may depend on."""
ROUNDING = ("OPENBLAS_CORETYPE", "NPY_DISABLE_CPU_FEATURES", "GLIBC_TUNABLES")
"""Variables that choose how numbers are rounded: ``make portable``."""
STATES = 4
"""So many states of those files have their results kept: a file of a shell takes up to 14 MB."""

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")

_read: dict[str, Any] = {}
"""What this process has made or read."""


def kept(makes: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """A function without effects that keeps its results, by arguments whose ``repr`` says all.

    All who ask in a process have the same object.
    """

    @wraps(makes)
    def found(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Result:
        code = makes.__code__
        asked = (code.co_qualname, code.co_firstlineno, args, sorted(kwargs.items()))
        name = _digest(repr(asked).encode(), _bytes(code.co_filename))
        result: Result = _found(name, lambda: makes(*args, **kwargs))
        return result

    return found


def kept_shell(
    file: DesignFile,
    progress: Progress = no_progress,
    *,
    clash: ClashPolicy = "refused",
    skip: Collection[Step] = (),
    told: Callable[[Shell], None] | None = None,
) -> Shell:
    """As ``make_shell``, for a file with which it was called before without delay.

    told: Is told nothing: what is kept is known at once.
    """
    asked = (file, file.tables, clash, sorted(skip))
    name = _digest(b"shell", repr(asked).encode(), *map(_bytes, file.inputs))
    shell: Shell = _found(name, lambda: make_shell(file, progress, clash=clash, skip=skip))
    return shell


def _found(name: str, makes: Callable[[], Any]) -> Any:
    if name not in _read:
        place = PLACE / state()
        _begin(place)
        with _alone(place / f"{name}.lock"):
            path = place / f"{name}.pickle"
            if path.exists():
                _read[name] = pickle.loads(path.read_bytes())
            else:
                _read[name] = makes()
                _write(path, _dumps(_read[name]))
    return _read[name]


class _Pickler(cloudpickle.Pickler):  # type: ignore[misc] # which has no types
    """Leaves out libigl's trees of boxes, which cannot be written: they are made anew."""

    def reducer_override(self, thing: Any) -> Any:
        """How a thing is written that has a tree; all else as usual."""
        if isinstance(thing, Triangles):
            return _with_tree, (thing.vertices, thing.corners, thing.columns, thing.turning)
        if isinstance(thing, Facets) and "_tree" in vars(thing):
            reduced = thing.__reduce_ex__(2)
            assert not isinstance(reduced, str)
            makes, parts, values = reduced[:3]
            return makes, parts, {name: value for name, value in values.items() if name != "_tree"}
        return super().reducer_override(thing)


def _with_tree(vertices: Array, corners: Integers, columns: int, turning: Any) -> Triangles:
    tree = Triangles.scattered(vertices, corners).tree
    return Triangles(vertices, corners, columns, turning, tree)


def _dumps(thing: Any) -> bytes:
    file = io.BytesIO()
    _Pickler(file).dump(thing)
    return file.getvalue()


def _write(path: Path, content: bytes) -> None:
    """Whole or not at all: who is killed here leaves nothing that is read."""
    begun = path.with_suffix(".begun")
    begun.write_bytes(content)
    begun.replace(path)


@contextmanager
def _alone(path: Path) -> Iterator[None]:
    """Without another process: the lock of one that ends, however it does, is free."""
    with path.open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _begin(place: Path) -> None:
    """The folder of a state, and an end of the oldest ones."""
    if place.is_dir():
        return
    place.mkdir(parents=True, exist_ok=True)
    states = sorted(PLACE.iterdir(), key=lambda each: each.stat().st_mtime, reverse=True)
    for old in states[STATES:]:
        shutil.rmtree(old, ignore_errors=True)


@cache
def state() -> str:
    """A digest of all that results depend on whatever is asked for."""
    files = sorted({path for each in READ for path in ROOT.glob(each) if path.is_file()})
    files = [path for path in files if "__pycache__" not in path.parts]
    libraries = sorted(path.name for path in Path(sysconfig.get_path("purelib")).iterdir())
    known = (sys.version, libraries, [os.environ.get(each) for each in ROUNDING])
    named = (
        part for path in files for part in (str(path.relative_to(ROOT)).encode(), _bytes(path))
    )
    return _digest(repr(known).encode(), *named)


def _bytes(path: str | Path) -> bytes:
    return Path(path).read_bytes()


def _digest(*parts: bytes) -> str:
    """Of parts that another division into parts does not have."""
    whole = sha256()
    for part in parts:
        whole.update(sha256(part).digest())
    return whole.hexdigest()[:24]
