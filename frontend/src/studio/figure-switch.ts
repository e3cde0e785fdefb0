// Whether a person stands beside the shell and in the profile, asked at both.

import { h } from "./dom.ts";
import type { Store } from "./store.ts";

export function figureSwitch({ figure }: Store, testid: string): HTMLElement {
  const input = h("input", { type: "checkbox", "data-testid": testid, onchange: () => figure.set(input.checked) });
  figure.bind((on) => (input.checked = on));
  const title = "a person of 1.75 m, for the size";
  return h("label", { class: "check", title }, input, "Person");
}
