// Designs that follow curves, a surface or a drawn sheet, or have no target; and the ways between.

import { READY_MADE } from "../surface/ready-made.ts";
import { changed } from "./changed.ts";
import type { Signal } from "./signal.ts";
import type { Design, Info, Target, Value } from "./types.ts";

export type Aim = "curves" | "surface" | "drawing" | "none";

/** Keys that mean the same in every family, for the same target. */
const SHARED = ["rows", "columns", "flap"];

export function aimOf({ target }: Design): Aim {
  if (!target || isSizesOnly(target)) return "none";
  if (target.pattern) return "drawing";
  return target.surface ? "surface" : "curves";
}

/** Sizes of a sheet that follows nothing. */
function isSizesOnly(target: Target): boolean {
  const keys = Object.keys(target);
  return keys.length === 1 && keys[0] === "fit";
}

/** Whether the shell is fitted to its surface, which takes seconds. */
export function isFitted(design: Design): boolean {
  return aimOf(design) === "surface";
}

/** What a design calls the family that is to be chosen. */
export const AUTO = "auto";

export function isAuto(design: Design): boolean {
  return design.shell.family === AUTO;
}

/** Whether its shell takes seconds: it is fitted, or all families are tried. */
export function isSlow(design: Design): boolean {
  return isFitted(design) || isAuto(design);
}

/** A design whose family is to be chosen, in one of them, as it is compared. */
export function inFamily(info: Info, design: Design, family: string): Design {
  const pattern = { ...openKeys(info, family, aimOf(design)), ...design.pattern };
  return changed(design, { "shell.family": family, pattern });
}

/** What must be given, and has no value yet, is left to the program. */
function openKeys(info: Info, family: string, aim: Aim): Record<string, Value> {
  const open = info.families[family]!.parameters.filter(({ auto, default: value, only }) => value === null && auto && (only ?? aim) === aim);
  return Object.fromEntries(open.map(({ key }) => [key, "auto"]));
}

/** What was last followed, and with which parameters of each family. */
export class Left {
  private readonly targets = new Map<Aim, Target | undefined>();
  private readonly patterns = new Map<string, Record<string, Value>>();
  private readonly families = new Map<Aim, string>();

  constructor(design: Signal<Design>) {
    design.bind((design) => {
      const { shell: { family }, pattern, target } = design;
      const aim = aimOf(design);
      this.targets.set(aim, target);
      this.families.set(aim, family);
      this.patterns.set(`${family} ${aim}`, pattern);
    });
  }

  target(aim: Aim): Target | undefined {
    return this.targets.get(aim);
  }

  family(aim: Aim): string | undefined {
    return this.families.get(aim);
  }

  pattern(family: string, aim: Aim): Record<string, Value> | undefined {
    return this.patterns.get(`${family} ${aim}`);
  }
}

/** What is known of designs and families. */
interface Known {
  readonly info: Info;
  readonly design: { readonly value: Design };
  readonly left: Left;
}

/** The present design in another family; what that cannot follow is replaced by what it can. */
export function designIn(store: Known, family: string): Design {
  const design = store.design.value;
  const { aims } = store.info.families[family]!;
  const aim = aimOf(design);
  return made(store, family, aims.includes(aim) ? aim : (aims[0] ?? "curves"));
}

/** A design that follows the other thing. */
export function designFor(store: Known, aim: Aim): Design {
  const { families } = store.info;
  const now = store.design.value.shell.family;
  const can = (name: string | undefined): name is string => name !== undefined && (families[name]?.aims.includes(aim) ?? false);
  // The one that follows any surface comes before those that follow curves.
  const names = Object.keys(families);
  const own = names.filter((name) => !families[name]!.aims.includes("curves"));
  const family = [store.left.family(aim), ...(aim === "surface" ? own : []), now, ...names].find(can);
  return family ? made(store, family, aim) : store.design.value;
}

function made(store: Known, family: string, aim: Aim): Design {
  const design = store.design.value;
  const same = aimOf(design) === aim;
  const target = aim === "none" ? (same && design.target) || null : same ? design.target : (store.left.target(aim) ?? usualTarget(store, family, aim));
  const pattern = patternFor(store, family, aim, same);
  const tables = same ? {} : { tolerance: null };
  return changed(design, { "shell.family": family, target, pattern, ...tables });
}

function usualTarget(store: Known, family: string, aim: Aim): Target | undefined {
  const { shell, target } = store.design.value;
  if (aim === "surface") return { surface: READY_MADE[0]!.table(shell.unit) };
  return exampleOf(store, family, aim)?.target ?? target;
}

function exampleOf(store: Known, family: string, aim: Aim): Design | undefined {
  const designs = store.info.examples.map((each) => each.design as unknown as Design);
  const fitting = designs.filter((each) => aimOf(each) === aim);
  return fitting.find((each) => each.shell.family === family) ?? fitting[0];
}

function patternFor(store: Known, family: string, aim: Aim, same: boolean): Record<string, Value> {
  const design = store.design.value;
  const { parameters } = store.info.families[family]!;
  const pattern = openKeys(store.info, family, aim);
  // Without a target, a family's own example is what there is to begin with.
  const example = exampleOf(store, family, aim);
  const usual = aim === "none" && example?.shell.family === family ? example.pattern : undefined;
  Object.assign(pattern, store.left.pattern(family, aim) ?? usual);
  // Flaps that suit one family do not suit all: where the family is left open, each has its own.
  const shared = SHARED.filter((key) => family !== AUTO || key !== "flap");
  for (const key of same ? shared : []) {
    const value = design.pattern[key];
    if (value !== undefined && parameters.some((each) => each.key === key)) pattern[key] = value;
  }
  const odd = parameters.some((p) => p.key === "rows" && p.step === 2);
  if (odd && typeof pattern["rows"] === "number" && pattern["rows"] % 2 === 0) pattern["rows"]++;
  if (design.tolerance && same) {
    delete pattern["rows"];
    delete pattern["columns"];
    return pattern;
  }
  // A drawn sheet has its own rows and columns.
  if (aim === "drawing") return pattern;
  pattern["rows"] ??= 9;
  pattern["columns"] ??= aim === "surface" ? 9 : 11;
  trim(pattern);
  return pattern;
}

/** Lists that were as long as the rows and columns then do not outlive these. */
function trim(pattern: Record<string, Value>): void {
  const lengths: Record<string, number> = {
    row_lengths: Number(pattern["columns"]) - 1,
    couplings: Number(pattern["columns"]) - 1,
    column_lengths: Number(pattern["rows"]) + 1,
  };
  for (const [key, length] of Object.entries(lengths)) {
    const value = pattern[key];
    if (Array.isArray(value) && value.length !== length) delete pattern[key];
  }
}
