// Sizes that the built shell is to have, the table [target.fit], and what it measures; without the page.

import { tableOf } from "../state/changed.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";

export type Side = "outside" | "inside";
export const SIZES = ["width", "depth", "height"] as const;
export type Size = (typeof SIZES)[number];

export function fitOf(design: Design): Record<string, number | string> {
  return design.target?.fit ?? {};
}

export function isAsked(table: Record<string, unknown>): boolean {
  return SIZES.some((key) => table[key] !== undefined);
}

/** Of what sizes are asked for; null if none are. */
export function sideOf(table: Record<string, unknown>): Side | null {
  return !isAsked(table) ? null : table["of"] === "inside" ? "inside" : "outside";
}

/** A table has a size; the room is clear up to a height only where it has a width or depth. Null: none is asked for. */
export function fitTable(given: Record<string, unknown>, side: Side): Record<string, unknown> | null {
  const inside = side === "inside";
  const { head_height: head, ...sizes } = given;
  const clear = inside && (sizes["width"] ?? sizes["depth"]) !== undefined;
  if (!isAsked(sizes)) return null;
  return tableOf({ ...sizes, of: inside ? side : undefined, head_height: clear ? head : undefined }) ?? null;
}

/** What the shell on the screen measures, as far as that is known. */
export function measuredSizes({ report, proof, freshness }: Pick<Store, "report" | "proof" | "freshness">, side: Side): Partial<Record<Size, number>> {
  if (freshness.value === "outdated") return {};
  const sizes = proof.value.state === "done" ? proof.value.sizes : null;
  const fitted = report.value?.fitted;
  const drawn = side === "outside" ? report.value?.outside : undefined;
  return sizes?.[side] ?? (fitted?.of === side ? fitted.found : (drawn ?? {}));
}
