import { expect, test } from "vitest";

import type * as Api from "../src/shared/api-types.ts";
import { amountsOf, deflectionOf, DRAWN, exaggeration, rimsOf, scalesOf, worstUsed } from "../src/shared/loaded.ts";
import type { Loaded } from "../src/shared/view.ts";

/** Two unit squares side by side, of two triangles each. */
const points = Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0]);
const loaded: Loaded = {
  cases: [
    { name: "snow", sign: "holds", balanced: true, strength: 8, parts_strength: null },
    { name: "own weight", sign: "fails", balanced: false, strength: null, parts_strength: null },
  ],
  points,
  triangles: Uint32Array.from([0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4]),
  panels: Uint32Array.from([0, 0, 1, 1]),
  ofPanels: 4,
  called: (number) => ["panel 0,0", "panel 0,1", "gusset 1,1"][number]!,
  ties: Uint32Array.from([0, 5]),
  displacements: Float32Array.from([...points.map((_, i) => (i === 5 ? -0.03 : i === 3 ? 0.04 : 0)), ...points.map((_, i) => (i === 17 ? -1 : 0))]),
  stresses: Float32Array.from([1, 2, 4, 3, NaN, NaN, NaN, NaN]),
  loads: new Float32Array(12),
  creases: null,
  held: new Uint32Array(0),
};

test("panels are outlined, and the sheet; what lies inside a panel is not", () => {
  const { rims, border } = rimsOf(loaded);
  const lines = (ends: Uint32Array) =>
    Array.from({ length: ends.length / 2 }, (_, k) => `${ends[2 * k]}-${ends[2 * k + 1]}`).sort();
  expect(lines(border)).toEqual(["0-1", "0-3", "1-2", "2-5", "3-4", "4-5"]);
  expect(lines(rims)).toEqual([...lines(border), "1-4"].sort());
});

/** With a triangle upright on the middle line, of something weaker, and a node that only it has. */
const stiffened: Loaded = {
  ...loaded,
  cases: loaded.cases.map((each) => ({ ...each, parts_strength: each.strength && 2 })),
  points: Float32Array.from([...points, 1, 0, 1]),
  triangles: Uint32Array.from([...loaded.triangles, 1, 4, 6]),
  panels: Uint32Array.from([...loaded.panels, 2]),
  displacements: new Float32Array(42).map((_, i) => (i === 20 ? 0.1 : 0)),
  stresses: Float32Array.from([1, 2, 4, 3, 1, NaN, NaN, NaN, NaN, NaN]),
};

test("what stiffens a sheet is outlined as panels are, and is no border of the sheet", () => {
  const { rims, border } = rimsOf(stiffened);
  expect(border).toEqual(rimsOf(loaded).border);
  const lines = Array.from({ length: rims.length / 2 }, (_, k) => `${rims[2 * k]}-${rims[2 * k + 1]}`);
  expect(lines).toContain("1-6");
  expect(lines).toContain("4-6");
});

test("it is coloured as it is displaced and stressed, by its own strength", () => {
  const snow = deflectionOf(stiffened, 0);
  expect(snow.most).toBeCloseTo(0.1, 7);
  expect([...amountsOf(stiffened, snow, "displacement").shares.slice(-3)]).toEqual([0, 0, 1]);
  expect([...amountsOf(stiffened, snow, "stress").shares.slice(-3)]).toEqual([0.25, 0.25, 0.25]);
  const { shares, most } = amountsOf(stiffened, snow, "utilisation");
  expect([...shares.slice(-6)]).toEqual([3 / 8, 3 / 8, 3 / 8, 0.5, 0.5, 0.5]);
  expect(most).toBe(0.5);
  const weak = { ...stiffened, cases: stiffened.cases.map((each) => ({ ...each, parts_strength: 1 })) };
  const { of } = amountsOf(weak, deflectionOf(weak, 0), "utilisation");
  expect(weak.called(of!)).toBe("gusset 1,1");
  expect(amountsOf(stiffened, snow, "stress").of).toBe(1);
  expect(amountsOf(stiffened, snow, "displacement").of).toBeNull();
  // Where one strength is not known, that of the other is said all the same.
  expect([...amountsOf(stiffened, { ...snow, strength: null }, "utilisation").shares.slice(-6)]).toEqual([NaN, NaN, NaN, 0.5, 0.5, 0.5]);
  expect([...worstUsed(stiffened)!.shares]).toEqual([2 / 8, 4 / 8]);
});

test("displacements are drawn by a round number, as large as they may be", () => {
  for (const most of [1e-7, 3e-4, 0.02, 1, 30]) {
    const scale = exaggeration(10, most);
    expect(scale * most).toBeLessThanOrEqual(DRAWN * 10 * (1 + 1e-9));
    expect(scale * most).toBeGreaterThanOrEqual((DRAWN * 10) / 2.5);
    expect("125").toContain(scale.toExponential(0)[0]);
    expect(scalesOf(scale)).toContain(scale);
  }
  expect(exaggeration(10, 0)).toBe(1);
});

test("the numbers to choose from go from what is to a few times what is proposed", () => {
  expect(scalesOf(20)).toEqual([1, 2, 5, 10, 20, 50, 100]);
  expect(scalesOf(1)).toEqual([1, 2, 5]);
  expect(scalesOf(0.02)[0]).toBe(0.02);
  expect(scalesOf(0.02).at(-1)).toBe(1);
});

test("colours are shares of the most, at corners or for whole triangles", () => {
  const snow = deflectionOf(loaded, 0);
  expect(snow.most).toBeCloseTo(0.05, 7);  // 3, 4, 5
  const sizes = amountsOf(loaded, snow, "displacement");
  expect(sizes.most).toBe(snow.most);
  expect([...sizes.shares]).toEqual([0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0]);
  const stresses = amountsOf(loaded, snow, "stress");
  expect(stresses.most).toBe(4);
  expect([...stresses.shares]).toEqual([1, 1, 1, 2, 2, 2, 4, 4, 4, 3, 3, 3].map((each) => each / 4));
  // Colours of utilisation end at the strength, whatever the most is.
  const used = amountsOf(loaded, snow, "utilisation");
  expect(used.most).toBe(4 / 8);
  expect(amountsOf(loaded, { ...snow, strength: 16 }, "utilisation").most).toBe(4 / 16);
  expect([...used.shares]).toEqual([1, 1, 1, 2, 2, 2, 4, 4, 4, 3, 3, 3].map((each) => each / 8));
  const moves = deflectionOf(loaded, 1);
  expect(moves.balanced).toBe(false);
  expect(amountsOf(loaded, moves, "stress").shares.every(Number.isNaN)).toBe(true);
});

test("a panel uses the largest share of its strength, in any case", () => {
  const [snow, weight] = loaded.cases as [Api.NamedCase, Api.NamedCase];
  const stresses = Float32Array.from([1, 2, 4, 3, 6, 1, 1, 1]);
  const both = (strength: number) => worstUsed({ ...loaded, cases: [snow, { ...weight, balanced: true, strength }], stresses })!;
  expect(both(8)).toEqual({ shares: Float32Array.from([6 / 8, 4 / 8]), cases: Uint32Array.from([1, 0]) });
  // What lasts is borne less: smaller stresses may use more.
  expect(both(1.5)).toEqual({ shares: Float32Array.from([6 / 1.5, 1 / 1.5]), cases: Uint32Array.from([1, 1]) });
  expect([...worstUsed(loaded)!.shares]).toEqual([2 / 8, 4 / 8]);
  expect(worstUsed({ ...loaded, cases: [{ ...snow, strength: null }, weight] })).toBeNull();
});
