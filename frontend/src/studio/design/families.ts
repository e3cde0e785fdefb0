// The families as cards.

import { h } from "../parts/dom.ts";
import { designIn } from "../state/aims.ts";
import type { Store } from "../state/store.ts";

export class Families {
  readonly element: HTMLElement;
  private readonly inputs = new Map<string, HTMLInputElement>();

  constructor(private readonly store: Store) {
    this.element = h("div", { class: "families", role: "radiogroup", "aria-label": "Family of crease patterns" });
    for (const [name, family] of Object.entries(store.info.families)) {
      const input = h("input", {
        type: "radio",
        name: "family",
        value: name,
        "data-testid": `family-${name}`,
        onchange: () => this.choose(name),
      });
      this.inputs.set(name, input);
      this.element.append(
        h(
          "label",
          { class: "family", title: family.what },
          input,
          h("span", { class: "family-name" }, family.label),
          h("span", { class: "family-what" }, family.what),
        ),
      );
    }
    store.design.bind((design) => {
      this.inputs.forEach((input, name) => (input.checked = name === design.shell.family));
    });
  }

  private choose(family: string): void {
    this.store.change(designIn(this.store, family), "family");
  }
}
