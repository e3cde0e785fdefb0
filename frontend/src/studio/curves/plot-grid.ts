// Grid lines of a plane with their numbers, and the lines that say where a point is caught.

import { s } from "../parts/dom.ts";
import { pretty, roundTo } from "../parts/numbers.ts";
import type { Plane } from "./plane.ts";
import type { Guide } from "./snapping.ts";
import type { Point } from "../state/types.ts";

export function gridOf(plane: Plane): { lines: Node[]; texts: Node[] } {
  const { step, width, height } = plane;
  const lines: Node[] = [];
  const texts: Node[] = [];
  for (const value of plane.ticks(0, step)) {
    const [x] = plane.toPixels([value, 0]);
    const kind = Math.abs(value) < step / 1e6 ? "axis" : "";
    lines.push(s("path", { d: `M${x.toFixed(1)} 0V${height}`, class: kind }));
    if (x > 30 && x < width - 14) {
      texts.push(s("text", { x, y: height - 5, "text-anchor": "middle" }, tick(value, step)));
    }
  }
  for (const value of plane.ticks(1, step)) {
    const [, y] = plane.toPixels([0, value]);
    const kind = Math.abs(value) < step / 1e6 ? "axis" : "";
    lines.push(s("path", { d: `M0 ${y.toFixed(1)}H${width}`, class: kind }));
    if (y > 8 && y < height - 16) texts.push(s("text", { x: 5, y: y + 3.5 }, tick(value, step)));
  }
  return { lines, texts };
}

export function guidesOf(plane: Plane, guides: Guide[]): string {
  const words = guides.map((guide) => {
    if ("from" in guide) return line(plane.toPixels(guide.from), plane.toPixels(guide.to));
    const [x, y] = plane.toPixels([guide.value, guide.value]);
    return guide.axis === 0 ? line([x, 0], [x, plane.height]) : line([0, y], [plane.width, y]);
  });
  return words.join("");
}

export function line(...points: Point[]): string {
  if (!points.length) return "";
  return `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
}

function tick(value: number, step: number): string {
  return pretty(roundTo(value, step), 5);
}
