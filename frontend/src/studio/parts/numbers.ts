// Numbers as the studio writes them.

/** At most six significant digits, without trailing zeros. */
export function short(value: number, digits = 6): string {
  if (!Number.isFinite(value)) return "";
  return String(Number(value.toPrecision(digits)));
}

/** With a real minus sign, for reading. */
export function pretty(value: number, digits = 6): string {
  return short(value, digits).replace("-", "\u2212");
}

/** Round to the place where a step counts. */
export function roundTo(value: number, step: number): number {
  const places = Math.max(0, 1 - Math.floor(Math.log10(step)));
  return Number(value.toFixed(Math.min(places, 12)));
}

/** 1, 2 or 5 times a power of ten, not below the value. */
export function niceAbove(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  for (const nice of [1, 2, 5]) if (lead <= nice * (1 + 1e-9)) return nice * power;
  return 10 * power;
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}
