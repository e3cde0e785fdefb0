// The families as cards: the chosen one, and the others when they are asked for.

import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { designIn } from "../state/aims.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

export class Families {
  readonly element: HTMLElement;
  private readonly inputs = new Map<string, HTMLInputElement>();
  private readonly cards = h("div", { class: "families", role: "radiogroup", "aria-label": "Family of crease patterns" });
  private readonly more = button({ label: "Other families", text: "Other families", testid: "families-more", act: () => this.fold(!this.folded) });
  private folded = true;
  /** Whether a pointer chooses: keys go from one card to the next, and may go on. */
  private pointed = false;
  /** The design from which keys go along the cards, and what the present one makes of it: none of those between
   * takes a target away that the next could follow. */
  private walk: { from: Design; now: Design } | null = null;

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
      else if (key === "Enter" || key === "Escape") this.arrive();
    });
    this.element = h("div", { class: "family-choice" }, this.cards, this.more);
    this.element.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget instanceof Node && !this.element.contains(relatedTarget)) this.arrive();
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

  private arrive(): void {
    this.fold(true);
    if (this.walk) this.store.rest();
    this.walk = null;
  }

  private choose(family: string): void {
    const { store } = this;
    const { info, left, design } = store;
    if (this.pointed) {
      store.change(designIn(store, family), "family");
      return this.fold(true);
    }
    const from = this.walk?.now === design.value ? this.walk.from : design.value;
    const now = family === from.shell.family ? from : designIn({ info, left, design: { value: from } }, family);
    this.walk = { from, now };
    store.change(now, "family", "family!");
  }
}
