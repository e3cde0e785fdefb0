import { expect, test } from "vitest";

import { wordsOfSize } from "../src/studio/design/panel-count.ts";

test("rows and columns count vertices, one less than panels, and flaps are columns of panels", () => {
  expect(wordsOfSize(9, 11, "flaps")).toBe(
    "9 × 11 vertices inside the sheet make 10 × 12 = 120 panels; the first and last column are flaps.",
  );
  expect(wordsOfSize(9, 11, "")).toContain("10 × 10 = 100 panels");
  expect(wordsOfSize(NaN, 11, "flaps")).toBe("");
  expect(wordsOfSize(2.5, 11, "flaps")).toBe("");
});
