// Rows of controls of the structure: a name, a control, a unit.

import type { KeyWords } from "../../shared/api-types.ts";
import { numberBox, type Segmented } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";

/** A box for a number; one with a placeholder may be emptied, which is 0. */
export function box(key: string, changed: (value: number) => void, placeholder = "", min = 0): HTMLInputElement {
  const input = numberBox({ min, step: "any", placeholder, id: `structure-${key}`, "data-testid": `structure-${key}` }, changed);
  // One that was empty when it was entered has no "change" when it is empty again.
  const empty = (): void => void (input.classList.contains("unfinished") && input.value === "" && input.placeholder && changed(0));
  for (const left of ["change", "blur"]) input.addEventListener(left, empty);
  return input;
}

export function choice(key: string, { label }: KeyWords, options: [string, string][], chosen: (value: string) => void): HTMLSelectElement {
  const select = h("select", { id: `structure-${key}`, "data-testid": `structure-${key}`, "aria-label": label, onchange: () => chosen(select.value) });
  select.append(...options.map(([value, text]) => new Option(text, value)));
  return select;
}

export function row(key: string, { label, help }: KeyWords, control: HTMLElement, unit?: string): HTMLElement {
  return h(
    "div",
    { class: "parameter-head", title: help },
    h("label", { for: `structure-${key}` }, label),
    control,
    unit === undefined ? null : h("span", { class: "unit" }, unit),
  );
}

export function named({ label, help }: KeyWords, { element }: Segmented<string>): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("span", {}, label), element);
}
