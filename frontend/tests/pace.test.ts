import { afterEach, expect, test, vi } from "vitest";
import { Pace, type Quality } from "../src/shared/pace.ts";

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("a motion begins as coarse as the one before had to be drawn", () => {
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
  const used: Quality[] = [];
  const rest = vi.fn();
  const pace = new Pace((quality) => used.push(quality), rest);
  for (let k = 0; k < 12; k++) pace.step(200 * k);
  const coarse = used.at(-1)!;
  expect(coarse.density).toBeLessThan(1);
  vi.advanceTimersByTime(300);
  expect(rest).toHaveBeenCalledOnce();
  expect(used.at(-1)).toEqual({ density: 1, taps: 12 });
  pace.step(60_000);
  expect(used.at(-1)).toEqual(coarse);
});
