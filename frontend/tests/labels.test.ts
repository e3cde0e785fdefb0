import { expect, test } from "vitest";

import { Labels } from "../src/studio/state/labels.ts";
import type { Info } from "../src/studio/state/types.ts";

function family(keys: Record<string, string>): Info["families"][string] {
  const parameters = Object.entries(keys).map(([key, label]) => ({ key, label, unit: key === "flap" ? "length" : "" }));
  return { label: "", what: "", parameters } as unknown as Info["families"][string];
}
const key = (label: string): Info["tables"][string]["keys"][string] => ({ label, help: "", unit: "", choices: {} });
const TABLES: Info["tables"] = {
  pattern: { label: "Pattern", keys: {} },
  deployment: { label: "Deployment", keys: { flap_attachment: { ...key("Flaps"), choices: { clipped: "Clipped on" } }, largest_fold_deg: key("Hinges close to") } },
  motion: { label: "", keys: { frames: key("Frames") } },
  "target.fit": { label: "", keys: { width: { ...key("Width"), unit: "length" }, head_height: key("Head height") } },
};
const LABELS = new Labels(
  { one: family({ xi_deg: "Crease angle ξ", flap: "Flap", rows: "Rows" }), two: family({ flap: "Border", stage_deg: "Stage" }) },
  TABLES,
  () => ({ family: "one", unit: "m" }),
);

test.each([
  ["xi_deg = 120 is too large for f", "Crease angle ξ = 120° is too large for f"],
  ["shallower folds, by a wider xi_deg (50 now)", "shallower folds, by a wider crease angle ξ (50 now)"],
  ["it must be below xi_deg = 53.", "it must be below crease angle ξ = 53°."],
  ["rows meet, or set rows = 3", "rows meet, or set rows = 3"],
  ['tie its feet together (ties = "feet" in [deployment])', "tie its feet together"],
  ["use finer cells (cells, or refine, in [structure])", "use finer cells"],
  ["hold edges there (edges = true, or patch, in supports in [structure])", "hold edges there"],
  ["what it bears (give a strength in [structure])", "what it bears (give a strength under Structure)"],
  ["close no further: largest_fold_deg", "close no further: hinges close to"],
  ["[pattern] rows, columns", "Pattern rows, columns"],
  ["[target.f] range", "curve f: range"],
  ["[target.surface] formula", "surface: formula"],
  ["add the table [structure]", "add the table Structure"],
  ["frames in [motion]", "frames under Motion"],
  ['cylinders (shape = "cylinder" or "valleys" in [load_case])', "cylinders"],
  ["is m the unit of its curves? (unit in [shell]; of a drawing, in [target.f] and [target.g])", "is m the unit of its curves?"],
  ['turn it where y points up (up = "y" in [target.surface]), or not (up = "z")', "turn it where y points up, or not"],
  ['ties across the folds (ties = "folds"), and more', "ties across the folds, and more"],
  ['with flap_attachment = "clipped" in [deployment]', "with flaps: clipped on under Deployment"],
  ["stage_deg = 12 is beyond", "Stage = 12° is beyond"],
  ["a depth of no_such_key = 3", "a depth of no_such_key = 3"],
])("%s", (text, expected) => {
  expect(LABELS.said(text)).toBe(expected);
});

test.each([
  ["deployment.largest_fold_deg", "Hinges close to", "Deployment"],
  ["motion.frames", "Frames", "Motion"],
  ["pattern.flap", "Flap", "Pattern"],
  ["structure.tie_stiffness", "Tie stiffness", "Structure"],
  ["target.f.range.1", "Range 2 of f", "Target"],
  ["target.surface.x.0", "X 1 of the surface", "Target"],
  ["target.fit.width", "Width of the built shell", "Target"],
])("%s", (place, label, section) => {
  expect([LABELS.place(place), LABELS.section(place)]).toEqual([label, section]);
});

test("a remedy is said by the labels of what it changes", () => {
  const remedy = (changes: Record<string, number | string | number[] | null>): string => LABELS.remedy({ text: "", changes });
  expect(remedy({ "pattern.xi_deg": 53.08 })).toBe("crease angle ξ = 53.08°");
  expect(remedy({ "pattern.flap": 0.2, "deployment.flap_attachment": null })).toBe("flap = 0.2 m without flaps");
  expect(remedy({ "pattern.rows": 5, "deployment.flap_attachment": "clipped" })).toBe("rows = 5 and flaps: clipped on");
  expect(LABELS.remedy({ text: "", changes: { "structure.line_strength": { kind: "piano hinge" } } })).toBe("line strength: piano hinge");
  expect(LABELS.remedy({ text: "", changes: { "structure.self_weight": true } })).toBe("self weight: yes");
  expect(remedy({ "target.g.range": [0, 6.1] })).toBe("range of g = 0, 6.1");
  expect(remedy({ "target.fit.width": 4.2, "target.fit.head_height": null })).toBe("width = 4.2 m without head height");
  expect(LABELS.of("xi_deg")).toBe("Crease angle ξ");
  expect(LABELS.of("couplings")).toBe("couplings");
});
