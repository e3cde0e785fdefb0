// What a search has found, put together from what the server tells on the way; without the page.

import type { FrontMember, SearchedDesign, SearchState } from "../../shared/api-types.ts";

export interface Found extends Omit<SearchState, "front"> {
  front: Member[];
}

/** A design that no other beats. */
export interface Member extends FrontMember {
  design: SearchedDesign;
}

/** What is known once more is told: designs are told once, all else anew. */
export function joined(before: Found | null, state: SearchState): Found {
  const designs = [...(before?.designs ?? []), ...state.designs];
  return { ...state, designs, front: state.front.map((each) => ({ ...each, design: designs[each.number]! })) };
}

/** How long the rest takes, in words; empty before that can be said. */
export function wordsOfRest({ made, total }: Pick<SearchState, "made" | "total">, seconds: number): string {
  if (made < 2 || made >= total) return "";
  const left = (seconds / made) * (total - made);
  if (left < 5) return "a few seconds left";
  if (left < 90) return `about ${5 * Math.round(left / 5)} s left`;
  return `about ${Math.round(left / 60)} min left`;
}

/** How many designs there are, and why others are not among them. */
export function wordsOfCount({ made, total, designs, refused }: SearchState, whole: boolean): string {
  const tried = whole ? `${made} designs tried` : `${made} of ${total} designs tried`;
  const left = made - designs.length;
  if (!left) return `${tried}.`;
  const reasons = refused.map(([reason, count]) => (refused.length > 1 || count !== left ? `${reason} (${count})` : reason));
  return `${tried}; ${left} cannot be made or break a limit: ${reasons.join("; ")}.`;
}
