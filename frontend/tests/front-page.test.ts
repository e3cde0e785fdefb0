import { describe, expect, it } from "vitest";
import { scaleOf } from "../src/front/scales.ts";
import { difference } from "../src/front/words.ts";
import { written } from "../src/shared/written.ts";
import { Scale } from "../src/shared/plot.ts";
import { together, type Stop } from "../src/shared/stops.ts";

describe("the plot's axes", () => {
  it("show all of the front and the design to begin with, and of others those near it", () => {
    const scale = scaleOf([10, 20], [25], [12, 30, 1000, -1000], 100, 500);
    expect([10, 20, 25, 12, 30].every((value) => scale.has(value))).toBe(true);
    expect([1000, -1000].some((value) => scale.has(value))).toBe(false);
    expect(scale.at(10)).toBeGreaterThan(100);
    expect(scale.at(30)).toBeLessThan(500);
  });

  it("hold a front of one design, of zeros too", () => {
    for (const value of [0, 5, -3e-9, 4e12]) {
      const scale = scaleOf([value], [], [], 0, 100);
      expect(scale.at(value)).toBeCloseTo(50);
      expect(scale.ticks(4).length).toBeGreaterThan(1);
    }
  });

  it("have round ticks within them, about as many as are asked for", () => {
    expect(Scale.of([16, 120], 0, 1).ticks(6)).toEqual([20, 40, 60, 80, 100, 120]);
    expect(Scale.of([-0.31, 0.32], 0, 1).ticks(3)).toEqual([-0.2, 0, 0.2]);
    for (const about of [2, 5, 9]) {
      const scale = Scale.of([3.7e-5, 8.1e-5], 0, 1);
      const ticks = scale.ticks(about);
      expect(ticks.every((tick) => scale.has(tick))).toBe(true);
      expect(ticks.length).toBeLessThanOrEqual(about / 0.75 + 1);
    }
  });
});

describe("two shells folded together", () => {
  const stops = (...shares: [Stop["name"], number][]): Stop[] => shares.map(([name, share]) => ({ name, label: name, share }));
  const first = stops(["pack", 0], ["target", 0.25], ["flat", 1]), other = stops(["pack", 0], ["target", 0.5], ["flat", 1]);

  it("are at their stops together, and between them on the way", () => {
    expect([0, 0.125, 0.25, 0.625, 1].map((share) => together(first, other, share))).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect([0, 0.25, 0.5, 0.75, 1].map((share) => together(other, first, share))).toEqual([0, 0.125, 0.25, 0.625, 1]);
  });

  it("go the same share of their ways where they have other stops", () => {
    expect(together(first, stops(["flat", 0], ["target", 1]), 0.3)).toBe(0.3);
    expect(together([], [], 0.3)).toBe(0.3);
  });
});

describe("words of a value", () => {
  it("have four digits, or are what the design file has", () => {
    expect([0.123456, 1234.6, 12, 0, -2.5, 1.23456e-7].map(written)).toEqual(["0.1235", "1235", "12", "0", "\u22122.5", "1.23e\u22127"]);
    expect([true, "auto", [1, 2]].map(written)).toEqual(["true", "auto", "[1,2]"]);
  });

  it("say by how much it differs", () => {
    expect(difference(12, 10)).toBe("+20.0 %");
    expect(difference(10, 12)).toBe("\u221216.7 %");
    expect(difference(-10, -20)).toBe("+50.0 %");
    expect(difference(50, 10)).toBe("+400 %");
    expect(difference(1.0004, 1)).toBe("+0.04 %");
    expect(difference(5, 5)).toBe("same");
    expect([difference(5, 0), difference("auto", 3), difference(false, true)]).toEqual(["differs", "differs", "differs"]);
  });
});
