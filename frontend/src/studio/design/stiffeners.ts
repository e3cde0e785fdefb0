// What stiffens the shell once it stands: the table [stiffeners] of the design file.

import type { KeyWords } from "../../shared/api-types.ts";
import { boxOf } from "../curves/plane.ts";
import { FormulaFields } from "../curves/formula-fields.ts";
import { button, numberBox, type Segmented, segmented, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { capital } from "../../shared/words.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import { listed } from "./row-list.ts";
import { AS_PANELS, bolted, BOXES, EMPTY, GAP, KEYS, lowered, NONE, ROWS, SHARE, SKIN, stepOf, stiffened } from "./stiffener-table.ts";

const SIZES = ["hole", "spacing", "edge"] as const;
/** A new curve of a second skin lies below f by this share of how wide that is. */
const BELOW = 0.1;

export class StiffenerControls {
  readonly element: HTMLElement;
  private readonly kind: Segmented<string>;
  private readonly rows: Segmented<string>;
  private readonly step: HTMLInputElement;
  private readonly share: HTMLInputElement;
  private readonly thickness: HTMLInputElement;
  private readonly material: HTMLSelectElement;
  private readonly bolts: Record<(typeof SIZES)[number], HTMLInputElement>;
  private readonly units = [...SIZES, "thickness", "gap"].map(() => h("span", { class: "unit" }));
  private readonly note = h("p", { class: "note" });
  private readonly rest: HTMLElement;
  private readonly gap: HTMLInputElement;
  private readonly walls: HTMLInputElement;
  /** Its rows, by their keys. */
  private readonly heads: Record<string, HTMLElement[]>;
  /** What only gussets have that are bolted on. */
  private readonly held: HTMLElement[];
  private boxes = false;
  /** The curve of a second skin. */
  private readonly inner = new FormulaFields("inner", (table, gesture) => this.store.set({ "target.inner": table }, "curve of the second skin", gesture));
  private readonly curve = h("div", { class: "parameter-list" }, h("span", {}, "Curve of the second skin, where f is"), this.inner.element);
  private readonly own = button({ label: "Follow a curve of its own", text: "Follow a curve of its own", testid: "skin-curve", act: () => this.follow() });

  constructor(private readonly store: Store) {
    const { label, keys } = store.info.tables["stiffeners"]!;
    const { kind, rows, columns, share, thickness, material, gap, walls } = keys;
    this.kind = this.segments("kind", { ...kind!, choices: { [NONE]: "None", ...kind!.choices } });
    this.rows = this.segments("rows", rows!);
    this.step = this.box("columns", { min: 1, step: 1 });
    this.share = this.box("share", { min: 0, max: 1, step: "any" });
    this.thickness = this.box("thickness", { min: 0, step: "any", placeholder: "as panels" });
    // Emptied it is as panels again, which no number says.
    this.thickness.addEventListener("change", () => this.thickness.value === "" && this.set("thickness", 0));
    this.gap = this.box("gap", { min: 0, step: "any", placeholder: GAP });
    this.gap.addEventListener("change", () => this.gap.value === "" && this.set("gap", GAP));
    this.walls = this.box("walls", { min: 1, step: 1 });
    for (const [key, box] of [["columns", this.step], ["share", this.share]] as const) {
      box.addEventListener("change", () => box.value === "" && this.boxes && this.set(key, EMPTY[key]));
    }
    this.material = h("select", { id: "stiffeners-material", "data-testid": "stiffeners-material", "aria-label": material!.label, onchange: () => this.set("material", this.material.value) });
    this.material.append(new Option("As panels", AS_PANELS), ...store.info.materials.map(({ name }) => new Option(capital(name), name)));
    this.bolts = { hole: this.bolt("hole", "clipped in"), spacing: this.bolt("spacing"), edge: this.bolt("edge", "4 diameters") };
    const sizes = store.info.tables["stiffeners.bolts"]!.keys;
    const bolts = SIZES.map((key, k) => row(`bolts-${key}`, sizes[key]!, this.bolts[key], this.units[k]!));
    this.held = bolts.slice(1);
    this.heads = {
      rows: [named(rows!, this.rows)],
      columns: [row("columns", columns!, this.step)],
      share: [row("share", share!, this.share)],
      thickness: [row("thickness", thickness!, this.thickness, this.units[SIZES.length]!)],
      material: [row("material", material!, this.material)],
      bolts,
      gap: [row("gap", gap!, this.gap, this.units[SIZES.length + 1]!)],
      walls: [row("walls", walls!, this.walls)],
    };
    this.rest = h("div", { class: "parameter-list" }, ...Object.values(this.heads).flat(), this.own, this.curve, this.note);
    this.element = h(
      "section",
      { class: "stiffeners", "aria-labelledby": "stiffeners-title" },
      h("h2", { id: "stiffeners-title" }, label),
      named(kind!, this.kind),
      this.rest,
    );
    store.design.bind(({ stiffeners, shell }) => this.show(stiffeners, String(shell["unit"] ?? "")));
    for (const signal of [store.design, store.curves]) (signal as { bind(listener: () => void): void }).bind(() => this.showCurve());
  }

  private set(key: string, value: unknown, gesture = ""): void {
    const { stiffeners, target } = this.store.design.value;
    // A gap, or another kind, takes the place of a curve.
    const curve = target?.inner && (key === "kind" || key === "gap") ? { "target.inner": null } : {};
    this.store.set({ stiffeners: stiffened(stiffeners, key, value), ...curve }, "stiffeners", gesture);
  }

  private get lowered(): ReturnType<typeof lowered> {
    const { design, curves } = this.store;
    const { stiffeners, target } = design.value;
    const box = boxOf(curves.value?.f ?? []);
    return stiffeners?.["kind"] === SKIN && !target?.inner && target?.f && box ? lowered(target.f, BELOW * (box.high[0] - box.low[0])) : null;
  }

  private follow(): void {
    const { design } = this.store;
    this.store.set({ "target.inner": this.lowered, stiffeners: stiffened(design.value.stiffeners, "gap", GAP) }, "curve of the second skin");
  }

  private showCurve(): void {
    const { inner } = this.store.design.value.target ?? {};
    this.own.hidden = !this.lowered;
    this.curve.hidden = inner?.formula === undefined;
    if (inner) this.inner.show(inner);
    this.gap.placeholder = inner ? "its curve" : GAP;
  }

  private segments(key: string, { label, choices }: KeyWords): Segmented<string> {
    const values = Object.entries(choices).map(([value, text]) => ({ value, text, testid: `stiffeners-${key}-${value}` }));
    return segmented<string>(label, values, (value) => this.set(key, value));
  }

  private box(key: string, limits: Record<string, string | number>): HTMLInputElement {
    return numberBox({ ...limits, id: `stiffeners-${key}`, "data-testid": `stiffeners-${key}` }, (value) => this.set(key, value, `type-stiffeners-${key}`));
  }

  private bolt(key: (typeof SIZES)[number], placeholder = ""): HTMLInputElement {
    const set = (size: number, gesture = ""): void => this.set("bolts", bolted(this.store.design.value.stiffeners?.["bolts"], key, size), gesture);
    const id = `stiffeners-bolts-${key}`;
    const box = numberBox({ min: 0, step: "any", placeholder, id, "data-testid": id }, (size) => size > 0 && set(size, `type-${id}`));
    box.addEventListener("change", () => box.value === "" && set(0));
    return box;
  }

  private show(table: Record<string, unknown> | undefined, unit: string): void {
    const { kind = NONE, rows = ROWS, columns, share = SHARE, thickness, material = AS_PANELS, bolts, gap = GAP, walls } = table ?? {};
    this.rest.hidden = !table;
    this.kind.set(String(kind));
    this.rows.set(String(rows));
    this.boxes = kind === BOXES;
    for (const [key, heads] of Object.entries(this.heads)) for (const each of heads) each.hidden = !KEYS[String(kind)]?.includes(key);
    const step = stepOf(columns);
    setNumber(this.step, step === null ? "" : short(step));
    this.step.placeholder = Array.isArray(columns) ? "listed" : this.boxes ? "none" : "";
    this.share.placeholder = this.boxes ? "auto" : "";
    setNumber(this.share, short(Number(share)));
    setNumber(this.thickness, thickness === undefined ? "" : short(Number(thickness)));
    for (const each of this.units) each.textContent = unit;
    for (const each of this.held) each.hidden ||= !bolts;
    for (const key of SIZES) {
      const size = (bolts as Record<string, unknown> | undefined)?.[key];
      setNumber(this.bolts[key], size === undefined || size === "auto" ? "" : short(Number(size)));
    }
    setNumber(this.gap, gap === GAP ? "" : short(Number(gap)));
    const every = stepOf(walls);
    setNumber(this.walls, every === null ? "" : short(every));
    this.walls.placeholder = every === null ? "listed" : "";
    this.material.value = String(material);
    const words = Object.entries({ Rows: rows, Columns: columns, Walls: walls }).flatMap(([name, each]) => (Array.isArray(each) ? [`${name} listed in the file: ${listed(each)}.`] : []));
    this.note.textContent = words.join(" ");
    this.note.hidden = !words.length;
  }
}

function row(key: string, { label, help }: KeyWords, ...controls: HTMLElement[]): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("label", { for: `stiffeners-${key}` }, label), ...controls);
}

function named({ label, help }: KeyWords, { element }: Segmented<string>): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("span", {}, label), element);
}
