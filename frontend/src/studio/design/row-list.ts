// Rows of a sheet as they are typed: "2, 4, 6".

/** The numbers in a text; null where it has anything else, or one of them twice. */
export function rowsIn(text: string): number[] | null {
  const typed = text.split(/[\s,;]+/).filter(Boolean);
  if (!typed.every((each) => /^\d+$/.test(each))) return null;
  const rows = typed.map(Number);
  return new Set(rows).size === rows.length ? rows : null;
}

export function listed(rows: unknown): string {
  return Array.isArray(rows) ? rows.join(", ") : "";
}

/** Ties across folds: at some rows, or at all of them where none is named. */
export function tiesAt(rows: number[]): "folds" | { folds: number[] } {
  return rows.length ? { folds: rows } : "folds";
}
