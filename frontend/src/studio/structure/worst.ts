// The load case under which a shell is worst, of all or of those with one load.

import type { CaseResult, Finding, Load } from "../../shared/api-types.ts";
import { threeDigits } from "../../shared/quantities.ts";
import type { Tone } from "../../shared/verdict.ts";
import type { View } from "../../shared/view.ts";

export interface WorstCase {
  /** As the view names it. */
  name: string;
  sign: Tone;
  /** The largest share of what anything bears, and of what; null if the shell moves, or nothing is known. */
  share: number | null;
  governs: string | null;
  moves: boolean;
  /** What speaks against it, or is in doubt, most; null if nothing does. */
  against: Finding["kind"] | null;
}

/** Of what speaks against a case, what is a share of what is borne. */
const SHARES: readonly (Finding["kind"] | null)[] = [null, "exceeds strength", "buckles"];

/** How much of what it bears a shell uses, or what else speaks against it, in a word. */
export function wordsOfWorst({ share, against }: WorstCase): string {
  if (share !== null && SHARES.includes(against)) return `${threeDigits(100 * share)} %`;
  return against === null || against === "unknown" ? "not known" : against;
}

const SIGNS: readonly Tone[] = ["fails", "warns", "holds"];

/** Null if nothing was analysed, or no case has the load. */
export function worstCase({ loaded, header }: View, kind?: Load["kind"]): WorstCase | null {
  const cases = header.report.structure?.cases ?? [];
  // Both have the same cases, in the same order.
  const found = cases.flatMap((each, k) => {
    const name = loaded?.cases[k]?.name;
    return name !== undefined && (!kind || each.loads.some((load) => load.kind === kind)) ? [judgedCase(each, name)] : [];
  });
  const size = ({ share, moves }: WorstCase): number => (moves ? Infinity : share ?? 0);
  return found.sort((one, other) => SIGNS.indexOf(one.sign) - SIGNS.indexOf(other.sign) || size(other) - size(one))[0] ?? null;
}

function judgedCase({ carries, equilibrium, findings }: CaseResult, name: string): WorstCase {
  const used = equilibrium?.utilisation;
  const governs = used?.governs ?? null;
  const sign = carries === null ? "warns" : carries ? "holds" : "fails";
  return { name, sign, governs, share: governs && used![governs], moves: !equilibrium, against: findings[0]?.kind ?? null };
}
