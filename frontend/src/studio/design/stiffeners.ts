// What stiffens the shell once it stands: the table [stiffeners] of the design file.

import type { KeyWords } from "../../shared/api-types.ts";
import { numberBox, type Segmented, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import { listed } from "./row-list.ts";
import { NONE, ROWS, SHARE, stepOf, stiffened } from "./stiffener-table.ts";

export class StiffenerControls {
  readonly element: HTMLElement;
  private readonly kind: Segmented<string>;
  private readonly rows: Segmented<string>;
  private readonly step: HTMLInputElement;
  private readonly share: HTMLInputElement;
  private readonly note = h("p", { class: "note" });
  private readonly rest: HTMLElement;

  constructor(private readonly store: Store) {
    const { label, keys } = store.info.tables["stiffeners"]!;
    const { kind, rows, columns, share } = keys;
    this.kind = this.segments("kind", { ...kind!, choices: { [NONE]: "None", ...kind!.choices } });
    this.rows = this.segments("rows", rows!);
    this.step = this.box("columns", { min: 1, step: 1 });
    this.share = this.box("share", { min: 0, max: 1, step: "any" });
    this.rest = h("div", { class: "parameter-list" }, named(rows!, this.rows), row("columns", columns!, this.step), row("share", share!, this.share), this.note);
    this.element = h(
      "section",
      { class: "stiffeners", "aria-labelledby": "stiffeners-title" },
      h("h2", { id: "stiffeners-title" }, label),
      named(kind!, this.kind),
      this.rest,
    );
    store.design.bind(({ stiffeners }) => this.show(stiffeners));
  }

  private set(key: string, value: unknown, gesture = ""): void {
    const { stiffeners } = this.store.design.value;
    this.store.set({ stiffeners: stiffened(stiffeners, key, value) }, "stiffeners", gesture);
  }

  private segments(key: string, { label, choices }: KeyWords): Segmented<string> {
    const values = Object.entries(choices).map(([value, text]) => ({ value, text, testid: `stiffeners-${key}-${value}` }));
    return segmented<string>(label, values, (value) => this.set(key, value));
  }

  private box(key: string, limits: Record<string, string | number>): HTMLInputElement {
    return numberBox({ ...limits, id: `stiffeners-${key}`, "data-testid": `stiffeners-${key}` }, (value) => this.set(key, value, `type-stiffeners-${key}`));
  }

  private show(table: Record<string, unknown> | undefined): void {
    const { kind = NONE, rows = ROWS, columns, share = SHARE } = table ?? {};
    this.rest.hidden = !table;
    this.kind.set(String(kind));
    this.rows.set(String(rows));
    const step = stepOf(columns);
    setNumber(this.step, step === null ? "" : short(step));
    this.step.placeholder = step === null ? "listed" : "";
    setNumber(this.share, short(Number(share)));
    const words = Object.entries({ Rows: rows, Columns: columns }).flatMap(([name, each]) => (Array.isArray(each) ? [`${name} listed in the file: ${listed(each)}.`] : []));
    this.note.textContent = words.join(" ");
    this.note.hidden = !words.length;
  }
}

function row(key: string, { label, help }: KeyWords, control: HTMLElement): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("label", { for: `stiffeners-${key}` }, label), control);
}

function named({ label, help }: KeyWords, { element }: Segmented<string>): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("span", {}, label), element);
}
