import { expect, it } from "vitest";
import type { Sheets } from "../src/shared/api-types.ts";
import { factsOf } from "../src/studio/files/sheet-preview.ts";
import { isIdle, percent } from "../src/studio/files/workshop-words.ts";

it("settings that others make idle are not shown", () => {
  const plain = (key: string): unknown => ({ creases: "score", stock: null })[key];
  const shop = (key: string): unknown => ({ creases: "dashes", stock: [2, 1] })[key];
  expect(["dash", "duty", "margin", "joint"].every((key) => isIdle(key, plain))).toBe(true);
  expect(["dash", "duty", "margin", "joint"].some((key) => isIdle(key, shop))).toBe(false);
  expect(isIdle("labels", plain)).toBe(false);
});

it("what sheets come to has its units", () => {
  const stock = { sheets: 4, stock_area: 25, used_area: 17, waste: 0.32, cut_length: 34.17257, crease_length: 91.6353 };
  const sheets: Sheets = { sheets: [], unit: "m", layers: [], palette: "", stock, boards: 2, paper: { says: "Scale 1:20, 4 pages of A4", svg: "" } };
  const facts = new Map(factsOf(sheets));
  expect(facts.get("Used of the sheets")).toBe("68 %");
  expect(facts.get("Cut")).toBe("34.2 m");
  expect(facts.get("Sheets for boards")).toBe("2");
  expect(new Map(factsOf({ ...sheets, boards: null })).has("Sheets for boards")).toBe(false);
  expect(percent(0.005)).toBe("1 %");
});
