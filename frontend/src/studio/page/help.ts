// Help: a short tour of the page, which ends with keys and gestures.

import { button } from "../parts/controls.ts";
import { h, scrolledByKeys } from "../parts/dom.ts";
import { placeCard, STEPS } from "./tour-steps.ts";

const KEYS: [string, string][] = [
  ["Ctrl Z, Ctrl Shift Z", "undo, redo"],
  ["Ctrl O, Ctrl S", "open, save the design file"],
  ["Space", "play or pause the folding"],
  ["?", "these keys"],
  ["← →, Page Up, Page Down", "fold by a step, with Shift a stride; to the next rest or back"],
  ["Home, End", "the begin and the end of the motion"],
  ["M, Escape", "measure a distance; end that, close a card"],
  ["Enter and arrow keys in the pattern", "choose a panel and go to those beside; measuring: vertices"],
  ["Arrow keys on a point", "move it; with Shift ten times as far, with Alt a tenth"],
  ["Delete on a point", "remove it"],
  ["D on a curve", "draw it anew; arrow keys and Space put points, Enter ends, Escape cancels"],
  ["Double click on a curve", "add a point"],
  ["Alt while dragging a point", "it is not caught by the grid, axes and mirror images"],
  ["Dots and sizes at the shell", "drag a dot, or press arrow keys on it; type a size and press Enter"],
  ["Wheel, drag, + and −", "zoom and pan a curve, the pattern, the shell"],
  ["0 or Home in a drawing", "fit into view"],
  ["F, or double click on the shell", "fit it into view, and follow it as it folds"],
  ["Drop a file", "a design file (TOML) opens; a drawing (CSV, SVG, DXF) becomes f or g; a crease pattern (FOLD, SVG, DXF) a design"],
];

export class Help {
  readonly element: HTMLDialogElement;
  private readonly ring = h("div", { class: "tour-ring" });
  private readonly title = h("h2", { id: "help-title" });
  private readonly text = h("p", { id: "help-text" });
  private readonly keys: HTMLElement;
  private readonly count = h("span", { class: "quiet tour-count" });
  private readonly back = button({ label: "Back", text: "Back", testid: "tour-back", act: () => this.go(this.at - 1) });
  private readonly next = button({ label: "Next", text: "Next", class: "button primary", testid: "tour-next", act: () => this.go(this.at + 1) });
  private readonly card: HTMLElement;
  private at = 0;
  /** How far the page and its rooms were scrolled before they were shown. */
  private scrolled: [Element, number][] = [];

  constructor(version: string) {
    this.keys = h(
      "div",
      {},
      h("dl", { class: "keys" }, ...KEYS.flatMap(([keys, what]) => [h("dt", {}, keys), h("dd", {}, what)])),
      h("p", { class: "note" }, `orishell ${version}. Everything is computed on this machine; nothing is sent elsewhere.`),
    );
    this.card = h(
      "div",
      { class: "tour-card", "data-testid": "tour-card" },
      h("header", { class: "panel-head" }, this.title, button({ label: "Close", icon: "close", testid: "tour-close", act: () => this.element.close() })),
      scrolledByKeys(h("div", { class: "tour-body", "aria-live": "polite" }, this.text, this.keys)),
      h("footer", { class: "tour-foot" }, this.count, this.back, this.next),
    );
    this.element = h("dialog", { class: "tour", "aria-labelledby": "help-title", "data-testid": "tour" }, this.ring, this.card);
    this.element.addEventListener("click", (event) => {
      if (event.target === this.element || event.target === this.ring) this.element.close();
    });
    this.element.addEventListener("keydown", (event) => {
      if (event.key === "ArrowRight") this.go(this.at + 1);
      else if (event.key === "ArrowLeft") this.go(this.at - 1);
      else return;
      event.preventDefault();
    });
    // What opened it may be gone; keys belong to the page again.
    this.element.addEventListener("close", () => {
      for (const [room, top] of this.scrolled) room.scrollTop = top;
      if (this.element.contains(document.activeElement)) (document.activeElement as HTMLElement).blur();
    });
    window.addEventListener("resize", () => this.element.open && this.place());
  }

  /** Show the page, step by step. */
  tour(): void {
    this.open(0);
  }

  /** Show keys and gestures. */
  list(): void {
    this.open(STEPS.length);
  }

  private open(at: number): void {
    if (!this.element.open) {
      this.scrolled = [...document.querySelectorAll("html, .rooms > *")].map((room) => [room, room.scrollTop]);
      this.element.showModal();
    }
    this.go(at);
    this.next.focus();
  }

  private go(at: number): void {
    if (at > STEPS.length) return this.element.close();
    this.at = Math.max(0, at);
    const step = STEPS[this.at];
    this.title.textContent = step?.title ?? "Keys and gestures";
    this.text.textContent = step?.text ?? "";
    this.text.hidden = !step;
    this.keys.hidden = !!step;
    this.count.textContent = `${this.at + 1} of ${STEPS.length + 1}`;
    this.back.disabled = this.at === 0;
    this.next.textContent = step ? "Next" : "Done";
    this.next.setAttribute("aria-label", this.next.textContent);
    this.place();
  }

  private place(): void {
    const selector = STEPS[this.at]?.region;
    const region = selector ? document.querySelector(selector) : null;
    region?.scrollIntoView({ block: "nearest" });
    const whole = region?.getBoundingClientRect();
    const { innerWidth: width, innerHeight: height } = window;
    // What is out of the window is not pointed at.
    const box = whole && {
      left: Math.max(0, whole.left),
      top: Math.max(0, whole.top),
      width: Math.min(width, whole.right) - Math.max(0, whole.left),
      height: Math.min(height, whole.bottom) - Math.max(0, whole.top),
    };
    const { offsetWidth, offsetHeight } = this.card;
    const { left, top } = placeCard(box ?? null, { width: offsetWidth, height: offsetHeight }, { width, height });
    Object.assign(this.card.style, { left: `${left}px`, top: `${top}px` });
    const ring = box ?? { left: width / 2, top: height / 2, width: 0, height: 0 };
    Object.assign(this.ring.style, {
      left: `${ring.left}px`, top: `${ring.top}px`, width: `${ring.width}px`, height: `${ring.height}px`,
    });
  }
}
