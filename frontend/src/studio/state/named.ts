// A design with its name, and where it is kept.

import { handlesIn } from "../curves/curve-table.ts";
import type { Design } from "./types.ts";

/** A design and the name of its file. */
export interface Named {
  name: string;
  design: Design;
}

/** What an opened design and all later versions of it share. */
export interface Home {
  /** The design as it is in a file: as it was opened or saved last; null where it is in none. */
  file: Named | null;
  /** Where the browser keeps it (kept.ts), and what was kept there last. */
  slot: string | null;
  text: string;
}

/** A design as it was opened, or as it became since. */
export interface Work extends Named {
  readonly home: Home;
}

/** What is no work yet is as it is in a file, or in a link. */
export function workOf(opened: Named | Work): Work {
  return "home" in opened ? opened : { ...opened, home: { file: opened, slot: null, text: "" } };
}

/** Whether a design is in no file, or in one of another name. */
export function isUnsaved({ name, design, home }: Work): boolean {
  return !Object.is(home.file?.design, design) || home.file?.name !== name;
}

/** What was read, if it is a design with its name; throws where the points of a curve are none. */
export function namedOf(value: unknown): Named | null {
  const found = value as Partial<Named> | null;
  const design = found?.design as Partial<Design> | undefined;
  if (typeof found?.name !== "string" || typeof design?.shell?.family !== "string") return null;
  const { pattern, target } = design;
  if (!isTable(pattern) || (target !== undefined && !isTable(target))) return null;
  if (!target) return { name: found.name, design: design as Design };
  const { f, g, surface, pattern: drawn } = target;
  const other = surface ?? drawn;
  if (other === undefined ? ![f, g].every(isTable) : !isTable(other)) return null;
  for (const table of [f, g]) if (table) handlesIn(table);
  return { name: found.name, design: design as Design };
}

function isTable(value: unknown): boolean {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
