// The shell under load, as numbers: which case, coloured by what, drawn how many times as large.

import { largest } from "./colours.ts";
import type * as Api from "./api-types.ts";
import type { Loaded } from "./view.ts";

/** Utilisation: stress as a share of what panels bear. */
export type Measure = "displacement" | "stress" | "utilisation";

/** The largest displacement is drawn as about this share of the shell's size, at most. */
export const DRAWN = 0.06;

/** What a load case does to the shell. */
export interface Deflection {
  number: number;
  name: string;
  sign: Api.NamedCase["sign"];
  balanced: boolean;
  /** Stress (MPa) that panels bear under loads that last as long; null if that is not known. */
  strength: number | null;
  /** The same of what stiffens the sheet. */
  partsStrength: number | null;
  /** (N, 3) */
  displacements: Float32Array;
  /** Largest displacement. */
  most: number;
  /** By which displacements are drawn larger, so that they can be seen. */
  scale: number;
}

export function deflectionOf(loaded: Loaded, number: number): Deflection {
  const { name, sign, balanced, strength, parts_strength: partsStrength } = loaded.cases[number]!;
  const size = loaded.points.length;
  const displacements = loaded.displacements.subarray(number * size, (number + 1) * size);
  const most = largest(sizes(displacements));
  return { number, name, sign, balanced, strength, partsStrength, displacements, most, scale: exaggeration(diagonal(loaded.points), most) };
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

interface Amounts {
  shares: Float32Array;
  most: number;
  /** The panel or stiffener with the most; null of displacements. */
  of: number | null;
}

/** Shares (3 T,) of the end of the colours at the corners of all triangles, NaN where it is not known; the most,
 * and what has it. Colours end at the most, those of utilisation at 1: of the strength of what each triangle is of. */
export function amountsOf(loaded: Loaded, deflection: Deflection, measure: Measure): Amounts {
  const { triangles } = loaded;
  const count = triangles.length / 3;
  const moved = measure === "displacement";
  const stresses = loaded.stresses.subarray(deflection.number * count, (deflection.number + 1) * count);
  const { strength, partsStrength } = deflection;
  const used = measure === "utilisation";
  const values = moved
    ? sizes(deflection.displacements)
    : used
      ? stresses.map((stress, k) => stress / ((k < loaded.ofPanels ? strength : partsStrength) ?? NaN))
      : stresses;
  const most = largest(values);
  const end = used ? 1 : most || 1;
  const shares = Float32Array.from(triangles, (node, corner) => values[moved ? node : Math.floor(corner / 3)]! / end);
  return { shares, most, of: moved ? null : loaded.panels[values.indexOf(most)] ?? null };
}

/** Whether it is known how much of its strength anything uses, in any case. */
export function usesStrength({ cases }: Loaded): boolean {
  return cases.some((each) => each.strength ?? each.parts_strength);
}

/** The largest share of their strength (P,) that panels use, and the case (P,) in which: what they bear depends on
 * how long the loads of a case last. Null where the strength is not known. */
export function worstUsed(loaded: Loaded): { shares: Float32Array; cases: Uint32Array } | null {
  const { cases: named, panels, ofPanels, stresses } = loaded;
  if (!named.some(({ strength }) => strength)) return null;
  const count = panels.subarray(0, ofPanels).reduce((most, panel) => Math.max(most, panel), 0) + 1;
  const shares = new Float32Array(count), cases = new Uint32Array(count);
  for (let k = 0; k < stresses.length; k++) {
    const number = Math.floor(k / panels.length), panel = panels[k % panels.length]!;
    if (k % panels.length >= ofPanels) continue;
    const share = stresses[k]! / (named[number]!.strength ?? NaN);
    if (!(share > shares[panel]!)) continue;
    shares[panel] = share;
    cases[panel] = number;
  }
  return { shares, cases };
}

/** The largest stress of a panel in a case (MPa). */
export function stressOf({ panels, stresses }: Loaded, number: number, panel: number): number {
  const count = panels.length;
  return largest(stresses.subarray(number * count, (number + 1) * count).filter((_, k) => panels[k] === panel));
}

/** Lines (2 L,) round the panels and what stiffens them, and those (2 B,) round the whole sheet: pairs of nodes. */
export function rimsOf(loaded: Loaded): { rims: Uint32Array; border: Uint32Array } {
  return {
    rims: sidesOf(loaded, () => true, (beside) => beside.size > 0),
    border: sidesOf(loaded, (k) => k < loaded.ofPanels, (beside) => beside.size === 1),
  };
}

/** Lines (2 K,) round a panel, or one of what stiffens the sheet. */
export function rimOf(loaded: Loaded, number: number): Uint32Array {
  return sidesOf(loaded, (k) => loaded.panels[k] === number, (beside) => beside.size > 0);
}

/** Sides of some triangles that are wanted by the panels that they are at the rim of. */
function sidesOf({ points, triangles, panels }: Loaded, taken: (triangle: number) => boolean, wanted: (beside: Set<number>) => boolean): Uint32Array {
  const nodes = points.length / 3;
  const within = new Map<number, Set<number>>();
  triangles.forEach((node, corner) => {
    if (!taken(Math.floor(corner / 3))) return;
    const next = triangles[corner - (corner % 3) + ((corner + 1) % 3)]!;
    const code = Math.min(node, next) * nodes + Math.max(node, next);
    const beside = within.get(code) ?? new Set();
    const panel = panels[Math.floor(corner / 3)]!;
    // A side that two triangles of one panel share lies inside it.
    if (!beside.delete(panel)) beside.add(panel);
    within.set(code, beside);
  });
  return Uint32Array.from([...within].filter(([, beside]) => wanted(beside)).flatMap(([code]) => [Math.floor(code / nodes), code % nodes]));
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
