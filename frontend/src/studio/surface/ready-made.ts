// Surfaces to begin with, about as large as a shelter.

import { WIDTHS } from "../curves/curve-words.ts";
import { short } from "../parts/numbers.ts";
import type { SurfaceTable } from "../state/types.ts";

export interface ReadyMade {
  name: string;
  table(unit: string): SurfaceTable;
}

export const READY_MADE: ReadyMade[] = [
  { name: "Dome", table: (unit) => ({ formula: `sqrt(${times(unit, 2, 2)} - x**2 - y**2)`, ...square(unit) }) },
  { name: "Saddle", table: (unit) => ({ formula: `(x**2 - y**2)/${times(unit, 4)}`, ...square(unit) }) },
  { name: "Hyperbolic paraboloid", table: (unit) => ({ formula: `x*y/${times(unit, 2)}`, ...square(unit) }) },
  {
    name: "Piece of a torus",
    table: (unit) => {
      const [ring, tube] = [times(unit, 2), times(unit, 1)];
      const round = `(${ring} + ${tube}*cos(v))`;
      return { formula: [`${round}*cos(u)`, `${round}*sin(u)`, `${tube}*sin(v)`], u: [-0.7, 0.7], v: [-0.7, 0.7] };
    },
  },
];

/** Half the width of an empty plane, times a factor, to a power. */
function times(unit: string, factor: number, power = 1): string {
  return short((factor * half(unit)) ** power, 6);
}

function square(unit: string): Pick<SurfaceTable, "x" | "y"> {
  const size = Number(short(half(unit), 6));
  return { x: [-size, size], y: [-size, size] };
}

function half(unit: string): number {
  return (WIDTHS[unit] ?? 8) / 2;
}
