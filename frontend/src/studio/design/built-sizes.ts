// Sizes that the built shell is to have: the table [target.fit] of the design file. Each is optional, and beside
// it is what the shell measures.

import { type Segmented, numberBox, numberIn, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { Note } from "../parts/note.ts";
import { pretty, short } from "../parts/numbers.ts";
import { aimOf } from "../state/aims.ts";
import type { Store } from "../state/store.ts";
import { fitOf, fitTable, isAsked, measuredSizes, type Side, sideOf, SIZES } from "./fit-table.ts";

const KEYS = [...SIZES, "head_height"] as const;
type Key = (typeof KEYS)[number];

interface Row {
  element: HTMLElement;
  box: HTMLInputElement;
  measured: HTMLElement;
  unit: HTMLElement;
}

export class BuiltSizes {
  readonly element: HTMLDetailsElement;
  private readonly rows: Record<Key, Row>;
  private readonly sides: Segmented<Side>;
  private readonly words = h("p", { class: "note" });
  private readonly note = new Note();
  /** Of what sizes are: chosen before any is asked for, too. */
  private side: Side = "outside";
  private asked = false;

  constructor(private readonly store: Store) {
    const { keys } = store.info.tables["target.fit"]!;
    const of = keys["of"]!;
    this.sides = segmented<Side>(
      of.label,
      Object.entries(of.choices).map(([value, text]) => ({ value: value as Side, text, testid: `fit-${value}` })),
      (side) => this.turnTo(side),
    );
    this.rows = Object.fromEntries(KEYS.map((key) => [key, this.row(key)])) as Record<Key, Row>;
    this.element = h(
      "details",
      { class: "more built-sizes" },
      h("summary", { "data-testid": "built-sizes" }, "Sizes of the built shell"),
      h(
        "div",
        { class: "parameter-list" },
        h("div", { class: "parameter-head", title: of.help }, h("span", {}, of.label), this.sides.element),
        ...KEYS.map((key) => this.rows[key].element),
        this.words,
        this.note.element,
      ),
    );
    store.design.bind(() => this.show());
    store.fault.bind(() => this.showFault());
    for (const signal of [store.report, store.proof, store.freshness]) {
      (signal as { watch(listener: () => void): void }).watch(() => this.measure());
    }
  }

  private get table(): Record<string, number | string> {
    return fitOf(this.store.design.value);
  }

  private row(key: Key): Row {
    const { label, help } = this.store.info.tables["target.fit"]!.keys[key]!;
    const id = `fit-${key}`;
    // Read when it is left or Enter is pressed: every size is a search.
    const box = numberBox({ min: 0, step: "any", id, "data-testid": id }, () => undefined);
    box.addEventListener("change", () => {
      if (!box.value || Number.isFinite(numberIn(box))) this.set(key, box.value ? numberIn(box) : undefined);
    });
    const measured = h("span", { class: "measured", "data-testid": `${id}-measured` });
    const unit = h("span", { class: "unit" });
    const element = h("div", { class: "parameter-head", title: help }, h("label", { for: id }, label), measured, box, unit);
    return { element, box, measured, unit };
  }

  private turnTo(side: Side): void {
    this.side = side;
    if (isAsked(this.table)) return this.write(this.table, "sizes");
    this.show();
  }

  private set(key: Key, value: number | undefined): void {
    this.write({ ...this.table, [key]: value }, this.store.labels.of(key), `type-fit-${key}`);
  }

  private write(given: Record<string, unknown>, what: string, gesture = ""): void {
    this.store.set({ "target.fit": fitTable(given, this.side) }, what, gesture);
  }

  private show(): void {
    const { table } = this;
    const { design } = this.store;
    this.element.hidden = aimOf(design.value) === "none";
    const asked = isAsked(table);
    this.side = sideOf(table) ?? this.side;
    if (asked && !this.asked) this.element.open = true;
    this.asked = asked;
    this.sides.set(this.side);
    for (const key of KEYS) {
      setNumber(this.rows[key].box, short(Number(table[key] ?? NaN), 8));
      this.rows[key].unit.textContent = design.value.shell.unit;
    }
    const clear = this.side === "inside" && (table["width"] ?? table["depth"]) !== undefined;
    this.rows.head_height.element.hidden = !clear;
    this.measure();
  }

  /** What the shell on the screen measures, as far as that is known. */
  private measure(): void {
    const { proof, design } = this.store;
    const { unit } = design.value.shell;
    const sizes = proof.value.state === "done" ? proof.value.sizes : null;
    const known = measuredSizes(this.store, this.side);
    for (const key of SIZES) {
      const value = known[key];
      this.rows[key].measured.textContent = value === undefined ? "" : value ? `is ${pretty(value, 4)} ${unit}` : "none";
    }
    this.rows.head_height.box.placeholder = sizes ? short(sizes.head_height, 4) : "";
    const standing = this.side === "outside" || !sizes || sizes.inside;
    this.words.textContent = !standing
      ? "The shell does not stand on the ground: it has no room within."
      : this.side === "inside"
        ? `Clear through the whole shell${sizes ? ` up to ${short(sizes.head_height, 4)} ${unit}` : ""}; height is the headroom.`
        : "Of all that is built: the target is scaled until the shell measures what is asked for.";
  }

  private showFault(): void {
    const fault = this.store.fault.value;
    const keys = fault?.keys ?? [];
    const mine = keys.some((key) => `${key}.`.startsWith("target.fit."));
    for (const key of KEYS) this.rows[key].element.classList.toggle("faulty", keys.includes(`target.fit.${key}`));
    if (mine) this.element.open = true;
    this.note.showFault(mine ? this.store.labels.said(fault!.what) : null);
  }
}
