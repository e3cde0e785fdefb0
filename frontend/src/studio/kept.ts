// What the browser keeps of unsaved work, so that a page that was closed loses nothing.

import { namedOf } from "./link.ts";
import type { Named, Store } from "./store.ts";

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

export function readKept(storage: Storage | null): Named | null {
  const text = storage?.getItem(KEY);
  if (!text) return null;
  try {
    return namedOf(JSON.parse(text));
  } catch {
    return null;
  }
}

/** Keeps one page's design; what another page keeps in its place is not removed. */
export class Keeper {
  private mine: string | null = null;

  constructor(private readonly storage: Storage | null) {}

  write(named: Named): void {
    this.mine = JSON.stringify(named);
    try {
      this.storage?.setItem(KEY, this.mine);
    } catch {
      // The browser's room is full: what was kept before would be another design.
      this.storage?.removeItem(KEY);
    }
  }

  remove(): void {
    if (this.storage?.getItem(KEY) === this.mine) this.storage?.removeItem(KEY);
    this.mine = null;
  }
}

/** Keep the store's design while it is not saved, and ask before the page is left. */
export function keepUnsaved(store: Store, page: Window): void {
  const keeper = new Keeper(storageOf(page));
  let timer = 0;
  const keep = (): void => {
    page.clearTimeout(timer);
    timer = 0;
    if (store.unsaved) keeper.write(store.named);
    else keeper.remove();
  };
  const later = (): void => {
    page.clearTimeout(timer);
    timer = page.setTimeout(keep, REST);
  };
  for (const signal of [store.name, store.design, store.saved]) signal.watch(later);
  page.addEventListener("pagehide", keep);
  page.document.addEventListener("visibilitychange", () => {
    if (page.document.visibilityState === "hidden") keep();
  });
  page.addEventListener("beforeunload", (event) => {
    if (!store.unsaved) return;
    keep();
    event.preventDefault();
  });
  keep();
}
