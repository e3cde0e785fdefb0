"""Hypothesis: no time limits, the same examples in every run. What tests measured is printed.

A test that fails is named at once: who waits need not wait for the last one.
"""

from __future__ import annotations

import gc
import os
from collections import Counter
from collections.abc import Generator, Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

import margins
from node_tools import BUILT_DOCS
from reading import in_one_order, read_apart
from samples import LEFT_OUT, examples

if TYPE_CHECKING:
    from playwright.sync_api import Browser

LONGEST = ("test_calculix_agrees", "test_a_clone_becomes_a_wheel", "test_every_offer_typed_in")

settings.register_profile(
    "orishell",
    deadline=None,
    max_examples=examples(100),
    derandomize=True,
    print_blob=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("orishell")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--margins", action="store_true", help="print which bounds are held narrowly: margins.py"
    )


def pytest_configure(config: pytest.Config) -> None:
    read_apart(config)
    if config.getoption("--margins"):
        margins.install(config)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """While tests are read nothing is garbage, and what was read is not searched for it later."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One for all tests of a process: what it needs to draw its first shell takes it the longest.

    As long as it runs, so does an event loop in this thread: other loops run apart (``apart.py``).
    """
    from viewer_pages import running_browser

    with running_browser() as found:
        yield found


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first, so that no process works alone at the end.

    What needs the site is last if the site is built beside the tests, else it builds it: first.
    """
    built_beside = BUILT_DOCS in os.environ

    def place(item: pytest.Item) -> int:
        if "site" in getattr(item, "fixturenames", ()):
            return 2 if built_beside else 0
        return 0 if item.name.startswith(LONGEST) else 1

    items[:] = sorted(in_one_order(items), key=place)


def pytest_report_teststatus(
    report: pytest.TestReport | pytest.CollectReport,
) -> tuple[str, str, str] | None:
    """In place of an F or E, the name of what failed and why."""
    if report.skipped and LEFT_OUT in report.longreprtext:
        return "left out", "-", "LEFT OUT"
    if not report.failed:
        return None
    crash = getattr(report.longrepr, "reprcrash", None)
    why = crash.message if crash else report.longreprtext
    category = "failed" if report.when == "call" else "error"
    word = category.upper()
    return category, f"\n{word} {report.nodeid}\n{why}\n", word


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    """What tests measured without a limit, by ``record_property``; what `make thorough` adds."""
    # What a fixture tells at its end is in the report of that, which is in no category.
    reports = (*terminalreporter.getreports("passed"), *terminalreporter.getreports(""))
    told = [
        (name, str(value))
        for report in reports
        for name, value in getattr(report, "user_properties", ())
    ]
    for name, value in dict.fromkeys(told):
        if not name.startswith(margins.MARGIN):
            terminalreporter.write_line(f"{name}: {value}")
    if config.getoption("--margins"):
        margins.report(terminalreporter)
    left_out = Counter(
        each.nodeid.split("[")[0] for each in terminalreporter.getreports("left out")
    )
    if left_out:
        terminalreporter.section(f"{LEFT_OUT}, and eight times as many random examples")
        for name, count in sorted(left_out.items()):
            terminalreporter.write_line(f"{count:3d} {name}")
