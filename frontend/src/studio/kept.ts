// What the browser keeps of unsaved work, so that a page that was closed loses nothing.

import { keptOf } from "./link.ts";
import type { Store } from "./store.ts";
import type { Design } from "./types.ts";

export interface Kept {
  name: string;
  design: Design;
}

const KEY = "orishell.design";
/** Rest after a change before it is kept, in milliseconds. */
const REST = 300;

/** Where a browser refuses to keep anything, nothing is kept. */
export function storageOf(page: Window): Storage | null {
  try {
    return page.localStorage;
  } catch {
    return null;
  }
}

export function readKept(storage: Storage | null): Kept | null {
  const text = storage?.getItem(KEY);
  if (!text) return null;
  try {
    return keptOf(JSON.parse(text));
  } catch {
    return null;
  }
}

export function writeKept(storage: Storage | null, kept: Kept | null): void {
  if (!kept) return storage?.removeItem(KEY);
  try {
    storage?.setItem(KEY, JSON.stringify(kept));
  } catch {
    // The browser's room is full: what was kept before would be another design.
    storage?.removeItem(KEY);
  }
}

/** Keep the store's design while it is not saved, and ask before the page is left. */
export function keepUnsaved(store: Store, page: Window): void {
  const storage = storageOf(page);
  let timer = 0;
  const keep = (): void => {
    page.clearTimeout(timer);
    timer = 0;
    writeKept(storage, store.unsaved ? { name: store.name.value, design: store.design.value } : null);
  };
  const later = (): void => {
    page.clearTimeout(timer);
    timer = page.setTimeout(keep, REST);
  };
  store.design.watch(later);
  store.saved.watch(later);
  store.name.watch(later);
  page.addEventListener("pagehide", keep);
  page.document.addEventListener("visibilitychange", () => {
    if (page.document.visibilityState === "hidden") keep();
  });
  page.addEventListener("beforeunload", (event) => {
    if (!store.unsaved) return;
    keep();
    event.preventDefault();
  });
}
