// Links that lead past what comes first, for the keyboard.

import { h } from "../parts/dom.ts";

/** Words, and what to go to. */
const PLACES: [words: string, selector: string][] = [
  ["To the shell", ".scene canvas"],
  ["To the curves", "[data-testid=curve-f]"],
  ["To the loads", ".structure > button:not([hidden]), .structure select"],
  ["To the figures", ".figures-frame"],
];

export function skipLinks(): HTMLElement {
  return h(
    "nav",
    { class: "skips", "aria-label": "Go to" },
    ...PLACES.map(([words, selector]) => {
      const go = (): void => {
        const place = document.querySelector<HTMLElement | SVGElement>(selector);
        place?.focus();
        place?.scrollIntoView({ block: "nearest" });
      };
      return h("button", { type: "button", class: "button skip", onclick: go }, words);
    }),
  );
}
