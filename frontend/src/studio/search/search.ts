// A search on the open design: the table [search], what is found, and a choice out of it.

import { capital } from "../../shared/words.ts";
import { button, numberBox, setNumber } from "../parts/controls.ts";
import { h, setAttribute, uniqueId } from "../parts/dom.ts";
import { pretty } from "../parts/numbers.ts";
import { WorkBar } from "../parts/work-bar.ts";
import { changed } from "../state/changed.ts";
import type { Store } from "../state/store.ts";
import type { Parameter, SearchTable } from "../state/types.ts";
import { FigureList, offeredFigures } from "./figures.ts";
import { type Found, type Member, wordsOfCount, wordsOfRest } from "./found.ts";
import { candidates, suggestion } from "./numbers.ts";
import { type Axis, SearchPlot } from "./plot.ts";
import { type Run, Search } from "./run.ts";
import { countOf, hasValues, keyOf, lacking, searchOf } from "./table.ts";
import { VariableList } from "./variables.ts";

export class SearchCard {
  readonly element: HTMLElement;
  private readonly search = new Search();
  /** What is edited and is no whole table yet. */
  private draft: SearchTable | null = null;
  /** What the last search was about. */
  private about = { key: "", variables: [] as string[] };

  private readonly details = h("details", { "data-testid": "search", ontoggle: () => this.show() });
  private readonly variables = new VariableList((variables, gesture) => this.edit({ ...this.table, variables }, gesture), (key) => this.store.labels.place(key));
  private readonly figures = new FigureList((limits, gesture) => {
    const { subject_to: _, ...table } = this.table;
    this.edit({ ...table, ...limits }, gesture);
  });
  private readonly evaluations = numberBox(
    { min: 1, step: 1, id: "search-evaluations", "data-testid": "search-evaluations" },
    (value) => this.edit({ ...this.table, evaluations: Math.max(1, Math.round(value)) }, "type-evaluations"),
  );
  private readonly count = h("p", { class: "note", "data-testid": "search-count" });
  private readonly go = button({ label: "Search", text: "Search", class: "button primary", testid: "search-go", act: () => this.begin() });
  private readonly work = new WorkBar("Search", () => this.search.stop(), "search-work");
  private readonly note = h("p", { class: "note", role: "status", "data-testid": "search-note" });
  private readonly plot = new SearchPlot({
    looked: () => this.showMember(),
    picked: (member) => this.pick(member),
    pointed: (member) => this.store.pointed.set(member && changed(this.store.design.value, member.design.values)),
  });
  private readonly axes = [this.axis("Across"), this.axis("Up")] as const;
  private readonly facts = h("div", { class: "search-facts", "data-testid": "search-facts" });
  private readonly result: HTMLElement;

  constructor(private readonly store: Store) {
    const title = uniqueId("search-title");
    const { install } = store.info.search;
    this.result = h("div", { class: "search-result", hidden: true }, h("div", { class: "search-axes" }, ...this.axes.map(({ element }) => element)), this.plot.element, this.facts);
    this.details.append(
      h("summary", {}, h("h2", { id: title }, "Search")),
      ...(install
        ? [h("p", { class: "note" }, "A search for the best of many designs needs pymoo. Install it, and start the studio again: ", h("code", {}, install))]
        : [
            h("p", { class: "note" }, "The program changes numbers of this design, and keeps the designs that no other beats."),
            this.variables.element,
            this.figures.element,
            h("div", { class: "parameter-head" }, h("label", { for: "search-evaluations" }, "Designs tried, at most"), this.evaluations),
            this.count,
            h("div", { class: "actions" }, this.go),
            this.work.element,
            this.note,
            this.result,
          ]),
    );
    this.element = h("section", { class: "search folding", "aria-labelledby": title }, this.details);
    if (install) return;
    for (const signal of [store.ranges, store.report]) (signal as { watch(listener: () => void): void }).watch(() => this.show());
    store.design.watch((design, before) => {
      if (design.shell !== before.shell) this.search.forget();
      if (design.shell !== before.shell || design.search !== before.search) this.draft = null;
      this.show();
      this.showMember();
    });
    this.search.run.watch((run, before) => this.follow(run, before));
  }

  private get table(): SearchTable {
    const { design } = this.store;
    return this.draft ?? searchOf(design.value) ?? suggestion(this.candidates());
  }

  private get running(): boolean {
    return this.search.run.value.state === "running";
  }

  private get parameters(): Parameter[] {
    return this.store.info.families[this.store.design.value.shell.family]?.parameters ?? [];
  }

  private candidates(): ReturnType<typeof candidates> {
    const { design, ranges, report, labels } = this.store;
    const shown = report.value?.family === design.value.shell.family ? report.value : null;
    return candidates(design.value, this.parameters, ranges.value, shown, labels);
  }

  /** A table that is not whole is in no file: it waits here until it is. */
  private edit(table: SearchTable, gesture: string): void {
    const { design } = this.store;
    const whole = !lacking(table);
    if (whole || design.value.search) this.store.set({ search: whole ? table : null }, "search", gesture);
    this.draft = whole ? null : table;
    this.show();
  }

  private begin(): void {
    const { design, name } = this.store;
    const { table } = this;
    if (lacking(table) || this.running) return;
    if (!design.value.search) this.store.set({ search: table }, "search");
    const variables = Object.keys(table.variables);
    this.about = { key: keyOf(design.value, variables), variables };
    void this.search.begin(changed(design.value, { search: table }), name.value);
  }

