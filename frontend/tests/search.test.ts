import { describe, expect, it, test } from "vitest";
import type { SearchState } from "../src/shared/api-types.ts";
import { offeredFigures } from "../src/studio/search/figures.ts";
import { Scale } from "../src/shared/plot.ts";
import { joined, wordsOfCount, wordsOfRest } from "../src/studio/search/found.ts";
import { candidates, otherwise, suggestion } from "../src/studio/search/numbers.ts";
import { countOf, hasValues, keyOf, lacking, listed, searchOf } from "../src/studio/search/table.ts";
import { changed } from "../src/studio/state/changed.ts";
import { Labels } from "../src/studio/state/labels.ts";
import { isSameShell } from "../src/studio/state/sizing.ts";
import type { Design, Info, Parameter, Report, SearchTable } from "../src/studio/state/types.ts";

const PARAMETERS = [
  { key: "rows", label: "Rows", kind: "integer", default: null, slider: [1, 61], step: 2, choices: [] },
  { key: "columns", label: "Columns", kind: "integer", default: null, slider: [2, 61], step: 1, choices: [] },
  { key: "xi_deg", label: "Crease angle ξ", kind: "number", default: "auto", slider: [1, 179], choices: [] },
  { key: "solution", label: "Solution", kind: "integer", default: 0, slider: [0, 1], step: 1, choices: [] },
  { key: "placement", label: "Placement", kind: "choice", default: "inscribed", choices: ["inscribed", "balanced"] },
] as unknown as Parameter[];
const TABLES: Info["tables"] = {
  target: { label: "Curves", keys: {} },
  panel: { label: "Panels", keys: { thickness: { label: "Thickness", help: "", unit: "length", choices: {} } } },
};
const LABELS = new Labels({ one: { label: "", what: "", borders: "", aims: ["curves"], parameters: PARAMETERS } }, TABLES, () => ({ family: "one", unit: "m" }));
const design: Design = {
  shell: { family: "one", unit: "m" },
  target: { f: { formula: "-x**2", range: [-1, 1] }, g: { points: [[0, 0], [1, 0]] } },
  pattern: { rows: 9, columns: 11, xi_deg: 48 },
};
const report = { parameters: { xi_deg: 48 }, quantities: { mass_kg: null, built: null } } as unknown as Report;
const found = (changed: Partial<Design> = {}): ReturnType<typeof candidates> =>
  candidates({ ...design, ...changed }, PARAMETERS, { xi_deg: { span: [1, 179], intervals: [[2, 9], [30, 53.123456]], below: "", above: "", beyond: [false, false] } }, report, LABELS);
const allowed = (key: string, changed: Partial<Design> = {}): unknown => found(changed).find((each) => each.key === key)?.allowed;

describe("what may change", () => {
  it("has ends that are known to work, or lie a quarter to either side", () => {
    expect(allowed("pattern.rows")).toEqual({ low: 5, high: 13, step: 2 });
    expect(allowed("pattern.columns")).toEqual({ low: 8, high: 14 });
    expect(allowed("pattern.xi_deg")).toEqual({ low: 30, high: 53.12 });
    expect(allowed("pattern.placement")).toEqual(["inscribed", "balanced"]);
    expect(allowed("pattern.solution")).toEqual({ low: 0, high: 1 });
    expect(allowed("panel.thickness", { panel: { thickness: 0.02 } })).toEqual({ low: 0.015, high: 0.025 });
  });

  it("stays within what a size can be", () => {
    expect(allowed("pattern.rows", { pattern: { rows: 1, columns: 2 } })).toEqual({ low: 1, high: 5, step: 2 });
    expect(allowed("pattern.columns", { pattern: { rows: 1, columns: 61 } })).toEqual({ low: 46, high: 61 });
  });

  it("is every number of the design but points and loads, in the words of the page", () => {
    const labels = Object.fromEntries(found({ panel: { thickness: 0.02 }, load_case: [{ snow: 500 }] }).map(({ key, label, section }) => [key, `${section}: ${label}`]));
    expect(labels).toMatchObject({
      "pattern.xi_deg": "Pattern: Crease angle ξ",
      "target.f.scale": "Curves: Scale of f",
      "target.f.range.1": "Curves: Range 2 of f",
      "target.g.scale": "Curves: Scale of g",
      "panel.thickness": "Panels: Thickness",
    });
    expect(Object.keys(labels).filter((key) => /points|load_case/.test(key))).toEqual([]);
    expect(LABELS.place("load_case.0.snow.ground")).toBe("Snow ground 1"); // a file may say so
  });

  it("is rows and columns first, or what stands in their place", () => {
    expect(suggestion(found())).toEqual({
      variables: { "pattern.rows": { low: 5, high: 13, step: 2 }, "pattern.columns": { low: 8, high: 14 } },
      minimise: ["panels", "deviation"],
      evaluations: 100,
    });
    const tolerated = found({ tolerance: { surface: 0.2 }, pattern: { xi_deg: 48 } });
    expect(Object.keys(suggestion(tolerated).variables)).toEqual(["tolerance.surface"]);
  });

  it("turns from a range into a list and back", () => {
    expect(otherwise({ low: 5, high: 9, step: 2 }, undefined)).toEqual([5, 7, 9]);
    expect(otherwise({ low: 1, high: 2 }, undefined)).toEqual([1, 1.5, 2]);
    expect(otherwise([7, 5, 9], undefined)).toEqual({ low: 5, high: 9 });
    expect(otherwise([7, 5], found()[0])).toEqual({ low: 5, high: 13, step: 2 });
  });
});

