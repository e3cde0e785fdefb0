// What a profile stands on, and a person beside whom it is seen how large it is.

import { PERSON, heightOfPerson, suitsPerson } from "../../shared/person.ts";
import { s } from "../parts/dom.ts";
import { type Plane, boxOf } from "./plane.ts";
import { line } from "./plot-grid.ts";
import type { Point } from "../state/types.ts";

/** Shares of the plane's height between which a person is drawn, however near one looks. */
const [SMALLEST, LARGEST] = [0.05, 1];
/** How many times as high as the curve a person may be who is to be in view with it. */
const TALLER = 1.6;
const HATCH = 8;

/** Whether a person says how large a curve is. */
export function suitsCurve(samples: Point[], unit: string): boolean {
  const box = boxOf(samples);
  return box !== null && suitsPerson(Math.max(box.high[0] - box.low[0], box.high[1] - box.low[1]), unit);
}

/** What of a person is to be in view beside a curve, unless that would make a speck of it. */
export function headOf(samples: Point[], unit: string): Point[] {
  const box = boxOf(samples);
  if (!box || !suitsCurve(samples, unit)) return [];
  const height = heightOfPerson(unit);
  const level = Math.min(samples[0]![1], samples.at(-1)![1]);
  const large = height < TALLER * (box.high[1] - box.low[1]);
  return large ? [[(box.low[0] + box.high[0]) / 2, level + height]] : [];
}

/** The ground at a curve's lower end, and a person on it in the middle of the curve. */
export function profileGround(plane: Plane, samples: Point[], unit: string, person: boolean): Node[] {
  if (samples.length < 2) return [];
  const level = Math.min(samples[0]![1], samples.at(-1)![1]);
  const [, y] = plane.toPixels([0, level]);
  const nodes: Node[] = [];
  if (person && suitsCurve(samples, unit)) {
    const height = heightOfPerson(unit);
    const share = (height * plane.scale) / plane.height;
    if (share >= SMALLEST && share <= LARGEST) {
      const middle = (samples[0]![0] + samples.at(-1)![0]) / 2;
      const outline = PERSON.map(([x, up]) => plane.toPixels([middle + x * height, level + up * height]));
      nodes.push(s("path", { class: "plot-person", d: `${line(...outline)}Z` }));
    }
  }
  if (y < 0 || y > plane.height) return nodes;
  const strokes: string[] = [];
  for (let x = HATCH / 2; x < plane.width + HATCH; x += HATCH) strokes.push(line([x, y], [x - 5, y + 5]));
  nodes.push(
    s("path", { class: "plot-hatch", d: strokes.join("") }),
    s("path", { class: "plot-ground", d: line([0, y], [plane.width, y]) }),
  );
  return nodes;
}
