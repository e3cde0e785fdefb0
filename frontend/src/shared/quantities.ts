// Numbers with their units as people write them, in the design's system of units: as in
// orishell.conventions.quantities.

/** Below so many of the unit a length is written in a smaller one, of which the unit has so many. */
const SMALLER: Record<string, [below: number, unit: string, times: number]> = {
  m: [0.1, "mm", 1000],
  cm: [1, "mm", 10],
  ft: [0.1, "in", 12],
};
/** Lengths below these are none: nobody makes or measures them. */
const LEAST: Record<string, number> = { mm: 0.001, in: 0.0001 };
/** Millimetres of the metric units. */
const METRIC: Record<string, number> = { mm: 1, cm: 10, m: 1000 };
/** Areas from so many square millimetres are written in these units. */
const AREAS: [from: number, unit: string][] = [[1e4, "m"], [100, "cm"], [0, "mm"]];

/** A length of three significant digits with its unit. */
export function length(value: number, unit: string): string {
  const [below, other, times] = SMALLER[unit] ?? [0, unit, 1];
  const small = value !== 0 && Math.abs(value) < below;
  const [size, said] = small ? [value * times, other] : [value, unit];
  const least = LEAST[said] ?? 0;
  if (size !== 0 && Math.abs(size) < least / 2) return `< ${least} ${said}`;
  return said === "unit" ? threeDigits(size) : `${threeDigits(size)} ${said}`;
}

/** An area likewise. */
export function area(value: number, unit: string): string {
  const metric = METRIC[unit];
  if (!metric) return unit === "unit" ? threeDigits(value) : `${threeDigits(value)} ${unit}\u00b2`;
  const square = value * metric ** 2;
  const said = value === 0 ? unit : AREAS.find(([from]) => square >= from)![1];
  return `${threeDigits(square / METRIC[said]! ** 2)} ${said}\u00b2`;
}

/** A number of three significant digits, thousands apart. */
export function threeDigits(value: number): string {
  if (!Number.isFinite(value)) return "-";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e4 ? Math.round(size).toLocaleString("en").replaceAll(",", "\u202f")
    : size >= 100 ? size.toFixed(0) : size < 1e-4 ? size.toExponential(1) : String(Number(size.toPrecision(3)));
  return (value < 0 ? "\u2212" : "") + text.replace("-", "\u2212");
}
