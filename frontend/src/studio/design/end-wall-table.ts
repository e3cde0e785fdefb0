// What the tables [[end_wall]] of a design say, as the page shows and changes them.

import { millimetres } from "../structure/table.ts";
import { short } from "../parts/numbers.ts";
import type { Design, Value } from "../state/types.ts";

export const ENDS = ["first", "last"] as const;
export type End = (typeof ENDS)[number];
export type Wall = Record<string, Value>;
export const DOOR = ["width", "height", "offset"] as const;
export type DoorSize = (typeof DOOR)[number];

/** A new door (mm). */
const USUAL = { width: 900, height: 2000 };

export function wallAt({ end_wall }: Design, at: End): Wall | undefined {
  return end_wall?.find((each) => each["at"] === at);
}

export function doorOf(wall: Wall | undefined): Record<string, number> | undefined {
  return wall?.["door"] as unknown as Record<string, number> | undefined;
}

/** The tables with another wall, or none, at an end; those of the file keep their order. None is left: no table. */
export function withWall(design: Design, at: End, wall: Wall | undefined): Wall[] | undefined {
  const before = design.end_wall ?? [];
  const stands = before.some((each) => each["at"] === at);
  const made = wall && !stands ? [...before, wall] : before.flatMap((each) => (each["at"] !== at ? [each] : wall ? [wall] : []));
  return made.length ? made : undefined;
}

/** A wall with another value; null removes it. */
export function walled(wall: Wall | undefined, at: End, key: string, value: unknown): Wall {
  const { [key]: _, ...rest } = wall ?? { at };
  return value === null ? rest : { ...rest, [key]: value as Value };
}

export function usualDoor(design: Design): Record<string, number> {
  const size = (mm: number): number => Number(short(mm / millimetres(design), 2));
  return { width: size(USUAL.width), height: size(USUAL.height) };
}
