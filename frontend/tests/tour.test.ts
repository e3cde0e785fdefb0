import { expect, test } from "vitest";

import { placeCard, STEPS } from "../src/studio/page/tour-steps.ts";

const WINDOW = { width: 1000, height: 700 };
const CARD = { width: 300, height: 200 };

test("the card stands beside what it is about, where there is room", () => {
  expect(placeCard({ left: 0, top: 50, width: 336, height: 600 }, CARD, WINDOW)).toEqual({ left: 348, top: 50 });
  expect(placeCard({ left: 700, top: 650, width: 300, height: 50 }, CARD, WINDOW)).toEqual({ left: 388, top: 488 });
  expect(placeCard({ left: 0, top: 0, width: 1000, height: 48 }, CARD, WINDOW)).toEqual({ left: 350, top: 60 });
  expect(placeCard({ left: 0, top: 600, width: 1000, height: 100 }, CARD, WINDOW)).toEqual({ left: 350, top: 388 });
});

test("the card stays in the window, over a region that fills it, and in the middle without one", () => {
  expect(placeCard({ left: 0, top: 0, ...WINDOW }, CARD, WINDOW)).toEqual({ left: 350, top: 488 });
  expect(placeCard(null, CARD, WINDOW)).toEqual({ left: 350, top: 250 });
  expect(placeCard(null, { width: 380, height: 900 }, { width: 390, height: 844 })).toEqual({ left: 12, top: 12 });
});

test("the tour is short", () => {
  expect(STEPS.length).toBeLessThan(7);
  for (const { text } of STEPS) expect(text.length).toBeLessThan(170);
});
