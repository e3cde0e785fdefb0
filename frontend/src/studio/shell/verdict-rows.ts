// The rows of the verdict while the proof goes on: card and chips say the same.

import { type Missing, type Shown, shownRows } from "../../shared/verdict.ts";
import { isFound, type Store } from "../state/store.ts";

type Known = Pick<Store, "proof" | "freshness" | "report">;

/** What is said of rows that are not known; null once all are. */
export function missingOf({ proof, freshness }: Known): Missing | null {
  const { value } = proof;
  switch (value.state) {
    case "done":
      return null;
    case "none":
      return { words: freshness.value === "outdated" ? "not known" : "waiting" };
    case "waiting":
      return { words: "waiting" };
    case "running":
      return { words: "not yet known" };
    case "late":
      return { words: "not finished in time ", sign: "warns" };
    case "stopped":
    case "failed":
      return { words: "not verified" };
  }
}

/** All rows as they are known; none where the proof failed, which says why. */
export function rowsNow(store: Known): Shown[] {
  const { value } = store.proof;
  return shownRows(value.state === "failed" ? null : store.report.value, missingOf(store), isFound(value));
}
