// Ways in which people type numbers into boxes, and what each means in the unit beside the box.

import { describe, expect, it } from "vitest";
import { typedNumber } from "../src/studio/parts/amounts.ts";

const MEANT: [text: string, unit: string, value: number][] = [
  ["10 mm", "m", 0.01], ["650 cm", "m", 6.5], ["6,5", "m", 6.5], ["6.5", "m", 6.5], ["33/10", "m", 3.3],
  ["2*pi", "", 2 * Math.PI], ["2\u03c0", "", 2 * Math.PI], ["45\u00b0", "\u00b0", 45], ["45 deg", "\u00b0", 45], ["pi/4 rad", "\u00b0", 45],
  ["(pi/4)rad", "\u00b0", 45], ["1.5m", "mm", 1500], ["3 m 20 cm", "m", 3.2], ["5' 6\"", "m", 1.6764], ["5ft 6in", "ft", 5.5],
  ["1 200", "mm", 1200], ["1.200,5", "mm", 1200.5], ["1,200.5", "mm", 1200.5], ["1'000'000", "", 1e6], ["1,234,567", "", 1234567],
  [" -3 ", "", -3], ["\u22122,5", "m", -2.5], ["1e-3", "m", 1e-3], ["2 x 3", "", NaN], ["2 \u00d7 3 cm", "cm", 6],
  ["1/2 in", "in", 0.5], ["(1/2) in", "in", 0.5], ["\u00bd", "m", 0.5], ["2\u00bd", "m", 2.5], [".5", "m", 0.5], ["5.", "m", 5],
  ["0,6+0,2", "m", 0.8], ["2^3", "", 8], ["1 kN/m\u00b2", "kN/m\u00b2", 1], ["500 N/m2", "kN/m\u00b2", 0.5], ["90 km/h", "m/s", 25],
  ["5 rows", "rows", 5], ["3 m", "rows", NaN], ["10 mm", "\u00b0", NaN], ["10 m + 2", "m", NaN], ["", "m", NaN],
  ["m", "m", NaN], ["1,2,3", "", NaN], ["12 34", "", NaN], ["1/0", "", NaN], ["1 mmm", "m", NaN], ["--3", "", 3], ["3 -", "", NaN],
  ["100 kPa", "N/mm\u00b2", 0.1], ["7 kg", "m", NaN], ["2 m * 3 m", "m", NaN], ["1 m / 4", "m", 0.25], ["NaN", "", NaN], ["Infinity", "", NaN],
];

describe("a number", () => {
  for (const [text, unit, value] of MEANT) {
    it(`"${text}" beside ${unit || "no unit"} is ${value}`, () => {
      const found = typedNumber(text, unit);
      if (Number.isNaN(value)) expect(found).toBeNaN();
      else expect(found).toBeCloseTo(value, 12);
    });
  }
});
