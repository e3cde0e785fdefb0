import { expect, it } from "vitest";

import { headline, judged } from "../src/shared/verdict.ts";

type Report = Parameters<typeof judged>[0];
const head = (...rows: [sign: string, subject: string][]): ReturnType<typeof headline> =>
  headline(judged({ verdict: rows.map(([sign, subject]) => ({ sign, subject, finding: "", remedy: "", changes: {} })) } as unknown as Report));

it("the worst rows make the headline", () => {
  expect(head(["fails", "folds"], ["warns", "locks"], ["holds", "packs"])).toEqual(["Fails: Folds", "fails"]);
  expect(head(["warns", "stands"], ["warns", "locks"], ["holds", "folds"])).toEqual(["Needs attention: Stands, Locks", "warns"]);
  expect(head(["holds", "folds"], ["holds", "locks"], ["says", "feet"])).toEqual(["Holds: Folds, Locks", "holds"]);
  expect(head(["says", "feet"])).toBeNull();
});

it("what nobody looked at stands beside what holds, and never as held", () => {
  expect(head(["warns", "unchecked"], ["holds", "folds"])).toEqual(["Holds as far as it is checked", "warns"]);
  expect(head(["warns", "unchecked"], ["warns", "locks"], ["holds", "folds"])).toEqual(["Needs attention: Unchecked, Locks", "warns"]);
  expect(head(["warns", "unchecked"])).toEqual(["Needs attention: Unchecked", "warns"]);
});
