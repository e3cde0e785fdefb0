import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";

import { Keeper, keepUnsaved, readKept, readOpen } from "../src/studio/state/kept.ts";
import { faultOf } from "../src/studio/state/faults.ts";
import { designOf, fragmentOf } from "../src/studio/files/link.ts";
import { type Named, type Work, isUnsaved } from "../src/studio/state/named.ts";
import { Store } from "../src/studio/state/store.ts";
import type { Info } from "../src/studio/state/types.ts";

const kept: Named = {
  name: "Zelt – 3 × 6 m",
  design: {
    shell: { family: "orthodiagonal", unit: "m" },
    target: { f: { formula: ["cos(t)", "sin(t)"], range: [0, 3.14] }, g: { points: [[0, 0], [1, 0.5]] } },
    pattern: { rows: 11, columns: 13 },
  },
};

/** A design that is in no file and not kept yet. */
const work = (named: Named): Work => ({ ...named, home: { file: null, slot: null, text: "" } });
/** What is kept, without where. */
function keptIn(storage: Storage | null, name?: string): Named | null {
  const found = readKept(storage, name);
  return found && { name: found.name, design: found.design };
}

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
let tab: Room;
beforeEach(() => {
  room = new Room();
  tab = new Room();
});

test("what is kept comes back, and is gone when it is saved", () => {
  const keeper = new Keeper(room);
  const mine = work(kept);
  expect(readKept(room)).toBeNull();
  keeper.write(mine);
  expect(keptIn(room)).toEqual(kept);
  keeper.remove(mine);
  expect(readKept(room)).toBeNull();
  expect(room.length).toBe(0);
});

test("what comes back is kept where it was", () => {
  new Keeper(room).write(work(kept));
  const back = readKept(room)!;
  new Keeper(room).write({ ...back, name: "new" });
  expect(keptIn(room)).toEqual({ ...kept, name: "new" });
  expect(room.length).toBe(2);
  new Keeper(room).remove(back);
  expect(room.length).toBe(0);
});

test("what another page keeps under the same name is neither replaced nor removed", () => {
  const keeper = new Keeper(room);
  const mine = work(kept);
  const theirs = { ...kept, design: { ...kept.design, pattern: { rows: 3 } } };
  keeper.write(mine);
  new Keeper(room).write(work(theirs));
  new Keeper(room).write(work({ ...kept, name: "other" }));
  expect(keptIn(room, kept.name)).toEqual(theirs);
  keeper.write(mine);
  expect(keptIn(room)).toEqual(kept);
  keeper.remove(mine);
  expect(keptIn(room)?.name).toBe("other");
  expect(keptIn(room, kept.name)).toEqual(theirs);
});

test("of work that two pages go on with, both are kept", () => {
  new Keeper(room).write(work(kept));
  const [one, two] = [readKept(room)!, readKept(room)!];
  const changed = (mine: Work, rows: number): Work => ({ ...mine, design: { ...kept.design, pattern: { rows } } });
  new Keeper(room).write(changed(one, 3));
  new Keeper(room).write(changed(two, 5));
  new Keeper(room).write(changed(one, 7));
  const rows = [...room.texts.values()].map((text) => JSON.parse(text) as Partial<Named>).map(({ design }) => design?.pattern["rows"]);
  expect(rows.filter((each) => each !== undefined).sort()).toEqual([5, 7]);
});

test("each design has its own, and the latest comes back", () => {
  const keeper = new Keeper(room);
  const [first, other] = [work(kept), work({ ...kept, name: "other" })];
  keeper.write(first);
  keeper.write(other);
  expect(keptIn(room)?.name).toEqual("other");
  expect(keptIn(room, kept.name)).toEqual(kept);
  expect(readKept(room, "none")).toBeNull();
  keeper.remove(other);
  expect(keptIn(room)).toEqual(kept);
});

