// The three families as cards.

import { h } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";
import type { Design, Value } from "../state/types.ts";

/** Keys that mean the same in every family. */
const SHARED = ["rows", "columns", "flap"];

export class Families {
  readonly element: HTMLElement;
  private readonly inputs = new Map<string, HTMLInputElement>();
  /** Each family's table as it was left. */
  private readonly left = new Map<string, Record<string, Value>>();

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
      this.left.set(design.shell.family, design.pattern);
      this.inputs.forEach((input, name) => (input.checked = name === design.shell.family));
    });
  }

  private choose(family: string): void {
    const design = this.store.design.value;
    const pattern = this.patternFor(family, design);
    this.store.set({ "shell.family": family, pattern }, "family");
  }

  private patternFor(family: string, design: Design): Record<string, Value> {
    const pattern: Record<string, Value> = {};
    for (const { key, auto, default: value } of this.store.info.families[family]!.parameters) {
      // What must be given, and what has no value yet, is left to the program.
      if (value === null && auto) pattern[key] = "auto";
    }
    Object.assign(pattern, this.left.get(family));
    for (const key of SHARED) {
      const value = design.pattern[key];
      if (value !== undefined) pattern[key] = value;
    }
    const odd = this.store.info.families[family]!.parameters.some((p) => p.key === "rows" && p.step === 2);
    if (odd && typeof pattern["rows"] === "number" && pattern["rows"] % 2 === 0) pattern["rows"]++;
    if (design.tolerance) {
      delete pattern["rows"];
      delete pattern["columns"];
    } else {
      pattern["rows"] ??= 9;
      pattern["columns"] ??= 11;
      this.trim(pattern);
    }
    return pattern;
  }

  /** Lists that were as long as the rows and columns then do not outlive these. */
  private trim(pattern: Record<string, Value>): void {
    const lengths: Record<string, number> = {
      row_lengths: Number(pattern["columns"]) - 1,
      couplings: Number(pattern["columns"]) - 1,
      column_lengths: Number(pattern["rows"]) + 1,
    };
    for (const [key, length] of Object.entries(lengths)) {
      const value = pattern[key];
      if (Array.isArray(value) && value.length !== length) delete pattern[key];
    }
  }
}
