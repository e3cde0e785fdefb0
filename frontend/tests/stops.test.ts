import { expect, test } from "vitest";

import type { Header, View } from "../src/shared/view.ts";
import { isEarly, targetPoints } from "../src/shared/view.ts";
import { frameAt, Journey, stopsOf, targetShare, wayOf } from "../src/shared/stops.ts";
import { Motion } from "../src/shared/rigid.ts";
import { decodeView } from "../src/shared/view.ts";
import type { Report } from "../src/studio/state/types.ts";
import scipy from "./motion.json";

function viewOf(drives_deg: number[], named: Record<string, number>, report: object = {}): View {
  return { header: { drives_deg, named, report } as Partial<Header> } as View;
}

const pack = viewOf([180, 135, 90, 60, 30, 0], { pack: 0, target: 2, flat: 5 }, { lock: { cause: "crease" } });
const flat = viewOf([0, 60, 120], { flat: 0, target: 2 }, { lock: { cause: "flaps" } });

test("stops are the named states, where their drives are", () => {
  expect(stopsOf(pack).map(({ label, share }) => [label, share])).toEqual([["Pack", 0], ["Target", 0.5], ["Flat", 1]]);
  expect(stopsOf(flat).map(({ label, share }) => [label, share])).toEqual([["Flat", 0], ["Locked", 1]]);
  expect(targetShare(stopsOf(pack))).toBe(0.5);
  expect(targetShare(stopsOf(flat))).toBe(1);
  expect(wayOf(stopsOf(pack))).toBe("Fold, from pack over target to flat");
  expect(wayOf(stopsOf(flat))).toBe("Fold, from flat to locked");
});

test("a sheet without names goes from its first state to its last", () => {
  expect(stopsOf(viewOf([0, 50], {})).map(({ label, share }) => [label, share])).toEqual([["Flat", 0], ["Folded", 1]]);
  expect(targetShare(stopsOf(viewOf([], {})))).toBe(1);
});

test("until the proof, flaps of the sheet are to lock it", () => {
  const label = (attached: string | null) =>
    stopsOf(viewOf([0, 90], { flat: 0, target: 1 }, { deployment: { flap_attachment: attached } }))[1]!.label;
  expect([label("folded"), label("clipped"), label(null)]).toEqual(["Locked", "Target", "Target"]);
});

test("frames are spread over the stops as the motion's are", () => {
  const shares = [0, 0.1, 0.49, 0.5, 0.51, 0.99, 1];
  expect(shares.map((share) => frameAt(stopsOf(pack), share, 25))).toEqual([0, 2, 12, 12, 12, 24, 24]);
  expect(shares.map((share) => frameAt(stopsOf(flat), share, 11))).toEqual([0, 1, 5, 5, 5, 10, 10]);
  // However near a stop is to an end, it has a frame of its own.
  const late = stopsOf(viewOf([100, 1, 0], { pack: 0, target: 1, flat: 2 }));
  expect([0, 0.99, 1].map((share) => frameAt(late, share, 3))).toEqual([0, 1, 2]);
});

test("a motion that is played rests at its target", () => {
  for (const view of [pack, flat]) {
    const journey = new Journey(stopsOf(view));
    expect(journey.shareAt(0)).toBe(0);
    expect(journey.shareAt(journey.length)).toBe(1);
    for (const share of [0, 0.2, 0.5, 0.7, 1]) expect(journey.shareAt(journey.timeOf(share))).toBeCloseTo(share, 9);
    const times = Array.from({ length: 200 }, (_, k) => journey.shareAt((k / 199) * journey.length));
    expect([...times].sort((one, other) => one - other)).toEqual(times);
    expect(times.filter((share) => share === 0.5).length > 10).toBe(view === pack);
  }
});

test("stops in one place take no time that is not a number", () => {
  const journey = new Journey([{ share: 0 }, { share: 0 }, { share: 1 }, { share: 1 }]);
  for (const share of [0, 0.5, 1]) {
    expect(journey.timeOf(share)).toBeGreaterThanOrEqual(0);
    expect(journey.shareAt(journey.timeOf(share))).toBeCloseTo(share, 9);
  }
  const stop = { name: "flat", label: "Flat", share: 1 } as const;
  expect(frameAt([stop, stop], 1, 11)).toBe(0);
});

test("panels are drawn at descending drives", () => {
  const view = decodeView(Uint8Array.from(atob(scipy.view), (each) => each.charCodeAt(0)).buffer);
  const rising = new Motion(view);
  const size = view.positions.length / view.header.drives_deg.length;
  const turned = new Float32Array(view.positions.length);
  const drives = view.header.drives_deg.toReversed();
  drives.forEach((_, k) => turned.set(view.positions.subarray((drives.length - 1 - k) * size).subarray(0, size), k * size));
  const header = { ...view.header, drives_deg: drives, named: { target: 0, flat: drives.length - 1 } };
  const falling = new Motion({ ...view, header, positions: turned });
  const [one, other] = [new Float64Array(12), new Float64Array(12)];
  for (const share of [0, 0.1, 0.6, 1]) {
    rising.setFold(share);
    falling.setFold(1 - share);
    expect(falling.driveAt(1 - share)).toBeCloseTo(rising.driveAt(share), 9);
    expect(falling.shareOf(rising.driveAt(share))).toBeCloseTo(1 - share, 9);
    for (let panel = 0; panel < rising.panels; panel++) {
      rising.place(panel, one);
      falling.place(panel, other);
      other.forEach((value, k) => expect(value).toBeCloseTo(one[k]!, 5));
    }
  }
  expect(targetPoints({ ...view, header, positions: turned })).toEqual(targetPoints(view));
});

test("only a contact before the target is too early", () => {
  const lock = { drive_deg: 180, target_drive_deg: 90 } as Report["lock"];
  expect(isEarly({ drive_deg: 80 }, lock)).toBe(true);
  expect(isEarly({ drive_deg: 120 }, lock)).toBe(false);
  expect(isEarly({ drive_deg: 120 }, undefined)).toBe(true);
});
