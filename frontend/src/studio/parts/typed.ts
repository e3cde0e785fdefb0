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

export function shown(end: Bound): string {
  return typeof end === "number" ? short(end, 12) : end;
}

/** Show a text, unless the user is just typing what means the same. */
export function put(input: HTMLInputElement, text: string): void {
  if (document.activeElement === input ? bound(input.value) === bound(text) : input.value === text) return;
  input.value = text;
  makeRoom(input, ROOM);
}