  /** What is asked for. */
  private show(): void {
    if (!this.details.open) return;
    const { table, store } = this;
    const { design, report, info } = store;
    this.variables.show(table.variables, this.candidates());
    this.figures.show(table, offeredFigures(info.search.figures, design.value, report.value, table));
    const most = table.evaluations ?? info.search.evaluations;
    setNumber(this.evaluations, String(most));
    const missing = lacking(table);
    const whole = new Set(this.parameters.filter(({ kind }) => kind === "integer").map(({ key }) => `pattern.${key}`));
    const count = countOf(table.variables, (key) => whole.has(key));
    const all = count <= most ? `There are ${count} such designs: all are tried.` : "";
    this.count.textContent = missing || all || `They are bred from the best so far${Number.isFinite(count) ? `, out of ${count}` : ""}.`;
    // Not disabled: it would lose the focus.
    setAttribute(this.go, "aria-disabled", missing !== "" || this.running ? "true" : "false");
  }

  private follow(run: Run, before: Run): void {
    const { state, found, message, seconds } = run;
    this.details.dataset["state"] = state;
    if (state !== before.state) this.show();
    if (state !== "running") this.work.hide();
    else if (!found) this.work.begin("making the first design");
    else this.work.show(found.made / found.total, `${found.made} of ${found.total} designs${rest(found, seconds)}`);
    this.note.classList.toggle("error", state === "failed");
    const words = found ? this.store.labels.said(wordsOfCount(found, state === "done")) : "";
    this.note.textContent = state === "running" ? "" : [message, state === "stopped" ? `Stopped. ${words}` : words].filter(Boolean).join(" ");
    if (!found) this.plot.forget();
    const first = this.result.hidden;
    this.result.hidden = !found?.front.length;
    if (!found?.front.length) return;
    this.draw(found);
    // Whoever began the search watches the front grow.
    if (first && this.element.contains(document.activeElement)) this.plot.element.scrollIntoView({ block: "nearest" });
  }

  private draw(found: Found): void {
    const names = found.objectives.map(({ name }) => name);
    for (const [k, { element, select }] of this.axes.entries()) {
      element.hidden = names.length < 3;
      if ([...select.options].map(({ value }) => value).join() === names.join()) continue;
      select.replaceChildren(...found.objectives.map(({ name, label }) => h("option", { value: name }, capital(label))));
      select.value = names[k] ?? names[0]!;
    }
    this.plot.draw(found, this.shownAxes(names), (member) => `${this.wordsOfValues(member)}: ${this.wordsOfFigures(found, member)}`);
    this.showMember();
  }

  private shownAxes(names: string[]): [Axis, Axis] {
    return names.length < 2 ? [null, names[0]!] : [this.axes[0].select.value, this.axes[1].select.value];
  }

  private axis(label: string): { element: HTMLElement; select: HTMLSelectElement } {
    const redraw = (): void => {
      const { found } = this.search.run.value;
      if (found?.front.length) this.draw(found);
    };
    const select = h("select", { "data-testid": `search-axis-${label.toLowerCase()}`, onchange: redraw });
    return { element: h("label", { class: "search-axis" }, label, select), select };
  }

  /** What the point that is looked at is, and what it costs. */
  private showMember(): void {
    const { found } = this.search.run.value;
    if (!found?.front.length) return;
    const { design } = this.store;
    const same = keyOf(design.value, this.about.variables) === this.about.key;
    const picked = same ? (found.front.find((each) => hasValues(design.value, each.design.values)) ?? null) : null;
    this.result.classList.toggle("outdated", !same);
    this.plot.mark(picked);
    const member = this.plot.member;
    if (!member) return;
    const figures = Object.entries(member.design.figures).map(([name, value]) => [this.labelOf(found, name), pretty(value, 4)] as const);
    const values = Object.entries(member.design.values).map(([key, value]) => [this.store.labels.place(key), written(value)] as const);
    const facts = [...values, ...figures].flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]);
    const knee = found.front[found.knee] === member;
    const words = knee ? "This is the knee: to either side a little less of one costs much of another." : `Against the knee: ${member.costs}.`;
    const state = picked === member ? "The open design is this one. " : "";
    const stale = same ? "" : "The design has changed in other ways since: search again to see what it gives now. ";
    this.facts.replaceChildren(h("p", { class: "note" }, stale + state + (found.front.length > 1 ? words : "No other is as good.")), h("dl", {}, ...facts));
  }

  private pick(member: Member): void {
    this.store.set(member.design.values, this.wordsOfValues(member));
    this.showMember();
  }

  private wordsOfValues({ design }: Member): string {
    return Object.entries(design.values).map(([key, value]) => `${this.store.labels.place(key)} ${written(value)}`).join(", ");
  }

  private wordsOfFigures(found: Found, { design }: Member): string {
    return found.objectives.map(({ name, label }) => `${label} ${pretty(design.figures[name]!, 3)}`).join(", ");
  }

  private labelOf(found: Found, name: string): string {
    return capital(found.objectives.find((each) => each.name === name)?.label ?? name.replaceAll("_", " "));
  }
}

function rest(found: Found, seconds: number): string {
  const words = wordsOfRest(found, seconds);
  return words && `, ${words}`;
}

function written(value: unknown): string {
  return typeof value === "number" ? pretty(value, 4) : String(value);
}
