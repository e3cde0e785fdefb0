// What was done, in a few words at the edge of the page, until one has gone on for a moment.

import { h } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";

const MOMENT = 5000;

export function saidElement(store: Store): HTMLElement {
  const element = h("p", { class: "said", role: "status", "data-testid": "said", hidden: true });
  let timer = 0;
  store.said.bind((text) => {
    clearTimeout(timer);
    timer = 0;
    element.textContent = text;
    element.hidden = !text;
  });
  const goneOn = (): void => {
    if (store.said.value && !timer) timer = window.setTimeout(() => store.said.set(""), MOMENT);
  };
  for (const event of ["pointermove", "keydown"]) document.addEventListener(event, goneOn);
  return element;
}
