// The base rail, which joins the feet of a row: the table `rail` of [structure].

import { setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import { capital } from "../../shared/words.ts";
import type { Store } from "../state/store.ts";
import { box, choice, row } from "./rows.ts";
import { millimetres, railOf, withRail } from "./table.ts";

const SIZES = ["width", "height", "wall"] as const;
const NONE = "";

export class RailControls {
  readonly element: HTMLElement;
  private readonly material: HTMLSelectElement;
  private readonly boxes: Record<(typeof SIZES)[number], HTMLInputElement>;
  private readonly sizes: HTMLElement;

  constructor(private readonly store: Store) {
    const { tables, materials } = store.info;
    const rail = tables["structure"]!.keys["rail"]!, { keys } = tables["structure.rail"]!;
    this.material = choice("rail", rail, [[NONE, "None"], ...materials.map(({ name }): [string, string] => [name, capital(name)])], (name) => this.set("material", name));
    this.boxes = {
      width: this.size("width"),
      height: this.size("height"),
      wall: this.size("wall", "solid"),
    };
    this.sizes = h("div", { class: "parameter-list" }, ...SIZES.map((key) => row(`rail-${key}`, keys[key]!, this.boxes[key], "mm")));
    this.element = h("div", { class: "parameter-list" }, row("rail", rail, this.material), this.sizes);
    store.design.bind(() => this.show());
  }

  private size(key: string, placeholder = ""): HTMLInputElement {
    return box(`rail-${key}`, (mm) => this.set(key, Number(short(mm / millimetres(this.store.design.value))), `type-rail-${key}`), placeholder);
  }

  private set(key: string, value: unknown, gesture = ""): void {
    this.store.set(withRail(this.store.design.value, key, value), "base rail", gesture);
  }

  private show(): void {
    const design = this.store.design.value, rail = railOf(design);
    this.material.value = String(rail?.["material"] ?? NONE);
    this.sizes.hidden = !rail;
    for (const key of SIZES) {
      const size = rail?.[key];
      setNumber(this.boxes[key], size === undefined ? "" : short(Number(size) * millimetres(design)));
    }
  }
}
