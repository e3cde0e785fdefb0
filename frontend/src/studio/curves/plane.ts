// A plane on the screen: equal scales on both axes, y up.

import { niceAbove } from "../parts/numbers.ts";
import type { Point } from "../state/types.ts";

export interface Box {
  low: Point;
  high: Point;
}

export function boxOf(points: Point[]): Box | null {
  if (!points.length) return null;
  const low: Point = [Infinity, Infinity];
  const high: Point = [-Infinity, -Infinity];
  for (const point of points) {
    for (const axis of [0, 1] as const) {
      low[axis] = Math.min(low[axis], point[axis]);
      high[axis] = Math.max(high[axis], point[axis]);
    }
  }
  return { low, high };
}

/** Share of the shorter side that stays free about what is shown. */
const MARGIN = 0.14;

export class Plane {
  width = 288;
  height = 168;
  /** Pixels to the unit. */
  scale = 100;
  centre: Point = [0, 0];

  toPixels([x, y]: Point): Point {
    return [
      this.width / 2 + (x - this.centre[0]) * this.scale,
      this.height / 2 - (y - this.centre[1]) * this.scale,
    ];
  }

  fromPixels([x, y]: Point): Point {
    return [
      this.centre[0] + (x - this.width / 2) / this.scale,
      this.centre[1] - (y - this.height / 2) / this.scale,
    ];
  }

  /** Show a box with a margin in pixels. */
  fit(box: Box, margin = MARGIN * Math.min(this.width, this.height)): void {
    const size = [box.high[0] - box.low[0], box.high[1] - box.low[1]] as const;
    const room = [this.width - 2 * margin, this.height - 2 * margin] as const;
    const scale = Math.min(room[0] / (size[0] || 1e-12), room[1] / (size[1] || 1e-12));
    this.scale = Number.isFinite(scale) && scale < 1e11 ? scale : 100;
    this.centre = [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2];
  }

  /** Show so much of the x axis about 0 and y = 0 at a share of the height. */
  spread(width: number, level: number): void {
    this.fit({ low: [-width / 2, 0], high: [width / 2, width / 4] });
    this.centre = [0, (0.5 - level) * (this.height / this.scale)];
  }

  /** Whether a box lies in view and is not tiny there. */
  suits(box: Box): boolean {
    const [left, bottom] = this.toPixels(box.low);
    const [right, top] = this.toPixels(box.high);
    const inside = left >= 0 && top >= 0 && right <= this.width && bottom <= this.height;
    return inside && Math.max((right - left) / this.width, (bottom - top) / this.height) > 0.35;
  }

  zoom(factor: number, about: Point = [this.width / 2, this.height / 2]): void {
    const fixed = this.fromPixels(about);
    this.scale = Math.min(Math.max(this.scale * factor, 1e-6), 1e9);
    const moved = this.fromPixels(about);
    this.centre = [
      this.centre[0] + fixed[0] - moved[0],
      this.centre[1] + fixed[1] - moved[1],
    ];
  }

  pan(dx: number, dy: number): void {
    this.centre = [this.centre[0] - dx / this.scale, this.centre[1] + dy / this.scale];
  }

  /** Distance between grid lines, in units: at least 40 pixels. */
  get step(): number {
    return niceAbove(40 / this.scale);
  }

  /** The point whose coordinates are multiples of a step. */
  rounded(point: Point, step: number): Point {
    return point.map((value) => Number((Math.round(value / step) * step).toPrecision(12))) as Point;
  }

  /** Multiples of a step in view along an axis. */
  ticks(axis: 0 | 1, step: number): number[] {
    const half = (axis === 0 ? this.width : this.height) / 2 / this.scale;
    const first = Math.ceil((this.centre[axis] - half) / step);
    const last = Math.floor((this.centre[axis] + half) / step);
    return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step);
  }
}
