// Whether a person stands beside the shell.

import { h } from "./dom.ts";
import type { Store } from "./store.ts";

export function figureSwitch({ figure }: Store): HTMLElement {
  const input = h("input", { type: "checkbox", "data-testid": "figure-f", onchange: () => figure.set(input.checked) });
  figure.bind((on) => (input.checked = on));
  const title = "a person of 1.75 m, where that is no speck and fits";
  return h("label", { class: "check", title }, input, "Person");
}
