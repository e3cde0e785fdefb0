import { expect, test } from "vitest";

import { changed, tableOf } from "../src/studio/state/changed.ts";
import type { Design } from "../src/studio/state/types.ts";
import CASES from "./changes.json";

interface Case { changes: Record<string, unknown>; before: unknown; after: unknown }

test.each(CASES as unknown as Case[])("a design is changed as the program changes it: $changes", ({ changes, before, after }) => {
  const kept = structuredClone(before);
  expect(changed(before as Design, changes)).toEqual(after);
  expect(before).toEqual(kept);
});

test("a table in which nothing is left is none", () => {
  expect(tableOf({ ties: "feet", from: undefined })).toEqual({ ties: "feet" });
  expect(tableOf({ from: undefined })).toBeUndefined();
});
