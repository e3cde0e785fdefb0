// A target that is scaled for the sizes that its built shell is to have.

import { short } from "../parts/numbers.ts";
import type { Design, Report } from "./types.ts";

export type ScaledTarget = "f" | "g" | "surface" | "pattern";
const AXES = ["x", "y", "z"];

/** By how much the shell's target is larger than the design's, in words; empty where they are one. */
export function scaledBy(design: Design, report: Report | null, name: ScaledTarget): string {
  const scale = report?.fitted?.scales[`target.${name}.scale`];
  if (!design.target?.fit || scale === undefined) return "";
  const [now, own] = [listOf(scale), listOf(design.target[name]?.scale ?? 1)];
  const factors = Array.from({ length: Math.max(now.length, own.length) }, (_, k) => short((now[k] ?? now[0]!) / (own[k] ?? own[0]!), 4));
  if (factors.every((each) => each === factors[0])) return factors[0] === "1" ? "" : `by ${factors[0]}`;
  const parts = factors.map((each, k) => (each === "1" ? "" : `by ${each} along ${AXES[k]}`));
  return parts.filter(Boolean).join(" and ");
}

function listOf(scale: unknown): number[] {
  return Array.isArray(scale) ? scale.map(Number) : [Number(scale)];
}
