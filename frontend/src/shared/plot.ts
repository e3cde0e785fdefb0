// The frame of a plot: scales from values to places, lines and numbers at their ticks.

import { svg } from "./svg.ts";

/** Room beside the outermost values, as a share of the axis. */
const ROOM = 0.06;

export class Scale {
  constructor(readonly low: number, readonly high: number, protected readonly from: number, protected readonly to: number) {}

  /** The scale that shows all values, with some room. */
  static of(values: readonly number[], from: number, to: number): Scale {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = ROOM * (high - low || Math.abs(high) || 1);
    return new Scale(low - room, high + room, from, to);
  }

  at(value: number): number {
    return this.from + ((value - this.low) / (this.high - this.low)) * (this.to - this.from);
  }

  has(value: number): boolean {
    return value >= this.low && value <= this.high;
  }

  /** 1, 2 or 5 times a power of ten apart, about as many as are asked for. */
  ticks(about = 6): number[] {
    const raw = (this.high - this.low) / about;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = power * ([1, 2, 5, 10].find((lead) => lead * power >= 0.75 * raw) ?? 10);
    const ticks: number[] = [];
    for (let k = Math.ceil(this.low / step); k * step <= this.high; k++) ticks.push(Number((k * step).toPrecision(10)) + 0);
    return ticks;
  }
}

/** Where the axes of a plot end. */
export interface Frame {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** One of the axes: its scale, about how many ticks it has, and what it is of. */
export interface Axis {
  scale: Pick<Scale, "at" | "ticks">;
  about?: number;
  name: string;
}

type Written = (value: number) => string;

export function axisAcross({ left, right, top, bottom }: Frame, { scale, about, name }: Axis, written: Written): SVGElement[] {
  const lines = scale.ticks(about).flatMap((tick) => {
    const x = scale.at(tick);
    return [
      svg("line", { class: "grid", x1: x, x2: x, y1: top, y2: bottom }),
      svg("text", { x, y: bottom + 15, "text-anchor": "middle" }, written(tick)),
    ];
  });
  return [...lines, svg("text", { class: "axis", x: (left + right) / 2, y: bottom + 33, "text-anchor": "middle" }, name)];
}

export function axisUp({ left, right, top, bottom }: Frame, { scale, about, name }: Axis, written: Written): SVGElement[] {
  const middle = (top + bottom) / 2;
  const lines = scale.ticks(about).flatMap((tick) => {
    const y = scale.at(tick);
    return [
      svg("line", { class: "grid", x1: left, x2: right, y1: y, y2: y }),
      svg("text", { x: left - 6, y: y + 4, "text-anchor": "end" }, written(tick)),
    ];
  });
  return [...lines, svg("text", { class: "axis", x: 12, y: middle, "text-anchor": "middle", transform: `rotate(-90 12 ${middle})` }, name)];
}
