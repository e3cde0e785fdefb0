// What is to be written, as pictures to leaf through: drawings for a workshop with what they come to, a paper
// model on its pages, or the booklet of a kit.

import type { Booklet, LayerPen, Sheets } from "../../shared/api-types.ts";
import { length } from "../../shared/quantities.ts";
import { sentence } from "../../shared/words.ts";
import { drawBooklet, drawSheets } from "../server/api.ts";
import { h } from "../parts/dom.ts";
import { remedyButton } from "../parts/remedy-button.ts";
import { faultOf } from "../state/faults.ts";
import { isAuto } from "../state/aims.ts";
import { settled } from "../state/sizing.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { type Leaf, Leaves } from "./leaves.ts";
import { percent } from "./workshop-words.ts";

/** Rest of the settings after which all is drawn anew, in milliseconds. */
const REST = 300;

/** Drawings, a paper model, a booklet alone, that of a kit, or that of the kit of a card model. */
export type Subject = "sheets" | "paper" | "booklet" | "kit" | "card";
type Drawn = { sheets: Sheets } | { booklet: Booklet };

export class SheetPreview {
  readonly element: HTMLElement;
  private readonly leaves = new Leaves();
  private readonly facts = h("dl", { class: "sheet-facts", "data-testid": "sheet-facts" });
  private readonly legend = h("ul", { class: "sheet-legend", "aria-label": "Layers" });
  private readonly note = h("p", { class: "note", role: "status", "data-testid": "sheet-note" });
  private readonly work = new WorkBar("Drawing of pages", () => this.stop(), "sheet-work");
  private drawn: Drawn | null = null;
  private open = false;
  private subject: Subject = "sheets";
  private timer = 0;
  private stopping = new AbortController();

  constructor(private readonly store: Store) {
    this.element = h(
      "div",
      { class: "sheet-preview", "data-testid": "sheet-preview" },
      this.leaves.paper, this.leaves.turner, this.note, this.work.element, this.facts, this.legend,
    );
    store.design.watch(() => this.later(REST));
    store.name.watch(() => this.later(REST));
    store.freshness.watch((now) => now === "current" && this.later(REST));
    this.state = "none";
  }

  /** What is shown. */
  of(subject: Subject): void {
    if (subject === this.subject) return;
    this.subject = subject;
    this.element.dataset["subject"] = subject;
    if (this.drawn && "sheets" in this.drawn && !this.isBooklet) return this.take(this.drawn, true);
    this.leaves.show([]);
    this.clear();
    this.later(0);
  }

  /** The window is open or closed: all is drawn for those who look. */
  shown(open: boolean): void {
    this.open = open;
    if (open) return this.later(0);
    this.stopping.abort();
    clearTimeout(this.timer);
  }

  private get isBooklet(): boolean {
    return this.subject !== "sheets" && this.subject !== "paper";
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
    this.work.begin(this.isBooklet ? "drawing the booklet" : "drawing the sheets");
    try {
      const drawn = await this.ask(settled(this.store.info, design.value, report.value), name.value, signal);
      if (!signal.aborted) this.take(drawn);
    } catch (error) {
      if (signal.aborted) return;
      const fault = faultOf(error);
      const { what, got, expected, remedy, message, kind } = fault;
      const said = kind === "input" ? [what, got && `Given: ${got}`, expected && `Needed: ${expected}`, remedy && `Remedy: ${remedy}`] : [message];
      this.refuse(said.map((text) => sentence(text || "")).filter(Boolean).join(" "), remedyButton(this.store, fault));
    }
  }

  private async ask(design: Design, name: string, signal: AbortSignal): Promise<Drawn> {
    const progressed = (share: number, what: string): void => {
      if (!signal.aborted) this.work.show(share, what);
    };
    return this.isBooklet
      ? { booklet: await drawBooklet(design, name, this.subject, signal, progressed) }
      : { sheets: await drawSheets(design, name, signal, progressed) };
  }

  private stop(): void {
    clearTimeout(this.timer);
    this.stopping.abort();
    this.refuse(`Stopped. The ${this.isBooklet ? "booklet is" : "sheets are"} drawn again when a setting changes.`);
  }

  private refuse(words: string, mend: HTMLElement | null = null): void {
    this.work.hide();
    this.drawn = null;
    this.leaves.show([]);
    this.clear();
    this.note.replaceChildren(words, ...(mend ? [" ", mend] : []));
    this.note.classList.add("error");
    this.state = "refused";
  }

  private clear(): void {
    this.facts.replaceChildren();
    this.legend.replaceChildren();
    this.note.textContent = "";
    this.note.classList.remove("error");
  }

  private take(drawn: Drawn, fromFirst = false): void {
    this.work.hide();
    this.drawn = drawn;
    this.clear();
    if ("booklet" in drawn) {
      const pages = drawn.booklet.pages.map(({ svg, title }) => ({ svg, name: "", says: `Page of the booklet: ${title}` }));
      this.leaves.show(pages, "Page ", fromFirst);
    } else {
      const { sheets } = drawn;
      const paper = this.subject === "paper";
      this.leaves.show(paper ? pagesOf(sheets) : sheets.sheets.map(({ svg, file, title }) => ({ svg, name: file, says: title })), "", fromFirst);
      this.note.textContent = sheets.palette && `${sheets.palette}. Lines are wider here than in the files.`;
      this.describe(paper ? [["Model", sheets.paper.says]] : factsOf(sheets), sheets.layers);
    }
    this.state = "shown";
  }

  private describe(facts: [string, string][], layers: LayerPen[]): void {
    this.facts.replaceChildren(...facts.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    this.legend.replaceChildren(...[...layers].reverse().map(({ label, colour }) => h("li", {}, swatch(colour), label)));
  }

  private set state(state: "none" | "waiting" | "shown" | "refused") {
    this.element.dataset["state"] = state;
  }
}

/** The paper model with the frames of its pages; none where that takes too many. */
function pagesOf({ paper }: Sheets): Leaf[] {
  return paper.svg ? [{ svg: paper.svg, name: "", says: `Pages of the paper model: ${paper.says}` }] : [];
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
