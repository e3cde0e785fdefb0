// Where a motion stops: its named states, and the way through them when it is played.

import { type Contact, drives, isEarly, numberOf, type View } from "./view.ts";

export interface Stop {
  name: "flat" | "target" | "pack";
  label: string;
  /** Of the way from the first drive to the last. */
  share: number;
}

/** Share of the way from the first drive to the last; drives may descend. */
export function shareOf(drives: ArrayLike<number>, drive: number): number {
  const first = drives[0]!, last = drives[drives.length - 1]!;
  return last === first ? 1 : (drive - first) / (last - first) + 0;  // not -0
}

/** The named states in the order of the motion; of a sheet without names its first and last. */
export function stopsOf(view: View): Stop[] {
  const { named, report } = view.header;
  const all = drives(view);
  const numbers = Object.keys(named).length ? named : { flat: 0, target: Math.max(0, all.length - 1) };
  const { lock, deployment } = report;
  // Until the proof says what ends the motion, flaps of the sheet are to.
  const locked = lock ? lock.cause === "flaps" : deployment?.flap_attachment === "folded";
  const target = named["target"] === undefined ? "Folded" : locked ? "Locked" : "Target";
  const labels = { flat: "Flat", target, pack: "Pack" };
  return (["pack", "flat", "target"] as const)
    .filter((name) => numbers[name] !== undefined)
    .map((name) => ({ name, label: labels[name], share: shareOf(all, all[numbers[name]!]!) }))
    .sort((one, other) => one.share - other.share);
}

/** Where panels touch that are not meant to: before the target, or where that ends the motion. */
export function contactOf(view: View): Contact | null {
  const { contact, grid, report } = view.header;
  if (contact && isEarly(contact, report.lock)) return contact;
  const first = report.lock?.first_contact;
  if (!first || !grid || !(report.lock!.cause === "clash" || report.lock!.cause === "boards")) return null;
  return { drive_deg: first.drive_deg, panels: [numberOf(view, first.panels[0]), numberOf(view, first.panels[1])] };
}

/** Stops nearer to each other than this share are one. */
const APART = 0.004;

/** Shares at which the motion rests: its named states, and where panels touch. */
export function restsOf(view: View): number[] {
  const shares = stopsOf(view).map(({ share }) => share);
  const contact = contactOf(view);
  const at = contact && Math.min(1, Math.max(0, shareOf(drives(view), contact.drive_deg)));
  if (at !== null && shares.every((share) => Math.abs(share - at) > APART)) shares.push(at);
  return shares.sort((one, other) => one - other);
}

/** The next rest from a share, forwards or backwards; the end if there is none. */
export function nextRest(rests: number[], share: number, forwards: boolean): number {
  const found = forwards ? rests.find((each) => each > share + 1e-6) : rests.findLast((each) => each < share - 1e-6);
  return found ?? (forwards ? 1 : 0);
}

/** A share moved on, but over no rest. */
export function stepped(rests: number[], share: number, by: number): number {
  const wanted = Math.min(1, Math.max(0, share + by));
  const next = nextRest(rests, share, by > 0);
  return by > 0 ? Math.min(wanted, next) : Math.max(wanted, next);
}

/** The rest within reach of a share that is dragged to; else that share. */
export function caught(rests: number[], share: number, reach: number): number {
  return rests.find((each) => Math.abs(each - share) < reach) ?? share;
}

/** Share of the target: where overlays and distances belong, and what is shown first. */
export function targetShare(stops: Stop[]): number {
  return stops.find(({ name }) => name === "target")?.share ?? 1;
}

/** Where another shell is in its motion while the first is at a share of its own: at flat, target and
 * pack both are together. */
export function together(first: readonly Stop[], other: readonly Stop[], share: number): number {
  if (first.map(({ name }) => name).join() !== other.map(({ name }) => name).join()) return share;
  const k = Math.max(1, first.findIndex((stop, number) => number > 0 && share <= stop.share));
  const from = first[k - 1], to = first[k];
  if (!from || !to) return share;
  const part = shareOf([from.share, to.share], share);
  return other[k - 1]!.share + part * (other[k]!.share - other[k - 1]!.share);
}

export function shareTogether(first: View, other: View, share: number): number {
  return together(stopsOf(first), stopsOf(other), share);
}

/** From what to what the motion goes, in words. */
export function wayOf(stops: Stop[]): string {
  const [first, ...others] = stops.map(({ label }) => label.toLowerCase());
  const last = others.pop();
  return `Fold, from ${first} ${others.map((each) => `over ${each} `).join("")}to ${last}`;
}

/** Of a short way between two stops this part of the whole time is taken all the same. */
const LEAST = 0.3;
/** Rest at a stop on the way, as a part of the whole time. */
const REST = 0.12;

/** A motion that is played: slow at every stop, with a rest at those on its way. */
export class Journey {
  /** The time that it takes, about 1. */
  readonly length: number;
  private readonly legs: { from: number; to: number; start: number; time: number }[] = [];

  constructor(stops: Pick<Stop, "share">[]) {
    let start = 0;
    for (let k = 1; k < stops.length; k++) {
      const from = stops[k - 1]!.share, to = stops[k]!.share;
      const time = Math.max(LEAST, to - from);
      this.legs.push({ from, to, start, time });
      start += time + REST;
    }
    this.length = Math.max(0, start - REST);
  }

  shareAt(time: number): number {
    const leg = this.legs.findLast((each) => each.start <= time) ?? this.legs[0];
    if (!leg) return 1;
    const part = Math.min(1, Math.max(0, (time - leg.start) / leg.time));
    return leg.from + (leg.to - leg.from) * (0.5 - 0.5 * Math.cos(Math.PI * part));
  }

  /** When a share is passed; when a stop is left. */
  timeOf(share: number): number {
    const leg = this.legs.findLast((each) => each.from <= share) ?? this.legs[0];
    if (!leg) return 0;
    const whole = leg.to - leg.from;
    const part = whole > 0 ? Math.min(1, Math.max(0, (share - leg.from) / whole)) : 0;
    return leg.start + (leg.time * Math.acos(1 - 2 * part)) / Math.PI;
  }
}

/** Number of the frame nearest to a share, of so many frames spread over the stops. */
export function frameAt(stops: Stop[], share: number, frames: number): number {
  const last = frames - 1;
  const at = stops.map((stop, k) =>
    k === 0 ? 0 : k === stops.length - 1 ? last : Math.min(last - 1, Math.max(1, Math.round(stop.share * last))),
  );
  const k = Math.max(1, stops.findIndex((stop, number) => number > 0 && share <= stop.share));
  const from = stops[k - 1]!.share, to = stops[k]!.share;
  const part = to > from ? (share - from) / (to - from) : 0;
  return Math.round(at[k - 1]! + part * (at[k]! - at[k - 1]!));
}
