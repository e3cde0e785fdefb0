"""A person at the studio's page, with a mouse or keys alone; clicks and keys are counted."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from viewer_pages import await_frames

if TYPE_CHECKING:
    from playwright.sync_api import Download, Page

By = Literal["mouse", "keys"]
BOTH: list[By] = ["mouse", "keys"]
COUNT = """() => {
    window.done = { clicks: 0, keys: 0 };
    let keyed = null;
    const listen = (name, act) => addEventListener(name, act, { capture: true });
    listen("pointerdown", () => window.done.clicks++);
    listen("keydown", ({ target }) => {
        keyed = target;
        window.done.keys++;
    });
    // A choice in a list is opened and taken; keys take it without a click.
    listen("change", ({ target }) => {
        if (target instanceof HTMLSelectElement && target !== keyed) window.done.clicks += 2;
    });
}"""
"""Counts clicks and strokes of a pointer, and keys that are pressed; text that is typed is none."""
FOCUSED = "document.activeElement?.dataset.testid"
AMONG = """(name) => {
    const wanted = document.querySelector(`[data-testid="${name}"]`);
    return wanted !== null && document.activeElement?.name === wanted.name;
}"""
"""Whether the focus is on something of the same choice."""

STEPS = """(list, wanted) =>
    [...list.options].findIndex(({ value }) => value === wanted) - list.selectedIndex"""
"""How far down a list something is from what is chosen."""


class Person:
    """Does a task, step by step, and takes the time.

    Parameters
    ----------
    by
        With a mouse, boxes being typed into; or with keys alone.
    """

    def __init__(self, page: Page, by: By) -> None:
        self.page = page
        self.by = by
        self.steps: dict[str, float] = {}
        self.done = {"clicks": 0, "keys": 0}

    def begin(self) -> None:
        """Count from now on."""
        self.page.evaluate("document.activeElement.blur()")
        self.page.evaluate(COUNT)

    @contextmanager
    def step(self, what: str) -> Iterator[None]:
        begin = time.perf_counter()
        yield
        self.steps[what] = time.perf_counter() - begin
        self.done = self.page.evaluate("window.done")

    def __str__(self) -> str:
        said = ", ".join(f"{what} {seconds:.1f} s" for what, seconds in self.steps.items())
        pressed = f"{self.done['clicks']} clicks, {self.done['keys']} keys"
        return f"{said}; {sum(self.steps.values()):.0f} s in all, {pressed}"

    def go(self, name: str, *, back: bool = False, most: int = 90) -> None:
        """Tab to something, forwards or back."""
        self._tab(f"{FOCUSED} === '{name}'", back=back, most=most)

    def press(self, name: str, *, back: bool = False) -> None:
        """A button."""
        if self.by == "mouse":
            self.page.get_by_test_id(name).click()
            return
        self.go(name, back=back)
        self.page.keyboard.press("Enter")

    def take(self, name: str, *, back: bool = False) -> None:
        """One of a few that are all in view."""
        if self.by == "mouse":
            self.page.locator(f"label:has([data-testid={name}])").click()
            return
        self._tab(f"({AMONG})('{name}')", back=back)
        for _ in range(9):
            if self.page.evaluate(FOCUSED) == name:
                return
            self.page.keyboard.press("ArrowRight")
        raise AssertionError(f"{name} is not reached by arrow keys")

    def pick(self, name: str, value: str, *, back: bool = False) -> None:
        """One of a list, by its text."""
        if self.by == "mouse":
            self.page.get_by_test_id(name).select_option(value)
            return
        self.go(name, back=back)
        steps = self.page.get_by_test_id(name).evaluate(STEPS, value)
        self.keys(["Space"], ["ArrowDown" if steps > 0 else "ArrowUp"] * abs(steps), ["Enter"])

    def write(self, name: str, text: str, *, back: bool = False) -> None:
        """Into a box."""
        if self.by == "mouse":
            self.page.get_by_test_id(name).click()
            self.page.get_by_test_id(name).fill(text)
        else:
            self.go(name, back=back)
            self.page.keyboard.insert_text(text)
        self.page.keyboard.press("Enter")

    def keys(self, *presses: Sequence[str]) -> None:
        for each in presses:
            for key in each:
                self.page.keyboard.press(key)

    def bring(self, name: str, path: Path, *, back: bool = False) -> None:
        """A file, by the button that asks for it."""
        with self.page.expect_file_chooser() as chooser:
            # The browser is told to hand over what it is asked; without that it says no at once.
            await_frames(self.page)
            self.press(name, back=back)
        chooser.value.set_files(path)

    def receive(self, name: str, *, back: bool = False) -> Download:
        """The file that a button hands over."""
        with self.page.expect_download(timeout=120_000) as download:
            self.press(name, back=back)
        return download.value

    def _tab(self, reached: str, *, back: bool, most: int = 90) -> None:
        for _ in range(most):
            if self.page.evaluate(reached):
                return
            self.page.keyboard.press("Shift+Tab" if back else "Tab")
        raise AssertionError(f"{reached}: {self.page.evaluate(FOCUSED)} has the focus")
