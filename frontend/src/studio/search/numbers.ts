// What of a design may change in a search, and within which ends; without the page.

import { short } from "../parts/numbers.ts";
import type { Labels } from "../state/labels.ts";
import type { Design, Parameter, Ranges, Report, SearchTable, Value, Variable } from "../state/types.ts";
import { DESIGNS } from "./table.ts";

export interface Candidate {
  /** Of the design file, its tables in front of it. */
  key: string;
  label: string;
  section: string;
  allowed: Variable;
}

/** Tables that are looked at by themselves, or whose numbers nobody chooses: loads are what they are. */
const APART = ["shell", "pattern", "target", "motion", "workshop", "search", "load_case"];
/** Numbers of a curve that stand in it, or may. */
const OF_CURVE = ["scale", "range", "part"];
/** Share by which a number may change of which nothing else is known. */
const SHARE = 0.25;
/** Steps by which a whole number may change at least. */
const STEPS = 2;

/** All that may change in a design. */
export function candidates(design: Design, parameters: Parameter[], ranges: Ranges, report: Report | null, labels: Labels): Candidate[] {
  const found = new Map<string, Variable>();
  for (const parameter of parameters) {
    const { key, kind, choices } = parameter;
    if (design.tolerance && (key === "rows" || key === "columns")) continue;
    if (kind === "choice") found.set(`pattern.${key}`, choices);
    const value = [design.pattern[key], report?.parameters[key], parameter.default].find((each) => typeof each === "number");
    if (typeof value !== "number") continue;
    if (kind === "integer") found.set(`pattern.${key}`, around(value, parameter));
    if (kind === "number") found.set(`pattern.${key}`, within(value, ranges[key]?.intervals));
  }
  for (const curve of ["f", "g"] as const) {
    if (!design.target?.[curve]) continue;
    const table: Record<string, unknown> = { scale: 1, ...design.target[curve] };
    for (const key of OF_CURVE) addNumbers(found, `target.${curve}.${key}`, table[key]);
  }
  const tables = Object.entries(design).filter(([name]) => !APART.includes(name));
  for (const [name, table] of [["pattern", design.pattern] as const, ...tables]) addNumbers(found, name, table);
  return [...found].map(([key, allowed]) => ({ key, allowed, label: labels.place(key), section: labels.section(key) }));
}

function addNumbers(found: Map<string, Variable>, key: string, value: unknown): void {
  if (typeof value === "number") {
    if (!found.has(key)) found.set(key, within(value));
  } else if (typeof value === "object" && value !== null) {
    for (const [name, each] of Object.entries(value)) if (!/^pattern.(rows|columns)$/.test(`${key}.${name}`)) addNumbers(found, `${key}.${name}`, each);
  }
}

/** The interval that works in which a value lies, or about a quarter to either side. */
function within(value: number, intervals: [number, number][] = []): Variable {
  const around: [number, number] = value ? [value - SHARE * Math.abs(value), value + SHARE * Math.abs(value)] : [0, 1];
  const [low, high] = intervals.find(([from, to]) => from <= value && value <= to && from < to) ?? around;
  return { low: Number(short(low, 4)), high: Number(short(high, 4)) };
}

function around(value: number, { slider = [0, 1], step = 1 }: Parameter): Variable {
  const [least, most] = slider;
  if (most - least <= STEPS) return { low: least, high: most };
  const count = Math.max(STEPS, Math.round((SHARE * value) / step));
  const low = value - step * Math.min(count, Math.floor((value - least) / step));
  return { low, high: Math.max(Math.min(value + step * count, most), low + step), ...(step === 1 ? {} : { step }) };
}

/** What is searched for in a design that does not say it. */
export function suggestion(from: Candidate[]): SearchTable {
  const sizes = ["pattern.rows", "pattern.columns"];
  const offered = from.filter(({ key }) => sizes.includes(key));
  const chosen = offered.length ? offered : from.filter(({ key }) => key === "tolerance.surface");
  return {
    variables: Object.fromEntries(chosen.map(({ key, allowed }) => [key, allowed])),
    minimise: ["panels", "deviation"],
    evaluations: DESIGNS,
  };
}

/** A range as a list, or a list as a range. */
export function otherwise(allowed: Variable, from: Candidate | undefined): Variable {
  if (!Array.isArray(allowed)) {
    const { low, high, step = (high - low) / 2 } = allowed;
    const count = Math.min(Math.floor((high - low) / step + 1e-9), 20);
    return Array.from({ length: count + 1 }, (_, k) => Number(short(low + k * step)));
  }
  if (from && !Array.isArray(from.allowed)) return from.allowed;
  const numbers = allowed.filter((each): each is number => typeof each === "number");
  return numbers.length > 1 ? { low: Math.min(...numbers), high: Math.max(...numbers) } : allowed;
}

/** Whether a list may become a range. */
export function isNumeric(values: Value[]): boolean {
  return values.length > 1 && values.every((each) => typeof each === "number");
}
