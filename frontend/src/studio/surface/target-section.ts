// What the shell is to follow: two curves, a surface, a drawn sheet, or nothing.

import type { CurveEditor } from "../curves/curve-editor.ts";
import { segmented } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { scaledNote } from "../parts/scaled-note.ts";
import { type Aim, aimOf, designFor } from "../state/aims.ts";
import type { Store } from "../state/store.ts";
import type { DrawingForm } from "./drawing-form.ts";
import type { SurfaceEditor } from "./surface-editor.ts";

export function targetSection(store: Store, editors: CurveEditor[], surface: SurfaceEditor, drawing: DrawingForm, sizes: HTMLElement): HTMLElement {
  const aims: { value: Aim; text: string; testid: string; title: string }[] = [
    { value: "curves", text: "Curves", testid: "aim-curves", title: "the curve f, swept along g" },
    { value: "surface", text: "Surface", testid: "aim-surface", title: "any surface, by formulas or as a mesh" },
    { value: "drawing", text: "Drawing", testid: "aim-drawing", title: "a crease pattern of quadrilaterals" },
    { value: "none", text: "None", testid: "aim-none", title: "the sheet is designed by its own numbers" },
  ];
  const none = h("p", { class: "note" }, "The sheet is designed by the numbers of its pattern alone.");
  const possible = (each: Aim): boolean => Object.values(store.info.families).some(({ aims }) => aims.includes(each));
  const aim = segmented<Aim>("What the shell follows", aims.filter(({ value }) => possible(value)), (value) => aimAt(store, value));
  store.design.bind((design) => {
    const now = aimOf(design);
    aim.set(now);
    for (const { element } of editors) element.hidden = now !== "curves";
    surface.element.hidden = now !== "surface";
    drawing.element.hidden = now !== "drawing";
    none.hidden = now !== "none";
  });
  return h(
    "section",
    { class: "target", "aria-labelledby": "curves-title" },
    h("div", { class: "target-head" }, h("h2", { id: "curves-title" }, "Target"), aim.element),
    ...editors.map(({ element }) => element),
    surface.element,
    drawing.element,
    scaledNote(store, "surface"),
    scaledNote(store, "pattern"),
    none,
    sizes,
  );
}

const WHAT = { curves: "curves", surface: "a surface", drawing: "a drawn sheet", none: "no target" };

/** Follow the other: in the present family if that can, else in the first that can. */
export function aimAt(store: Store, aim: Aim): void {
  if (aimOf(store.design.value) !== aim) store.change(designFor(store, aim), WHAT[aim]);
}