describe("the table", () => {
  const table: SearchTable = { variables: { "pattern.rows": [5, 7] }, minimise: ["panels"] };

  it("has its keys joined, as a file may have them", () => {
    const written = { variables: { pattern: { rows: [5, 7], xi_deg: { low: 1, high: 2 } } }, minimise: ["panels"], subject_to: { deflection: { snow: { most: 1 } } }, seed: 3 };
    expect(searchOf({ ...design, search: written as unknown as SearchTable })).toEqual({
      variables: { "pattern.rows": [5, 7], "pattern.xi_deg": { low: 1, high: 2 } },
      minimise: ["panels"],
      subject_to: { "deflection.snow": { most: 1 } },
      seed: 3,
    });
    expect(searchOf(design)).toBeNull();
  });

  test.each<[Partial<SearchTable>, string]>([
    [{}, ""],
    [{ variables: {} }, "Nothing may change"],
    [{ minimise: [] }, "at least one figure"],
    [{ variables: { a: { low: 2, high: 2 } } }, "below its high end"],
    [{ variables: { a: [] } }, "at least one value"],
    [{ variables: { a: [1, 1] } }, "differ"],
    [{ subject_to: { panels: { least: 2, most: 1 } } }, "least above"],
  ])("%j lacks %s", (change, words) => {
    const said = lacking({ ...table, ...change });
    expect(words ? said.includes(words) : said === "").toBe(true);
  });

  it("counts the designs that there are", () => {
    expect(countOf({ a: [1, 2, 3], b: { low: 1, high: 4 } }, (key) => key === "b")).toBe(12);
    expect(countOf({ a: { low: 0, high: 1, step: 0.1 } }, () => false)).toBe(11);
    expect(countOf({ a: { low: 0, high: 1 } }, () => false)).toBe(Infinity);
  });

  it("reads lists", () => {
    expect(listed("5, 7,9.5,")).toEqual([5, 7, 9.5]);
    expect(listed("inscribed, balanced")).toEqual(["inscribed", "balanced"]);
    expect(listed("true, false")).toEqual([true, false]);
  });

  it("changes nothing of the shell", () => {
    expect(isSameShell(changed(design, { search: table }), design)).toBe(true);
    expect(isSameShell(changed({ ...design, pattern: { ...design.pattern } }, { search: table }), design)).toBe(false);
    expect(isSameShell({ ...design, panel: {} }, design)).toBe(false);
    expect(changed(changed(design, { search: table }), { search: null })).toEqual(design);
  });
});

