// Small controls that several panels use.

import { h, uniqueId } from "./dom.ts";
import { type IconName, icon } from "./icons.ts";

export interface ButtonOptions {
  label: string;
  icon?: IconName;
  text?: string;
  testid?: string;
  class?: string;
  keys?: string;
  act: () => void;
}

/** A button; without text it shows its icon only and is labelled for screen readers. */
export function button(options: ButtonOptions): HTMLButtonElement {
  const named = options.text === undefined || options.text !== options.label;
  return h(
    "button",
    {
      type: "button",
      class: options.class ?? (options.text === undefined ? "button icon-only" : "button"),
      title: options.keys ? `${options.label} (${options.keys})` : options.label,
      "aria-label": named ? options.label : null,
      "aria-keyshortcuts": options.keys?.replace("Ctrl", "Control") ?? null,
      "data-testid": options.testid ?? null,
      onclick: options.act,
    },
    options.icon ? icon(options.icon) : null,
    options.text === undefined ? null : options.icon ? h("span", { class: "word" }, options.text) : options.text,
  );
}

export interface Segmented<T extends string> {
  element: HTMLElement;
  set(value: T): void;
}

/** A choice of a few, all in view. */
export function segmented<T extends string>(
  label: string,
  choices: { value: T; text: string; testid?: string; title?: string }[],
  chosen: (value: T) => void,
): Segmented<T> {
  const name = uniqueId("choice");
  const inputs = new Map<T, HTMLInputElement>();
  const element = h("div", { class: "segmented", role: "radiogroup", "aria-label": label });
  for (const { value, text, testid, title } of choices) {
    const input = h("input", {
      type: "radio",
      name,
      value,
      "data-testid": testid ?? null,
      onchange: () => chosen(value),
    });
    inputs.set(value, input);
    element.append(h("label", { title: title ?? null }, input, h("span", {}, text)));
  }
  return { element, set: (value) => inputs.forEach((input, each) => (input.checked = each === value)) };
}

/** A box for a number; calls back when what is typed is one. */
export function numberBox(
  attributes: Record<string, string | number | null>,
  changed: (value: number) => void,
): HTMLInputElement {
  const input = h("input", { type: "number", class: "number", autocomplete: "off", ...attributes });
  input.addEventListener("input", () => {
    const value = input.valueAsNumber;
    const wrong = !Number.isFinite(value);
    makeRoom(input);
    input.classList.toggle("unfinished", wrong);
    if (!wrong) changed(value);
  });
  return input;
}

/** Show a value unless the user is just typing the same one in other digits. */
export function setNumber(input: HTMLInputElement, text: string): void {
  if (document.activeElement === input && input.valueAsNumber === Number(text)) return;
  if (input.value !== text) input.value = text;
  makeRoom(input);
  input.classList.remove("unfinished");
}

/** Characters that a box has room for without growing. */
const ROOM = 8;

/** A box grows with what is in it, so that nothing is cut. */
export function makeRoom(input: HTMLInputElement, least = ROOM): void {
  input.style.setProperty("--digits", String(Math.max(least, input.value.length)));
}
