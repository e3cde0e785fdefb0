import { expect, it } from "vitest";

import { shownRows } from "../src/shared/verdict.ts";
import { missingOf, rowsNow } from "../src/studio/shell/verdict-rows.ts";
import { placeOf } from "../src/studio/shell/verdict-place.ts";
import { Signal } from "../src/studio/state/signal.ts";
import { wordsOfWorst, worstCase } from "../src/studio/structure/worst.ts";
import type { View } from "../src/shared/view.ts";

type Store = Parameters<typeof rowsNow>[0];
type Proof = Store["proof"]["value"];

const row = (subject: string, sign = "holds", known = true) => ({ sign, subject, finding: `${subject} ${sign}`, remedy: "", changes: {}, known });
const report = { verdict: [row("stands", "warns", false), row("unchecked", "warns", false), row("folds"), row("feet", "says")] };
const storeWith = (proof: object, freshness = "current") =>
  ({ proof: new Signal(proof as Proof), freshness: new Signal(freshness), report: new Signal(report) }) as unknown as Store;
const said = (proof: object, freshness?: string) => rowsNow(storeWith(proof, freshness)).map(({ subject, sign, words }) => `${sign} ${subject}: ${words}`);

it("rows say what the proof has come to, and nothing before", () => {
  expect(said({ state: "none" })).toEqual(["pending stands: waiting", "pending folds: waiting"]);
  expect(said({ state: "none" }, "outdated")).toEqual(["pending stands: not known", "pending folds: not known"]);
  expect(said({ state: "running", found: false })).toEqual(["pending stands: not yet known", "pending folds: not yet known"]);
  expect(said({ state: "running", found: true })).toEqual(["pending stands: not yet known", "warns unchecked: unchecked warns", "holds folds: folds holds"]);
  expect(said({ state: "late", found: true })[0]).toBe("warns stands: not finished in time ");
  expect(said({ state: "done" })).toEqual(["warns stands: stands warns", "warns unchecked: unchecked warns", "holds folds: folds holds"]);
  expect(said({ state: "stopped" })).toEqual(["pending stands: not verified", "pending folds: not verified"]);
  expect(said({ state: "failed", fault: {} })).toEqual([]);
  expect(missingOf(storeWith({ state: "done" }))).toBeNull();
  expect(shownRows({ verdict: [row("folds")] } as never, { words: "late", sign: "warns" }, true).map(({ subject }) => subject)).toEqual(["remedies", "folds"]);
});

/** A sheet of 2 x 3 panels, opened from a pack at 180 over its target at 90 degrees to flat. */
function viewWith(report: object): View {
  const points = Float32Array.from({ length: 36 }, (_, k) => [Math.floor(k / 3) % 4, Math.floor(k / 12), Math.floor(k / 12) === 1 ? 1 : 0][k % 3]!);
  const faces = [0, 1].flatMap((r) => [0, 1, 2].flatMap((c) => [4 * r + c, 4 * r + c + 1, 4 * r + c + 5, 4 * r + c + 4]));
  return {
    header: { grid: [3, 4], drives_deg: [180, 90, 0], named: { pack: 0, target: 1, flat: 2 }, report, contact: null, origin: [0, 0, 0], arrays: { flat: { shape: [12, 2] } } },
    positions: Float32Array.from([...points, ...points, ...points]), faces: Uint32Array.from(faces), clipped: [],
  } as unknown as View;
}

it("a row has a place: panels that meet, ties and flaps that hold, feet that stand", () => {
  const first_contact = { drive_deg: 135, panels: [[0, 0], [1, 2]] };
  const clash = viewWith({ lock: { cause: "clash", target_drive_deg: 90, first_contact } });
  expect(placeOf("folds", clash)).toMatchObject({ panels: [0, 5], share: 0.25 });
  // Beyond the target one would have to untie the shell first.
  const beyond = viewWith({ lock: { cause: "clash", target_drive_deg: 90, first_contact: { ...first_contact, drive_deg: 45 } } });
  expect(placeOf("folds", beyond)).toMatchObject({ panels: [0, 5], share: 0.5 });
  const tied = viewWith({ deployment: { closing: "flaps", opening: "ties", flap_attachment: "folded", ties: [{ ends: [[0, 0], [2, 0]], length: 1 }] } });
  expect(placeOf("held", tied)).toMatchObject({ panels: [0, 2, 3, 5], ties: [[0, 8]], feet: [], share: 0.5 });
  const loose = viewWith({ deployment: { closing: null, opening: null, ties: [] } });
  expect(placeOf("locks", loose).feet).toEqual([0, 1, 2, 3, 8, 9, 10, 11]);
  expect(placeOf("packs", loose).share).toBe(0);
  expect(placeOf("stands", loose)).toMatchObject({ load: null, share: 0.5 });
});

it("the worst case of a load is the one that fails, then the one that uses most", () => {
  const used = (governs: string | null, share: number | null) => ({ utilisation: { governs, ...(governs ? { [governs]: share } : {}) } });
  const cases = [
    { carries: true, equilibrium: used("panels", 0.4), loads: [{ kind: "snow" }], findings: [] },
    { carries: true, equilibrium: used("lines", 0.9), loads: [{ kind: "snow" }, { kind: "wind" }], findings: [] },
    { carries: false, equilibrium: null, loads: [{ kind: "wind" }], findings: [{ kind: "moves" }] },
    { carries: null, equilibrium: used("lines", 0.1), loads: [{ kind: "person" }], findings: [{ kind: "unknown" }] },
    { carries: false, equilibrium: used("lines", 0.1), loads: [{ kind: "pressure" }], findings: [{ kind: "displaced" }] },
  ];
  const view = { header: { report: { structure: { cases } } }, loaded: { cases: ["a", "b", "c", "d", "e"].map((name) => ({ name })) } } as unknown as View;
  expect(worstCase(view)).toMatchObject({ name: "c", sign: "fails", moves: true });
  expect(worstCase(view, "snow")).toMatchObject({ name: "b", sign: "holds", share: 0.9, governs: "lines" });
  expect(worstCase(view, "person")).toMatchObject({ sign: "warns", against: "unknown" });
  // What fails otherwise than by its strength has no small share beside it.
  expect((["snow", "wind", "person", "pressure"] as const).map((kind) => wordsOfWorst(worstCase(view, kind)!))).toEqual(["90 %", "moves", "not known", "displaced"]);
  expect(worstCase(view, "self_weight")).toBeNull();
  expect(worstCase({ header: { report: {} } } as unknown as View)).toBeNull();
});
