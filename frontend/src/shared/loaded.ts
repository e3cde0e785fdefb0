// The shell under load, as numbers: which case, coloured by what, drawn how many times as large.

import { largest } from "./colours.ts";
import type * as Api from "./api-types.ts";
import type { Loaded } from "./view.ts";

export type Measure = "displacement" | "stress";

/** The largest displacement is drawn as about this share of the shell's size, at most. */
export const DRAWN = 0.06;

/** What a load case does to the shell. */
export interface Deflection {
  number: number;
  name: string;
  sign: Api.NamedCase["sign"];
  balanced: boolean;
  /** (N, 3) */
  displacements: Float32Array;
  /** Largest displacement. */
  most: number;
  /** By which displacements are drawn larger, so that they can be seen. */
  scale: number;
}

export function deflectionOf(loaded: Loaded, number: number): Deflection {
  const { name, sign, balanced } = loaded.cases[number]!;
  const size = loaded.points.length;
  const displacements = loaded.displacements.subarray(number * size, (number + 1) * size);
  const most = largest(sizes(displacements));
  return { number, name, sign, balanced, displacements, most, scale: exaggeration(diagonal(loaded.points), most) };
}

/** 1, 2 or 5 times a power of ten, as in orishell.plot.structure. */
export function exaggeration(size: number, most: number): number {
  if (!(most > 0)) return 1;
  const wanted = (DRAWN * size) / most;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return Math.max(...[1, 2, 5].filter((step) => step <= (wanted / power) * (1 + 1e-9))) * power;
}

/** Round numbers by which displacements may be drawn larger: as they are, to beyond the one proposed. */
export function scalesOf(proposed: number): number[] {
  const scales: number[] = [];
  for (let power = Math.floor(Math.log10(Math.min(1, proposed))); ; power++) {
    for (const step of [1, 2, 5]) {
      const scale = step * 10 ** power;
      if (scale > 5.001 * proposed && scale > 1) return scales;
      if (scale >= Math.min(1, proposed) * 0.999) scales.push(scale);
    }
  }
}

/** Shares (3 T,) of the most at the corners of all triangles, NaN where it is not known; and the most. */
export function amountsOf(loaded: Loaded, deflection: Deflection, measure: Measure): { shares: Float32Array; most: number } {
  const { triangles } = loaded;
  const count = triangles.length / 3;
  const values = measure === "stress"
    ? loaded.stresses.subarray(deflection.number * count, (deflection.number + 1) * count)
    : sizes(deflection.displacements);
  const most = largest(values);
  const shares = Float32Array.from(triangles, (node, corner) =>
    values[measure === "stress" ? Math.floor(corner / 3) : node]! / (most || 1));
  return { shares, most };
}

/** Lines (2 L,) round the panels, and those of them (2 B,) round the whole sheet: pairs of nodes. */
export function rimsOf({ points, triangles, panels }: Loaded): { rims: Uint32Array; border: Uint32Array } {
  const nodes = points.length / 3;
  const within = new Map<number, Set<number>>();
  triangles.forEach((node, corner) => {
    const next = triangles[corner - (corner % 3) + ((corner + 1) % 3)]!;
    const code = Math.min(node, next) * nodes + Math.max(node, next);
    const beside = within.get(code) ?? new Set();
    const panel = panels[Math.floor(corner / 3)]!;
    // A side that two triangles of one panel share lies inside it.
    if (!beside.delete(panel)) beside.add(panel);
    within.set(code, beside);
  });
  const ends = (wanted: (panels: number) => boolean): Uint32Array =>
    Uint32Array.from([...within].filter(([, beside]) => wanted(beside.size)).flatMap(([code]) => [Math.floor(code / nodes), code % nodes]));
  return { rims: ends((count) => count > 0), border: ends((count) => count === 1) };
}

function sizes(vectors: Float32Array): Float32Array {
  return Float32Array.from({ length: vectors.length / 3 }, (_, k) =>
    Math.hypot(vectors[3 * k]!, vectors[3 * k + 1]!, vectors[3 * k + 2]!));
}

function diagonal(points: Float32Array): number {
  const spans = [0, 1, 2].map((axis) => {
    let low = Infinity, high = -Infinity;
    for (let i = axis; i < points.length; i += 3) {
      low = Math.min(low, points[i]!);
      high = Math.max(high, points[i]!);
    }
    return high - low;
  });
  return Math.hypot(...spans);
}
