// What the browser keeps of unsaved work, so that a page that was closed loses nothing.

import { namedOf } from "../files/link.ts";
import type { Named, Store } from "./store.ts";

/** Followed by the design's name. */
const KEY = "orishell.design:";
/** The names of what is kept, the latest first. */
const LATEST = "orishell.latest";
/** So many names are kept. */
const MOST = 8;
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

/** What is kept under a name; of none, what was kept last. */
export function readKept(storage: Storage | null, name = namesIn(storage)[0]): Named | null {
  const text = name === undefined ? null : storage?.getItem(KEY + name);
  if (!text) return null;
  try {
    return namedOf(JSON.parse(text));
  } catch {
    return null;
  }
}

function namesIn(storage: Storage | null): string[] {
  try {
    const names: unknown = JSON.parse(storage?.getItem(LATEST) ?? "[]");
    return Array.isArray(names) ? names.filter((each) => typeof each === "string") : [];
  } catch {
    return [];
  }
}

/** Keeps one page's designs, each under its name; what another page keeps in their place is not removed. */
export class Keeper {
  private mine: { name: string; text: string } | null = null;

  constructor(private readonly storage: Storage | null) {}

  write(named: Named): void {
    const { name } = named;
    const text = JSON.stringify(named);
    this.mine = { name, text };
    const names = [name, ...namesIn(this.storage).filter((each) => each !== name)];
    try {
      for (const old of names.splice(MOST)) this.storage?.removeItem(KEY + old);
      this.storage?.setItem(KEY + name, text);
      this.storage?.setItem(LATEST, JSON.stringify(names));
    } catch {
      // The browser's room is full: what was kept before would be another design.
      this.forget(name);
    }
  }

  /** Keep a design whose place another takes. */
  leave(named: Named): void {
    this.write(named);
    this.mine = null;
  }

  /** What was written last is saved, or has another name. */
  remove(): void {
    const { mine } = this;
    if (mine && this.storage?.getItem(KEY + mine.name) === mine.text) this.forget(mine.name);
    this.mine = null;
  }

  private forget(name: string): void {
    const { storage } = this;
    storage?.removeItem(KEY + name);
    const names = namesIn(storage).filter((each) => each !== name);
    try {
      if (names.length) storage?.setItem(LATEST, JSON.stringify(names));
      else storage?.removeItem(LATEST);
    } catch {
      // A name under which there is nothing does no harm.
    }
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
  store.replaced.watch((named) => named && keeper.leave(named));
  store.name.watch(() => {
    // Only the name is another: the design goes with it.
    if (Object.is(store.named.design, store.design.value)) {
      keeper.remove();
      keep();
    }
  });
  store.design.watch(later);
  store.saved.watch(keep);
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
