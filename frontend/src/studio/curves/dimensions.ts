// How large a curve is: its extents as numbers that scale it.

import { button, numberBox, setNumber } from "../parts/controls.ts";
import { scaleOf, withExtent, withScale } from "./curve-table.ts";
import { h, s, setAttribute } from "../parts/dom.ts";
import { icon } from "../parts/icons.ts";
import { keptSwitch } from "../state/storage.ts";
import { short } from "../parts/numbers.ts";
import { type Plane, boxOf } from "./plane.ts";
import { line } from "./plot-grid.ts";
import type { CurveName, CurveTable, Point } from "../state/types.ts";

type Axis = 0 | 1;

/** Whether all of a curve grows when one of its extents does. */
const proportional = keptSwitch("orishell.proportional", true);
/** An extent below this share of the other is none that could be scaled. */
const NOTHING = 1e-6;
/** On the canvas: how far a line that measures is from the curve, half its ends, and the room that its
 * box needs to either side of its middle (pixels). */
const [AWAY, END] = [40, 5];
const ROOM: Point = [84, 20];

interface Measure {
  name: string;
  /** The axis along which it is measured. */
  axis(extents: Point): Axis;
}
const MEASURES: Record<CurveName, Measure[]> = {
  f: [
    { name: "Span", axis: () => 0 },
    { name: "Height", axis: () => 1 },
  ],
  g: [{ name: "Length", axis: ([x, y]) => (y > x ? 1 : 0) }],
};

export class Dimensions {
  readonly element: HTMLElement;
  private readonly boxes: HTMLInputElement[];
  private readonly units: HTMLElement[] = [];
  private table: CurveTable = {};
  private extents: Point = [0, 0];
  /** Extents and factors when the typing began: samples follow the typing later. */
  private base: { extents: Point; scale: Point } | null = null;
  private typed: CurveTable | null = null;
  /** Each extent by itself, whether or not proportions are kept elsewhere. */
  private apart = false;

  constructor(
    private readonly name: CurveName,
    private readonly scaled: (table: CurveTable, what: string, gesture: string) => void,
  ) {
    this.boxes = MEASURES[name].map((measure) => this.box(measure));
    const lock = button({
      label: `Keep the proportions of ${name}`,
      icon: "locked",
      testid: `proportional-${name}`,
      act: () => proportional.set(!proportional.value),
    });
    proportional.bind((on) => {
      setAttribute(lock, "aria-pressed", String(on));
      lock.replaceChildren(icon(on ? "locked" : "unlocked"));
    });
    this.element = h(
      "div",
      { class: "dimensions" },
      ...this.boxes.map((box, k) => {
        const unit = h("span", { class: "unit" });
        this.units.push(unit);
        return h("label", { class: "dimension" }, MEASURES[name][k]!.name, box, unit);
      }),
      lock,
    );
  }

  /** Boxes beside the lines that they measure, each by itself; or in a row. */
  separate(on: boolean): void {
    this.apart = on;
    for (const box of this.boxes) box.parentElement!.hidden = false;
  }

  /** Ready to be typed into, where that brings no keyboard onto the screen. */
  takeFocus(): void {
    if (matchMedia("(pointer: coarse)").matches) return;
    this.boxes[0]!.focus({ preventScroll: true });
    this.boxes[0]!.select();
  }

  /** The lines that measure a curve in its plane; the boxes go to the middle, or to the upper end of one
   * that is upright: there an arch is least in the way. */
  layOut(plane: Plane, samples: Point[]): Node[] {
    const box = boxOf(samples);
    return MEASURES[this.name].flatMap((measure, k) => {
      const label = this.boxes[k]!.parentElement!;
      label.hidden = !box;
      if (!box) return [];
      const axis = measure.axis(this.extents);
      const [[left, bottom], [right, top]] = [plane.toPixels(box.low), plane.toPixels(box.high)];
      const x = clamp(axis === 0 ? (left + right) / 2 : right + AWAY, ROOM[0], plane.width - ROOM[0]);
      const y = clamp(axis === 1 ? top : bottom + AWAY, 2 * ROOM[1], plane.height - 2 * ROOM[1]);
      label.style.setProperty("--x", `${x}px`);
      label.style.setProperty("--y", `${y}px`);
      const ends: Point[][] = axis === 0
        ? [[[left, y], [right, y]], ...[left, right].map((at): Point[] => [[at, y - END], [at, y + END]])]
        : [[[x, bottom], [x, top]], ...[bottom, top].map((at): Point[] => [[x - END, at], [x + END, at]])];
      return [s("path", { class: "plot-measure", d: ends.map((each) => line(...each)).join("") })];
    });
  }

  show(table: CurveTable, samples: Point[], unit: string): void {
    const box = boxOf(samples);
    // Another curve than what was typed of: an opened one, or an earlier one.
    if (table !== this.table && table !== this.typed) this.base = null;
    this.table = table;
    // Without a curve boxes stay, empty: what is below does not move under the pointer that draws it.
    this.extents = box ? [box.high[0] - box.low[0], box.high[1] - box.low[1]] : [0, 0];
    const least = NOTHING * Math.max(...this.extents);
    MEASURES[this.name].forEach((measure, k) => {
      const extent = this.extents[measure.axis(this.extents)];
      const input = this.boxes[k]!;
      input.disabled = !(extent > least);
      this.units[k]!.textContent = unit;
      // While it is typed into, a box says what is typed.
      if (!this.base || document.activeElement !== input) setNumber(input, box ? short(extent, 5) : "");
    });
  }

  private box(measure: Measure): HTMLInputElement {
    const { name } = this;
    const word = measure.name.toLowerCase();
    const input = numberBox(
      { step: "any", min: 0, "aria-label": `${measure.name} of ${name}`, "data-testid": `${word}-${name}` },
      (value) => {
        const { extents, scale } = (this.base ??= { extents: this.extents, scale: scaleOf(this.table) });
        const axis = measure.axis(extents);
        const factor = value / extents[axis];
        if (!(factor > 0) || !Number.isFinite(factor)) return input.classList.add("unfinished");
        this.typed = proportional.value && !this.apart
          ? withScale(this.table, [scale[0] * factor, scale[1] * factor])
          : withExtent(this.table, axis, value, scale.with(axis, scale[axis] * factor) as Point);
        this.scaled(this.typed, `${word} of ${name}`, `size-${name}-${word}`);
      },
    );
    input.addEventListener("focus", () => (this.base = null));
    input.addEventListener("blur", () => {
      this.base = null;
      setNumber(input, short(this.extents[measure.axis(this.extents)], 5));
    });
    return input;
  }
}

function clamp(value: number, low: number, high: number): number {
  return Math.max(low, Math.min(value, high));
}
