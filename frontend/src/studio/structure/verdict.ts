// Whether the shell carries its loads, in a line.

import type { Analysis } from "../../shared/api-types.ts";
import { GOVERNING } from "../../shared/api-words.ts";
import { threeDigits } from "../../shared/quantities.ts";
import { capital } from "../../shared/words.ts";

export interface Carries {
  tone: "good" | "bad" | "doubt";
  text: string;
}

export function wordsOfStructure(report: Analysis): Carries {
  const { cases, carries, governs } = report;
  const failing = cases.find((each) => each.carries === false);
  if (failing) {
    const count = cases.filter((each) => each.carries === false).length;
    const [worst] = failing.findings;
    const more = count > 1 ? `; ${count} of ${cases.length} cases fail` : "";
    return { tone: "bad", text: `Fails under ${failing.name}: ${worst?.text ?? "it does not carry its loads"}${more}.` };
  }
  const used = governs ? `: ${threeDigits(100 * governs.utilisation)} % used. ${capital(GOVERNING[governs.part])} governs, under ${governs.case}` : "";
  return carries ? { tone: "good", text: `Carries all cases${used}.` } : { tone: "doubt", text: `Carries its loads as far as is known${used}.` };
}
