// Small controls that several panels use.

import { h, uniqueId } from "./dom.ts";
import { type IconName, icon } from "./icons.ts";
import { short } from "./numbers.ts";
import { isUnit, typedNumber } from "./amounts.ts";

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

/** Boxes for numbers, and what is typed into each. */
const NUMBERS = new WeakMap<HTMLInputElement, number>();

/**
 * A box for a number, as people type them, in any unit of what the one beside it measures; calls back when what
 * is typed is one. Until it is left what that means is said below it.
 *
 * `min` and `max` end the steps of the arrow keys.
 */
export function numberBox(
  { step, min, max, ...attributes }: Record<string, string | number | null>,
  changed: (value: number) => void,
): HTMLInputElement {
  const input = h("input", { type: "text", inputmode: "decimal", class: "number", autocomplete: "off", spellcheck: "false", ...attributes });
  const echo = h("output", { class: "echo", "aria-live": "polite" });
  input.addEventListener("input", () => {
    const unit = unitBeside(input);
    const value = typedNumber(input.value, unit);
    const wrong = !Number.isFinite(value);
    NUMBERS.set(input, value);
    makeRoom(input);
    input.classList.toggle("unfinished", wrong);
    const { left, bottom } = input.getBoundingClientRect();
    Object.assign(echo.style, { left: `${left}px`, top: `${bottom}px` });
    echo.textContent = wrong || Number(input.value) === value ? "" : `= ${short(value, 8)} ${isUnit(unit) ? unit : ""}`;
    if (echo.textContent && !echo.isConnected) input.after(echo);
    if (!wrong) changed(value);
  });
  input.addEventListener("blur", () => {
    const value = numberIn(input);
    if (echo.textContent && Number.isFinite(value)) input.value = short(value, 10);
    makeRoom(input);
    echo.remove();
  });
  input.addEventListener("keydown", (event) => {
    const way = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    const value = numberIn(input);
    if (!way || !Number.isFinite(value)) return;
    event.preventDefault();
    const least = typeof step === "number" ? step : 10 ** Math.floor(Math.log10(Math.abs(value) || 10) - 1);
    const to = value + way * least * (event.shiftKey ? 10 : 1);
    input.value = short(Math.min(Number(max ?? Infinity), Math.max(Number(min ?? -Infinity), to)), 10);
    input.dispatchEvent(new Event("input", { bubbles: true }));
    input.dispatchEvent(new Event("change", { bubbles: true }));
  });
  return input;
}

/** The unit that stands beside a box. */
function unitBeside(input: HTMLInputElement): string {
  for (let at: Element | null = input; at && !at.matches("fieldset, section, form"); at = at.parentElement) {
    for (let next = at.nextElementSibling; next; next = next.nextElementSibling) {
      if (next.matches(".unit")) return next.textContent;
      if (next.matches("input")) break;
    }
  }
  return "";
}

/** The number that is in a box; NaN if there is none. */
export function numberIn(input: HTMLInputElement): number {
  return NUMBERS.get(input) ?? NaN;
}

/** Show a value unless the user is just typing the same one in other digits, or another unit. */
export function setNumber(input: HTMLInputElement, text: string): void {
  const value = text === "" ? NaN : Number(text);
  const typed = numberIn(input);
  if (document.activeElement === input && Math.abs(typed - value) <= 1e-9 * Math.abs(value)) return;
  NUMBERS.set(input, value);
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
