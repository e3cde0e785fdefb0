// The dialog that lists keys and gestures.

import { button } from "./controls.ts";
import { h } from "./dom.ts";

const KEYS: [string, string][] = [
  ["Ctrl Z, Ctrl Shift Z", "undo, redo"],
  ["Ctrl O, Ctrl S", "open, save the design file"],
  ["Space", "play or pause the folding"],
  ["?", "this help"],
  ["Arrow keys on a control point", "move it; with Shift ten times as far, with Alt a tenth"],
  ["Delete on a control point", "remove it"],
  ["Double click on a curve's plane", "add a control point"],
  ["Wheel, drag, + and −", "zoom and pan a curve, the pattern, the shell"],
  ["0 or Home", "fit into view"],
  ["Drop a file", "on a curve: CSV, SVG or DXF; elsewhere: a design file (TOML)"],
];

export class Help {
  readonly element: HTMLDialogElement;

  constructor(version: string) {
    this.element = h(
      "dialog",
      { class: "dialog", "aria-labelledby": "help-title" },
      h(
        "header",
        { class: "panel-head" },
        h("h2", { id: "help-title" }, "Keys and gestures"),
        button({ label: "Close", icon: "close", act: () => this.element.close() }),
      ),
      h("dl", { class: "keys" }, ...KEYS.flatMap(([keys, what]) => [h("dt", {}, keys), h("dd", {}, what)])),
      h(
        "p",
        { class: "note" },
        `orishell ${version}. Everything is computed on this machine; nothing is sent elsewhere.`,
      ),
    );
    this.element.addEventListener("click", (event) => {
      if (event.target === this.element) this.element.close();
    });
  }

  open(): void {
    if (!this.element.open) this.element.showModal();
  }
}
