// The design's name, which its files carry, typed in place.

import { h } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";

/** What a design without a name is called. */
const NAMELESS = "shell";

export function nameField(store: Store): HTMLInputElement {
  const input = h("input", {
    type: "text",
    class: "design-name",
    "aria-label": "Name of the design",
    title: "Name of the design, and of the files that are written of it",
    autocomplete: "off",
    spellcheck: "false",
    maxlength: 80,
    "data-testid": "design-name",
  });
  const take = (): void => {
    store.rename(nameOf(input.value));
    input.value = store.name.value;
  };
  input.addEventListener("change", take);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") input.value = store.name.value;
    if (event.key === "Enter" || event.key === "Escape") input.blur();
  });
  store.name.bind((text) => (input.value = text));
  return input;
}

/** A name that files of every system can have. */
export function nameOf(typed: string): string {
  const plain = typed.replace(/[\\/:*?"<>|\p{C}]+/gu, " ").replace(/\s+/g, " ");
  return plain.replace(/^[. ]+|[. ]+$/g, "") || NAMELESS;
}
