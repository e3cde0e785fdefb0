"""A shell under load in the studio: the case that is chosen stays, and the fold at the target."""

from __future__ import annotations

import tomllib
from typing import TYPE_CHECKING

import numpy as np
import pytest

from studio_pages import settle
from viewer_pages import await_frames, keep_picture, pixels

if TYPE_CHECKING:
    from playwright.sync_api import Page

DESIGN = """
[shell]
family = "parallel-repeating"
unit = "m"

[target.f]
formula = "0.4*(1-x**2)"
range = [-1, 1]

[target.g]
formula = "0"
range = [0, 2]

[pattern]
rows = 5
columns = 5

[workshop]
areal_density = 1.9

[structure]
modulus = 270e6
thickness = 0.01
crease_stiffness = "rigid"
cells = 1
supports = [{ at = "feet", kind = "pinned" }]

[[load_case]]
name = "own weight"
self_weight = true

[[load_case]]
name = "snow"
snow = { ground = 500 }
"""

SHOWN = "window.__orishell.shell3d.loaded.shown"


def test_a_case_is_chosen_and_stays_while_the_shell_changes(page: Page) -> None:
    change = "(design) => window.__orishell.store.change(design, 'loaded')"
    page.evaluate(change, tomllib.loads(DESIGN))
    settle(page)
    cases = page.get_by_test_id("load-case")
    assert cases.locator("option").all_inner_texts() == ["Without loads", "! own weight", "! snow"]
    assert "Displacement" in page.get_by_test_id("figures").inner_text()
    page.get_by_test_id("flat").click()
    await_frames(page)
    before = pixels(page, "canvas")
    cases.select_option("snow")
    await_frames(page)
    assert page.evaluate("window.__orishell.fold") == 1
    assert (np.abs(before - pixels(page, "canvas")).max(axis=2) > 0.1).mean() > 0.02
    keep_picture(page, "studio-loads")
    report = "window.__orishell.report.structure.cases[1].equilibrium.displacement.size"
    most = page.evaluate(f"{SHOWN}.most")
    assert most == pytest.approx(page.evaluate(report), rel=1e-5)
    page.keyboard.press("Space")  # plays the motion, but not of a loaded shell
    await_frames(page)
    assert page.evaluate("window.__orishell.fold") == 1

    page.get_by_test_id("param-rows").fill("7")
    settle(page)
    await_frames(page)
    assert cases.input_value() == "snow"
    assert page.evaluate(f"{SHOWN}.deflection.name") == "snow"
    assert page.evaluate(f"{SHOWN}.most") == pytest.approx(page.evaluate(report), rel=1e-5)
    assert page.evaluate(f"{SHOWN}.most") != pytest.approx(most, rel=1e-3)

    cases.select_option("")
    page.get_by_test_id("flat").click()
    await_frames(page)
    assert page.evaluate("window.__orishell.fold") == 0
