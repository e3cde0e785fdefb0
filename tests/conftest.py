"""Hypothesis: no time limits, the same examples in every run. What tests measured is printed.

A test that fails is named at once: who waits need not wait for the last one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

from samples import examples

if TYPE_CHECKING:
    from playwright.sync_api import Browser

settings.register_profile(
    "orishell",
    deadline=None,
    max_examples=examples(100),
    derandomize=True,
    print_blob=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("orishell")


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """One for all tests of a process: what it needs to draw its first shell takes it the longest.

    As long as it runs, so does an event loop in this thread: other loops run apart (``apart.py``).
    """
    from viewer_pages import running_browser

    with running_browser() as found:
        yield found


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first, so that no process works alone at the end; what needs the site last."""

    def place(item: pytest.Item) -> int:
        if "test_calculix_agrees" in item.nodeid:
            return 0
        return 2 if "site" in getattr(item, "fixturenames", ()) else 1

    items.sort(key=place)


def pytest_report_teststatus(
    report: pytest.TestReport | pytest.CollectReport,
) -> tuple[str, str, str] | None:
    """In place of an F or E, the name of what failed and why."""
    if not report.failed:
        return None
    crash = getattr(report.longrepr, "reprcrash", None)
    why = crash.message if crash else report.longreprtext
    category = "failed" if report.when == "call" else "error"
    word = category.upper()
    return category, f"\n{word} {report.nodeid}\n{why}\n", word


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print what tests measured without a limit, by ``record_property``, from all processes."""
    for report in terminalreporter.getreports("passed"):
        for name, value in report.user_properties:
            terminalreporter.write_line(f"{name}: {value}")
