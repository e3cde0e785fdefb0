import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";

import { Keeper, keepUnsaved, readKept } from "../src/studio/state/kept.ts";
import { designOf, fragmentOf } from "../src/studio/files/link.ts";
import { type Named, Store } from "../src/studio/state/store.ts";
import type { Info } from "../src/studio/state/types.ts";

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
  const theirs = { ...kept, design: { ...kept.design, pattern: { rows: 3 } } };
  keeper.write(kept);
  new Keeper(room).write(theirs);
  new Keeper(room).write({ ...kept, name: "other" });
  keeper.remove();
  new Keeper(room).remove();
  expect(readKept(room)?.name).toBe("other");
  expect(readKept(room, kept.name)).toEqual(theirs);
});

test("each name has its own, and the latest comes back", () => {
  const keeper = new Keeper(room);
  const other = { ...kept, name: "other" };
  keeper.leave(kept);
  keeper.write(other);
  expect(readKept(room)).toEqual(other);
  expect(readKept(room, kept.name)).toEqual(kept);
  expect(readKept(room, "none")).toBeNull();
  keeper.remove();
  expect(readKept(room)).toEqual(kept);
  // What was left is no longer this page's to remove.
  keeper.leave(kept);
  keeper.remove();
  expect(readKept(room)).toEqual(kept);
});

test("no more than eight names are kept", () => {
  const keeper = new Keeper(room);
  for (let k = 0; k < 12; k++) keeper.leave({ ...kept, name: `shell ${k}` });
  expect([3, 4, 11].map((k) => readKept(room, `shell ${k}`)?.name)).toEqual([undefined, "shell 4", "shell 11"]);
  expect(room.length).toBe(9);
});

test("nothing is made of what is no design", () => {
  const shell = { family: "orthodiagonal", unit: "m" };
  const [f, g] = [{ formula: "x" }, { points: [[0, 0], [1, 1]] }];
  const designs = [
    { shell: {} },
    { shell, pattern: {}, target: {} },
    { shell, pattern: {}, target: null },
    { shell, pattern: null, target: { f, g } },
    { shell, pattern: {}, target: { f, g: null } },
    { shell, pattern: {}, target: { f: [], g } },
    { shell, pattern: {}, target: { f, g: { points: [null] } } },
  ].map((design) => JSON.stringify({ name: "x", design }));
  room.texts.set("orishell.latest", '["x"]');
  for (const text of ["", "{", "null", '{"name": "x"}', ...designs]) {
    room.texts.set("orishell.design:x", text);
    expect(readKept(room)).toBeNull();
  }
  room.texts.set("orishell.design:x", JSON.stringify({ name: "x", design: { shell, pattern: {}, target: { f, g } } }));
  expect(readKept(room)?.name).toBe("x");
  for (const names of ["{", "3", "[3]", "null", ""]) {
    room.texts.set("orishell.latest", names);
    expect(readKept(room)).toBeNull();
  }
});

test("a browser that is full, or keeps nothing, does not hold another design", () => {
  const keeper = new Keeper(room);
  keeper.write(kept);
  room.full = true;
  keeper.write({ ...kept, name: "later" });
  expect(readKept(room, "later")).toBeNull();
  expect(readKept(room)).toEqual(kept);
  keeper.write({ ...kept, design: { ...kept.design, pattern: { rows: 3 } } });
  expect(readKept(room)).toBeNull();
  const nowhere = new Keeper(null);
  nowhere.write(kept);
  nowhere.remove();
  expect(readKept(null)).toBeNull();
});

/** A page with a store whose unsaved work is kept in the room. */
function opened(): Store {
  const page = { localStorage: room, setTimeout, clearTimeout, addEventListener: () => undefined, document: { addEventListener: () => undefined } };
  const store = new Store({ families: {} } as unknown as Info, kept);
  keepUnsaved(store, page as unknown as Window);
  return store;
}

describe("work in a page", () => {
  const changed = { ...kept.design, pattern: { rows: 21 } };
  const other: Named = { name: "other", design: { ...kept.design, pattern: { rows: 5 } } };
  const rest = (): void => void vi.advanceTimersByTime(1000);
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal("window", { event: undefined });
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  test("stays kept when a file takes its place, and is gone when it has come back and is saved", () => {
    const store = opened();
    store.change(changed, "rows");
    store.open(other);
    store.saved.set(other);
    rest();
    expect(readKept(room)).toEqual({ ...kept, design: changed });
    expect(room.length).toBe(2);
    store.undo();
    rest();
    store.saved.set(store.named);
    expect(room.length).toBe(0);
  });

  test("stays kept when the design of a link takes its place, that too", () => {
    const store = opened();
    store.change(changed, "rows");
    for (let again = 0; again < 2; again++) {
      store.open(other);
      rest();
      expect(readKept(room)).toEqual(other);
      expect(readKept(room, kept.name)?.design).toEqual(changed);
      store.undo();
      rest();
    }
  });

  test("goes with its name", () => {
    const store = opened();
    store.change(changed, "rows");
    rest();
    store.rename("new");
    expect(readKept(room)).toEqual({ name: "new", design: changed });
    expect(readKept(room, kept.name)).toBeNull();
    store.undo();
    expect(readKept(room)).toEqual({ ...kept, design: changed });
    store.undo();
    rest();
    expect(room.length).toBe(0);
  });
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
