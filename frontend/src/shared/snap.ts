// Points of the sheet that one measures between: vertices, and places on edges.

import { Vector3 } from "three";
import { flatPlace } from "./inspect.ts";
import type { Motion } from "./rigid.ts";
import type { View } from "./view.ts";

/** On the edge between two vertices of a panel. */
export interface Anchor {
  panel: number;
  from: number;
  to: number;
  /** Share of the way. */
  along: number;
}

export type Pixel = [number, number];

export interface Snapped {
  /** Which side of the panel, 0 to 3. */
  side: number;
  /** Share of the way along it: 0 or 1 is a vertex. */
  along: number;
  /** Pixels away. */
  away: number;
}

/** The corner of a panel within reach of a place, else the nearest place on its sides. */
export function snapTo(corners: Pixel[], at: Pixel, reach: number): Snapped {
  let best: Snapped = { side: 0, along: 0, away: Infinity };
  for (let k = 0; k < 4; k++) {
    const away = apart(corners[k]!, at);
    if (away < best.away) best = { side: k, along: 0, away };
  }
  if (best.away <= reach) return best;
  for (let k = 0; k < 4; k++) {
    const [x, y] = corners[k]!, [u, v] = corners[(k + 1) & 3]!;
    const square = (u - x) ** 2 + (v - y) ** 2 || 1;
    const along = Math.min(1, Math.max(0, ((at[0] - x) * (u - x) + (at[1] - y) * (v - y)) / square));
    const away = apart([x + along * (u - x), y + along * (v - y)], at);
    if (away < best.away) best = { side: k, along, away };
  }
  return best;
}

/** Place of an anchor in the flat sheet. */
export function anchorFlat(view: View, { from, to, along }: Anchor): Vector3 {
  return flatPlace(view, from).lerp(flatPlace(view, to), along);
}

/** Place of an anchor in the state drawn. */
export function anchorNow(motion: Motion, { panel, from, to, along }: Anchor): Vector3 {
  const begin = motion.at(motion.cornerOf(panel, from), new Vector3());
  return begin.lerp(motion.at(motion.cornerOf(panel, to), new Vector3()), along);
}

export function anchorOf(view: View, panel: number, { side, along }: Pick<Snapped, "side" | "along">): Anchor {
  return { panel, from: view.faces[4 * panel + side]!, to: view.faces[4 * panel + ((side + 1) & 3)]!, along };
}

function apart(one: Pixel, other: Pixel): number {
  return Math.hypot(one[0] - other[0], one[1] - other[1]);
}
