// How a motion ends, in words, and whether panels meet before it should.

import { isEarly } from "../../shared/view.ts";
import { pretty } from "../parts/numbers.ts";
import type { Lock, Report } from "../state/types.ts";

export type Tone = "quiet" | "good" | "bad";

/** What holds a shell, and against what, in a sentence or two. */
export function wordsOfLock(report: Pick<Report, "lock" | "deployment"> | null): [string, Tone] {
  if (!report?.lock) return ["Not verified.", "quiet"];
  const { lock, deployment } = report;
  const contact = lock.first_contact;
  if (contact && isEarly(contact, lock)) {
    const [first, second] = contact.panels.map((panel) => panel.join(","));
    const where = `at drive ${pretty(contact.drive_deg, 4)}° of ${pretty(lock.target_drive_deg, 4)}°`;
    return [`Panels ${first} and ${second} touch first, ${where} (${contact.kind}).`, "bad"];
  }
  const clipped = lock.clipped_contact;
  if (clipped) {
    const [first, second] = clipped.panels.map((panel) => panel.join(","));
    return [`Flaps have no room at the target: panels ${first} and ${second} meet when they are clipped on.`, "bad"];
  }
  const opening = deployment.opening ? ` Held from opening by ${deployment.opening}.` : "";
  return [`${againstClosing(lock, deployment)}: nothing touches on the way, proved.${opening}`, "good"];
}

function againstClosing(lock: Lock, { closing, start, end_drive_deg: end }: Report["deployment"]): string {
  const on =
    lock.cause === "clash"
      ? `closes until panels meet at ${pretty(end, 4)}°`
      : `closes on to ${start === "pack" ? "the pack at " : ""}${pretty(end, 4)}°`;
  const beyond = end > lock.target_drive_deg;
  switch (closing) {
    case "flaps":
      return "Locked against closing by its flaps";
    case "clipped flaps":
      return `Held from closing by flaps clipped on at the target${beyond ? `; without them it ${on}` : besides(lock)}`;
    case "crease":
      return "Held from closing by a crease that is folded flat";
    case "hinges":
      return "Held from closing by its hinges";
    case "boards":
      return "Held from closing by the thickness of its boards";
    case "clash":
      return "Beyond the target panels meet";
    default:
      return `Nothing holds it from closing${beyond ? `; it ${on}` : ""}`;
  }
}

/** What ends the motion at the target, flaps or not. */
function besides({ cause }: Lock): string {
  return cause === "boards" ? ", and by the thickness of its boards" : "";
}
