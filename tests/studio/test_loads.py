"""A shell under load in the studio: the case that is chosen stays, and the fold at the target."""

from __future__ import annotations

import tomllib
from typing import TYPE_CHECKING

import numpy as np
import pytest

from samples import thorough
from studio_pages import drawn, settle
from viewer_pages import await_frames, keep_picture, pixels, wait_until

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
snow = { ground = 500, arrangement = "undrifted" }
"""

SHOWN = "window.__orishell.shell3d.loaded.shown"


@thorough
def test_a_case_is_chosen_and_stays_while_the_shell_changes(page: Page) -> None:
    change = "(design) => window.__orishell.store.change(design, 'loaded')"
    page.evaluate(change, tomllib.loads(DESIGN))
    settle(page)
    cases = page.get_by_test_id("load-case")
    assert cases.locator("option").all_inner_texts() == ["Without loads", "! own weight", "! snow"]
    assert "\nStands\nnot known: under snow" in page.get_by_test_id("figures").inner_text()
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


def shown_on_the_canvas(page: Page, sign: str) -> None:
    """The load that was typed, what is worst, its share beside the box; wind that is turned."""
    by_id = page.get_by_test_id
    await_frames(page)
    name = by_id("load-case").input_value()
    assert name.startswith("snow")
    shown, worst = page.evaluate(f"[{SHOWN}.deflection, {SHOWN}.of]")
    assert shown["name"] == name
    flag = by_id("worst-flag")
    assert flag.is_visible() == (worst is not None)
    assert (worst or "") in (flag.text_content() or "")
    signs = {"fails": "fails", "warns": "attention", "holds": "holds"}
    said = by_id("share-snow").locator("[role=img]").get_attribute("aria-label")
    assert said == signs[shown["sign"]]
    assert by_id("chip-stands").get_attribute("data-sign") == sign
    # Wind is turned by its arrow.
    by_id("load-case").select_option("")
    by_id("structure-wind").fill("20")
    drawn(page)
    arrow = by_id("wind-arrow")
    arrow.focus()
    page.keyboard.press("ArrowUp")
    wind = "window.__orishell.store.design.value.load_case.at(-1).wind"
    assert page.evaluate(f"{wind}.direction_deg") == 5
    assert by_id("structure-direction").input_value() == "5"
    by_id("undo").click()
    by_id("structure-wind").fill("")
    by_id("structure-snow").focus()


def test_what_codes_ask_is_listed_below_the_loads(page: Page) -> None:
    """As the report has it, of an arch under its own weight and snow."""
    page.evaluate("design => window.__orishell.store.change(design, 'arch')", tomllib.loads(DESIGN))
    settle(page)
    asked = page.evaluate("window.__orishell.report.structure.code_asks")
    listed = page.get_by_test_id("code-asks").locator("li").all_text_contents()
    assert len(listed) == len(asked) > 0
    assert listed[-1] == asked[-1]


def test_a_structure_is_made_by_hand(page: Page) -> None:
    """From a plain arch to a verdict: boards of plywood, 0.4 kN/m2 of snow; two inputs."""
    plain = {
        key: each
        for key, each in tomllib.loads(DESIGN).items()
        if key not in {"structure", "load_case", "workshop"}
    }
    page.evaluate("(design) => window.__orishell.store.change(design, 'plain')", plain)
    settle(page)
    by_id = page.get_by_test_id
    assert not by_id("structure-snow").is_visible()
    by_id("structure-material").select_option("birch plywood")
    by_id("structure-snow").fill("0.4")
    assert by_id("structure-thickness").input_value() == "15"
    settle(page)
    design = page.evaluate("window.__orishell.store.design.value")
    assert design["structure"] == {
        "material": "birch plywood",
        "thickness": 0.015,
        "supports": [{"at": "feet", "kind": "pinned"}],
    }
    snow = {"name": "snow", "snow": {"ground": 400}, "self_weight": True}
    assert design["load_case"] == [{"name": "own weight", "self_weight": True}, snow]
    rows = page.evaluate("window.__orishell.report.verdict")
    stands = next(each for each in rows if each["subject"] == "stands")
    assert f"Stands {stands['finding']}" in by_id("structure-verdict").inner_text()
    shown_on_the_canvas(page, stands["sign"])
    # Colours end at the strength of the material under snow, 0.65 x 33.2/1.2 MPa.
    by_id("structure-creases").select_option("rigid")
    settle(page)
    report = page.evaluate("window.__orishell.report.structure")
    cases = by_id("load-case")
    cases.select_option("snow, undrifted")
    await_frames(page)
    assert by_id("load-measure").input_value() == "utilisation"
    legend = page.locator(".orishell-legend").inner_text()
    assert "100 %: 18 MPa" in legend
    assert "N a panel" in legend
    assert "displacements \u00d7" in legend
    used = page.evaluate(f"{SHOWN}.most * 17.983")
    loaded = "window.__orishell.store.view.value.loaded"
    assert 0 < used <= page.evaluate(f"Math.max(...{loaded}.stresses)") * (1 + 1e-6)
    # Arrows add up to what loads the shell.
    total = page.evaluate(
        f"(() => {{ const {{ loads, cases }} = {loaded}, n = loads.length / cases.length;"
        f" const at = {SHOWN}.deflection.number; let down = 0;"
        " for (let k = at * n + 2; k < (at + 1) * n; k += 3) down += loads[k]; return down; })()"
    )
    assert total == pytest.approx(
        next(each["load"][2] for each in report["cases"] if each["name"] == "snow, undrifted"),
        rel=1e-4,
    )
    keep = page.evaluate(f"[...{loaded}.held].filter((_, k) => k % 2)")
    assert keep
    assert set(keep) == {1}
    cases.select_option("")

    # What stops stays stopped until it is asked for.
    by_id("structure-kind-sliding").check(force=True)
    wait_until(page, "window.__orishell.store.proof.value.state === 'running'")
    by_id("structure-work-stop").click()
    settle(page)
    assert "Stopped" in by_id("verify-status").inner_text()
    by_id("structure-again").click()
    settle(page)
    assert by_id("structure-verdict").is_visible()
    page.keyboard.press("Control+z")
    by_id("structure-material").select_option("")
    settle(page)
    assert "structure" not in page.evaluate("window.__orishell.store.design.value")
