// What is to be small in a search, and what figures may be.

import type { SearchFigure } from "../../shared/api-types.ts";
import { capital } from "../../shared/words.ts";
import { numberBox, setNumber } from "../parts/controls.ts";
import { h, keepFocus } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Design, Report, SearchTable } from "../state/types.ts";

export interface Offered {
  name: string;
  /** In words, with its unit. */
  label: string;
  /** Its limit where the table sets none. */
  most: number | null;
}

/** The figures that a design can have, and those that its table asks for. */
export function offeredFigures(figures: SearchFigure[], design: Design, report: Report | null, { minimise, subject_to: limits = {} }: SearchTable): Offered[] {
  const weighed = report !== null && (report.quantities.mass_kg ?? report.quantities.built?.mass_kg ?? null) !== null;
  const asked = [...minimise, ...Object.keys(limits)];
  const has = ({ name, of_structure: ofStructure }: SearchFigure): boolean =>
    asked.includes(name) || (ofStructure ? design.structure !== undefined : name !== "mass" || weighed);
  const named = figures.filter(has).map(({ name, words, unit, most }) => {
    const said = unit.replaceAll("{unit}", design.shell.unit);
    return { name, label: capital(words) + (said && ` (${said})`), most };
  });
  const others = [...new Set(asked)].filter((name) => !figures.some((each) => each.name === name));
  return [...named, ...others.map((name) => ({ name, label: capital(name.replaceAll("_", " ").replace(".", " of ")), most: null }))];
}

interface Row {
  small: HTMLInputElement;
  most: HTMLInputElement;
  least: HTMLElement;
}
type Limits = Pick<SearchTable, "minimise" | "subject_to">;

export class FigureList {
  readonly element: HTMLElement;
  private readonly list = h("div", { class: "search-figures" });
  private rows = new Map<string, Row>();
  private built = "";
  private table: Limits = { minimise: [] };

  constructor(private readonly changed: (table: Limits, gesture: string) => void) {
    this.element = h("div", { class: "search-group" }, h("div", { class: "search-figures-head" }, h("h3", {}, "Minimise"), h("span", { class: "unit" }, "at most")), this.list);
  }

  show(table: Limits, offered: Offered[]): void {
    this.table = table;
    const shape = JSON.stringify(offered);
    if (shape !== this.built) keepFocus(() => this.build(offered));
    this.built = shape;
    for (const [name, { small, most, least }] of this.rows) {
      const limit = table.subject_to?.[name];
      small.checked = table.minimise.includes(name);
      setNumber(most, limit?.most === undefined ? "" : short(limit.most));
      least.textContent = limit?.least === undefined ? "" : `at least ${short(limit.least)}`;
    }
  }

  private build(offered: Offered[]): void {
    this.rows = new Map();
    this.list.replaceChildren(...offered.map((each) => this.row(each)));
  }

  private row({ name, label, most: usual }: Offered): HTMLElement {
    const small = h("input", { type: "checkbox", "data-testid": `search-small-${name}`, onchange: () => this.minimise(name, small.checked) });
    const most = numberBox({ step: "any", placeholder: usual === null ? "any" : short(usual), "aria-label": `${label}, at most`, "data-testid": `search-most-${name}` }, (value) => this.limit(name, value));
    most.addEventListener("input", () => {
      if (most.value === "" && !most.validity.badInput) this.limit(name, undefined);
    });
    const least = h("span", { class: "unit" });
    this.rows.set(name, { small, most, least });
    return h("div", { class: "search-figure-row" }, h("label", { class: "check" }, small, label), least, most);
  }

  private minimise(name: string, small: boolean): void {
    const others = this.table.minimise.filter((each) => each !== name);
    // In the order of the list, but what is not in it first.
    const order = [...this.rows.keys()];
    const minimise = small ? [...others, name].sort((a, b) => order.indexOf(a) - order.indexOf(b)) : others;
    this.changed({ ...this.table, minimise }, "");
  }

  private limit(name: string, most: number | undefined): void {
    const { [name]: before, ...others } = this.table.subject_to ?? {};
    const { most: _, ...rest } = before ?? {};
    const limit = most === undefined ? rest : { ...rest, most };
    const limits = Object.keys(limit).length ? { ...others, [name]: limit } : others;
    const { subject_to: __, ...table } = this.table;
    this.changed(Object.keys(limits).length ? { ...table, subject_to: limits } : table, `type-most-${name}`);
    this.rows.get(name)!.most.classList.remove("unfinished");
  }
}
