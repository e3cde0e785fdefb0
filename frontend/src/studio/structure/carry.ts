// Designs that carry their loads, found from one that does not: a table, each row opens as the design.

import type { Carrying, CarrySearch } from "../../shared/api-types.ts";
import { threeDigits } from "../../shared/quantities.ts";
import { capital, sentence } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { makeItCarry } from "../server/api.ts";
import { changed } from "../state/changed.ts";
import { faultOf } from "../state/faults.ts";
import { isFound, type Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

type State = "none" | "running" | "found" | "stopped" | "failed";
const FIGURES: [string, string][] = [
  ["kg", "mass of all that loads it with its own weight"],
  ["Parts", "on the site: pieces, what is clipped on, ties and locks"],
  ["Pack", "sides of its pack"],
  ["Used", "share of what is borne, by what governs"],
];

export class CarryCard {
  readonly element: HTMLElement;
  /** The design that the search began from, and what was found. */
  private base: Design | null = null;
  private found: Carrying[] = [];
  private stopping = new AbortController();

  private readonly go = button({ label: "Find designs that carry", text: "Make it carry", class: "button primary", testid: "make-it-carry", act: () => void this.search() });
  private readonly work = new WorkBar("Search for designs that carry", () => this.stop(), "carry-work");
  private readonly note = h("p", { class: "note", role: "status", "data-testid": "carry-note" });
  private readonly table = h("table", { "data-testid": "carry-table" });
  private readonly count = h("summary", {});
  private readonly list = h("ul", {});
  private readonly results: HTMLElement;
  private readonly tried = h("details", { "data-testid": "carry-tried" }, this.count, this.list);

  constructor(private readonly store: Store) {
    this.results = h("div", { class: "carry-results" }, this.note, this.table, this.tried);
    this.element = h("div", { class: "carry", role: "region", "aria-label": "Designs that carry", "data-testid": "carry" }, this.go, this.work.element, this.results);
    for (const signal of [store.design, store.proof, store.report]) (signal as { watch(listener: () => void): void }).watch(() => this.follow());
    this.show("none");
  }

  private get state(): State {
    return this.element.dataset["state"] as State;
  }

  private async search(): Promise<void> {
    this.stopping.abort();
    this.stopping = new AbortController();
    const { signal } = this.stopping;
    const { design } = this.store;
    this.base = design.value;
    this.found = [];
    this.table.replaceChildren();
    this.say([]);
    const held = document.activeElement === this.go;
    this.show("running");
    this.work.begin("analysing the file");
    // The button that had the focus is gone: what came in its place has it.
    if (held) this.work.element.querySelector("button")?.focus();
    try {
      const found = await makeItCarry(
        design.value,
        signal,
        (share, what) => void (signal.aborted || this.work.show(share, this.store.labels.said(what))),
        (tried) => void (signal.aborted || this.say(tried)),
      );
      if (!signal.aborted) this.tell(found);
    } catch (error) {
      if (signal.aborted) return;
      const { message, remedy } = faultOf(error);
      const words = [sentence(message), remedy && !message.includes(remedy) ? sentence(remedy) : ""].join(" ").trim();
      this.show("failed", this.store.labels.said(words));
    }
  }

  private stop(): void {
    this.stopping.abort();
    this.show("stopped", "Stopped before the end: nothing was found so far.");
  }

  private tell({ carries, found, tried, near, ended }: CarrySearch): void {
    const { labels } = this.store;
    const held = this.work.element.contains(document.activeElement);
    const head = h("thead", {}, h("tr", {}, ...FIGURES.map(([name, title]) => h("th", { scope: "col", title }, name))));
    if (found.length) this.table.replaceChildren(head, ...found.map((each, number) => this.rows(each, number)));
    const none = carries ? "It carries as it is: nothing is to be changed." : `No design was found that carries. ${near ? `Nearest came ${labels.said(near)}.` : ""}`;
    const words = found.length ? "All of them were made and analysed as this design is. The lightest is first." : none;
    this.say(tried);
    this.found = found;
    this.show("found", ended && !found.length ? `${words} More would have taken too long.` : words);
    if (held) this.table.querySelector("button")?.focus();
  }

  /** A design: what is changed over its numbers. */
  private rows(each: Carrying, number: number): HTMLElement {
    const { unit } = this.store.design.value.shell;
    const words = capital(this.store.labels.said(each.words));
    const take = button({ label: `Open: ${words}`, text: "Open", testid: `carry-open-${number}`, act: () => this.take(each) });
    const pack = each.pack ? `${each.pack.map(threeDigits).join(" × ")} ${unit}` : "–";
    const used = each.used === null ? "–" : `${threeDigits(100 * each.used)} %`;
    const cells = [each.mass === null ? "–" : threeDigits(each.mass), String(each.parts), pack, used];
    return h(
      "tbody",
      { "data-testid": `carries-${number}` },
      h("tr", {}, h("th", { scope: "rowgroup", colspan: 3 }, words), h("td", {}, take)),
      h("tr", {}, ...cells.map((text) => h("td", {}, text))),
      each.governs ? h("tr", {}, h("td", { class: "governs", colspan: 4 }, `${capital(each.governs)} governs.`)) : null,
      each.left ? h("tr", {}, h("td", { class: "governs", colspan: 4 }, `${capital(each.left)}.`)) : null,
    );
  }

  private take(each: Carrying): void {
    this.store.change(changed(this.base!, each.changes), this.store.labels.said(each.words));
  }

  /** What was found belongs to the design that it began from, and to those that it opens. */
  private follow(): void {
    const { design, proof, report } = this.store;
    const now = JSON.stringify(design.value);
    const known = this.base !== null && now === JSON.stringify(this.base);
    const open = this.found.findIndex((each) => now === JSON.stringify(changed(this.base!, each.changes)));
    if (this.state === "running" && !known) {
      this.stopping.abort();
      return this.show("none");
    }
    for (const [number, body] of [...this.table.tBodies].entries()) setAttribute(body, "aria-current", number === open ? "true" : null);
    this.results.hidden = this.state === "none" || !(known || open >= 0);
    // Its loads are looked at before it is tried what would help.
    const analysed = isFound(proof.value) && Boolean(report.value?.structure);
    const ended = analysed || proof.value.state === "stopped";
    const carries = analysed && report.value?.structure?.carries === true;
    const shown = this.state === "running" || (this.state === "found" && known);
    this.go.hidden = shown || !design.value["structure"] || !ended || carries;
  }

  private show(state: State, words = ""): void {
    this.element.dataset["state"] = state;
    if (state !== "running") this.work.hide();
    this.note.textContent = words;
    this.note.hidden = !words;
    this.note.classList.toggle("error", state === "failed");
    this.follow();
  }

  private say(tried: string[]): void {
    this.count.textContent = tried.length === 1 ? "One change was tried" : `${tried.length} changes were tried`;
    this.list.replaceChildren(...tried.map((each) => h("li", {}, capital(this.store.labels.said(each)))));
    this.tried.hidden = !tried.length;
  }
}
