// A curve by its formula: y(x), or x(t) and y(t), and a range.

import { segmented } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { TypedLines, boundAfter, put, shown } from "../parts/typed.ts";
import type { CurveName, CurveTable } from "../state/types.ts";

type Form = "single" | "pair";

export class FormulaFields {
  readonly element: HTMLElement;
  private readonly x: HTMLInputElement;
  private readonly y: HTMLInputElement;
  private readonly low: HTMLInputElement;
  private readonly high: HTMLInputElement;
  private readonly xLine: HTMLElement;
  private readonly yName = h("span", { class: "formula-name" }, "y(x) =");
  private readonly form = segmented<Form>(
    "Kind of formula",
    [
      { value: "single", text: "y(x)", title: "height over x" },
      { value: "pair", text: "x(t), y(t)", title: "both coordinates over a parameter" },
    ],
    (form) => this.setForm(form),
  );
  private readonly lines = new TypedLines((gesture) => this.publish(gesture));
  private table: CurveTable = {};

  constructor(
    private readonly name: CurveName | "inner",
    private readonly changed: (table: CurveTable, gesture: string) => void,
  ) {
    this.x = this.text("formula", `formula-${name}-x`, "formula of x of t");
    this.y = this.text("formula", `formula-${name}`, "formula of y");
    this.low = this.text("range", `range-${name}-low`, "range begins at");
    this.high = this.text("range", `range-${name}-high`, "range ends at");
    this.xLine = h("div", { class: "formula-line" }, h("span", { class: "formula-name" }, "x(t) ="), this.x);
    this.element = h(
      "div",
      { class: "formula-fields" },
      this.xLine,
      h("div", { class: "formula-line" }, this.yName, this.y),
      h(
        "div",
        { class: "formula-line" },
        this.form.element,
        h("span", { class: "formula-range" }, h("span", { class: "quiet" }, "from"), this.low, h("span", { class: "quiet" }, "to"), this.high),
      ),
    );
  }

  show(table: CurveTable): void {
    this.table = table;
    const { formula, range } = table;
    if (formula === undefined) return;
    const pair = Array.isArray(formula);
    this.dress(pair);
    if (pair) put(this.x, formula[0]);
    put(this.y, pair ? formula[1] : formula);
    put(this.low, shown(range?.[0] ?? 0));
    put(this.high, shown(range?.[1] ?? 1));
  }

  private dress(pair: boolean): void {
    this.form.set(pair ? "pair" : "single");
    this.xLine.hidden = !pair;
    this.yName.textContent = pair ? "y(t) =" : "y(x) =";
  }

  private setForm(form: Form): void {
    const variable = (text: string, from: string, to: string): string =>
      text.replace(new RegExp(`\\b${from}\\b`, "g"), to);
    if (form === "pair") {
      this.x.value = "t";
      this.y.value = variable(this.y.value, "x", "t");
    } else {
      this.y.value = variable(this.y.value, "t", "x");
    }
    this.dress(form === "pair");
    this.publish("");
  }

  private text(key: "formula" | "range", testid: string, label: string): HTMLInputElement {
    const gesture = `${key}-${this.name}`;
    const kind = key === "range" ? "formula number" : "formula";
    return this.lines.line(kind, testid, `${this.name}, ${label}`, gesture);
  }

  private publish(gesture: string): void {
    const [from, to] = this.table.range ?? [0, 1];
    const low = boundAfter(this.low.value, from);
    const high = boundAfter(this.high.value, to);
    if (low === "" || high === "") return;
    const formula: CurveTable["formula"] = this.xLine.hidden
      ? this.y.value
      : [this.x.value, this.y.value];
    const { table } = this;
    const same =
      JSON.stringify([formula, [low, high]]) === JSON.stringify([table.formula, table.range]);
    if (same) return;
    this.changed({ ...table, formula, range: [low, high] }, gesture);
  }
}
