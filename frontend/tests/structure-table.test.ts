import { expect, test } from "vitest";

import { changed } from "../src/studio/state/changed.ts";
import type { Design } from "../src/studio/state/types.ts";
import { type Changes, kilonewtons, millimetres, supportOf, withCombinations, withLoad, withMaterial, withPanel, withRail, withSupport } from "../src/studio/structure/table.ts";

const facts = { modulus: 1e10, strength: 1e7, density: 700, conservative: "", grain: false, sandwich: false };
const MATERIALS = [{ ...facts, name: "steel" }, { ...facts, name: "birch plywood", grain: true }, { ...facts, name: "skins on foam", sandwich: true }];
const arch: Design = { shell: { family: "parallel-repeating", unit: "m" }, pattern: { rows: 5 } };
const plywood = after(arch, withMaterial(arch, "birch plywood", MATERIALS));

function after(design: Design, changes: Changes): Design {
  return changed(design, changes);
}

test("a material makes a structure: pinned feet, own weight, panels of 15 mm in any unit", () => {
  expect(plywood.structure).toEqual({
    material: "birch plywood", thickness: 0.015, supports: [{ at: "feet", kind: "pinned" }],
  });
  expect(plywood.load_case).toEqual([{ name: "own weight", self_weight: true }]);
  const inMillimetres: Design = { ...arch, shell: { ...arch.shell, unit: "mm" } };
  expect(after(inMillimetres, withMaterial(inMillimetres, "steel", MATERIALS)).structure!["thickness"]).toBe(15);
  // Panels that have a thickness keep it.
  const thick: Design = { ...arch, panel: { thickness: 0.01 } };
  expect(after(thick, withMaterial(thick, "steel", MATERIALS)).structure).not.toHaveProperty("thickness");
  expect(after(plywood, withMaterial(plywood, null, MATERIALS))).toEqual(arch);
});

test("another material takes the place of values that the file gives", () => {
  const own: Design = { ...plywood, structure: { modulus: 3e9, strength: 1e7, poisson: 0.2, thickness: 0.02, supports: [] } };
  expect(after(own, withMaterial(own, "steel", MATERIALS)).structure).toEqual({ material: "steel", thickness: 0.02, supports: [] });
});

test("grain and core stay with materials that can have them", () => {
  const of = (design: Design, material: string): unknown => after(design, withMaterial(design, material, MATERIALS)).structure;
  const grained: Design = { ...arch, structure: { material: "birch plywood", grain: "along rows" } };
  expect(of(grained, "steel")).toEqual({ material: "steel" });
  const faced = { ...arch, structure: { material: "steel", sandwich: { core_shear_modulus: 5e6 } } } as unknown as Design;
  expect(of(faced, "birch plywood")).toEqual({ material: "birch plywood" });
  expect(of(faced, "skins on foam")).toEqual({ ...faced.structure, material: "skins on foam" });
  const foam: Design = { ...faced, structure: { ...faced.structure, material: "skins on foam" } };
  expect(of(foam, "steel")).toEqual({ material: "steel" });
});

test("loads are those of the file: kilonewtons per square metre in its unit, a case for each", () => {
  // 0.4 kN/m2 is 400 N per square metre, and 4e-4 N per square millimetre.
  expect(0.4 * kilonewtons(arch)).toBeCloseTo(400, 9);
  expect(0.4 * kilonewtons({ ...arch, shell: { ...arch.shell, unit: "mm" } })).toBeCloseTo(4e-4, 12);
  expect(millimetres({ ...arch, shell: { ...arch.shell, unit: "ft" } })).toBeCloseTo(304.8, 9);
  const snowed = after(plywood, withLoad(plywood, "snow", "ground", 400));
  const blown = after(snowed, withLoad(snowed, "wind", "speed", 26));
  expect(blown.load_case).toEqual([
    { name: "own weight", self_weight: true },
    { name: "snow", snow: { ground: 400 }, self_weight: true },
    { name: "wind", wind: { terrain: "II", direction_deg: 0, speed: 26 }, self_weight: true },
  ]);
  const turned = after(blown, withLoad(blown, "wind", "direction_deg", 90));
  expect(turned.load_case![2]).toMatchObject({ wind: { terrain: "II", direction_deg: 90, speed: 26 } });
  const worked = after(plywood, withLoad(plywood, "person", "force", 1000));
  expect(worked.load_case![1]).toEqual({ name: "person", person: { force: 1000 }, self_weight: true });
  const coming = { ...plywood, load_case: [{ name: "a", person: {}, duration: "short" }] } as unknown as Design;
  expect(after(coming, withLoad(coming, "person", "force", 900)).load_case![0]).toMatchObject({ person: { force: 900 } });
  // How long it lasts is no load.
  expect(after(coming, withLoad(coming, "person", "", undefined)).load_case).toEqual([]);
  // A code combines loads that are alone; without own weight none has it.
  const coded = after(snowed, withCombinations(snowed, "EN 1990"));
  expect(coded.load_case).toEqual([{ name: "own weight", self_weight: true }, { name: "snow", snow: { ground: 400 } }]);
  expect(after(coded, withCombinations(coded, "none"))).toEqual(snowed);
  expect(after(snowed, withLoad(snowed, "self_weight", "", undefined)).load_case).toEqual([{ name: "snow", snow: { ground: 400 } }]);
  expect(after(snowed, withLoad(snowed, "snow", "", undefined))).toEqual(plywood);
});