describe("a design that is picked", () => {
  it("has the values, and all else as before", () => {
    const values = { "pattern.rows": 7, "target.f.range.1": 2, "target.g.scale": 3 };
    const picked = changed(design, values);
    expect(picked.pattern).toEqual({ rows: 7, columns: 11, xi_deg: 48 });
    expect(picked.target!.f!.range).toEqual([-1, 2]);
    expect(picked.target!.g).toEqual({ points: [[0, 0], [1, 0]], scale: 3 });
    expect(picked.shell).toBe(design.shell);
    expect(design.target!.f!.range).toEqual([-1, 1]);
    expect(hasValues(picked, values)).toBe(true);
    expect(hasValues(design, values)).toBe(false);
  });

  it("is of the same search, another design is not", () => {
    const key = keyOf(design, ["pattern.rows"]);
    expect(keyOf(changed(design, { "pattern.rows": 5 }), ["pattern.rows"])).toBe(key);
    expect(keyOf(changed(design, { search: { variables: {}, minimise: [] } }), ["pattern.rows"])).toBe(key);
    expect(keyOf(changed(design, { "pattern.columns": 5 }), ["pattern.rows"])).not.toBe(key);
  });
});

describe("what is found", () => {
  const made = (panels: number): SearchState["designs"][number] => ({ values: { "pattern.rows": panels }, figures: { panels } });
  const state = (more: Partial<SearchState>): SearchState => ({
    objectives: [{ name: "panels", label: "panels" }], baseline: null, designs: [], front: [], knee: -1, made: 0, total: 10, refused: [], ...more,
  });

  it("grows by what is told", () => {
    const first = joined(null, state({ designs: [made(3)], front: [{ number: 0, costs: "" }], knee: 0, made: 1 }));
    const second = joined(first, state({ designs: [made(4), made(2)], front: [{ number: 2, costs: "" }], knee: 0, made: 3 }));
    expect(second.designs.map(({ figures }) => figures["panels"])).toEqual([3, 4, 2]);
    expect(second.front.map(({ design: each }) => each.figures["panels"])).toEqual([2]);
  });

  it("says how long the rest takes, and what is left out", () => {
    expect(wordsOfRest({ made: 1, total: 100 }, 1)).toBe("");
    expect(wordsOfRest({ made: 10, total: 100 }, 5)).toBe("about 45 s left");
    expect(wordsOfRest({ made: 10, total: 100 }, 20)).toBe("about 3 min left");
    expect(wordsOfRest({ made: 99, total: 100 }, 20)).toBe("a few seconds left");
    expect(wordsOfRest({ made: 100, total: 100 }, 20)).toBe("");
    expect(wordsOfCount(state({ made: 1, designs: [made(1)] }), false)).toBe("1 of 10 designs tried.");
    expect(wordsOfCount(state({ made: 3, designs: [made(1)], refused: [["no", 2]] }), true)).toBe("3 designs tried; 2 cannot be made or break a limit: no.");
    expect(wordsOfCount(state({ made: 3, refused: [["no", 2], ["never", 1]] }), true)).toContain("no (2); never (1).");
  });

  it("has scales that hold all values, equal ones too", () => {
    for (const values of [[1, 5, 3], [2, 2], [0], [-4, 1e-3]]) {
      const scale = Scale.of(values, 0, 100);
      for (const value of values) {
        expect(scale.at(value)).toBeGreaterThan(0);
        expect(scale.at(value)).toBeLessThan(100);
      }
      const ticks = scale.ticks();
      expect(ticks.length).toBeGreaterThan(1);
      expect(ticks.length).toBeLessThan(9);
    }
  });
});

describe("figures that are offered", () => {
  const figures = [
    { name: "panels", words: "panels", unit: "", of_structure: false, most: null },
    { name: "mass", words: "mass", unit: "kg", of_structure: false, most: null },
    { name: "deflection", words: "deflection", unit: "{unit}", of_structure: true, most: null },
    { name: "utilisation", words: "utilisation", unit: "", of_structure: true, most: 1 },
  ];
  const none: SearchTable = { variables: {}, minimise: [] };
  const names = (of: Design, table = none, said = report): string[] => offeredFigures(figures, of, said, table).map(({ label }) => label);

  it("are those that the design can have", () => {
    expect(names(design)).toEqual(["Panels"]);
    expect(names({ ...design, structure: {} })).toEqual(["Panels", "Deflection (m)", "Utilisation"]);
    const weighed = { ...report, quantities: { mass_kg: 0, built: null } } as unknown as Report;
    expect(names(design, none, weighed)).toEqual(["Panels", "Mass (kg)"]);
  });

  it("and those that the file asks for", () => {
    expect(names(design, { ...none, minimise: ["mass"], subject_to: { "deflection.snow": { most: 1 } } })).toEqual(["Panels", "Mass (kg)", "Deflection of snow"]);
  });
});
