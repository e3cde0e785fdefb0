// Errors of the server: what they say, which control they are about, and what would mend them.

import type { Refusal, RefusedDrawing } from "../../shared/api-types.ts";
import type { CurveName, Curves, Fault, Remedy } from "./types.ts";

/** An answer that is not what was asked for. */
export class ServerFault extends Error {
  constructor(
    readonly fault: Fault,
    /** Of a design that is refused, what can be drawn all the same. */
    readonly curves: Curves | null = null,
    readonly drawing: RefusedDrawing | null = null,
  ) {
    super(fault.message);
  }
}

/** What the server refuses. */
export function refusalOf({ error, curves, drawing }: Refusal): ServerFault {
  return new ServerFault({ ...error, searching: false }, curves ?? null, drawing ?? null);
}

/** What the page finds wrong itself. */
export function ownFault(kind: Fault["kind"], what: string, remedy = ""): Fault {
  return {
    kind, what, remedy, message: what,
    where: "", keys: [], got: "", expected: "", detail: "", place: "", size: "", limit: "",
    remedies: [], searching: false,
  };
}

/** The fault behind whatever was thrown. */
export function faultOf(error: unknown): Fault {
  return error instanceof ServerFault ? error.fault : ownFault("page", String(error));
}

/** The server cannot be reached, or a request was broken off. */
export function unreachable(): ServerFault {
  const remedy = "see whether `orishell studio` still runs; your design is kept in this page";
  return new ServerFault(ownFault("network", "The studio does not answer", remedy));
}

/** The studio has another key than this page: asked again, as the browser may be given it meanwhile. */
export function lockedOut(): ServerFault {
  const remedy = "open the address that it printed; your design is kept in this page, which then goes on";
  return new ServerFault(ownFault("network", "The studio was started anew, with another key", remedy));
}

/** The keys of the table [pattern] that a fault is about. */
export function patternKeysOf(fault: Fault | null): string[] {
  const keys = fault?.keys.filter((key) => key.startsWith("pattern.")) ?? [];
  return keys.map((key) => key.slice("pattern.".length));
}

/** Whether a fault is about a curve. */
export function isAbout(fault: Fault | null, curve: CurveName): boolean {
  return fault?.keys.some((key) => `${key}.`.startsWith(`target.${curve}.`)) ?? false;
}

/** Whether a fault is about the target surface. */
export function isAboutSurface(fault: Fault | null): boolean {
  return fault?.keys.some((key) => `${key}.`.startsWith("target.surface.")) ?? false;
}

/** What was found that works, or what limits. */
export function wordsOfRemedies(fault: Fault, words: (remedy: Remedy) => string): string {
  if (fault.searching) return "looking for it…";
  if (fault.limit) return `none: ${fault.limit}`;
  return fault.remedies.map(words).join(", or ");
}
