import { expect, test } from "vitest";

import { feetOf, groundOf } from "../src/shared/ground.ts";
import { headroomOf } from "../src/shared/headroom.ts";
import { flapSides } from "../src/shared/moving3d.ts";
import { Person3D } from "../src/shared/person3d.ts";
import { caught, contactOf, nextRest, restsOf, stepped } from "../src/shared/stops.ts";
import { shareAmong } from "../src/shared/ghost3d.ts";
import { stateOfTie, tiesOf } from "../src/shared/ties.ts";
import type { Header, View } from "../src/shared/view.ts";
import { isPinned } from "../src/studio/shell/compare.ts";
import { suitsCurve } from "../src/studio/curves/ground.ts";
import { differences } from "../src/shared/differences.ts";
import { headroomWords } from "../src/studio/shell/sheet-figures.ts";
import { Signal } from "../src/studio/state/signal.ts";
import type { Freshness } from "../src/studio/state/store.ts";
import type { Design } from "../src/studio/state/types.ts";

/** A tent of two slopes and a flat top, 4 wide, 2 high, 3 deep; flat sheet first. */
function tent(changes: Partial<Header> = {}): View {
  const x = [-2, -0.5, 0.5, 2], z = [0, 2, 2, 0];
  const state = (fold: number): number[] => [0, 3].flatMap((y) => x.flatMap((each, k) => [each, y, 5 + fold * z[k]! + (1 - fold) * 0.4]));
  const header = {
    drives_deg: [0, 90], named: { flat: 0, target: 1 }, grid: [2, 4], origin: [10, 20, -5], unit: "m",
    arrays: { flat: { type: "float32", shape: [8, 2], offset: 0 } },
    report: { deployment: { flap_attachment: "folded", ties: [{ ends: [[0, 0], [0, 3]], length: 4 }] }, lock: { cause: "flaps", target_drive_deg: 90 } },
    contact: null,
    ...changes,
  } as unknown as Header;
  return {
    header,
    positions: Float32Array.from([...state(0), ...state(1)]),
    flat: Float32Array.from([0, 3].flatMap((y) => x.flatMap((each) => [each, y]))),
    faces: Uint32Array.from([0, 1, 2].flatMap((k) => [k, k + 1, k + 5, k + 4])),
    clipped: [],
  } as unknown as View;
}

test("a shell stands on z = 0 of the world, and other states as far above the ground", () => {
  const view = tent();
  const ground = groundOf(view);
  expect(ground.atTarget).toBe(5);
  expect(ground.levelAt(90)).toBeCloseTo(5, 6);
  expect(ground.levelAt(0)).toBeCloseTo(5.4, 6);
  expect(ground.levelAt(45)).toBeCloseTo(5.2, 6);
  expect(feetOf(view, ground)).toEqual([0, 3, 4, 7]);
  // One that hangs elsewhere stands on what is below it.
  expect(groundOf(tent({ origin: [0, 0, 70] })).atTarget).toBe(5);
});

test("headroom is what is clear over a square, below the lowest panel", () => {
  const view = tent();
  expect(headroomOf(view, 5, 0)!.height).toBeCloseTo(2, 2);
  expect(headroomOf(view, 5, 0.25)!.height).toBeCloseTo(2, 2);
  // A square wider than the flat top reaches down the slopes.
  const wide = headroomOf(view, 5, 0.8)!;
  expect(wide.height).toBeCloseTo(2 - (0.3 * 2) / 1.5, 1);
  expect(wide.x).toBeCloseTo(0, 1);
  expect(headroomOf(view, 8, 0)).toBe(null);
});

test("headroom is said of the shell that it was measured of", () => {
  const view = tent(), before = tent();
  const room = { height: 2, x: 0, y: 0 };
  expect(headroomWords(view, { view, room })).toBe("2 m");
  expect(headroomWords(view, { view: before, room })).toBe("not yet known");
  expect(headroomWords(view, null)).toBe("not yet known");
  expect(headroomWords(view, { view, room: null })).toBe("");
});

test("a pinned design is on the screen once its own shell is", () => {
  const [one, other] = [{}, {}] as Design[];
  const design = new Signal(one!), freshness = new Signal<Freshness>("current");
  expect(isPinned(one!, { design, freshness })).toBe(true);
  design.set(other!);
  expect(isPinned(one!, { design, freshness })).toBe(false);
  // Undone, but the shell on the screen is still that of the other.
  freshness.set("computing");
  design.set(one!);
  expect(isPinned(one!, { design, freshness })).toBe(false);
});

