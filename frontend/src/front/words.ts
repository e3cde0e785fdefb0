// Values and their differences, as they are written.

/** A number of four digits; anything else as the design file has it. */
export function written(value: unknown): string {
  if (typeof value === "string") return value;
  if (typeof value !== "number") return JSON.stringify(value);
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return value.toExponential(2).replaceAll("-", "\u2212");
  const text = size >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(4)));
  return text.replace("-", "\u2212");
}

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
