// What the tables [structure] and [load_case] of a design say, as the page shows and changes it.

import type { MaterialFacts } from "../../shared/api-types.ts";
import { METRES } from "../../shared/person.ts";
import { short } from "../parts/numbers.ts";
import type { Design } from "../state/types.ts";

type Table = Record<string, unknown>;
/** Values by key, the tables in front of them; undefined removes a key. */
export type Changes = Record<string, unknown>;
export type Load = "self_weight" | "snow" | "wind" | "person";

/** Panels are made so thick until another thickness is asked for (mm). */
const THICKNESS = 15;
/** Feet on the ground slide at this friction until another one is asked for. */
const FRICTION = 0.5;
/** A new base rail: a hollow section (mm). */
const RAIL = { width: 60, height: 60, wall: 3 };
/** Snow on the ground (kN/m2) and wind (m/s) of many places in lowlands. */
const SNOW = 1, WIND = 25;
/** Where a new wind blows. */
const OPEN = { terrain: "II", direction_deg: 0 };
const NAMES: Record<Load, string> = { self_weight: "own weight", snow: "snow", wind: "wind", person: "person" };
/** The loads that have controls, and those of them that come and go. */
export const LOADS = Object.keys(NAMES) as Load[];
const VARIABLE = LOADS.filter((load) => load !== "self_weight");
/** What says of a case how it acts, and loads nothing. */
const BESIDE = ["name", "action", "duration", "self_weight"];
/** Who works on a shell weighs so much where a file does not say it (N). */
export const PERSON = 1000;
/** Supports that rub where ballast holds them down. */
const BALLASTED = ["pinned", "fixed"];

export function structureOf({ structure }: Design): Table | null {
  return structure ?? null;
}

export function casesOf({ load_case: cases }: Design): Table[] {
  return cases ?? [];
}

/** Millimetres in the unit of a design. */
export function millimetres({ shell }: Design): number {
  return 1000 * (METRES[shell.unit] ?? 1);
}

/** Newtons per square of the design's unit in a kilonewton per square metre. */
export function kilonewtons({ shell }: Design): number {
  return 1000 * (METRES[shell.unit] ?? 1) ** 2;
}

/** Number of the first case that has a load of its own kind; -1 if there is none. */
export function caseWith(design: Design, load: Load): number {
  return casesOf(design).findIndex((each) => Boolean(each[load]));
}

/** Of a material; null: without a structure. What the file gives itself of another one is left out. */
export function withMaterial(design: Design, material: string | null, materials: readonly MaterialFacts[]): Changes {
  if (material === null) return { structure: undefined, load_case: undefined };
  const before = structureOf(design);
  if (before) {
    const { modulus: _, poisson: __, strength: ___, ...rest } = before;
    const named = (name: unknown): MaterialFacts | undefined => materials.find((each) => each.name === name);
    const [old, now] = [named(before["material"]), named(material)];
    // What has no grain has no direction of it; boards with a grain have no core, and a core is its material's.
    if (!now?.grain) delete rest["grain"];
    if (now?.grain || old?.sandwich) delete rest["sandwich"];
    return { structure: { ...rest, material } };
  }
  const thickness = design.panel?.["thickness"] ? {} : { thickness: Number(short(THICKNESS / millimetres(design))) };
  return {
    structure: { material, ...thickness, supports: [{ at: "feet", kind: "pinned" }] },
    load_case: casesOf(design).length ? design.load_case : [{ name: NAMES.self_weight, self_weight: true }],
  };
}

/** The material that is sold for it first, and loads as there are in many places: to be set to those of one's own. */
export function underSnowAndWind(design: Design, materials: readonly MaterialFacts[]): Changes {
  const loads: Table[] = [
    { name: NAMES.self_weight, self_weight: true },
    { name: NAMES.snow, snow: { ground: SNOW * kilonewtons(design) }, self_weight: true },
    { name: NAMES.wind, wind: { speed: WIND, ...OPEN }, self_weight: true },
  ];
  return { ...withMaterial(design, materials[0]!.name, materials), load_case: loads };
}

/** The one support of all feet or ends; null where the file lists others. */
export function supportOf(design: Design): Table | null {
  const supports = structureOf(design)?.["supports"];
  const all = Array.isArray(supports) ? supports : supports ? [supports] : [];
  const [only] = all as Table[];
  return all.length === 1 && typeof only!["at"] === "string" ? only! : null;
}

