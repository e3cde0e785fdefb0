// The families as cards: the chosen one, and the others when they are asked for.

import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { designIn } from "../state/aims.ts";
import type { Store } from "../state/store.ts";

export class Families {
  readonly element: HTMLElement;
  private readonly inputs = new Map<string, HTMLInputElement>();
  private readonly cards = h("div", { class: "families", role: "radiogroup", "aria-label": "Family of crease patterns" });
  private readonly more = button({ label: "Other families", text: "Other families", testid: "families-more", act: () => this.fold(!this.folded) });
  private folded = true;
  /** Whether a pointer chooses: keys go from one card to the next, and may go on. */
  private pointed = false;

  constructor(private readonly store: Store) {
    for (const [name, family] of Object.entries(store.info.families)) {
      const input = h("input", {
        type: "radio",
        name: "family",
        value: name,
        "data-testid": `family-${name}`,
        onchange: () => this.choose(name),
      });
      this.inputs.set(name, input);
      this.cards.append(
        h(
          "label",
          { class: "family", title: family.what },
          input,
          h("span", { class: "family-name" }, family.label),
          h("span", { class: "family-what" }, family.what),
        ),
      );
    }
    this.cards.addEventListener("pointerdown", () => (this.pointed = true));
    this.cards.addEventListener("keydown", ({ key }) => {
      this.pointed = false;
      if (key.startsWith("Arrow")) this.fold(false);
      else if (key === "Enter" || key === "Escape") this.fold(true);
    });
    this.element = h("div", { class: "family-choice" }, this.cards, this.more);
    this.element.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget instanceof Node && !this.element.contains(relatedTarget)) this.fold(true);
    });
    this.fold(true);
    store.design.bind((design) => {
      this.inputs.forEach((input, name) => (input.checked = name === design.shell.family));
    });
  }

  private fold(folded: boolean): void {
    this.folded = folded;
    this.cards.classList.toggle("folded", folded);
    setAttribute(this.more, "aria-expanded", String(!folded));
  }

  private choose(family: string): void {
    this.store.change(designIn(this.store, family), "family");
    if (this.pointed) this.fold(true);
  }
}
