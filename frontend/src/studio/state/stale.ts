// What was said of a design is gone with it.

import type { Store } from "./store.ts";

/** While a design is changed, what was wrong stays until the server has looked again; what is wrong
 * with a file, or with another design, goes at once. */
export function forgetWhatIsStale(store: Store): void {
  store.design.watch((design, before) => {
    const { fault } = store;
    const another = design.shell !== before.shell || design.tolerance !== before.tolerance;
    if (another) store.ranges.set({});
    if (fault.value && (another || fault.value.kind === "page" || OF_FILES.has(fault.value))) fault.set(null);
  });
}

/** Faults that no change of the design mends. */
const OF_FILES = new WeakSet<object>();

export function isOfFile(fault: object | null): boolean {
  return fault !== null && OF_FILES.has(fault);
}

/** A fault of reading or writing a file, not of the design. */
export function ofFile<T extends object>(fault: T): T {
  OF_FILES.add(fault);
  return fault;
}
