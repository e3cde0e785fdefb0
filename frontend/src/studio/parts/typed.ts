// Lines of text that are typed: formulas, and ends of their ranges.

import { makeRoom } from "./controls.ts";
import { h } from "./dom.ts";
import { short } from "./numbers.ts";
import type { Bound } from "../state/types.ts";

/** Typing rests this long before what is typed is read, in milliseconds. */
const TYPING = 250;
/** Characters of an end of a range that there is always room for. */
const ROOM = 4;

/** Lines that are read together: when typing rests, and at once when one is left. */
export class TypedLines {
  private timer = 0;

  constructor(private readonly read: (gesture: string) => void) {}

  line(kind: string, testid: string, label: string, gesture: string): HTMLInputElement {
    const input = h("input", {
      type: "text",
      class: kind,
      spellcheck: "false",
      autocomplete: "off",
      autocapitalize: "off",
      "aria-label": label,
      "data-testid": testid,
    });
    input.addEventListener("input", () => {
      makeRoom(input, ROOM);
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.read(gesture), TYPING);
    });
    input.addEventListener("change", () => {
      clearTimeout(this.timer);
      this.read(gesture);
    });
    return input;
  }
}

/** What is typed as an end of a range: a number, or a formula of constants as in "pi/2". */
export function bound(text: string): Bound {
  const typed = text.trim();
  return typed && Number.isFinite(Number(typed)) ? Number(typed) : typed;
}

/** Whether two texts mean the same end: 3.14159265359 is pi. */
function same(one: string, other: string): boolean {
  return shown(bound(one)) === shown(bound(other));
}

/** An end as it is typed; multiples of pi, and simple shares of these, by that name. */
export function shown(end: Bound): string {
  return typeof end === "number" ? (ofPi(end) ?? short(end, DIGITS)) : end;
}

/** What an end becomes: as before where the same is shown. */
export function boundAfter(text: string, before: Bound): Bound {
  const typed = bound(text);
  return shown(typed) === shown(before) ? before : typed;
}

const DIGITS = 12;
const PARTS = [1, 2, 3, 4, 6, 8, 12];

/** A number as k pi / n, as far as digits tell; null if it is none. */
function ofPi(value: number): string | null {
  for (const part of PARTS) {
    const times = Math.round((value / Math.PI) * part);
    if (!times || Math.abs(times) > 4 * part || short((times * Math.PI) / part, DIGITS) !== short(value, DIGITS)) continue;
    const size = Math.abs(times) === 1 ? "pi" : `${Math.abs(times)}*pi`;
    return `${times < 0 ? "-" : ""}${size}${part > 1 ? `/${part}` : ""}`;
  }
  return null;
}

/** Show a text, unless the user is just typing what means the same. */
export function put(input: HTMLInputElement, text: string): void {
  if (document.activeElement === input ? same(input.value, text) : input.value === text) return;
  input.value = text;
  makeRoom(input, ROOM);
}
