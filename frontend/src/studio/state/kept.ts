// What the browser keeps of unsaved work, so that a page that was closed loses nothing.

import { isLink } from "../files/link.ts";
import { type Home, type Named, type Work, isUnsaved, namedOf } from "./named.ts";
import { storageOf, tabStorageOf } from "./storage.ts";
import type { Store } from "./store.ts";

/** Followed by the slot: a design's name, and a number where that name is taken. */
const KEY = "orishell.design:";
/** The slots of what is kept, the latest first. */
const LATEST = "orishell.latest";
/** What a tab has open. */
const OPEN = "orishell.open";
/** So many designs are kept. */
const MOST = 16;
/** Rest after a change before it is kept, in milliseconds. */
const REST = 300;

/** What was kept last, of a name if one is given: it is in no file. */
export function readKept(storage: Storage | null, name?: string): Work | null {
  for (const slot of slotsIn(storage)) {
    const text = storage?.getItem(KEY + slot) ?? "";
    const found = read(text);
    if (found && (name ?? found.name) === found.name) return { ...found, home: { file: null, slot, text } };
  }
  return null;
}

/** What a tab had open, saved or not. */
export function readOpen(storage: Storage | null): Work | null {
  try {
    const found = JSON.parse(storage?.getItem(OPEN) ?? "null") as { file: unknown; slot: string | null } | null;
    const named = namedOf(found);
    if (!found || !named) return null;
    const { name, design } = named;
    const file = found.file === SAME ? named : namedOf(found.file);
    return { name, design, home: { file, slot: found.slot, text: JSON.stringify({ name, design }) } };
  } catch {
    return null;
  }
}

/** Stands for a file that has the design as it is. */
const SAME = "same";

function keepOpen(storage: Storage | null, work: Work): void {
  const { name, design, home } = work;
  try {
    storage?.setItem(OPEN, JSON.stringify({ name, design, file: isUnsaved(work) ? home.file : SAME, slot: home.slot }));
  } catch {
    // No room: what was open before is not what is open now.
    storage?.removeItem(OPEN);
  }
}

function read(text: string): Named | null {
  try {
    return namedOf(JSON.parse(text));
  } catch {
    return null;
  }
}

function slotsIn(storage: Storage | null): string[] {
  try {
    const slots: unknown = JSON.parse(storage?.getItem(LATEST) ?? "[]");
    return Array.isArray(slots) ? slots.filter((each) => typeof each === "string") : [];
  } catch {
    return [];
  }
}

/** Keeps designs, each in a slot of its own: what a page keeps never takes the place of what another
 * page keeps, or this one of another design, whatever their names are. */
export class Keeper {
  constructor(private readonly storage: Storage | null) {}

  write({ name, design, home }: Work): void {
    const { storage } = this;
    const slot = this.holds(home) ? home.slot! : this.free(name);
    Object.assign(home, { slot, text: JSON.stringify({ name, design }) });
    const slots = [slot, ...slotsIn(storage).filter((each) => each !== slot)];
    const old = slots.splice(MOST);
    try {
      storage?.setItem(KEY + slot, home.text);
      storage?.setItem(LATEST, JSON.stringify(slots));
      for (const each of old) storage?.removeItem(KEY + each);
    } catch {
      // The browser's room is full: what was kept before would be another design.
      this.forget(home);
    }
  }

  /** What was kept of a design is saved, or taken back. */
  remove({ home }: Work): void {
    if (this.holds(home)) this.forget(home);
  }

  /** Whether a slot is still as it was left. */
  private holds({ slot, text }: Home): boolean {
    return slot !== null && this.storage?.getItem(KEY + slot) === text;
  }

  private free(name: string): string {
    const taken = new Set(slotsIn(this.storage));
    let slot = name;
    for (let k = 2; taken.has(slot) || (this.storage?.getItem(KEY + slot) ?? null) !== null; k++) slot = `${name} ${k}`;
    return slot;
  }

  private forget(home: Home): void {
    const { storage } = this;
    storage?.removeItem(KEY + home.slot);
    const slots = slotsIn(storage).filter((each) => each !== home.slot);
    home.slot = null;
    try {
      if (slots.length) storage?.setItem(LATEST, JSON.stringify(slots));
      else storage?.removeItem(LATEST);
    } catch {
      // A slot in which there is nothing does no harm.
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
    else keeper.remove(store.named);
    // A link stays in the address, and brings its design itself.
    if (!isLink(page.location.hash)) keepOpen(tabStorageOf(page), store.named);
  };
  const later = (): void => {
    page.clearTimeout(timer);
    timer = page.setTimeout(keep, REST);
  };
  store.replaced.watch((work) => work && keeper.write(work));
  store.name.watch(() => {
    // Only the name is another: the design goes with it.
    if (Object.is(store.named.design, store.design.value)) keep();
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
