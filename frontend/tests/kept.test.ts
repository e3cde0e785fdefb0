import { beforeEach, expect, test } from "vitest";

import { Keeper, readKept } from "../src/studio/kept.ts";
import { designOf, fragmentOf } from "../src/studio/link.ts";
import type { Named } from "../src/studio/store.ts";

const kept: Named = {
  name: "Zelt – 3 × 6 m",
  design: {
    shell: { family: "orthodiagonal", unit: "m" },
    target: { f: { formula: ["cos(t)", "sin(t)"], range: [0, 3.14] }, g: { points: [[0, 0], [1, 0.5]] } },
    pattern: { rows: 11, columns: 13 },
  },
};

class Room implements Storage {
  readonly texts = new Map<string, string>();
  full = false;
  get length(): number {
    return this.texts.size;
  }
  clear(): void {
    this.texts.clear();
  }
  getItem(key: string): string | null {
    return this.texts.get(key) ?? null;
  }
  key(): string | null {
    return null;
  }
  removeItem(key: string): void {
    this.texts.delete(key);
  }
  setItem(key: string, text: string): void {
    if (this.full) throw new DOMException("full", "QuotaExceededError");
    this.texts.set(key, text);
  }
}

let room: Room;
beforeEach(() => {
  room = new Room();
});

test("what is kept comes back, and is gone when it is saved", () => {
  const keeper = new Keeper(room);
  expect(readKept(room)).toBeNull();
  keeper.write(kept);
  expect(readKept(room)).toEqual(kept);
  keeper.remove();
  expect(readKept(room)).toBeNull();
});

test("what another page keeps is not removed", () => {
  const keeper = new Keeper(room);
  keeper.write(kept);
  new Keeper(room).write({ ...kept, name: "other" });
  keeper.remove();
  new Keeper(room).remove();
  expect(readKept(room)?.name).toBe("other");
});

test("nothing is made of what is no design", () => {
  for (const text of ["", "{", "null", '{"name": "x"}', '{"name": "x", "design": {"shell": {}}}']) {
    room.texts.set("orishell.design", text);
    expect(readKept(room)).toBeNull();
  }
});

test("a browser that is full, or keeps nothing, does not hold another design", () => {
  const keeper = new Keeper(room);
  keeper.write(kept);
  room.full = true;
  keeper.write({ ...kept, name: "later" });
  expect(readKept(room)).toBeNull();
  const nowhere = new Keeper(null);
  nowhere.write(kept);
  nowhere.remove();
  expect(readKept(null)).toBeNull();
});

test("a link brings the design with its name", async () => {
  const fragment = await fragmentOf(kept);
  expect(fragment).toMatch(/^#design=[A-Za-z0-9_-]+$/);
  expect(await designOf(fragment!)).toEqual(kept);
});

test("a broken link is none, a very long one is not made", async () => {
  const fragment = (await fragmentOf(kept))!;
  for (const broken of ["", "#", "#design=", "#design=%%", fragment.slice(0, -9), `#x${fragment.slice(1)}`]) {
    expect(await designOf(broken)).toBeNull();
  }
  const points = Array.from({ length: 4000 }, (_, k): [number, number] => [Math.sin(k), Math.cos(k * k)]);
  const long = { ...kept, design: { ...kept.design, target: { ...kept.design.target, f: { points } } } };
  expect(await fragmentOf(long)).toBeNull();
  // So long that its bytes are too many for one call.
  const many = Array.from({ length: 60_000 }, (_, k) => [k, Math.sin(k * k)] as [number, number]);
  expect(await fragmentOf({ ...kept, design: { ...kept.design, target: { ...kept.design.target, g: { points: many } } } })).toBeNull();
});
