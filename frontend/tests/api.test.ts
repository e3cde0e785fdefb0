import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { exportDesign, fetchRanges, fetchView, verify } from "../src/studio/server/api.ts";
import { faultOf, ownFault } from "../src/studio/state/faults.ts";
import { Live } from "../src/studio/server/live.ts";
import { forgetWhatIsStale, ofFile } from "../src/studio/state/stale.ts";
import { Store } from "../src/studio/state/store.ts";
import type { Design, Info } from "../src/studio/state/types.ts";
import scipy from "./motion.json";

const DESIGN: Design = {
  shell: { family: "orthodiagonal", unit: "m" },
  target: { f: { formula: "x" }, g: { formula: "x" } },
  pattern: { rows: 9, columns: 11 },
};

/** A body that ends, or breaks off, after some of it. */
function body(text: string, breaks = true): Response {
  let sent = false;
  return new Response(
    new ReadableStream({
      pull(controller) {
        if (!sent) controller.enqueue(new TextEncoder().encode(text));
        else if (breaks) controller.error(new TypeError("network error"));
        else controller.close();
        sent = true;
      },
    }),
  );
}

const answers = (answer: (path: string) => Response | Promise<Response>): void => {
  vi.stubGlobal("fetch", async (path: string) => answer(path));
};
const kindOf = (asked: Promise<unknown>): Promise<string> => asked.then(() => "none", (error: unknown) => faultOf(error).kind);

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("window", { event: undefined, setTimeout: (...all: Parameters<typeof setTimeout>) => setTimeout(...all) });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("a server that dies while it answers does not answer", async () => {
  const { signal } = new AbortController();
  const message = '{"progress": 0.5, "what": "verifying"}\n';
  for (const breaks of [true, false]) {
    answers(() => body(`${message}{"resu`, breaks));
    expect(await kindOf(verify(DESIGN, signal, () => undefined))).toBe("network");
    expect(await kindOf(fetchRanges(DESIGN, signal))).toBe("network");
  }
  answers(() => body("abc"));
  expect(await kindOf(fetchView(DESIGN, 1))).toBe("network");
  expect(await kindOf(exportDesign(DESIGN, "svg", 0, "x"))).toBe("network");
});

test("what was broken off here is not taken for that", async () => {
  const controller = new AbortController();
  answers(() => {
    controller.abort();
    return body("{");
  });
  await expect(fetchRanges(DESIGN, controller.signal)).rejects.toThrow("network error");
});

test("a design comes to rest where the server dies over its ranges", async () => {
  const refused = JSON.stringify({ error: { kind: "design", what: "no", keys: [] } });
  const asked: string[] = [];
  answers((path) => {
    asked.push(path);
    return path === "api/design" ? new Response(refused, { status: 422 }) : body("{");
  });
  const store = new Store({ families: {}, tables: {} } as unknown as Info, { name: "shell", design: DESIGN });
  const live = new Live(store, () => Promise.resolve());
  live.changed();
  await vi.advanceTimersByTimeAsync(1000);
  expect(asked.sort()).toEqual(["api/design", "api/ranges", "api/verify"]);
  expect(live.idle).toBe(true);
  expect(store.fault.value).toMatchObject({ kind: "design", searching: false });
});

test("a server that does not answer is asked again, and sizes are chosen anew with their word", async () => {
  let asked = 0;
  answers(() => {
    asked++;
    throw new TypeError("failed to fetch");
  });
  const store = new Store({ families: {}, tables: {} } as unknown as Info, { name: "shell", design: { ...DESIGN, tolerance: { surface: 1 } } });
  const live = new Live(store, () => Promise.resolve());
  const words: unknown[] = [];
  store.busy.watch((word) => words.push(word));
  live.choose();
  await vi.advanceTimersByTimeAsync(2100);
  expect(asked).toBe(2);
  expect(words).toEqual(["Choosing rows and columns", null, "Choosing rows and columns", null]);
});

test("a studio with another key is asked again until the browser has it", async () => {
  const bytes = Uint8Array.from(atob(scipy.view), (each) => each.charCodeAt(0));
  const refused = JSON.stringify({ error: { kind: "key", what: "the studio's key is missing", keys: [] } });
  let known = false;
  answers((path) => (!known ? new Response(refused, { status: 403 }) : path === "api/design" ? new Response(bytes) : body("{")));
  const store = new Store({ families: {}, tables: {} } as unknown as Info, { name: "shell", design: DESIGN });
  const live = new Live(store, () => Promise.resolve());
  live.changed();
  await vi.advanceTimersByTimeAsync(100);
  expect(store.fault.value).toMatchObject({ kind: "network", what: "The studio was started anew, with another key" });
  expect(store.fault.value?.remedy).toContain("open the address that it printed");
  known = true;
  await vi.advanceTimersByTimeAsync(2100);
  expect(store.view.value).not.toBeNull();
  expect(store.fault.value).toBeNull();
});

test("a change breaks the search for sizes off, with its word", async () => {
  answers(() => new Promise(() => undefined));
  const store = new Store({ families: {}, tables: {} } as unknown as Info, { name: "shell", design: { ...DESIGN, tolerance: { surface: 1 } } });
  const live = new Live(store, () => Promise.resolve());
  live.choose();
  expect(store.busy.value).toBe("Choosing rows and columns");
  store.change({ ...store.design.value, tolerance: { surface: 2 } }, "surface");
  expect(store.busy.value).toBeNull();
});

test("what is wrong with a file stays when the view comes, and goes with the design", async () => {
  const bytes = Uint8Array.from(atob(scipy.view), (each) => each.charCodeAt(0));
  answers((path) => (path === "api/design" ? new Response(bytes) : body("{")));
  const store = new Store({ families: {}, tables: {} } as unknown as Info, { name: "shell", design: DESIGN });
  const live = new Live(store, () => Promise.resolve());
  forgetWhatIsStale(store);
  live.changed();
  const fault = ofFile(ownFault("input", "The link of this design is broken"));
  store.fault.set(fault);
  await vi.advanceTimersByTimeAsync(100);
  expect(store.view.value).not.toBeNull();
  expect(store.fault.value).toBe(fault);
  store.setPattern("rows", 7);
  expect(store.fault.value).toBeNull();
  store.fault.set(ownFault("input", "This design is not usable"));
  await vi.advanceTimersByTimeAsync(100);
  expect(store.fault.value).toBeNull();
});
