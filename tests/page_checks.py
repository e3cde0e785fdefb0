"""What every page must keep: its controls in sight, and no serious finding of axe-core."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from node_tools import PACKAGES, lacking

if TYPE_CHECKING:
    from playwright.sync_api import Page

MISPLACED = """() => {
  const controls = "button, select, output, label, input, [role=status]";
  const seen = [];
  for (const each of document.querySelectorAll(controls)) {
    // A box in its label is placed with it.
    if (each.matches("input") && each.closest("label")) continue;
    if (!each.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const own = each.getBoundingClientRect();
    let { left, top, right, bottom } = own;
    for (let room = each.parentElement; room !== document.body; room = room.parentElement) {
      const { overflowX, overflowY } = getComputedStyle(room);
      if (overflowX === "visible" && overflowY === "visible") continue;
      const box = room.getBoundingClientRect();
      [left, right] = [Math.max(left, box.left), Math.min(right, box.right)];
      [top, bottom] = [Math.max(top, box.top), Math.min(bottom, box.bottom)];
    }
    if (right - left < 2 || bottom - top < 2) continue;
    const name = each.dataset.testid || each.ariaLabel || each.textContent.trim();
    const cut = own.left < left - 1 || own.right > right + 1;
    seen.push({ each, name, left, top, right, bottom, cut });
  }
  const wrong = [];
  for (const [k, one] of seen.entries()) {
    const { each, name, left, right } = one;
    if (left < -0.5 || right > innerWidth + 0.5 || one.cut) wrong.push(`${name} is out of view`);
    if (each.matches("button, .number") && each.scrollWidth > each.clientWidth + 1) {
      wrong.push(`${name} is cut`);
    }
    for (const other of seen.slice(0, k)) {
      if (each.contains(other.each) || other.each.contains(each)) continue;
      const across = Math.min(right, other.right) - Math.max(left, other.left);
      const down = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
      if (across > 1 && down > 1) wrong.push(`${name} lies on ${other.name}`);
    }
  }
  return wrong;
}"""
"""Controls that are not in the window (or in what scrolls), whose text is cut, or that overlap."""


CUT_RINGS = """() => {
  const wrong = [];
  const controls = "a[href], button, input, select, canvas, [tabindex]";
  for (const each of document.querySelectorAll(controls)) {
    const seen = each.checkVisibility({ visibilityProperty: true });
    if (each.tabIndex < 0 || each.disabled || each.closest("svg") || !seen) continue;
    each.focus({ focusVisible: true });
    if (document.activeElement !== each) continue;
    const name = each.dataset.testid || each.ariaLabel || each.textContent.trim();
    const ringed = [each, each.nextElementSibling, each.closest("label")]
      .find((one) => one && getComputedStyle(one).outlineStyle !== "none");
    if (!ringed) {
      wrong.push(`${name} has no ring`);
      continue;
    }
    const { outlineOffset, outlineWidth } = getComputedStyle(ringed);
    const out = parseFloat(outlineOffset) + parseFloat(outlineWidth);
    const own = ringed.getBoundingClientRect();
    const rooms = [{ left: 0, top: 0, right: innerWidth, bottom: innerHeight }];
    for (let room = ringed.parentElement; room !== document.body; room = room.parentElement) {
      const { overflowX, overflowY } = getComputedStyle(room);
      if (overflowX === "visible" && overflowY === "visible") continue;
      rooms.push(room.getBoundingClientRect());
    }
    const cut = rooms.some(({ left, top, right, bottom }) =>
      own.left - out < left - 0.5 || own.right + out > right + 0.5
      || own.top - out < top - 0.5 || own.bottom + out > bottom + 0.5);
    if (cut) wrong.push(`the ring of ${name} is cut`);
  }
  document.activeElement.blur();
  scrollTo(0, 0);
  for (const room of document.querySelectorAll(".rooms > *")) room.scrollTop = 0;
  return wrong;
}"""
"""Controls that have the focus and no ring around them, or one that is not all in view."""


def serious_findings(page: Page) -> list[Any]:
    """What axe-core finds serious or worse; the page must be opened with ``bypass_csp``."""
    axe = PACKAGES / "axe-core" / "axe.min.js"
    if not axe.is_file():
        lacking("axe-core is not installed: make node")
    if page.evaluate("typeof axe === 'undefined'"):
        page.add_script_tag(path=str(axe))
    found = page.evaluate("axe.run().then((result) => result.violations)")
    return [
        (each["id"], [node["html"][:120] for node in each["nodes"]])
        for each in found
        if each["impact"] in {"serious", "critical"}
    ]
