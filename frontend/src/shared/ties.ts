// Ties of a shell as it moves: taut where they are as long as at the target, slack where they are shorter.

import { targetPoints, vertexCount, type View } from "./view.ts";

export interface TieLine {
  /** Numbers of its vertices. */
  ends: [number, number];
  /** Distance of its vertices at the target. */
  length: number;
}

/** Parts of its length by which a tie that is taut may seem longer or shorter. */
const TAUT = 1e-3;

export function tiesOf(view: View): TieLine[] {
  const { grid, report } = view.header;
  const points = targetPoints(view);
  if (!grid || !points) return [];
  return (report.deployment?.ties ?? []).map(({ ends, length }) => {
    const [from, to] = ends.map(([row, column]) => row * grid[1] + column);
    return { ends: [from!, to!], length };
  });
}

/** "open": its vertices are farther apart than it is long, so that it is not hooked in yet. */
export function stateOfTie(tie: TieLine, distance: number): "taut" | "slack" | "open" {
  if (distance > tie.length * (1 + TAUT)) return "open";
  return distance < tie.length * (1 - TAUT) ? "slack" : "taut";
}

/** A corner of some panel at each vertex (V,). */
export function cornersOf(faces: Uint32Array, view: View): Uint32Array {
  const corners = new Uint32Array(vertexCount(view));
  for (let corner = 0; corner < faces.length; corner++) corners[faces[corner]!] = corner;
  return corners;
}