test("no more than sixteen designs are kept", () => {
  const keeper = new Keeper(room);
  for (let k = 0; k < 20; k++) keeper.write(work({ ...kept, name: `shell ${k}` }));
  expect([3, 4, 19].map((k) => readKept(room, `shell ${k}`)?.name)).toEqual([undefined, "shell 4", "shell 19"]);
  expect(room.length).toBe(17);
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
    { shell, pattern: {}, target: { surface: "x*y" } },
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
  const surface = { formula: "x*y", x: [0, 1], y: [0, 1] };
  room.texts.set("orishell.design:x", JSON.stringify({ name: "x", design: { shell, pattern: {}, target: { surface } } }));
  expect(readKept(room)?.design.target!.surface).toEqual(surface);
  for (const names of ["{", "3", "[3]", "null", ""]) {
    room.texts.set("orishell.latest", names);
    expect(readKept(room)).toBeNull();
  }
});

test("a browser that is full, or keeps nothing, does not hold another design", () => {
  const keeper = new Keeper(room);
  for (let k = 0; k < 16; k++) keeper.write(work({ ...kept, name: `shell ${k}` }));
  const mine = readKept(room)!;
  room.full = true;
  keeper.write(work({ ...kept, name: "later" }));
  expect(readKept(room, "later")).toBeNull();
  // Nothing goes for what is not kept in its place.
  expect(keptIn(room, "shell 0")).not.toBeNull();
  keeper.write({ ...mine, design: { ...kept.design, pattern: { rows: 3 } } });
  expect(readKept(room, "shell 15")).toBeNull();
  const nowhere = new Keeper(null);
  nowhere.write(mine);
  nowhere.remove(mine);
  expect(readKept(null)).toBeNull();
});

/** A page with a store whose unsaved work is kept in the room. */
function opened(): Store {
  const location = { hash: "" };
  const page = { localStorage: room, sessionStorage: tab, location, setTimeout, clearTimeout, addEventListener: () => undefined, document: { addEventListener: () => undefined } };
  const store = new Store({ families: {}, tables: {} } as unknown as Info, kept);
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
    rest();
    expect(keptIn(room)).toEqual({ ...kept, design: changed });
    expect(room.length).toBe(2);
    store.undo();
    rest();
    store.save(store.named);
    expect(room.length).toBe(0);
    store.undo();
    expect(store.unsaved).toBe(true);
    store.redo();
    rest();
    expect(room.length).toBe(0);
  });

  test("is neither replaced nor pushed out by links, whatever they are called", () => {
    const names = Array.from({ length: 15 }, (_, k) => `shell ${k}`);
    for (const name of names) new Keeper(room).write(work({ ...kept, name }));
    const store = opened();
    store.change(changed, "rows");
    rest();
    const before = new Map(room.texts);
    expect(before.size).toBe(17);
    for (const name of [kept.name, ...names, "new", "newer", "orishell.latest"]) {
      store.open({ ...other, name }, "the design of the link");
      rest();
      expect(room.texts).toEqual(before);
      expect(store.unsaved).toBe(false);
    }
    // Back at the work, which goes on where it was kept.
    while (store.name.value !== kept.name || store.design.value !== changed) store.undo();
    store.setPattern("rows", 23);
    rest();
    expect(room.texts.size).toBe(17);
    for (const name of names) expect(keptIn(room, name)).toEqual({ ...kept, name });
    expect(keptIn(room)?.design.pattern).toEqual({ rows: 23 });
  });

  test("that is made of a link has a place of its own", () => {
    const store = opened();
    store.change(changed, "rows");
    for (let again = 0; again < 2; again++) {
      store.open({ ...other, name: kept.name }, "the design of the link");
      store.setPattern("rows", 7);
      rest();
      expect(keptIn(room)?.design.pattern).toEqual({ rows: 7 });
      store.undo();
      store.undo();
      rest();
      expect(keptIn(room)).toEqual({ ...kept, design: changed });
    }
  });

  test("goes with its name", () => {
    const store = opened();
    store.change(changed, "rows");
    rest();
    store.rename("new");
    expect(keptIn(room)).toEqual({ name: "new", design: changed });
    expect(readKept(room, kept.name)).toBeNull();
    store.undo();
    expect(keptIn(room)).toEqual({ ...kept, design: changed });
    store.undo();
    rest();
    expect(room.length).toBe(0);
  });
});

