// Whether a person stands beside the shell and in the profile, asked at both.

import { h } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";

/** `suits`: of a curve, whether a person says how large it is. */
export function figureSwitch({ figure, curves }: Store, testid: string, suits: (() => boolean) | null = null): HTMLElement {
  const input = h("input", { type: "checkbox", "data-testid": testid, onchange: () => figure.set(input.checked) });
  figure.bind((on) => (input.checked = on));
  const title = "a person of 1.75 m, for the size";
  const label = h("label", { class: "check", title }, input, "Person");
  if (suits) curves.watch(() => (label.hidden = !suits()));
  return label;
}
