// The figures of a shell, from its report; what a report does not say is measured on the view.

import { area, length, threeDigits } from "./colours.ts";
import { structureFigures } from "./structure-figures.ts";
import { verdictList } from "./verdict.ts";
import { panelCount, targetPoints, type Known, type View } from "./view.ts";
import { sentence } from "./words.ts";

interface Size { width: number; height: number; depth?: number; area?: number }

export const UNKNOWN = "not yet known";
const CAUSES = {
  flaps: "against closing, by its flaps",
  clash: "panels meet",
  crease: "a crease is folded flat",
  hinges: "hinges close no further",
  boards: "boards close no further",
};

/** A list of names and figures; `container` is emptied first. `said` puts warnings into the page's words. */
export function renderFigures(container: HTMLElement, view: View, said = (text: string): string => text): void {
  const { report } = view.header;
  const known = Object.keys(report).length > 0;
  const unit = view.header.unit;
  const grid = view.header.grid;
  const list = document.createElement("dl");
  list.className = "orishell-figures";

  const sheet: Size | null = report.sheet ?? measured(view, "flat");
  const shell: Size | null = report.deployed ?? measured(view, "shell");
  const { names } = view.header;
  const sheets = names ? new Set(names).size : panelCount(view);  // parts of one have one name
  // The report counts boards that are clipped on, too.
  const { panels = sheets, clipped = 0 } = report.quantities ?? {};
  const counted = grid && !names ? `${grid[0] - 1} \u00d7 ${grid[1] - 1}` : "";
  add(list, "Panels", panels.toLocaleString("en").replaceAll(",", "\u202f"), clipped ? `${counted || sheets}, and ${clipped} clipped on` : counted);
  if (sheet) {
    add(list, "Flat sheet", `${threeDigits(sheet.width)} \u00d7 ${length(sheet.height, unit)}`, "", "sheet");
    if (sheet.area) add(list, "Area", area(sheet.area, unit), "");
  }
  if (shell) {
    add(list, "Span", `${threeDigits(shell.width)} \u00d7 ${length(shell.depth ?? 0, unit)}`, "in plan");
    add(list, "Height", length(shell.height, unit), "");
  }
  if (known) {
    if (report.deviation !== null) {
      const surface = report.deviation?.surface;
      const tilted = report.deviation?.tilted ? `; in the surface asked for ${report.deviation.tilted}` : "";
      const mean = surface && `mean ${length(surface.mean, unit)}${tilted}`;
      add(list, "Deviation", surface ? length(surface.max, unit) : surface === null ? "not measured" : UNKNOWN, mean || "from the target, at most");
    }
    const { crests, valleys } = report.deviation ?? {};
    if (crests && valleys) {
      const most = Math.max(crests.max, valleys.max);
      const parts = `crests ${length(crests.max, unit)}, valleys ${length(valleys.max, unit)}`;
      add(list, "Vertices", `within ${length(most, unit)}`, `of the surfaces beside the target that they follow: ${parts}`);
    }
    const { flap_attachment: flaps, start } = report.deployment ?? {};
    const locked = report.lock ? report.lock.cause === "flaps" : flaps === "folded";
    add(list, locked ? "Locks at" : "Closes to", lockOf(report), lockNote(report), "lock");
    const { packed, pieces, weight, ties } = report.deployment ?? {};
    if (pieces?.length) add(list, "Pieces", String(pieces.length), "the largest packs as follows");
    add(list, start === "pack" ? "Pack" : "Smallest box", packed ? [packed.length, packed.width].map(threeDigits).join(" \u00d7 ") + ` \u00d7 ${length(packed.height, unit)}` : UNKNOWN,
      packed ? `at ${threeDigits(packed.drive_deg)}\u00b0, ${packed.layers} ${packed.layers === 1 ? "panel" : "panels"} deep` : "");
    if (weight) {
      const force = weight.force_unit === "N" ? `${threeDigits(Math.abs(weight.at_feet))} N` : `${threeDigits(100 * Math.abs(weight.at_feet))} % of it`;
      add(list, "Own weight", force, `at the feet: ${weight.at_feet > 0 ? "opens" : "closes"} the shell`);
    }
    if (ties?.length) {
      const slack = ties.filter((tie) => tie.slack).length;
      const late = ties.every((tie) => tie.slack === null);
      add(list, "Ties", String(ties.length), late ? "fixed when pieces are joined" : `${slack === ties.length ? "all" : slack} proved slack until the target`);
    }
    for (const { name, value, note } of structureFigures(report.structure ?? null, unit)) add(list, name, value, note);
  }
  const examined = report.feasible !== null && report.verdict !== undefined;
  container.replaceChildren(...(examined ? [verdictList(report.verdict ?? [])] : []), list);
  for (const warning of new Set([...(report.warnings ?? []), ...(report.structure?.warnings ?? [])])) {
    const line = document.createElement("p");
    line.className = "orishell-warning";
    line.textContent = sentence(said(warning));
    container.append(line);
  }
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

function add(list: HTMLElement, name: string, value: string, note: string, key = name.toLowerCase()): void {
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
  list.append(row);
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
