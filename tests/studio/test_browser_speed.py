"""A slow network in a browser: several requests under way, and none drawn that is overtaken."""

from __future__ import annotations

from typing import TYPE_CHECKING

from samples import thorough
from studio_pages import opened, settle
from viewer_pages import wait_until

if TYPE_CHECKING:
    from playwright.sync_api import Browser

FAR = """() => {
  const seen = window.__seen = { under: 0, most: 0, sent: 0, drawn: [], done: false };
  const near = window.fetch;
  window.fetch = async (place, options) => {
    if (!String(place).endsWith("api/design")) return near(place, options);
    seen.most = Math.max(seen.most, ++seen.under);
    const late = ++seen.sent === 4 ? 3000 : 800;
    await new Promise((resolve) => setTimeout(resolve, late));
    try { return await near(place, options); } finally { seen.under--; }
  };
  const { store } = window.__orishell;
  store.report.watch((report) => seen.drawn.push(report.parameters.xi_deg));
}"""
"""Every design takes 800 ms to reach the server, one of them 3 s."""
DRAG = """() => {
  const { store } = window.__orishell;
  let step = 0;
  const move = () => {
    const design = structuredClone(store.design.value);
    design.pattern.xi_deg = 30 + 0.5 * ++step;
    store.change(design, "xi");
    if (step < 40) setTimeout(move, 100); else window.__seen.done = true;
  };
  move();
}"""


@thorough
def test_a_drag_over_a_slow_network(browser: Browser, address: str) -> None:
    with opened(browser, address) as page:
        page.evaluate(FAR)
        page.evaluate(DRAG)
        wait_until(page, "window.__seen.done")
        settle(page)
        seen = page.evaluate("window.__seen")
        assert 2 <= seen["most"] <= 4
        assert seen["drawn"] == sorted(seen["drawn"])
        assert seen["drawn"][-1] == 50
        assert len(set(seen["drawn"])) < seen["sent"]  # the one that was late was not drawn
        assert page.evaluate("window.__orishell.store.freshness.value") == "current"
