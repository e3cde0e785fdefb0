import { expect, test } from "vitest";

import { sentence } from "../src/shared/words.ts";
import { ServerFault, faultOf, isAbout, ownFault, patternKeysOf, refusalOf, wordsOfRemedies } from "../src/studio/state/faults.ts";

const { searching: _, ...input } = ownFault("input", "no");
const REFUSED = { ...input, kind: "input" as const };

test("the fault behind what was thrown is the server's, or the page's own", () => {
  const curves = { f: [], g: [] };
  const refusal = refusalOf({ error: { ...REFUSED, got: "3" }, curves });
  expect(refusal).toBeInstanceOf(ServerFault);
  expect(refusal.curves).toBe(curves);
  expect(faultOf(refusal)).toMatchObject({ kind: "input", got: "3", searching: false });
  expect(refusalOf({ error: REFUSED }).curves).toBeNull();
  expect(faultOf(new Error("x"))).toMatchObject({ kind: "page", what: "Error: x" });
});

test("the controls that a fault is about are found by its keys, not by its words", () => {
  const fault = { ...ownFault("design", "rows = 3 is said of another key"), keys: ["pattern.xi_deg", "target.f.range"] };
  expect(patternKeysOf(fault)).toEqual(["xi_deg"]);
  expect(patternKeysOf(null)).toEqual([]);
  expect(isAbout(fault, "f")).toBe(true);
  expect(isAbout(fault, "g")).toBe(false);
  expect(isAbout({ ...fault, keys: ["target.g"] }, "g")).toBe(true);
  expect(isAbout({ ...fault, keys: ["target"] }, "g")).toBe(false);
});

test("what works is listed, or what limits, or that it is being looked for", () => {
  const fault = ownFault("design", "no");
  const words = (each: typeof fault): string => wordsOfRemedies(each, ({ text }) => text);
  const remedies = [{ text: "xi_deg = 90", changes: {} }, { text: "rows = 3", changes: {} }];
  expect(words(fault)).toBe("");
  expect(words({ ...fault, remedies })).toBe("xi_deg = 90, or rows = 3");
  expect(words({ ...fault, limit: "g is too short" })).toBe("none: g is too short");
  expect(words({ ...fault, remedies, searching: true })).toBe("looking for it…");
});

test.each([
  ["a panel is small", "A panel is small."],
  ["f is straight", "f is straight."],
  ["xi_deg = 170 is too large", "xi_deg = 170 is too large."],
  ["  the sheet is too large!", "The sheet is too large!"],
  ["", ""],
])("%s, as a sentence", (text, expected) => {
  expect(sentence(text)).toBe(expected);
});
