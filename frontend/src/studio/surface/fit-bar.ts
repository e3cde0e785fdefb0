// How far a fit is, and a button that stops it; once it is stopped, one that fits again.

import { isWhole } from "../curves/curve-table.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { WorkBar } from "../parts/work-bar.ts";
import type { Live } from "../server/live.ts";
import { isAuto, isSlow } from "../state/aims.ts";
import type { Store } from "../state/store.ts";

export function fitBar(store: Store, live: Live): HTMLElement {
  const work = new WorkBar("Fit", () => live.cancel(), "fit-work");
  const words = h("span", {});
  const again = h(
    "div",
    { class: "fit-stopped" },
    words,
    button({ label: "Go on with what was stopped", text: "Go on", testid: "fit-again", act: () => live.again() }),
  );
  const element = h("div", { class: "fit-bar", role: "status" }, work.element, again);
  const refresh = (): void => {
    const { fitting, freshness, design, fault } = store;
    const stopped = isSlow(design.value) && isWhole(design.value) && !design.value.tolerance && freshness.value === "outdated" && !fault.value;
    again.hidden = !stopped;
    words.textContent = isAuto(design.value) ? "The trial of families was stopped." : "The fit was stopped.";
    if (fitting.value) work.show(fitting.value.share, fitting.value.what);
    else work.hide();
    element.hidden = !fitting.value && !stopped;
  };
  for (const signal of [store.fitting, store.freshness, store.design, store.fault]) (signal as { bind(listener: () => void): void }).bind(refresh);
  return element;
}
