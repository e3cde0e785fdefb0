import { expect, test } from "vitest";

import { tomlOf } from "../src/studio/files/toml.ts";

test("tables, values before the tables within, lists of tables", () => {
  const text = tomlOf({
    shell: { family: "orthodiagonal", unit: "m" },
    target: { f: { formula: ["cos(t)", "sin(t)"], range: [0, "pi"] }, g: { points: [[0, 0], [1.5, -2e-7]], smooth: true } },
    pattern: { rows: 11, flap: "auto", left: undefined },
    panel: { thickness: 0.01, largest_setback: { share: 0.5 } },
    motion: {},
    structure: { modulus: 2.7e8, supports: [{ at: "feet", kind: "pinned" }] },
    load_case: [
      { name: 'say "snow"', snow: { ground: 500 }, self_weight: true },
      { name: "both\n", combine: { "wind across": 1.5 }, pressure: Infinity },
    ],
  });
  expect(text).toBe(`[shell]
family = "orthodiagonal"
unit = "m"

[target.f]
formula = ["cos(t)", "sin(t)"]
range = [0, "pi"]

[target.g]
points = [[0, 0], [1.5, -2e-7]]
smooth = true

[pattern]
rows = 11
flap = "auto"

[panel]
thickness = 0.01

[panel.largest_setback]
share = 0.5

[motion]

[structure]
modulus = 270000000
supports = [{ at = "feet", kind = "pinned" }]

[[load_case]]
name = "say \\"snow\\""
snow = { ground = 500 }
self_weight = true

[[load_case]]
name = "both\\n"
combine = { "wind across" = 1.5 }
pressure = inf
`);
});
