// Errors of the server: what they say, which control they are about, and what would mend them.

import type { CurveName, Design, Fault, Value } from "./types.ts";

/** An answer that is not what was asked for. */
export class ServerFault extends Error {
  constructor(
    readonly fault: Fault,
    readonly status: number,
    readonly body: unknown = null,
  ) {
    super(fault.message);
  }
}

const EMPTY: Fault = {
  kind: "",
  message: "",
  what: "",
  where: "",
  got: "",
  expected: "",
  remedy: "",
  place: "",
  size: "",
  nearest: "",
};

/** A fault with all fields, from whatever an error answer holds. */
export function faultFrom(partial: Partial<Fault>): Fault {
  const fault = { ...EMPTY, ...partial };
  for (const key of Object.keys(fault) as (keyof Fault)[]) fault[key] ??= "";
  if (!fault.what) fault.what = fault.message;
  return fault;
}

/** The server cannot be reached, or a request was broken off. */
export function unreachable(): Fault {
  return faultFrom({
    kind: "network",
    what: "The studio does not answer",
    message: "The studio does not answer.",
    remedy: "see whether `orishell studio` still runs; your design is kept in this page",
  });
}

/** The control that a fault is about. */
export type Place =
  | { table: "pattern" | "tolerance" | "shell" | "motion" | "workshop"; keys: string[] }
  | { table: "target"; curve: CurveName; keys: string[] };

/** Find tables and keys in a fault's `where`, as in "design: [pattern] xi_deg"; if it has none,
 * keys that `what` gives values of, as in "xi_deg = 170 is too large". */
export function placeOf(fault: Fault): Place | null {
  if (!fault.where) {
    const keys = [...fault.what.matchAll(/\b([a-z]+(?:_[a-z0-9]+)*) = /g)].map((found) => found[1]!);
    return keys.length ? { table: "pattern", keys } : null;
  }
  const found = /\[(target\.([fg])|target|pattern|tolerance|shell|motion|workshop)\]\s*([\w, .]*)/.exec(
    fault.where,
  );
  if (!found) return null;
  const keys = (found[3] ?? "").split(/[,\s]+/).filter(Boolean);
  if (found[1]!.startsWith("target")) {
    const curve = (found[2] ?? keys.shift()?.charAt(0)) as CurveName | undefined;
    return curve === "f" || curve === "g" ? { table: "target", curve, keys } : null;
  }
  return { table: found[1] as "pattern", keys };
}

export interface Remedy {
  label: string;
  apply(design: Design): Design;
}

const NUMBER = String.raw`-?\d[\d.]*(?:e[+-]?\d+)?`;
const END = String.raw`(?=, or |,|$)`;
const SET = new RegExp(
  String.raw`^(\w+) = (${NUMBER}|"[\w-]+"|\[[^\]]*\])(?: in \[target\.([fg])\])?(?: with (\w+) = (${NUMBER}|"[\w-]+"))?${END}`,
);
const BELOW = new RegExp(String.raw`^(\w+) below (${NUMBER})(?: with (\w+) = (${NUMBER}|"[\w-]+"))?${END}`);
const BETWEEN = new RegExp(String.raw`^(\w+) between (${NUMBER}) and (${NUMBER})${END}`);
const TIMES = new RegExp(String.raw`^scale in \[target\.([fg])\] times (${NUMBER})`);
const PART = new RegExp(String.raw`^the part of ([fg]) from parameter (${NUMBER}) to (${NUMBER})`);
/** An open limit is kept clear of by this share. */
const CLEAR = 0.01;

