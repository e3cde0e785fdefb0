"""Work that takes time: how its progress is told, and how it is stopped.

It stops at Ctrl-C or SIGTERM at any moment, with no temporary and no half-moved files left.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from types import FrameType
from typing import TypeVar

Progress = Callable[[float, str], None]
"""Called with the share of the work that is done, from 0 to 1, and with what the work is."""


def no_progress(share: float, what: str) -> None:
    """Report no progress: the default where nobody watches."""


def stretch(progress: Progress, start: float, stop: float) -> Progress:
    """Report the progress of a part of some work, from start to stop, as that of the whole."""
    return lambda share, what: progress(start + share * (stop - start), what)


def rising(progress: Progress) -> Progress:
    """Report the most progress so far, where parts of some work begin anew."""
    most = 0.0

    def told(share: float, what: str) -> None:
        nonlocal most
        most = max(most, share)
        progress(most, what)

    return told


T = TypeVar("T")


def followed(items: Iterable[T], count: int, progress: Progress, what: str) -> Iterator[T]:
    """Pass items on, and report what share of them is done."""
    for number, item in enumerate(items, start=1):
        yield item
        progress(number / count, what)


SIGNALS = (signal.SIGINT, signal.SIGTERM)
SHOW_CURSOR = "\x1b[?25h"
"""A progress bar hides it."""

_cleanups: list[Callable[[], None]] = []


def stop_quietly() -> None:
    """Let Ctrl-C and SIGTERM end this process at once: cleaned up, no traceback, status 130 or 143.

    Nothing is raised: an exception could be swallowed, or turned into another one, by whatever
    library happens to run or to be imported.
    """
    for number in SIGNALS:
        if signal.getsignal(number) is not signal.SIG_IGN:  # as under nohup
            signal.signal(number, _stop)


def _stop(number: int, _: FrameType | None) -> None:
    for each in SIGNALS:
        signal.signal(each, signal.SIG_IGN)
    for clean in reversed(_cleanups):
        clean()
    if sys.stderr.isatty():
        with contextlib.suppress(OSError):
            os.write(sys.stderr.fileno(), SHOW_CURSOR.encode())
    os._exit(128 + number)


@contextlib.contextmanager
def cleaning_up(clean: Callable[[], None]) -> Iterator[None]:
    """Clean up at the end of the context, or when the process is stopped in it; raises nothing."""
    _cleanups.append(clean)
    try:
        yield
    finally:
        clean()
        _cleanups.remove(clean)


@contextlib.contextmanager
def uninterrupted() -> Iterator[None]:
    """Put off being stopped until the end of the context."""
    if threading.current_thread() is not threading.main_thread():  # signals are not for others
        yield
        return
    caught: list[int] = []

    def put_off(number: int, _: FrameType | None) -> None:
        caught.append(number)

    before = {each: signal.signal(each, put_off) for each in SIGNALS}
    try:
        yield
    finally:
        for each, handler in before.items():
            signal.signal(each, handler)
        for number in caught[:1]:
            signal.raise_signal(number)


class Asked(threading.Event):
    """Set once this process is asked to stop, with the number of the signal; 0 before."""

    number = 0


@contextlib.contextmanager
def asked_to_stop(said: str) -> Iterator[Asked]:
    """Let the first Ctrl-C or SIGTERM ask for an end, and the second one end this process.

    The first one is answered with a line on standard error.
    """
    asked = Asked()

    def ask(number: int, frame: FrameType | None) -> None:
        if asked.is_set():
            _stop(number, frame)
        asked.number = number
        asked.set()
        with contextlib.suppress(OSError):  # nobody reads it
            os.write(sys.stderr.fileno(), f"{said}\n".encode())

    watched = [each for each in SIGNALS if signal.getsignal(each) is not signal.SIG_IGN]
    before = {each: signal.signal(each, ask) for each in watched}
    try:
        yield asked
    finally:
        for each, handler in before.items():
            signal.signal(each, handler)
