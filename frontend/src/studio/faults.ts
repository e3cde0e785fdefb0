// Errors of the server: what they say, which control they are about, and what would mend them.

import type { CurveName, Design, Fault, Remedy } from "./types.ts";

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
  limit: "",
  remedies: [],
  searching: false,
};

/** A fault with all fields, from whatever an error answer holds. */
export function faultFrom(partial: Partial<Fault>): Fault {
  const given = Object.entries(partial).filter(([, value]) => value !== null && value !== undefined);
  const fault: Fault = { ...EMPTY, ...Object.fromEntries(given) };
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

/** The design with what a remedy changes. */
export function mended(design: Design, remedy: Remedy): Design {
  const changed = structuredClone(design);
  for (const [place, value] of Object.entries(remedy.changes)) {
    const path = place.split(".");
    const key = path.pop()!;
    let table = changed as unknown as Record<string, unknown>;
    for (const name of path) table = (table[name] ??= {}) as Record<string, unknown>;
    if (key === "formula") for (const other of SOURCES) delete table[other];
    if (value === null) delete table[key];
    else table[key] = value;
  }
  return changed;
}

/** What was found that works, or what limits. */
export function wordsOfRemedies(fault: Fault): string {
  if (fault.searching) return "looking for it…";
  if (fault.limit) return `none: ${fault.limit}`;
  return fault.remedies.map(({ text }) => text).join(", or ");
}

/** Keys of a curve that is no formula. */
const SOURCES = ["points", "smooth", "svg", "id", "dxf", "layer", "handle", "unit", "part", "reverse"];

/** A sentence as a person reads it: a capital first, one full stop last. */
export function sentence(text: string): string {
  const trimmed = text.trim();
  if (!trimmed) return "";
  // Names of keys and curves keep their small letter.
  const first = /^(?:a|[a-z]{2,})[\s,]/.test(trimmed) ? trimmed[0]!.toUpperCase() : trimmed[0]!;
  const whole = first + trimmed.slice(1);
  return /[.!?]$/.test(whole) ? whole : `${whole}.`;
}
