// The figures of a shell, from its report; what a report does not say is measured on the view.

import { area, length, sides, threeDigits } from "./quantities.ts";
import { structureFigures } from "./structure-figures.ts";
import { panelCount, targetPoints, type Known, type View } from "./view.ts";

interface Size { width: number; height: number; depth?: number; area?: number }

export const UNKNOWN = "not yet known";
const CAUSES = {
  flaps: "against closing, by its flaps",
  clash: "panels meet",
  crease: "a crease is folded flat",
  hinges: "hinges close no further",
  boards: "boards close no further",
  unproved: "proved no further",
};

/** A pack less high than this share of its length is a bundle, whose layers count: as in the verdict. */
const SLIM = 0.03;

/** Names and figures in three groups; `container` is emptied first. */
export function renderFigures(container: HTMLElement, view: View): void {
  const { report, unit, names } = view.header;
  const whole = Object.keys(report).length > 0;
  container.replaceChildren(
    ...group("Shell", (add) => {
      const shell: Size | null = report.deployed ?? measured(view, "shell");
      if (shell) {
        add("Span", sides([shell.width, shell.depth ?? 0], unit), "in plan");
        add("Height", length(shell.height, unit), "");
      }
      if (whole) closeness(report, unit, add);
    }),
    ...group("Sheet", (add) => {
      const sheet: Size | null = report.sheet ?? measured(view, "flat");
      const { grid } = view.header;
      const count = names ? new Set(names).size : panelCount(view);  // parts of one have one name
      // The report counts boards that are clipped on, too.
      const { panels = count, clipped = 0 } = report.quantities ?? {};
      const counted = grid && !names ? `${grid[0] - 1} \u00d7 ${grid[1] - 1}` : "";
      add("Panels", panels.toLocaleString("en").replaceAll(",", "\u202f"), clipped ? `${counted || count}, and ${clipped} clipped on` : counted);
      if (sheet) {
        add("Flat sheet", sides([sheet.width, sheet.height], unit), "", "sheet");
        if (sheet.area) add("Area", area(sheet.area, unit), "");
      }
    }),
    ...(whole ? group("Deployment and loads", (add) => deployed(report, unit, add)) : []),
  );
}

type Add = (name: string, value: string, note: string, key?: string) => void;

function closeness({ deviation }: Known, unit: string, add: Add): void {
  if (deviation === null) return;
  const { surface, crests, valleys, tilted } = deviation ?? {};
  const mean = surface && `mean ${length(surface.mean, unit)}${tilted ? `; in the surface asked for ${tilted}` : ""}`;
  add("Deviation", surface ? length(surface.max, unit) : surface === null ? "not measured" : UNKNOWN, mean || "from the target, at most");
  if (!crests || !valleys) return;
  const most = Math.max(crests.max, valleys.max);
  const parts = `crests ${length(crests.max, unit)}, valleys ${length(valleys.max, unit)}`;
  add("Vertices", `within ${length(most, unit)}`, `of the surfaces beside the target that they follow: ${parts}`);
}

function deployed(report: Known, unit: string, add: Add): void {
  const { flap_attachment: flaps, start, packed, pieces, weight, ties } = report.deployment ?? {};
  const locked = report.lock ? report.lock.cause === "flaps" : flaps === "folded";
  add(locked ? "Locks at" : "Closes to", lockOf(report), lockNote(report), "lock");
  if (pieces?.length) add("Pieces", String(pieces.length), "the largest packs as follows");
  add(start === "pack" ? "Pack" : "Smallest box", packed ? boxOf(packed, unit) : UNKNOWN,
    packed ? `at ${threeDigits(packed.drive_deg)}\u00b0, ${packed.layers} ${packed.layers === 1 ? "panel" : "panels"} deep` : "");
  if (weight) {
    const force = weight.force_unit === "N" ? `${threeDigits(Math.abs(weight.at_feet))} N` : `${threeDigits(100 * Math.abs(weight.at_feet))} % of it`;
    add("Own weight", force, `at the feet: ${weight.at_feet > 0 ? "opens" : "closes"} the shell`);
  }
  if (ties?.length) {
    const slack = ties.filter((tie) => tie.slack).length;
    const late = ties.every((tie) => tie.slack === null);
    add("Ties", String(ties.length), late ? "fixed when pieces are joined" : `${slack === ties.length ? "all" : slack} proved slack until the target`);
  }
  for (const { name, value, note } of structureFigures(report.structure ?? null, unit)) add(name, value, note);
}

/** Without a height where that is of panels without thickness. */
function boxOf({ length: long, width, height }: { length: number; width: number; height: number }, unit: string): string {
  return sides(height < SLIM * long ? [long, width] : [long, width, height], unit);
}

/** A heading, and what `fill` adds below it; nothing if that is nothing. */
function group(title: string, fill: (add: Add) => void): HTMLElement[] {
  const list = document.createElement("dl");
  list.className = "orishell-figures";
  fill((name, value, note, key = name.toLowerCase()) => list.append(rowOf(name, value, note, key)));
  if (!list.children.length) return [];
  const head = document.createElement("h2");
  head.className = "orishell-group";
  head.textContent = title;
  return [head, list];
}

function lockOf(report: Known): string {
  const lock = report.lock;
  if (!lock) return UNKNOWN;
  if (lock.drive_deg === null) return "no end";
  return `${threeDigits(lock.drive_deg)}\u00b0`;
}

function lockNote(report: Known): string {
  const lock = report.lock;
  if (!lock?.cause) return "";
  const beyond = lock.drive_deg !== null && Math.abs(lock.target_drive_deg - lock.drive_deg) > 1e-6;
  const cause = CAUSES[lock.cause];
  const aim = report.deviation === null ? "stage" : "target";
  const held = report.deployment?.closing === "clipped flaps" ? ", held by clipped flaps" : "";
  return beyond ? `${cause}; ${aim} at ${threeDigits(lock.target_drive_deg)}\u00b0${held}` : cause;
}

function rowOf(name: string, value: string, note: string, key: string): HTMLElement {
  const row = document.createElement("div");
  row.dataset["figure"] = key;
  const term = document.createElement("dt");
  term.textContent = name;
  const figure = document.createElement("dd");
  const number = document.createElement("span");
  number.className = value === UNKNOWN ? "orishell-pending" : "orishell-number";
  number.textContent = value;
  figure.append(number);
  if (note) {
    const small = document.createElement("small");
    small.textContent = note;
    figure.append(small);
  }
  row.append(term, figure);
  return row;
}

/** Box of the flat sheet, or of the shell as it stands. */
function measured(view: View, what: "flat" | "shell"): Size | null {
  const size = what === "flat" ? 2 : 3;
  const points = what === "flat" ? view.flat : targetPoints(view);
  if (!points?.length) return null;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; i++) {
    low[i % size] = Math.min(low[i % size]!, points[i]!);
    high[i % size] = Math.max(high[i % size]!, points[i]!);
  }
  const [x, y, z] = high.map((end, axis) => end - low[axis]!) as [number, number, number];
  if (what === "shell") return { width: x, depth: y, height: z };
  let area = 0;
  for (let f = 0; f < view.faces.length; f += 4) {
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => 2 * view.faces[f + k]!) as [number, number, number, number];
    area += 0.5 * Math.abs(
      (points[c]! - points[a]!) * (points[d + 1]! - points[b + 1]!) - (points[c + 1]! - points[a + 1]!) * (points[d]! - points[b]!),
    );
  }
  return { width: x, height: y, area };
}
