import { expect, test } from "vitest";

import { listed, rowsIn, tiesAt } from "../src/studio/design/row-list.ts";
import { AS_PANELS, bolted, BOXES, EMPTY, GAP, lowered, NONE, SKIN, stepOf, stiffened } from "../src/studio/design/stiffener-table.ts";

test("rows are typed with commas or spaces, and only whole numbers are rows", () => {
  expect(rowsIn("2, 4 6,")).toEqual([2, 4, 6]);
  expect(rowsIn(" ")).toEqual([]);
  for (const wrong of ["2, -4", "1.5", "two", "3, 3"]) expect(rowsIn(wrong)).toBeNull();
  expect(rowsIn(listed([2, 4]))).toEqual([2, 4]);
});

test("ties across folds are at all rows unless some are named", () => {
  expect(tiesAt([])).toBe("folds");
  expect(tiesAt([2, 4])).toEqual({ folds: [2, 4] });
});

test("a table of stiffeners says what is not usual, and is gone without a kind", () => {
  const gussets = stiffened(undefined, "kind", "gussets");
  expect(gussets).toEqual({ kind: "gussets" });
  const some = stiffened(stiffened(gussets, "rows", "all"), "columns", 2);
  expect(some).toEqual({ kind: "gussets", rows: "all", columns: 2 });
  expect(stiffened(stiffened(some, "rows", "valleys"), "columns", 1)).toEqual(gussets);
  const own = stiffened(stiffened(gussets, "thickness", 0.004), "material", "steel");
  expect(own).toEqual({ kind: "gussets", thickness: 0.004, material: "steel" });
  expect(stiffened(stiffened(own, "thickness", 0), "material", AS_PANELS)).toEqual(gussets);
  expect(stiffened(some, "kind", NONE)).toBeUndefined();
  const boxes = stiffened(own, "kind", BOXES);
  expect(boxes).toEqual({ kind: "boxes" });
  const held = stiffened(stiffened(boxes, "share", EMPTY["share"]), "columns", EMPTY["columns"]);
  expect(held).toEqual({ kind: "boxes", share: "auto", columns: "none" });
  expect(stiffened(held, "kind", "gussets")).toEqual({ kind: "gussets" });
  expect(stiffened(held, "columns", 4)).toEqual({ kind: "boxes", share: "auto", columns: 4 });
  const skin = stiffened(stiffened(stiffened(held, "kind", SKIN), "gap", 0.1), "walls", 2);
  expect(skin).toEqual({ kind: "skin", gap: 0.1, walls: 2 });
  expect(stiffened(stiffened(skin, "gap", GAP), "walls", 1)).toEqual({ kind: "skin" });
  expect(stiffened(skin, "kind", BOXES)).toEqual({ kind: "boxes" });
  expect([undefined, "none", "all", 3, [0, 2]].map(stepOf)).toEqual([1, null, 1, 3, null]);
});

test("bolts are there with their holes, at usual distances until others are said", () => {
  const bolts = bolted(undefined, "hole", 0.008);
  expect(bolts).toEqual({ hole: 0.008, spacing: 0.08 });
  expect(bolted({ hole: 1, spacing: 10 }, "hole", 12)).toEqual({ hole: 12, spacing: 120 });  // while one types
  const others = bolted(bolted(bolts, "spacing", 0.06), "edge", 0.02);
  expect(others).toEqual({ hole: 0.008, spacing: 0.06, edge: 0.02 });
  expect(bolted(others, "hole", 0.01)).toEqual({ hole: 0.01, spacing: 0.06, edge: 0.02 });
  expect(bolted(others, "edge", 0)).toEqual({ hole: 0.008, spacing: 0.06 });
  expect(bolted(others, "spacing", 0)).toEqual({ hole: 0.008, spacing: 0.08, edge: 0.02 });
  expect(bolted(others, "hole", 0)).toBeUndefined();
  expect(bolted(undefined, "edge", 0.02)).toBeUndefined();
  const gussets = stiffened({ kind: "gussets" }, "bolts", bolts);
  expect(gussets).toEqual({ kind: "gussets", bolts });
  expect(stiffened(gussets, "bolts", bolted(bolts, "hole", 0))).toEqual({ kind: "gussets" });
  expect(stiffened(gussets, "kind", BOXES)).toEqual({ kind: "boxes" });
});

test("the curve of a second skin begins as f, lowered", () => {
  expect(lowered({ formula: "-0.16*x**2", range: [-4, 4] }, 0.464)).toEqual({ formula: "-0.16*x**2 - 0.46", range: [-4, 4] });
  expect(lowered({ formula: ["cos(t)", "sin(t)"] }, 0.1)).toEqual({ formula: ["cos(t)", "sin(t) - 0.1"] });
  expect(lowered({ points: [[0, 0], [1, 1]] }, 0.1)).toBeNull();
});
