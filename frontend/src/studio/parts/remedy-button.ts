// The button that mends a fault, where the fault names a value that works.

import { capital } from "../../shared/words.ts";
import { button } from "./controls.ts";
import type { Store } from "../state/store.ts";
import type { Fault, Remedy } from "../state/types.ts";

/** Keys of the table [pattern] that the design's family knows. */
export function patternKeys(store: Store): string[] {
  const design = store.design.value;
  const parameters = store.info.families[design.shell.family]?.parameters ?? [];
  return [...parameters.map(({ key }) => key), ...Object.keys(design.pattern)];
}

/** Null if nothing is known that mends the fault. */
export function remedyButton(store: Store, fault: Fault): HTMLButtonElement | null {
  const [remedy] = fault.remedies;
  if (!remedy) return null;
  return changeButton(store, remedy.changes, { testid: "use-nearest", again: fault.again });
}

interface ChangeOptions {
  testid?: string;
  /** What it does, where values would not say it. */
  text?: string | undefined;
  /** Does again what was refused with these values. */
  again?: ((changes: Remedy["changes"]) => void) | undefined;
}

/** The button that changes values of the design, or does again what was refused with them. */
export function changeButton(store: Store, changes: Remedy["changes"], { testid = "mend", text: done, again }: ChangeOptions = {}): HTMLButtonElement {
  const said = done ?? store.labels.remedy({ text: "", changes });
  // "Use rows = 5", but "Set creases: rigid".
  const text = done ? capital(done) : `${said.includes(":") ? "Set" : "Use"} ${said}`;
  return button({
    label: text,
    text,
    class: "button primary",
    testid,
    act: () => (again ? again(changes) : store.set(changes, said)),
  });
}
