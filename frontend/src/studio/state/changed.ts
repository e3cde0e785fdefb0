// The one way in which the page changes a design: values by key, as `DesignFile.changed` takes them.

import type { Design } from "./types.ts";

/** The design with other values at some keys, the tables in front of them; null or undefined removes
 * a key. What does not change is the same as before. */
export function changed(design: Design, values: Record<string, unknown>): Design {
  let tables: unknown = design;
  for (const [key, value] of Object.entries(values)) tables = replaced(tables, key.split("."), value ?? undefined);
  return tables as Design;
}

function replaced(tables: unknown, [first, ...rest]: string[], value: unknown): unknown {
  if (first === undefined) return value;
  const copy = (Array.isArray(tables) ? [...tables] : { ...(tables as object) }) as Record<string, unknown>;
  if (value === undefined && !rest.length) delete copy[first];
  else copy[first] = replaced(copy[first], rest, value);
  return copy;
}

/** A table with what it has; none where nothing is left in it. */
export function tableOf(table: Record<string, unknown>): Record<string, unknown> | undefined {
  const given = Object.entries(table).filter(([, value]) => value !== undefined);
  return given.length ? Object.fromEntries(given) : undefined;
}
