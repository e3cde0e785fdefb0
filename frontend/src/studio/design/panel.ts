// What panels are made of: the table [panel] of the design file.

import type { TableWords } from "../../shared/api-types.ts";
import { numberBox, type Segmented, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import type { Value } from "../state/types.ts";
import { withPanel } from "../structure/table.ts";

/** Share of the thickness that a hinge takes, membrane or gap, until another is asked for. */
const HINGE = 0.05;
/** Keys that whole boards on hinges have not, and those that only they have. */
const SET_BACK = ["sides", "membrane", "membrane_density", "largest_setback", "stop_deg"];
const ARMS = ["largest_arm", "arm_width", "pieces", "arm_density", "hinge"];
type Size = "thickness" | "membrane" | "gap" | "largest_arm" | "pieces";

export class PanelControls {
  readonly element: HTMLElement;
  private readonly construction: Segmented<string>;
  private readonly sides: Segmented<string>;
  private readonly boxes: Record<Size, HTMLInputElement>;
  private readonly units: HTMLElement[] = [];
  private readonly more: HTMLElement[];

  constructor(private readonly store: Store) {
    this.boxes = {
      thickness: this.box("thickness", (value) => this.setThickness(value)),
      membrane: this.box("membrane", (value) => this.change({ ...this.table, membrane: value }, "type-membrane")),
      gap: this.box("gap", (value) => this.change({ ...this.table, gap: value }, "type-gap")),
      largest_arm: this.box("largest_arm", (value) => this.change({ ...this.table, largest_arm: value }, "type-arm")),
      pieces: this.box("pieces", (value) => this.setPieces(value)),
    };
    const { label, keys } = store.info.tables["panel"]!;
    const construction = keys["construction"]!;
    this.construction = segmented<string>(
      construction.label,
      Object.entries(construction.choices).map(([value, text]) => ({ value, text, testid: `panel-construction-${value}` })),
      (value) => this.setConstruction(value),
    );
    const sides = keys["sides"]!;
    this.sides = segmented<string>(
      sides.label,
      Object.entries(sides.choices).map(([value, text]) => ({ value, text, testid: `panel-sides-${value}` })),
      (value) => this.change(value === "both" ? without(this.table, ["sides"]) : { ...this.table, sides: value }),
    );
    this.more = [
      h("div", { class: "parameter-head", title: construction.help }, h("span", {}, construction.label), this.construction.element),
      h("div", { class: "parameter-head", title: sides.help }, h("span", {}, sides.label), this.sides.element),
      this.row("membrane", keys),
      this.row("gap", keys),
      this.row("largest_arm", keys),
      this.row("pieces", keys),
    ];
    this.element = h(
      "section",
      { class: "panel", "aria-labelledby": "panel-title" },
      h("h2", { id: "panel-title" }, label),
      this.row("thickness", keys),
      ...this.more,
    );
    store.design.bind(() => this.show());
  }

  private get table(): Record<string, Value> {
    return this.store.design.value.panel ?? {};
  }

  private box(key: string, changed: (value: number) => void): HTMLInputElement {
    return numberBox({ min: 0, step: "any", id: `panel-${key}`, "data-testid": `panel-${key}` }, changed);
  }

  private row(key: Size, keys: TableWords["keys"]): HTMLElement {
    const { label, help } = keys[key]!;
    const unit = h("span", { class: "unit" }, key === "pieces" ? "rows" : "");
    if (key !== "pieces") this.units.push(unit);
    return h("div", { class: "parameter-head", title: help }, h("label", { for: `panel-${key}` }, label), this.boxes[key], unit);
  }

  private setThickness(thickness: number): void {
    const membrane = Number(this.table["membrane"] ?? 0);
    const fits = this.solid || (membrane > 0 && membrane < thickness);
    this.change({ ...this.table, thickness, ...(fits ? {} : { membrane: hingeOf(thickness) }) }, "type-thickness");
  }

  /** A piece of one row has no motion of its own: below 2 the sheet is whole. */
  private setPieces(rows: number): void {
    const table = without(this.table, ["pieces"]);
    this.change(rows < 2 ? table : { ...table, pieces: Math.round(rows) }, "type-pieces");
  }

  private setConstruction(construction: string): void {
    const { membrane: _, construction: __, sides: ___, ...rest } = this.table;
    const hinge = hingeOf(Number(rest["thickness"]));
    if (construction === "hinged") return this.change({ ...without(rest, SET_BACK), construction });
    const table = without(rest, ARMS);
    // Solid panels have no membrane: their hinges need a gap.
    const bevel = { ...table, construction, gap: Number(table["gap"]) || hinge };
    this.change(construction === "bevel" ? bevel : { ...table, membrane: hinge });
  }

  /** Without a thickness panels are made of nothing, and the file has no such table. */
  private change(table: Record<string, Value>, gesture = ""): void {
    const panel = Number(table["thickness"]) > 0 ? table : undefined;
    this.store.set(withPanel(this.store.design.value, panel), "panels", gesture);
  }

  private show(): void {
    const { thickness = 0, membrane = 0, gap = 0, construction = "sandwich", sides = "both", largest_arm: arm, pieces } = this.table;
    setNumber(this.boxes.thickness, short(Number(thickness)));
    setNumber(this.boxes.membrane, short(Number(membrane)));
    setNumber(this.boxes.gap, short(Number(gap)));
    setNumber(this.boxes.largest_arm, typeof arm === "number" ? short(arm) : "");
    setNumber(this.boxes.pieces, typeof pieces === "number" ? String(pieces) : "");
    this.boxes.pieces.placeholder = String(pieces ?? "whole");
    this.construction.set(String(construction));
    this.sides.set(String(sides));
    for (const unit of this.units) unit.textContent = this.store.design.value.shell.unit;
    for (const row of this.more) row.hidden = !Number(thickness);
    for (const row of this.more.slice(1, 3)) row.hidden ||= this.solid;
    for (const row of this.more.slice(4)) row.hidden ||= construction !== "hinged";
  }

  private get solid(): boolean {
    return ["bevel", "hinged"].includes(String(this.table["construction"]));
  }
}

function without(table: Record<string, Value>, keys: string[]): Record<string, Value> {
  return Object.fromEntries(Object.entries(table).filter(([key]) => !keys.includes(key)));
}

function hingeOf(thickness: number): number {
  return Number(short(HINGE * thickness, 2));
}