test("a person stands beside shells of a person's size only", () => {
  expect(Person3D.suits(tent())).toBe(true);
  expect(Person3D.suits(tent({ unit: "mm" }))).toBe(false);
  expect(Person3D.suits(tent({ unit: "unit" }))).toBe(false);
  // Profiles by the same rule.
  expect(suitsCurve([[-2, 0], [2, 1]], "m")).toBe(true);
  expect(suitsCurve([[-2, 0], [2, 1]], "mm")).toBe(false);
  expect(suitsCurve([[-2, 0], [2, 1]], "unit")).toBe(false);
  expect(suitsCurve([], "m")).toBe(false);
});

test("flaps are the outer columns of a sheet that has them", () => {
  expect(flapSides(tent()).length).toBe(8);
  expect(flapSides(tent({ report: { deployment: { flap_attachment: "clipped" } } } as unknown as Partial<Header>))).toEqual([]);
});

test("ties are taut at their length, slack when shorter, not hooked in when longer", () => {
  const [tie] = tiesOf(tent());
  expect(tie).toEqual({ ends: [0, 3], length: 4 });
  expect([4, 3.99, 4.01, 3.9999].map((each) => stateOfTie(tie!, each))).toEqual(["taut", "slack", "open", "taut"]);
});

test("the motion rests where panels touch", () => {
  const view = tent({ contact: { drive_deg: 45, panels: [0, 1] } });
  expect(contactOf(view)).toEqual({ drive_deg: 45, panels: [0, 1] });
  expect(restsOf(view)).toEqual([0, 0.5, 1]);
  expect(restsOf(tent())).toEqual([0, 1]);
  const lock = { cause: "clash", target_drive_deg: 60, first_contact: { drive_deg: 90, panels: [[0, 0], [0, 2]], kind: "distant panels" } };
  const ended = tent({ report: { lock } } as unknown as Partial<Header>);
  expect(contactOf(ended)).toEqual({ drive_deg: 90, panels: [0, 2] });
  expect(restsOf(ended)).toEqual([0, 1]);
  expect(contactOf(tent({ report: { lock: { ...lock, cause: "flaps" } } } as unknown as Partial<Header>))).toBe(null);
});

test("keys fold to rests and over none, dragging is caught by them", () => {
  const rests = [0, 0.5, 1];
  expect([stepped(rests, 0.49, 0.1), stepped(rests, 0.5, 0.1), stepped(rests, 0.52, -0.1), stepped(rests, 0.05, -0.1)]).toEqual([0.5, 0.6, 0.5, 0]);
  expect([nextRest(rests, 0.5, true), nextRest(rests, 0.5, false), nextRest(rests, 1, true)]).toEqual([1, 0, 1]);
  expect([caught(rests, 0.497, 0.006), caught(rests, 0.49, 0.006)]).toEqual([0.5, 0.49]);
});

test("a ghost is as far between its stops as the shell", () => {
  const stop = (name: string, share: number) => ({ name, label: name, share }) as Parameters<typeof shareAmong>[1][0];
  const shell = [stop("pack", 0), stop("target", 0.5), stop("flat", 1)], ghost = [stop("pack", 0), stop("target", 0.8), stop("flat", 1)];
  expect([0, 0.25, 0.5, 0.75, 1].map((share) => shareAmong(share, shell, ghost))).toEqual([0, 0.4, 0.8, 0.9, 1]);
  expect(shareAmong(0.3, [stop("flat", 0), stop("target", 1)], ghost)).toBe(0.8);
});

test("differences are written to the digits shown", () => {
  expect(differences("1.5 m", "1.12 m")).toBe("+0.38");
  expect(differences("4.32 \u00d7 4.39 m", "4.41 \u00d7 3.86 m")).toBe("\u22120.09 \u00d7 +0.53");
  expect(differences("1\u202f024", "960")).toBe("+64");
  expect(differences("141 m\u00b2", "141 m\u00b2")).toBe("");
  expect(differences("2 \u00d7 3 m", "2 \u00d7 3.5 m")).toBe("0 \u00d7 \u22120.5");
  expect(differences("not yet known", "0.2 m")).toBe("was 0.2 m");
});
