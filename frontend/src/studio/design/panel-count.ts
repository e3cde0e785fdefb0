// What rows and columns count, against panels.

/** `flaps`: what the outermost columns of panels are; empty where the sheet has none. */
export function wordsOfSize(rows: number, columns: number, flaps: string): string {
  const down = rows + 1;
  const across = flaps ? columns + 1 : columns - 1;
  if (![down, across].every((count) => Number.isInteger(count) && count > 0)) return "";
  const sheet = `${down} × ${across} = ${down * across} panels`;
  const crossing = `${rows} × ${columns} vertices inside`;
  return flaps
    ? `${crossing} the sheet make ${sheet}; the first and last column are ${flaps}.`
    : `${crossing} a sheet with flaps make ${sheet} without them.`;
}
