import { expect, test } from "vitest";
import { boundAfter, shown } from "../src/studio/parts/typed.ts";

test("multiples of pi are called so, and nothing else is", () => {
  expect([Math.PI, 3.14159265359, -Math.PI, 2 * Math.PI, Math.PI / 2, (3 * Math.PI) / 4, -Math.PI / 6].map(shown)).toEqual([
    "pi", "pi", "-pi", "2*pi", "pi/2", "3*pi/4", "-pi/6",
  ]);
  expect([0, 1, 3.1415926, 3.14, 22 / 7, 100 * Math.PI].map(shown)).toEqual(["0", "1", "3.1415926", "3.14", "3.14285714286", "314.159265359"]);
  expect(shown("pi/2")).toBe("pi/2");
});

test("an end that nobody changed is the number that it was", () => {
  expect(boundAfter("pi", Math.PI)).toBe(Math.PI);
  expect(boundAfter("pi", 3)).toBe("pi");
  expect(boundAfter(" 2.50 ", 2.5)).toBe(2.5);
  expect(boundAfter("3", Math.PI)).toBe(3);
});