test("a tab has open what it had, saved or not, with what it was made of", () => {
  vi.useFakeTimers();
  vi.stubGlobal("window", { event: undefined });
  const store = opened();
  store.change({ ...kept.design, pattern: { rows: 21 } }, "rows");
  store.open({ ...kept, name: "opened" });
  vi.advanceTimersByTime(1000);
  const again = readOpen(tab)!;
  expect(again).toMatchObject({ name: "opened", design: kept.design });
  expect(isUnsaved(again)).toBe(false);
  store.setPattern("rows", 9);
  vi.advanceTimersByTime(1000);
  const unsaved = readOpen(tab)!;
  expect(unsaved.design.pattern["rows"]).toBe(9);
  expect(unsaved.home.file).toEqual({ name: "opened", design: kept.design });
  expect(isUnsaved(unsaved)).toBe(true);
  // It is kept where it was, and no second time.
  const kinds = room.length;
  new Keeper(room).write(unsaved);
  expect(room.length).toBe(kinds);
  tab.full = true;
  store.open({ ...kept, name: "too large" });
  vi.advanceTimersByTime(1000);
  expect(readOpen(tab)).toBeNull();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("a link brings the design with its name", async () => {
  const fragment = await fragmentOf(kept);
  expect(fragment).toMatch(/^#design=[A-Za-z0-9_-]+$/);
  expect(await designOf(fragment!)).toEqual(kept);
});

test("a broken link is none, a very long one is not made", async () => {
  const fragment = (await fragmentOf(kept))!;
  for (const broken of ["", "#", "#design=", "#design=%%", fragment.slice(0, -9), `#x${fragment.slice(1)}`]) {
    await expect(designOf(broken)).rejects.toThrow("is broken");
  }
  const points = Array.from({ length: 4000 }, (_, k): [number, number] => [Math.sin(k), Math.cos(k * k)]);
  const long = { ...kept, design: { ...kept.design, target: { ...kept.design.target, f: { points } } } };
  expect(await fragmentOf(long)).toBeNull();
  // So long that its bytes are too many for one call.
  const many = Array.from({ length: 60_000 }, (_, k) => [k, Math.sin(k * k)] as [number, number]);
  expect(await fragmentOf({ ...kept, design: { ...kept.design, target: { ...kept.design.target, g: { points: many } } } })).toBeNull();
});

/** What a link has of any bytes. */
async function linkOf(...plain: BlobPart[]): Promise<string> {
  const stream = new Blob(plain).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const text = btoa(Array.from(bytes, (each) => String.fromCharCode(each)).join(""));
  return `#design=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
}

test("of a link that inflates without end ten megabytes are", async () => {
  const link = await linkOf(...Array.from({ length: 40 }, () => new Uint8Array(1_000_000)));
  expect(link.length).toBeLessThan(300_000);
  let inflated = 0;
  const { DecompressionStream: own } = globalThis;
  vi.stubGlobal("DecompressionStream", class {
    readonly writable: WritableStream;
    readonly readable: ReadableStream;
    constructor() {
      const through = new own("deflate-raw");
      const count = new TransformStream<Uint8Array>({
        transform(piece, into) {
          inflated += piece.length;
          into.enqueue(piece);
        },
      }, undefined, { highWaterMark: 0 });
      this.writable = through.writable;
      this.readable = through.readable.pipeThrough(count);
    }
  });
  const fault = await designOf(link).catch(faultOf);
  vi.unstubAllGlobals();
  expect(fault).toMatchObject({ kind: "input", what: "The design of this link has more than 10 MB" });
  expect(inflated).toBeGreaterThan(10_000_000);
  expect(inflated).toBeLessThan(13_000_000);
});

test("what ten megabytes hold is a design", async () => {
  const large = { ...kept, name: "x".repeat(9_900_000) };
  expect(await designOf(await linkOf(JSON.stringify(large)))).toEqual(large);
});
