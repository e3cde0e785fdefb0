// What the browser keeps from visit to visit.

import { Signal } from "./signal.ts";

/** Where a browser refuses to keep anything, nothing is kept. */
export function storageOf(page: Window): Storage | null {
  try {
    return page.localStorage;
  } catch {
    return null;
  }
}

/** The same for what is kept as long as a tab is open. */
export function tabStorageOf(page: Window): Storage | null {
  try {
    return page.sessionStorage;
  } catch {
    return null;
  }
}

/** A choice that is kept. */
export function keptSwitch(key: string, fallback: boolean): Signal<boolean> {
  const storage = storageOf(window);
  const signal = new Signal(storage?.getItem(key) ? storage.getItem(key) === "on" : fallback);
  signal.watch((on) => {
    try {
      storage?.setItem(key, on ? "on" : "off");
    } catch {
      // A browser whose room is full: the choice lasts as long as the page.
    }
  });
  return signal;
}
