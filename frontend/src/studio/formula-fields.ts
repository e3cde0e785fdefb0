// A curve by its formula: y(x), or x(t) and y(t), and a range.

import { numberBox, segmented, setNumber } from "./controls.ts";
import { h } from "./dom.ts";
import { short } from "./numbers.ts";
import type { CurveName, CurveTable } from "./types.ts";

/** Typing rests this long before the formula is read, in milliseconds. */
const TYPING = 250;

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
  private timer = 0;
  private table: CurveTable = {};

  constructor(
    private readonly name: CurveName,
    private readonly changed: (table: CurveTable, gesture: string) => void,
  ) {
    this.x = this.text("x", "x of t");
    this.y = this.text("y", "y");
    const range = (end: "low" | "high", label: string): HTMLInputElement =>
      numberBox(
        { step: "any", "aria-label": `${name}, ${label}`, "data-testid": `range-${name}-${end}` },
        () => this.publish(`range-${name}`),
      );
    this.low = range("low", "range begins at");
    this.high = range("high", "range ends at");
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
        h("span", { class: "quiet" }, "from"),
        this.low,
        h("span", { class: "quiet" }, "to"),
        this.high,
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
    setNumber(this.low, short(range?.[0] ?? 0, 12));
    setNumber(this.high, short(range?.[1] ?? 1, 12));
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

  private text(axis: "x" | "y", label: string): HTMLInputElement {
    const input = h("input", {
      type: "text",
      class: "formula",
      spellcheck: "false",
      autocomplete: "off",
      autocapitalize: "off",
      "aria-label": `${this.name}, formula of ${label}`,
      "data-testid": axis === "y" ? `formula-${this.name}` : `formula-${this.name}-x`,
    });
    input.addEventListener("input", () => {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.publish(`formula-${this.name}`), TYPING);
    });
    input.addEventListener("change", () => {
      clearTimeout(this.timer);
      this.publish(`formula-${this.name}`);
    });
    return input;
  }

  private publish(gesture: string): void {
    const low = this.low.valueAsNumber;
    const high = this.high.valueAsNumber;
    if (!Number.isFinite(low) || !Number.isFinite(high)) return;
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

function put(input: HTMLInputElement, text: string): void {
  if (input.value !== text && document.activeElement !== input) input.value = text;
}
