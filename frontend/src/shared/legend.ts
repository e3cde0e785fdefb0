// What the colours mean, in a corner of the view in space.

import type { Drawn } from "./loaded3d.ts";
import { AMOUNT_MAP, DISTANCE_MAP, type Colouring } from "./colours.ts";
import { length, threeDigits } from "./quantities.ts";

export interface LegendFacts {
  colouring: Colouring;
  unit: string;
  /** Largest distance, 0 if none is known. */
  range: number;
  /** Numbers of edges by assignment. */
  counts: number[];
  /** The load case drawn, if there is one. */
  loaded: Drawn | null;
  /** What else is seen. */
  marks: Iterable<Mark>;
}

const SIGNS: [string, string, number][] = [
  ["mountain", "--mountain", 1],
  ["valley", "--valley", 2],
  ["unfolded", "--unfolded", 3],
  ["edge", "--border-crease", 0],
  ["cut", "--border-crease", 4],
];
/** What is seen beside creases: its words, and its colour. */
const MARKS = {
  surface: ["target surface", "--target"],
  f: ["curve f", "--curve-f"],
  g: ["curve g", "--curve-g"],
  contact: ["panels that touch", "--contact"],
  chosen: ["chosen", "--accent"],
  verdict: ["of the verdict", "--accent"],
  measured: ["distance", "--text"],
  pinned: ["pinned", "--ghost"],
  variant: ["pointed at", "--ghost"],
  feet: ["feet", "--foot"],
  flaps: ["flaps", "--flap"],
  ties: ["ties", "--tie"],
} as const;
export type Mark = keyof typeof MARKS;

export function renderLegend(container: HTMLElement, facts: LegendFacts): void {
  container.replaceChildren();
  container.hidden = false;
  if (facts.loaded) {
    explainLoaded(container, facts.loaded, facts.unit);
    return;
  }
  if (facts.colouring === "plain") {
    key(container, "upper side", "--panel-front", "orishell-side");
    key(container, "underside", "--panel-back", "orishell-side");
  } else if (facts.colouring === "signs") {
    explainSigns(container, facts.counts);
  } else if (facts.colouring === "angle") {
    bar(container, "fold angle, largest of the panel's creases", AMOUNT_MAP, ["0\u00b0", "90\u00b0", "180\u00b0"]);
  } else if (facts.range) {
    bar(container, "distance to the target surface", DISTANCE_MAP, [
      `\u2212${length(facts.range, facts.unit)}`, "0", `+${length(facts.range, facts.unit)}`,
    ]);
  } else {
    part(container, "orishell-legend-title").textContent = "distance to the target: not yet known";
  }
  for (const mark of facts.marks) {
    const [name, colour] = MARKS[mark];
    key(container, name, colour);
  }
}

/** What the lines of a crease pattern are; counts of edges by assignment. */
export function explainSigns(container: HTMLElement, counts: number[]): void {
  for (const [name, colour, code] of SIGNS) {
    if (counts[code]) key(container, name, colour, name === "valley" ? "orishell-stroke orishell-dashed" : "orishell-stroke");
  }
}

function key(container: HTMLElement, name: string, colour: string, kind = "orishell-stroke"): void {
  const item = part(container, "orishell-key");
  part(item, kind).style.setProperty("--ink", `var(${colour})`);
  item.append(name);
}

function explainLoaded(container: HTMLElement, { deflection, measure, scale, most, of, force }: Drawn, unit: string): void {
  const { name, balanced, strength, partsStrength } = deflection;
  const what = balanced ? `${measure}${of === null ? "" : `, most in ${of}`}` : "unstable: nothing resists this";
  const mpa = (size: number): string => `${threeDigits(size)} MPa`;
  const end = !balanced ? "most" : measure === "stress" ? mpa(most) : length(most, unit);
  const drawn = !balanced ? "" : `; displacements \u00d7 ${threeDigits(scale)}`;
  if (balanced && measure === "utilisation") {
    bar(container, `${name}: stress, ${threeDigits(100 * most)} % of strength at most, in ${of}${drawn}`, AMOUNT_MAP, [
      "0", "50 %", `100 %: ${[...new Set([strength, partsStrength])].flatMap((each) => (each ? mpa(each) : [])).join(", ")}`,
    ]);
  } else {
    bar(container, `${name}: ${what}${drawn}`, AMOUNT_MAP, ["0", end]);
  }
  if (force) key(container, `load, up to ${threeDigits(force)} N a panel`, "--load");
}

function bar(container: HTMLElement, title: string, map: string[], ticks: string[]): void {
  part(container, "orishell-legend-title").textContent = title;
  part(container, "orishell-ramp").style.background = `linear-gradient(to right, ${map.join(", ")})`;
  const row = part(container, "orishell-ticks");
  for (const tick of ticks) row.append(Object.assign(document.createElement("span"), { textContent: tick }));
}

function part(container: HTMLElement, name: string): HTMLElement {
  const element = document.createElement("div");
  element.className = name;
  container.append(element);
  return element;
}
