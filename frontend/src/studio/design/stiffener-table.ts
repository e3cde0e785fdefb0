// What the table [stiffeners] of a design says, as the page shows and changes it.

import { short } from "../parts/numbers.ts";
import type { CurveTable } from "../state/types.ts";

type Table = Record<string, unknown>;

export const NONE = "";
/** What a file means that says nothing. */
export const ROWS = "valleys", SHARE = 0.9;
/** Boards as those of panels: no thickness, and no material, of their own. */
export const AS_PANELS = "";
export const GAP = "auto";
const USUAL: Table = { rows: ROWS, columns: 1, share: SHARE, thickness: 0, material: AS_PANELS, gap: GAP, walls: 1 };

/** What box girders are asked for where a number box is empty, and gussets know nothing of. */
export const EMPTY: Table = { share: "auto", columns: "none" };
export const BOXES = "boxes", SKIN = "skin";
/** Keys that every kind has. */
export const KEYS: Record<string, string[]> = {
  gussets: ["rows", "columns", "share", "thickness", "material", "bolts"],
  [BOXES]: ["rows", "columns", "share"],
  [SKIN]: ["gap", "walls"],
};

/** New holes of bolts are so many diameters apart. */
const APART = 10;

/** Bolts with another size: none without holes, at the usual distances where others were not said. */
export function bolted(bolts: unknown, key: string, size: number): Table | undefined {
  const before = (bolts as Table | undefined) ?? {};
  const made: Table = { ...before, [key]: size };
  if (!made["hole"]) return undefined;
  const said = made["spacing"] && (key === "spacing" || made["spacing"] !== apart(before));
  if (!said) made["spacing"] = apart(made);
  if (!made["edge"]) delete made["edge"];
  return made;
}

function apart({ hole }: Table): number {
  return Number((APART * Number(hole)).toPrecision(12));
}

/** The table with another value; none without a kind. What says nothing new is left out. */
export function stiffened(table: Table | undefined, key: string, value: unknown): Table | undefined {
  const { [key]: _, ...others } = table ?? {};
  const kind = key === "kind" ? value : others["kind"];
  const has = KEYS[String(kind)] ?? [];
  const fit = ([name, each]: [string, unknown]) => name === "kind" || (has.includes(name) && (kind === BOXES || each !== EMPTY[name]));
  const rest = Object.fromEntries(Object.entries(others).filter(fit));
  const made = value === undefined || value === USUAL[key] ? rest : { ...rest, [key]: value };
  return made["kind"] ? made : undefined;
}

/** A formula f lowered by a length, for a second skin; null where f is given otherwise. */
export function lowered({ formula, range }: CurveTable, by: number): CurveTable | null {
  if (formula === undefined) return null;
  const below = (y: string): string => `${y} - ${short(by, 2)}`;
  return { formula: Array.isArray(formula) ? [formula[0], below(formula[1])] : below(formula), ...(range ? { range } : {}) };
}

/** Every so many columns have them; null where they are listed. */
export function stepOf(columns: unknown): number | null {
  if (columns === undefined || columns === "all") return 1;
  return typeof columns === "number" ? columns : null;
}