test("a load that goes leaves the cases that combine it, and what else is in its own", () => {
  const cases = [{ name: "a", snow: { ground: 1 }, pressure: 5 }, { name: "b", self_weight: true }, { name: "c", combine: { b: 1.35, a: 1.5 } }, { name: "d", combine: { b: 2 } }];
  const design = { ...plywood, load_case: cases } as unknown as Design;
  expect(after(design, withLoad(design, "snow", "", undefined)).load_case![0]).toEqual({ name: "a", pressure: 5 });
  expect(after(design, withLoad(design, "self_weight", "", undefined)).load_case).toEqual([cases[0], { name: "c", combine: { a: 1.5 } }]);
});

test("feet have friction on the ground, or under ballast that holds them in place", () => {
  const rough = after(plywood, withSupport(plywood, "kind", "friction"));
  expect(supportOf(rough)).toEqual({ at: "feet", kind: "friction", friction: 0.5 });
  const held = after(rough, withSupport(rough, "kind", "fixed"));
  expect(supportOf(held)).toEqual({ at: "feet", kind: "fixed" });
  // Ballast is judged with its friction; sliding feet have none, and the ground pushes without ballast.
  const heavy = after(held, withSupport(held, "ballast", 50));
  expect(supportOf(heavy)).toEqual({ at: "feet", kind: "fixed", ballast: 50 });
  const rubbed = after(heavy, withSupport(heavy, "friction", 0.3));
  expect(supportOf(after(rubbed, withSupport(rubbed, "kind", "pinned")))).toEqual({ at: "feet", kind: "pinned", ballast: 50, friction: 0.3 });
  expect(supportOf(after(rubbed, withSupport(rubbed, "kind", "sliding")))).toEqual({ at: "feet", kind: "sliding", ballast: 50 });
  expect(supportOf(after(rubbed, withSupport(rubbed, "kind", "friction")))).toEqual({ at: "feet", kind: "friction", friction: 0.3 });
  expect(supportOf(after(rubbed, withSupport(rubbed, "ballast", 0)))).toEqual({ at: "feet", kind: "fixed" });
  // Supports at single vertices are not what the controls show.
  expect(supportOf({ ...plywood, structure: { supports: [{ at: [[0, 1]], kind: "pinned" }] as never } })).toBeNull();
});

test("a base rail is a hollow section of 60 mm in any unit until it is another", () => {
  const railed = after(plywood, withRail(plywood, "material", "steel"));
  expect(railed.structure!["rail"]).toEqual({ material: "steel", width: 0.06, height: 0.06, wall: 0.003 });
  const inMillimetres: Design = { ...plywood, shell: { ...arch.shell, unit: "mm" } };
  expect(after(inMillimetres, withRail(inMillimetres, "material", "steel")).structure!["rail"]).toMatchObject({ width: 60, wall: 3 });
  expect(after(railed, withRail(railed, "wall", 0)).structure!["rail"]).toEqual({ material: "steel", width: 0.06, height: 0.06 });
  expect(after(railed, withRail(railed, "material", ""))).toEqual(plywood);
});

test("a thickness stands in one table only", () => {
  const thick = after(plywood, withPanel(plywood, { thickness: 0.01, membrane: 0.001 }));
  expect(thick.structure).not.toHaveProperty("thickness");
  expect(after(thick, withPanel(thick, undefined)).structure!["thickness"]).toBe(0.01);
  expect(after(arch, withPanel(arch, { thickness: 0.01 }))).toEqual({ ...arch, panel: { thickness: 0.01 } });
});
