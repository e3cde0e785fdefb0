import { expect, test } from "vitest";

import { dashes } from "../src/shared/pattern2d.ts";

test("a valley begins and ends with a dash, and its gaps are seen", () => {
  for (let size = 6; size < 300; size += 0.7) {
    const [dash, gap] = dashes(size);
    const gaps = Math.round((size - dash) / (dash + gap));
    expect(gaps).toBeGreaterThanOrEqual(1);
    expect(gaps * gap + (gaps + 1) * dash).toBeCloseTo(size, 9);
    expect(gap).toBeGreaterThanOrEqual(2);
    expect(dash).toBeGreaterThanOrEqual(2);
    // Nowhere does it look like another kind of line.
    expect(dash + gap).toBeLessThan(13);
    expect(dash / (dash + gap)).toBeGreaterThan(0.45);
  }
});
