// Where in the shell a row of the verdict is: panels, ties, feet, the state, the load case.

import { isFlap } from "../../shared/inspect.ts";
import { feetOf, groundOf } from "../../shared/ground.ts";
import { contactOf, shareOf, stopsOf, targetShare } from "../../shared/stops.ts";
import { tiesOf } from "../../shared/ties.ts";
import { drives, numberOf, panelCount, type View } from "../../shared/view.ts";
import { worstCase } from "../structure/worst.ts";

export interface Place {
  panels: readonly number[];
  /** Vertices. */
  feet: readonly number[];
  /** Pairs of vertices. */
  ties: readonly (readonly [number, number])[];
  /** Share of the motion at which it is seen. */
  share: number;
  /** The load case that it is about. */
  load: string | null;
}

export function placeOf(subject: string, view: View): Place {
  const target = targetShare(stopsOf(view));
  const place: Place = { panels: [], feet: [], ties: [], share: target, load: null };
  switch (subject) {
    case "folds":
      return { ...place, ...meeting(view, target) };
    case "locks":
    case "held":
      return { ...place, ...holding(view) };
    case "packs":
      return { ...place, share: stopsOf(view).find(({ name }) => name === "pack")?.share ?? target };
    case "stands":
      return { ...place, feet: standing(view), load: worstCase(view)?.name ?? null };
    default:
      return place;
  }
}

/** The panels that meet, or may; short of the target where they do. */
function meeting(view: View, target: number): Partial<Place> {
  const contact = contactOf(view), first = view.header.report.lock?.first_contact;
  const panels = contact?.panels ?? first?.panels.map((each) => numberOf(view, each)) ?? [];
  const all = drives(view);
  const share = contact ? shareOf(all, contact.drive_deg) : target;
  // Beyond the target ties hold it, or nobody folds it.
  return { panels: panels.filter((panel) => panel >= 0), share: Math.max(0, Math.min(share, target)) };
}

/** What stops the shell at its target, closing and opening. */
function holding(view: View): Partial<Place> {
  const { deployment, lock } = view.header.report;
  const { closing, opening } = deployment ?? {};
  const meet = lock?.clipped_contact ?? (closing === "clash" || closing === "boards" ? lock?.first_contact : null);
  const flaps = closing === "flaps" ? Array.from({ length: panelCount(view) }, (_, k) => k).filter((panel) => isFlap(view, panel)) : [];
  const panels = meet ? meet.panels.map((each) => numberOf(view, each)).filter((panel) => panel >= 0) : flaps;
  return {
    panels,
    ties: opening === "ties" ? tiesOf(view).map(({ ends }) => ends) : [],
    feet: closing && opening ? [] : standing(view),  // only its supports hold it
  };
}

function standing(view: View): number[] {
  return feetOf(view, groundOf(view));
}
