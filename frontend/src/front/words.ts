// Differences of values, and names of designs, as they are written.

/** By how much a value differs from another, in percent of that; a word where that says nothing. */
export function difference(value: unknown, other: unknown): string {
  if (JSON.stringify(value) === JSON.stringify(other)) return "same";
  if (typeof value !== "number" || typeof other !== "number" || other === 0) return "differs";
  const share = (100 * (value - other)) / Math.abs(other);
  const size = Math.abs(share);
  const text = size >= 100 ? size.toFixed(0) : size >= 1 ? size.toFixed(1) : String(Number(size.toPrecision(1)));
  return `${share < 0 ? "\u2212" : "+"}${text} %`;
}

export function nameOf(file: string): string {
  return file.replace(/\.toml$/, "");
}
