// The table [search] of a design: what may change, and what is to be small; without the page.

import { changed } from "../state/changed.ts";
import type { Design, Limit, SearchTable, Value, Variable } from "../state/types.ts";

/** Designs that are made, at most, until another number is asked for. */
export const DESIGNS = 100;
const LEAVES = ["low", "high", "step", "least", "most"];

/** The table of a design as the page has it: keys joined by dots; null if it has none. */
export function searchOf(design: Design): SearchTable | null {
  const { search } = design;
  if (!search) return null;
  const { variables = {}, subject_to: limits, ...rest } = search;
  const table = { ...rest, minimise: search.minimise ?? [], variables: joined(variables) as SearchTable["variables"] };
  return limits ? { ...table, subject_to: joined(limits) as Record<string, Limit> } : table;
}

/** Keys without quotes, which TOML takes for tables within each other. */
function joined(table: object, head = ""): Record<string, unknown> {
  return Object.fromEntries(
    Object.entries(table).flatMap(([name, value]) => {
      const key = head + name;
      const inner = typeof value === "object" && value !== null && !Array.isArray(value);
      return inner && !LEAVES.some((leaf) => leaf in value) ? Object.entries(joined(value, `${key}.`)) : [[key, value]];
    }),
  );
}

/** What is still missing before there is something to search for, in words; empty if nothing is. */
export function lacking({ variables, minimise, subject_to: limits = {} }: SearchTable): string {
  const allowed = Object.values(variables);
  if (!allowed.length) return "Nothing may change yet: add what may.";
  if (!minimise.length) return "Choose at least one figure to minimise.";
  const bad = allowed.some((each) => (Array.isArray(each) ? !each.length : !(each.low < each.high)));
  if (bad) return "A range needs a low end below its high end, a list at least one value.";
  if (allowed.some((each) => Array.isArray(each) && new Set(each).size < each.length)) return "Values of a list differ.";
  const empty = Object.values(limits).some(({ least = -Infinity, most = Infinity }) => least > most);
  return empty ? "A limit has its least above its most." : "";
}

/** How many designs there are to choose from; infinite where a number may be any. */
export function countOf(variables: SearchTable["variables"], isWhole: (key: string) => boolean): number {
  return Object.entries(variables).reduce((count, [key, each]) => count * sizeOf(each, isWhole(key)), 1);
}

function sizeOf(each: Variable, whole: boolean): number {
  if (Array.isArray(each)) return each.length;
  const step = each.step ?? (whole ? 1 : 0);
  return step ? Math.floor((each.high - each.low) / step + 1e-9) + 1 : Infinity;
}

/** What stands at a key of a design. */
export function valueAt(design: Design, key: string): unknown {
  return key.split(".").reduce<unknown>((at, name) => (at as Record<string, unknown> | undefined)?.[name], design);
}

/** Whether a design has certain values. */
export function hasValues(design: Design, values: Record<string, unknown>): boolean {
  return Object.entries(values).every(([key, value]) => JSON.stringify(valueAt(design, key)) === JSON.stringify(value));
}

/** What a search is about: designs that differ in what may change only are the same here. */
export function keyOf(design: Design, variables: string[]): string {
  return JSON.stringify(sorted(changed(design, { search: null, ...Object.fromEntries(variables.map((key) => [key, 0])) })));
}

function sorted(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(sorted);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, each]) => [key, sorted(each)]));
}

/** Values between commas: numbers where all are. */
export function listed(text: string): Value[] {
  const words = text.split(",").map((word) => word.trim()).filter(Boolean);
  const numbers = words.map(Number);
  if (numbers.every(Number.isFinite)) return numbers;
  return words.map((word) => (word === "true" ? true : word === "false" ? false : word));
}
