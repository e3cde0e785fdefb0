// A surface by its formulas: z(x, y), or x, y and z of u and v, and the ranges of both variables.

import { h } from "../parts/dom.ts";
import { TypedLines, boundAfter, put, shown } from "../parts/typed.ts";
import type { Bound, Ends, SurfaceTable } from "../state/types.ts";

const FORMS = {
  height: { formulas: ["z(x, y)"], variables: ["x", "y"] },
  map: { formulas: ["x(u, v)", "y(u, v)", "z(u, v)"], variables: ["u", "v"] },
} as const;

export class SurfaceFields {
  readonly element = h("div", { class: "formula-fields" });
  private readonly height: Form;
  private readonly map: Form;

  constructor(changed: (table: SurfaceTable, gesture: string) => void) {
    this.height = new Form("height", changed);
    this.map = new Form("map", changed);
    this.element.append(this.height.element, this.map.element);
  }

  show(table: SurfaceTable): void {
    const { formula } = table;
    this.element.hidden = formula === undefined;
    this.height.element.hidden = Array.isArray(formula);
    this.map.element.hidden = !Array.isArray(formula);
    if (formula !== undefined) (Array.isArray(formula) ? this.map : this.height).show(table);
  }
}

class Form {
  readonly element: HTMLElement;
  private readonly formulas: HTMLInputElement[];
  private readonly ends: HTMLInputElement[];
  private readonly ranges: HTMLElement;
  private table: SurfaceTable = {};
  private readonly lines = new TypedLines((gesture) => this.publish(gesture));

  constructor(
    private readonly form: keyof typeof FORMS,
    private readonly changed: (table: SurfaceTable, gesture: string) => void,
  ) {
    const { formulas, variables } = FORMS[form];
    this.formulas = formulas.map((name, k) => this.line(`formula-surface-${form}-${k}`, `surface, ${name}`, "formula"));
    this.ends = variables.flatMap((name) =>
      ["begins", "ends"].map((end) => this.line(`range-surface-${name}-${end}`, `surface, ${name} ${end} at`, "formula number")),
    );
    this.ranges = h(
      "div",
      { class: "surface-ranges" },
      ...variables.map((name, k) =>
        h(
          "span",
          { class: "formula-range" },
          h("span", { class: "formula-name" }, name),
          this.ends[2 * k]!,
          h("span", { class: "quiet" }, "to"),
          this.ends[2 * k + 1]!,
        ),
      ),
    );
    this.element = h(
      "div",
      { class: "formula-fields" },
      ...formulas.map((name, k) => h("div", { class: "formula-line" }, h("span", { class: "formula-name" }, `${name} =`), this.formulas[k]!)),
      this.ranges,
    );
  }

  show(table: SurfaceTable): void {
    this.table = table;
    const { variables } = FORMS[this.form];
    const formulas = [table.formula ?? ""].flat();
    this.formulas.forEach((input, k) => put(input, formulas[k] ?? ""));
    // A rectangle that is turned has its own sizes in place of ranges.
    this.ranges.hidden = table.size !== undefined;
    variables.forEach((name, k) => {
      const ends = table[name] ?? [0, 1];
      put(this.ends[2 * k]!, shown(ends[0]));
      put(this.ends[2 * k + 1]!, shown(ends[1]));
    });
  }

  private line(testid: string, label: string, kind: string): HTMLInputElement {
    return this.lines.line(kind, testid, label, testid);
  }

  private publish(gesture: string): void {
    const before = FORMS[this.form].variables.flatMap((name): Bound[] => this.table[name] ?? [0, 1]);
    const ends = this.ends.map((input, k) => boundAfter(input.value, before[k]!));
    if (ends.includes("")) return;
    const formulas = this.formulas.map((input) => input.value);
    const [first, second] = FORMS[this.form].variables;
    const typed: SurfaceTable = {
      ...this.table,
      formula: formulas.length === 1 ? formulas[0]! : (formulas as [string, string, string]),
      ...(this.table.size ? {} : { [first]: ends.slice(0, 2) as Ends, [second]: ends.slice(2) as Ends }),
    };
    if (JSON.stringify(typed) !== JSON.stringify(this.table)) this.changed(typed, gesture);
  }
}