/** The first remedy that a fault's `nearest` names, if the design can take it as it stands. */
export function remedyOf(fault: Fault, design: Design, known: readonly string[]): Remedy | null {
  const text = fault.nearest.trim();
  const part = PART.exec(text);
  if (part) {
    const name = part[1] as CurveName;
    if (design.target[name].formula === undefined) return null;
    return setting("range", [Number(part[2]), Number(part[3])], `${name} from ${part[2]} to ${part[3]}`, name);
  }
  const times = TIMES.exec(text);
  if (times) {
    const name = times[1] as CurveName;
    const scale = Number(((design.target[name].scale ?? 1) * Number(times[2])).toPrecision(6));
    return setting("scale", scale, `scale = ${scale} for ${name}`, name);
  }
  const set = SET.exec(text);
  if (set) {
    const value = valueOf(set[2]!);
    if (value === undefined) return null;
    const label = set[3] ? `${set[1]} = ${set[2]} for ${set[3]}` : `${set[1]} = ${set[2]}`;
    return joined(settingOf(set[1]!, value, label, set[3] as CurveName | undefined, known), set[4], set[5], known);
  }
  const below = BELOW.exec(text);
  if (below) {
    const limit = Number(below[2]);
    const value = Number((limit - CLEAR * Math.abs(limit)).toPrecision(4));
    const first = settingOf(below[1]!, value, `${below[1]} = ${value}`, undefined, known);
    return joined(first, below[3], below[4], known);
  }
  const between = BETWEEN.exec(text);
  if (between) {
    const [key, low, high] = [between[1]!, Number(between[2]), Number(between[3])];
    const clear = CLEAR * (high - low);
    const now = Number(design.pattern[key]);
    const inside = Math.min(Math.max(Number.isFinite(now) ? now : low, low + clear), high - clear);
    const value = Number(inside.toPrecision(5));
    return settingOf(key, value, `${key} = ${value}`, undefined, known);
  }
  return null;
}

function settingOf(
  key: string,
  value: Value,
  label: string,
  curve: CurveName | undefined,
  known: readonly string[],
): Remedy | null {
  if (curve) return setting(key, value, label, curve);
  if (TOLERANCES.includes(key)) return setting(key, value, label, "tolerance");
  return known.includes(key) ? setting(key, value, label, "pattern") : null;
}

const TOLERANCES = ["surface", "panel_min", "panel_max"];

function setting(
  key: string,
  value: Value,
  label: string,
  table: CurveName | "pattern" | "tolerance",
): Remedy {
  return {
    label,
    apply: (design) => {
      if (table === "pattern") return { ...design, pattern: { ...design.pattern, [key]: value } };
      if (table === "tolerance") {
        return design.tolerance ? { ...design, tolerance: { ...design.tolerance, [key]: value } } : design;
      }
      const changed = { ...design.target[table], [key]: value };
      return { ...design, target: { ...design.target, [table]: changed } };
    },
  };
}

/** A remedy "with" another key: both, or none if the other is not known. */
function joined(
  first: Remedy | null,
  key: string | undefined,
  written: string | undefined,
  known: readonly string[],
): Remedy | null {
  if (!first || !key || written === undefined) return first;
  const value = valueOf(written);
  const second = value === undefined ? null : settingOf(key, value, `${key} = ${written}`, undefined, known);
  return second && {
    label: `${first.label} with ${second.label}`,
    apply: (design) => second.apply(first.apply(design)),
  };
}

function valueOf(text: string): Value | undefined {
  const list = /^\[(.*)\]$/.exec(text);
  if (list) {
    const numbers = list[1]!.split(",").map(Number);
    return numbers.every(Number.isFinite) ? numbers : undefined;
  }
  if (text.startsWith('"')) return text.slice(1, -1);
  const number = Number(text);
  return Number.isFinite(number) ? number : undefined;
}

/** A sentence as a person reads it: a capital first, one full stop last. */
export function sentence(text: string): string {
  const trimmed = text.trim();
  if (!trimmed) return "";
  // Names of keys and curves keep their small letter.
  const first = /^(?:a|[a-z]{2,})[\s,]/.test(trimmed) ? trimmed[0]!.toUpperCase() : trimmed[0]!;
  const whole = first + trimmed.slice(1);
  return /[.!?]$/.test(whole) ? whole : `${whole}.`;
}