export function withSupport(design: Design, key: string, value: unknown): Changes {
  const support: Table = { ...(supportOf(design) ?? { at: "feet", kind: "pinned" }), [key]: value };
  // On the ground feet stand on points, and nothing holds them down.
  if (support["kind"] === "friction") {
    support["friction"] ??= FRICTION;
    for (const each of ["edges", "patch", "ballast"]) delete support[each];
  } else {
    if (!support["ballast"]) delete support["ballast"];
    if (!support["friction"] || !rubs(support)) delete support["friction"];
  }
  return { "structure.supports": [support] };
}

/** Whether a support may have friction: on the ground, or under ballast that is to hold it in place. */
export function rubs(support: Table): boolean {
  return support["kind"] === "friction" || (Boolean(support["ballast"]) && BALLASTED.includes(String(support["kind"])));
}

export function railOf(design: Design): Table | null {
  return (structureOf(design)?.["rail"] as Table | undefined) ?? null;
}

/** With a material or a size of the base rail; none without a material, bars without walls are solid. */
export function withRail(design: Design, key: string, value: unknown): Changes {
  const fresh = Object.entries(RAIL).map(([size, mm]) => [size, Number(short(mm / millimetres(design)))]);
  const rail: Table = { ...(railOf(design) ?? Object.fromEntries(fresh)), [key]: value };
  if (!rail["wall"]) delete rail["wall"];
  return { "structure.rail": rail["material"] ? rail : undefined };
}

/** With a key of a load, or without the load: its case goes, too, if nothing else is in it. */
export function withLoad(design: Design, load: Load, key: string, value: unknown): Changes {
  const cases = casesOf(design), number = caseWith(design, load);
  if (value !== undefined) {
    if (number >= 0) return { [`load_case.${number}.${load}${key && `.${key}`}`]: value };
    const given = key ? { ...(load === "wind" ? OPEN : {}), [key]: value } : value;
    return { load_case: weighed([...cases, { name: nameFor(cases, load), [load]: given }], isCombined(design)) };
  }
  if (number < 0) return {};
  const { [load]: _, ...rest } = cases[number]!;
  const kept = Object.keys(rest).some((each) => !BESIDE.includes(each));
  if (kept) return { [`load_case.${number}`]: rest };
  const others = cases.filter((__, k) => k !== number).flatMap((each) => without(each, String(rest["name"])));
  return { load_case: load === "self_weight" ? weighed(others, true) : others };
}

/** Loads by the combinations of a code, or each with own weight. */
export function withCombinations(design: Design, combinations: string): Changes {
  const none = combinations === "none";
  return { "structure.combinations": none ? undefined : combinations, load_case: weighed(casesOf(design), !none) };
}

function isCombined(design: Design): boolean {
  return (structureOf(design)?.["combinations"] ?? "none") !== "none";
}

/** Cases of loads that come and go with own weight, if that is a load; alone, where a code combines them. */
function weighed(cases: Table[], alone: boolean): Table[] {
  const weighs = !alone && cases.some((each) => each["self_weight"]);
  return cases.map((each) => {
    if (!VARIABLE.some((load) => each[load])) return each;
    const { self_weight: _, ...rest } = each;
    return weighs ? { ...rest, self_weight: true } : rest;
  });
}

/** Panels of a thickness have it in the table [panel] alone; without that the structure keeps it. */
export function withPanel(design: Design, panel: Table | undefined): Changes {
  if (!structureOf(design)) return { panel };
  const thickness = panel ? undefined : (design.panel?.["thickness"] ?? structureOf(design)!["thickness"]);
  return { panel, "structure.thickness": thickness };
}

/** A case that combines others, without one of them; none if nothing is left to combine. */
function without(each: Table, name: string): Table[] {
  if (!each["combine"]) return [each];
  const { [name]: _, ...combine } = each["combine"] as Table;
  return Object.keys(combine).length ? [{ ...each, combine }] : [];
}

function nameFor(cases: Table[], load: Load): string {
  const taken = cases.map(({ name }) => name);
  let name = NAMES[load];
  for (let k = 2; taken.includes(name); k++) name = `${NAMES[load]} ${k}`;
  return name;
}
