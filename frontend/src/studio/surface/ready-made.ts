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
    name: "Vault",
    table: (unit) => {
      const { x } = square(unit);
      return { formula: ["u", `${times(unit, 1)}*sin(v)`, `${times(unit, 1)}*cos(v)`], u: x!, v: [-1.2, 1.2] };
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
