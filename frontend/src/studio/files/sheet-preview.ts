// The drawings that a workshop gets, as pictures to leaf through, with what they come to.

import type { Sheets } from "../../shared/api-types.ts";
import { length } from "../../shared/quantities.ts";
import { sentence } from "../../shared/words.ts";
import { drawSheets } from "../server/api.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { faultOf } from "../state/faults.ts";
import { isAuto } from "../state/aims.ts";
import { settled } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { percent } from "./workshop-words.ts";

/** Rest of the settings after which the sheets are drawn anew, in milliseconds. */
const REST = 300;

export class SheetPreview {
  readonly element: HTMLElement;
  private readonly picture = h("img", { class: "sheet-picture", alt: "", "data-testid": "sheet-picture" });
  private readonly paper = h("div", { class: "sheet-paper", tabindex: 0, role: "group", "aria-label": "Sheet" }, this.picture);
  private readonly place = h("span", { class: "sheet-place", "data-testid": "sheet-place" });
  private readonly back = button({ label: "Sheet before", text: "‹", testid: "sheet-back", act: () => this.leaf(-1) });
  private readonly next = button({ label: "Next sheet", text: "›", testid: "sheet-next", act: () => this.leaf(1) });
  private readonly leaves = h("div", { class: "sheet-leaves" }, this.back, this.place, this.next);
  private readonly facts = h("dl", { class: "sheet-facts", "data-testid": "sheet-facts" });
  private readonly legend = h("ul", { class: "sheet-legend", "aria-label": "Layers" });
  private readonly note = h("p", { class: "note", role: "status", "data-testid": "sheet-note" });
  private readonly work = new WorkBar("Drawing of sheets", () => this.stop(), "sheet-work");
  private sheets: Sheets | null = null;
  private at = 0;
  private url = "";
  private open = false;
  private subject: "sheets" | "paper" = "sheets";
  private timer = 0;
  private stopping = new AbortController();

  constructor(private readonly store: Store) {
    this.element = h(
      "div",
      { class: "sheet-preview", "data-testid": "sheet-preview" },
      this.paper, this.leaves, this.note, this.work.element, this.facts, this.legend,
    );
    this.paper.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      this.leaf(step);
    });
    store.design.watch(() => this.later(REST));
    store.name.watch(() => this.later(REST));
    store.freshness.watch((now) => now === "current" && this.later(REST));
    this.state = "none";
  }

  /** What is shown: the drawings to leaf through, or a paper model on its pages. */
  of(subject: "sheets" | "paper"): void {
    this.subject = subject;
    if (this.sheets) this.take(this.sheets);
  }

  /** The window is open or closed: sheets are drawn for those who look. */
  shown(open: boolean): void {
    this.open = open;
    if (open) return this.later(0);
    this.stopping.abort();
    clearTimeout(this.timer);
  }

  private later(rest: number): void {
    clearTimeout(this.timer);
    this.stopping.abort();
    this.work.hide();
    if (!this.open) return;
    this.state = "waiting";
    this.timer = window.setTimeout(() => void this.draw(), rest);
  }

  private async draw(): Promise<void> {
    const { design, name, report, freshness } = this.store;
    if (isAuto(design.value) && freshness.value !== "current") {
      return this.refuse("No family has been taken yet.");
    }
    if (design.value.tolerance && freshness.value !== "current") {
      return this.refuse("Rows and columns have not been chosen yet: press Choose beside the tolerance.");
    }
    this.stopping = new AbortController();
    const { signal } = this.stopping;
    this.work.begin("drawing the sheets");
    try {
      const sheets = await drawSheets(settled(this.store.info, design.value, report.value), name.value, signal, (share, what) => {
        if (!signal.aborted) this.work.show(share, what);
      });
      if (!signal.aborted) this.take(sheets);
    } catch (error) {
      if (signal.aborted) return;
      const { what, got, expected, remedy, message, kind } = faultOf(error);
      const said = kind === "input" ? [what, got && `Given: ${got}`, expected && `Needed: ${expected}`, remedy && `Remedy: ${remedy}`] : [message];
      this.refuse(said.map((text) => sentence(text || "")).filter(Boolean).join(" "));
    }
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.stopping.abort();
    this.refuse("Stopped. The sheets are drawn again when a setting changes.");
  }

  private refuse(words: string): void {
    this.work.hide();
    this.sheets = null;
    this.show("");
    this.facts.replaceChildren();
    this.legend.replaceChildren();
    this.note.textContent = words;
    this.note.classList.add("error");
    this.leaves.hidden = true;
    this.paper.hidden = true;
    this.state = "refused";
  }

  private take(sheets: Sheets): void {
    this.work.hide();
    this.sheets = sheets;
    const paper = this.subject === "paper";
    this.at = paper ? 0 : Math.min(this.at, sheets.sheets.length - 1);
    this.note.classList.remove("error");
    this.note.textContent = sheets.palette && `${sheets.palette}. Lines are wider here than in the files.`;
    this.paper.hidden = false;
    this.leaves.hidden = paper || sheets.sheets.length < 2;
    const facts = paper ? [["Model", sheets.paper.says] as const] : factsOf(sheets);
    this.facts.replaceChildren(...facts.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    this.legend.replaceChildren(
      ...[...sheets.layers].reverse().map(({ label, colour }) => h("li", {}, swatch(colour), label)),
    );
    this.turn();
    this.state = "shown";
  }

  private leaf(step: number): void {
    if (!this.sheets) return;
    const last = this.sheets.sheets.length - 1;
    this.at = Math.min(Math.max(this.at + step, 0), last);
    this.turn();
  }

  private turn(): void {
    const { sheets, paper } = this.sheets!;
    if (this.subject === "paper") {
      this.picture.alt = `Pages of the paper model: ${paper.says}`;
      this.paper.hidden = !paper.svg;
      return this.show(paper.svg);
    }
    const sheet = sheets[this.at]!;
    this.place.textContent = `${this.at + 1} of ${sheets.length}: ${sheet.file}`;
    this.back.setAttribute("aria-disabled", String(this.at === 0));
    this.next.setAttribute("aria-disabled", String(this.at === sheets.length - 1));
    this.picture.alt = sheet.title;
    this.show(sheet.svg);
  }

  /** A picture runs nothing, whatever is in it. */
  private show(svg: string): void {
    if (this.url) URL.revokeObjectURL(this.url);
    this.url = svg && URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    if (this.url) this.picture.src = this.url;
    else this.picture.removeAttribute("src");
  }

  private set state(state: "none" | "waiting" | "shown" | "refused") {
    this.element.dataset["state"] = state;
  }
}

/** What the sheets come to. */
export function factsOf({ stock, boards, unit, sheets }: Sheets): [string, string][] {
  const facts: [string, string][] = [
    ["Drawings", String(sheets.length)],
    ["Sheets to cut", String(stock.sheets)],
    ["Used of the sheets", percent(1 - stock.waste)],
    ["Cut", length(stock.cut_length, unit)],
    ["Creases", length(stock.crease_length, unit)],
  ];
  if (boards !== null) facts.push(["Sheets for boards", String(boards)]);
  return facts;
}

function swatch(colour: string): HTMLElement {
  const line = h("span", { class: "sheet-swatch", "aria-hidden": "true" });
  line.style.background = colour;
  return line;
}
