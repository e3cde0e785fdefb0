"""A drag in a browser: what it costs the page, and what a slow network makes of it.

Over a slow network several requests are under way, and none is drawn that is overtaken.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from samples import thorough
from studio_pages import choose, drawn, opened, settle
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
        choose(page, "parallel-repeating")
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


LARGE = """() => {
  const { store } = window.__orishell, design = structuredClone(store.design.value);
  Object.assign(design.pattern, { rows: 29, columns: 30 });
  store.change(design, "large");
}"""
SIZES_ASKED = """() => {
  const asked = window.__asked = { times: 0 };
  for (const name of ["clientWidth", "clientHeight"]) {
    const { get } = Object.getOwnPropertyDescriptor(Element.prototype, name);
    Object.defineProperty(Element.prototype, name, {
      get() { asked.times++; return get.call(this); },
    });
  }
}"""
STEPS = """(steps) => {
  const { store, latencies } = window.__orishell;
  let step = 0;
  window.__dragged = false;
  const move = () => {
    if (step === steps) { window.__dragged = true; return; }
    const design = structuredClone(store.design.value), before = latencies.length;
    design.pattern.xi_deg = 45 + 0.3 * ++step;
    store.change(design, "xi");
    const wait = () => latencies.length > before ? move() : setTimeout(wait, 10);
    wait();
  };
  move();
}"""
"""Moves a slider by so many steps, each when the shell of the one before has been drawn."""


def longest_task(trace: bytes) -> float:
    """Processor time of the longest task of the page's main thread (ms), by a browser's trace.

    That is without the time that it waits: for the processor, or for pictures that are drawn
    without a graphics card.
    """
    events: list[dict[str, Any]] = json.loads(trace)["traceEvents"]
    main = {
        (each["pid"], each["tid"])
        for each in events
        if each["name"] == "thread_name" and each["args"]["name"] == "CrRendererMain"
    }
    tasks: list[float] = [
        each["tdur"] / 1e3
        for each in events
        if (each["pid"], each["tid"]) in main
        and each["name"].endswith("RunTask")
        and "tdur" in each
    ]
    assert len(tasks) > 20
    return max(tasks)


@thorough
def test_a_drag_never_holds_the_page(browser: Browser, address: str) -> None:
    """Of 29 x 30: the longest task took 15 to 50 ms of a busy, slow processor."""
    with opened(browser, address, width=1024, height=600) as page:
        choose(page, "parallel-repeating")
        page.evaluate(LARGE)
        drawn(page)
        page.evaluate(SIZES_ASKED)
        browser.start_tracing(page=page, categories=["-*", "toplevel"])
        page.evaluate(STEPS, 6)
        wait_until(page, "window.__dragged")
        assert longest_task(browser.stop_tracing()) < 100
        # Once and again: for every vertex of the pattern it was 7,000 times a shell, each of which
        # may make the page lay itself out.
        assert page.evaluate("window.__asked.times") < 6 * 100
