// How a motion ends, in words, and whether panels meet before it should.

import type { Contact } from "../shared/view.ts";
import { pretty } from "./numbers.ts";
import type { LockReport, Verified } from "./types.ts";

export type Tone = "quiet" | "good" | "bad";

/** Drives nearer to the target than this are the target (degrees). */
const SAME = 1e-6;

/** The first contact, if it comes before the target: flaps that meet at lock are meant to. */
export function earlyContact({ report, contact }: Verified): Contact | null {
  return contact && isEarly(contact.drive_deg, report.lock) ? contact : null;
}

function isEarly(drive: number, lock: LockReport): boolean {
  return drive < lock.target_drive_deg - SAME;
}

/** What a lock means, in a sentence. */
export function wordsOfLock(lock: LockReport | undefined): [string, Tone] {
  if (!lock) return ["Not verified.", "quiet"];
  const contact = lock.first_contact;
  if (contact && isEarly(contact.drive_deg, lock)) {
    const [first, second] = contact.panels.map((panel) => panel.join(","));
    const where = `at drive ${pretty(contact.drive_deg, 4)}° of ${pretty(lock.target_drive_deg, 4)}°`;
    return [`Panels ${first} and ${second} touch first, ${where} (${contact.kind}).`, "bad"];
  }
  const proved = "nothing touches before lock: proved";
  switch (lock.cause) {
    case "flaps":
      return [`Locks by its flaps; ${proved}.`, "good"];
    case "crease":
      return [`A crease folded flat ends the motion; ${proved}.`, "good"];
    case "clash":
      return ["Nothing touches before the target: proved. Beyond it panels meet.", "good"];
    default:
      return ["Nothing touches on the way: proved. Nothing locks it either.", "good"];
  }
}
