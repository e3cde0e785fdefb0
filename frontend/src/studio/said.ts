// What was done, in a few words at the edge of the page, for a moment.

import { h } from "./dom.ts";
import type { Store } from "./store.ts";

const MOMENT = 6000;

export function saidElement(store: Store): HTMLElement {
  const element = h("p", { class: "said", role: "status", "data-testid": "said", hidden: true });
  let timer = 0;
  store.said.bind((text) => {
    clearTimeout(timer);
    element.textContent = text;
    element.hidden = !text;
    if (text) timer = window.setTimeout(() => store.said.set(""), MOMENT);
  });
  return element;
}
