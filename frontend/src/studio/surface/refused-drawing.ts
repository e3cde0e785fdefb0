// A drawn sheet that is refused, in place of the shell and of its pattern, with marks where it is wrong.

import type { RefusedDrawing } from "../../shared/api-types.ts";
import { capital } from "../../shared/words.ts";
import { button } from "../parts/controls.ts";
import { h, s } from "../parts/dom.ts";
import type { Store } from "../state/store.ts";

/** Marks with more of a kind have no numbers of their own in the list. */
const LISTED = 8;
/** Radius of a mark, and the margin around the sheet, in sizes of the drawing. */
const RADIUS = 0.018, MARGIN = 0.06;

/** Over the scene: the drawing, and what is wrong where. */
export function refusedCover(store: Store): HTMLElement {
  const picture = h("div", { class: "refused-picture" });
  const list = h("ol", { "data-testid": "refused-marks" });
  const words = h("p", {});
  const back = button({ label: "Back to the shell", text: "Back to the shell", testid: "refused-back", act: () => leave(store) });
  const aside = h("div", { class: "refused-words" }, h("div", { class: "refused-head" }, words, back), list);
  const cover = h("div", { class: "refused-cover", role: "group", "aria-label": "The drawing that was refused", "data-testid": "refused", hidden: true }, picture, aside);
  store.refused.bind((drawing) => {
    cover.hidden = !drawing;
    picture.replaceChildren(...(drawing ? [pictureOf(drawing, true)] : []));
    if (!drawing) return list.replaceChildren();
    const { marks } = drawing;
    const places = marks.length === 1 ? "1 place" : `${marks.length} places`;
    words.textContent = marks.length ? `The drawing as it was read. ${capital(places)} where it is wrong:` : "The drawing as it was read.";
    list.replaceChildren(...kinds(drawing).map(([what, numbers]) => entry(what, numbers, picture)));
  });
  return cover;
}

/** In place of the crease pattern: the drawing with its marks. */
export function refusedSheet(store: Store): HTMLElement {
  const sheet = h("div", { class: "refused-sheet", "data-testid": "refused-sheet", hidden: true });
  store.refused.bind((drawing) => {
    sheet.hidden = !drawing;
    sheet.replaceChildren(...(drawing ? [pictureOf(drawing, false)] : []));
  });
  return sheet;
}

function leave(store: Store): void {
  store.refused.set(null);
  // What is wrong with a file is no fault of the design.
  if (store.freshness.value === "current") store.fault.set(null);
}

/** Numbers of marks, from 1, by what is wrong there. */
function kinds({ marks }: RefusedDrawing): [string, number[]][] {
  const found = new Map<string, number[]>();
  for (const [k, { what }] of marks.entries()) found.set(what, [...(found.get(what) ?? []), k + 1]);
  return [...found];
}

/** A line of the list, which lights its marks. */
function entry(what: string, numbers: number[], picture: HTMLElement): HTMLElement {
  const which = numbers.length <= LISTED ? numbers.join(", ") : `${numbers.slice(0, LISTED).join(", ")} and ${numbers.length - LISTED} more`;
  const light = (on: boolean) => (): void => {
    for (const number of numbers) picture.querySelector(`[data-mark="${number}"]`)?.classList.toggle("lit", on);
  };
  return h("li", { tabindex: 0, onpointerenter: light(true), onpointerleave: light(false), onfocus: light(true), onblur: light(false) }, h("b", {}, which), ` ${what}`);
}

/** The lines as they were drawn, mountains and valleys in their colours, and the marks. */
function pictureOf({ lines, letters, marks }: RefusedDrawing, numbered: boolean): SVGSVGElement {
  const xs = lines.flatMap(([a, , c]) => [a, c]), ys = lines.flatMap(([, b, , d]) => [b, d]);
  const [west, east, south, north] = [least(xs), -least(xs.map((x) => -x)), least(ys), -least(ys.map((y) => -y))];
  const size = Math.max(east - west, north - south) || 1, margin = MARGIN * size;
  const paths = new Map<string, string>();
  for (const [k, [a, b, c, d]] of lines.entries()) {
    const letter = KINDS[letters.charAt(k)] ?? "unassigned";
    // The page's y goes downwards.
    paths.set(letter, `${paths.get(letter) ?? ""}M${a} ${-b}L${c} ${-d}`);
  }
  const box = [west - margin, -north - margin, east - west + 2 * margin, north - south + 2 * margin];
  return s(
    "svg",
    { viewBox: box.join(" "), role: "img", "aria-label": `The drawing, with ${marks.length} places marked`, preserveAspectRatio: "xMidYMid meet" },
    ...[...paths].map(([letter, d]) => s("path", { class: `refused-${letter}`, d })),
    ...marks.map(({ x, y, what }, k) =>
      s(
        "g",
        { class: "refused-mark", "data-mark": k + 1, transform: `translate(${x} ${-y}) scale(${RADIUS * size})` },
        s("title", {}, `${k + 1}: ${what}`),
        s("circle", { r: 1 }),
        numbered ? s("text", { y: 0.36, "text-anchor": "middle", "font-size": 1 }, String(k + 1)) : null,
      ),
    ),
  );
}

const KINDS: Record<string, string> = { M: "mountain", V: "valley", B: "border", C: "border", F: "flat" };

/** Of more numbers than a call takes as arguments. */
function least(values: readonly number[]): number {
  return values.reduce((one, other) => Math.min(one, other), Infinity);
}
