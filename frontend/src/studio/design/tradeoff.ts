// What fewer panels cost: the sizes that were tried as a plot, the best of them as points to choose.

import type { Tradeoff, Trial } from "../../shared/api-types.ts";
import { length } from "../../shared/quantities.ts";
import { sentence } from "../../shared/words.ts";
import { findTradeoff } from "../server/api.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { faultOf } from "../state/faults.ts";
import { keyOf, nearestTo, toleranceOf, withSizes, withTolerance } from "./front.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import { TradeoffPlot } from "./tradeoff-plot.ts";
import { WorkBar } from "../parts/work-bar.ts";

type State = "none" | "running" | "found" | "refused";

export class TradeoffCard {
  readonly element: HTMLElement;
  /** What was found, for the present design. */
  found: Tradeoff | null = null;
  private key = "";
  private panels = 1;
  private stopping = new AbortController();
  private chosen: Trial | null = null;
  private then: ((trial: Trial) => void) | null = null;

  private readonly work = new WorkBar("Search for sizes", () => this.stop(), "tradeoff-work");
  private readonly plot = new TradeoffPlot((trial) => this.choose(trial), (trial) => this.point(trial));
  private readonly note = h("p", { class: "note", role: "status" });
  private readonly facts = h("div", { class: "tradeoff-facts", "data-testid": "tradeoff-facts" });
  private readonly takeTolerance = button({
    label: "Take this distance as the tolerance",
    text: "Take",
    testid: "take-tolerance",
    act: () => this.take("tolerance"),
  });
  private readonly takeSizes = button({
    label: "Take these rows and columns",
    text: "Take",
    class: "button primary",
    testid: "take-sizes",
    act: () => this.take("sizes"),
  });
  private readonly actions = h("div", { class: "actions" }, this.takeSizes, this.takeTolerance);
  private readonly seek = button({
    label: "Find what fewer panels cost",
    text: "Find what fewer panels cost",
    testid: "find-tradeoff",
    act: () => this.find(),
  });

  constructor(private readonly store: Store) {
    this.element = h(
      "div",
      { class: "tradeoff", "data-testid": "tradeoff", hidden: true },
      h("h3", {}, "Panels against distance"),
      this.work.element,
      this.plot.element,
      this.facts,
      this.actions,
      this.note,
      this.seek,
    );
    store.design.watch(() => this.followDesign());
    store.report.watch(() => this.followReport());
    this.show("none");
  }

  /** Try sizes, unless that was done; `then` is told the best one near the present shell. */
  find(then: ((trial: Trial) => void) | null = null): void {
    this.then = then;
    const key = keyOf(this.store.design.value);
    if (this.found && key === this.key) return this.tell();
    void this.search(key);
  }

  stop(): void {
    this.stopping.abort();
    this.then = null;
    this.show("none");
    const { tolerance, shell } = this.store.design.value;
    const { surface } = tolerance ?? {};
    this.note.textContent = surface === undefined ? "Stopped." : `Stopped: the tolerance stays ${short(surface, 3)} ${shell.unit}.`;
  }

  private async search(key: string): Promise<void> {
    this.stopping.abort();
    this.stopping = new AbortController();
    const { signal } = this.stopping;
    const { design, report } = this.store;
    const shown = report.value?.family === design.value.shell.family ? report.value : null;
    const size = shown && { rows: shown.rows, columns: shown.columns };
    if (size) this.panels = (size.rows + 1) * (size.columns - 1);
    this.key = key;
    this.found = null;
    this.show("running");
    this.work.begin("trying rows and columns");
    try {
      const found = await findTradeoff(design.value, size, signal, (share, what) => {
        if (!signal.aborted) this.work.show(share, what);
      });
      if (signal.aborted) return;
      this.found = found;
      this.show("found");
      this.draw(found);
      this.tell();
    } catch (error) {
      if (signal.aborted) return;
      const { message, remedy } = faultOf(error);
      this.show("refused");
      this.note.textContent = [sentence(message), remedy && !message.includes(remedy) ? sentence(remedy) : ""].join(" ").trim();
      this.note.classList.add("error");
    }
  }

  private tell(): void {
    const best = this.found!.best;
    const trial = best[nearestTo(this.panels, best)]!;
    this.plot.select(trial);
    this.choose(trial);
    this.then?.(trial);
    this.then = null;
  }

  private draw(found: Tradeoff): void {
    const { unit } = this.store.design.value.shell;
    this.plot.draw(found, unit, this.store.design.value.tolerance?.surface);
    const refused = found.refused ? `, ${found.refused} have no shell` : "";
    const scaled = this.store.design.value.target?.fit ? " Of the target as in the file, before it is scaled for its sizes." : "";
    this.note.textContent =
      `${found.tried.length + found.refused} sizes tried${refused}. Faint: another has fewer panels and is nearer. ` +
      `Dashed: the tolerance. Ring: the shell on the screen.${scaled}`;
  }

  private choose(trial: Trial): void {
    this.chosen = trial;
    const { unit } = this.store.design.value.shell;
    const facts: [string, string][] = [
      ["Rows × columns", `${trial.rows} × ${trial.columns}`],
      ["Panels without flaps", String(trial.panels)],
      ["Largest distance", length(trial.error, unit)],
      ["Edges", `${length(trial.shortest, unit)} to ${length(trial.longest, unit)}`],
    ];
    this.facts.replaceChildren(h("dl", {}, ...facts.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)])));
    const tolerance = length(toleranceOf(trial), unit);
    this.name(this.takeSizes, `Take ${trial.rows} × ${trial.columns}`, `Take ${trial.rows} rows and ${trial.columns} columns`);
    this.name(this.takeTolerance, `Allow ${tolerance}`, `Take ${tolerance} as the tolerance`);
  }

  private point(trial: Trial | null): void {
    const { design, pointed } = this.store;
    pointed.set(trial && this.found ? withSizes(design.value, trial, this.found.settled) : null);
  }

  private name(control: HTMLButtonElement, text: string, label: string): void {
    control.textContent = text;
    control.title = label;
    control.setAttribute("aria-label", label);
  }

  private take(what: "sizes" | "tolerance"): void {
    const { design } = this.store;
    const trial = this.chosen;
    if (!trial || !this.found) return;
    if (what === "sizes") {
      this.store.change(withSizes(design.value, trial, this.found.settled), `${trial.rows} × ${trial.columns}`);
    } else {
      const tolerance = { ...design.value.tolerance, surface: toleranceOf(trial) };
      this.store.change(withTolerance(design.value, tolerance), "tolerance");
    }
  }

  private followDesign(): void {
    const { tolerance } = this.store.design.value;
    this.element.hidden = !tolerance;
    this.plot.limit(tolerance?.surface);
    const left = this.state === "running" && !tolerance;
    if (this.state === "none" || (keyOf(this.store.design.value) === this.key && !left)) return;
    this.stopping.abort();
    this.found = null;
    this.then = null;
    this.show("none");
  }

  private followReport(): void {
    const { report, freshness } = this.store;
    if (!report.value || freshness.value === "outdated") return;
    const { rows, columns, deviation } = report.value;
    this.plot.mark(rows, columns, deviation?.surface?.max);
  }

  private get state(): State {
    return this.element.dataset["state"] as State;
  }

  private show(state: State): void {
    this.element.dataset["state"] = state;
    if (state !== "running") this.work.hide();
    const found = state === "found";
    for (const part of [this.plot.element, this.facts, this.actions]) part.toggleAttribute("hidden", !found);
    this.seek.hidden = found || state === "running";
    this.note.textContent = "";
    this.note.classList.remove("error");
  }
}
