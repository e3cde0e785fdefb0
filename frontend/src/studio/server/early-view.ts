// The first shell is asked for while the page that draws it is still being loaded.

import { type Answer, fetchView as fetchAnew } from "./api.ts";
import { isWhole } from "../curves/curve-table.ts";
import { isSlow } from "../state/aims.ts";
import { liveStates } from "./states.ts";
import type { Design } from "../state/types.ts";

let early: { design: Design; states: number; view: Promise<Answer> } | null = null;

export function askEarly(design: Design): void {
  if (design.tolerance || isSlow(design) || !isWhole(design)) return;
  const states = liveStates(design);
  const view = fetchAnew(design, states);
  // Whoever fetches it hears of its fault.
  view.catch(() => undefined);
  early = { design, states, view };
}

/** The view of a design: the one asked for early, if it is that. */
export function fetchView(design: Design, states: number, signal?: AbortSignal): Promise<Answer> {
  const asked = early;
  early = null;
  if (asked && asked.design === design && asked.states === states) return asked.view;
  return fetchAnew(design, states, signal);
}
