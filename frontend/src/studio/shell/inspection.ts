// Looking closely: what is chosen, distances, and what stands around the shell.

import { Touch3D } from "../../shared/moving3d.ts";
import type { View } from "../../shared/view.ts";
import { Compare } from "./compare.ts";
import { h } from "../parts/dom.ts";
import { InspectCard } from "./inspect-card.ts";
import { Measure } from "./measure.ts";
import { foldByKeys } from "./motion-keys.ts";
import { PastDesigns } from "./past.ts";
import { Pinned } from "./pinned.ts";
import { Preview } from "./preview.ts";
import type { Results } from "./results.ts";
import { SceneHandles } from "./scene-handles.ts";
import { SceneSizes } from "./scene-sizes.ts";
import { Selection } from "./selection.ts";
import { Sight } from "./sight.ts";
import { addFigures } from "./sheet-figures.ts";
import type { Stage } from "./stage.ts";
import { Standing } from "./standing.ts";
import { keptSwitch } from "../state/storage.ts";
import type { Store } from "../state/store.ts";
import { VerdictChips } from "./verdict-chips.ts";
import { WindArrow } from "./wind-arrow.ts";
import { flagWorst } from "./worst-flag.ts";

const TYPING = "input, select, textarea, dialog, :popover-open";

/** Windows in which cards would lie over the whole shell. */
const NARROW = matchMedia("(max-width: 560px)");

export function addInspection(store: Store, stage: Stage, results: Results): void {
  const { shell, fold } = stage;
  const { pattern } = results;
  const sight = new Sight(store, shell, pattern);
  const measure = new Measure(store, sight, shell, pattern, fold.share);
  const selection = new Selection(store, sight, pattern, shell);
  const chips = new VerdictChips(store, stage, (subject) => results.openRow(subject));
  const card = new InspectCard(store, selection, shell, fold.share);
  shell.add(new Touch3D(shell.uniforms));
  sight.onTap((room, event) => (measure.active.value ? measure : selection).take(room, event));
  sight.onMove((room, event) => (measure.active.value ? measure : selection).point(room, event));
  measure.active.watch(() => selection.pointed.set(null));
  const standing = new Standing(store, stage);
  const more = (figures: HTMLElement, view: View): void => addFigures(figures, view, standing, selection);
  const compare = new Compare(store, stage, results, more);
  const past = new PastDesigns(store, stage);
  const pinned = new Pinned(shell);
  const shown = keptSwitch("orishell.sizes", true);
  // Handles first: sizes make room for them.
  new SceneHandles(store, stage, pinned, shown);
  new WindArrow(store, stage, pinned);
  new SceneSizes(store, stage, pinned, shown);
  new Preview(store, stage);
  flagWorst(shell, pinned);
  results.onFigures = (figures) => {
    more(figures, store.view.value!);
    compare.annotate(figures);
  };
  standing.headroom.watch(() => results.showFigures());
  const cards = h("div", { class: "inspect-cards" }, measure.element, card.element);
  const place = (): void => void (NARROW.matches ? stage.frame.after(cards) : stage.frame.append(cards));
  NARROW.addEventListener("change", place);
  stage.frame.after(past.element);
  stage.tools.append(measure.button, compare.button, past.button);
  stage.tools.before(pinned.layer);
  stage.frame.append(chips.element, standing.legend);
  place();
  foldByKeys(fold);
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if ((event.target as HTMLElement).closest(TYPING)) return;
    if (event.key.toLowerCase() === "m") measure.toggle();
    else if (event.key !== "Escape") return;
    else if (!past.element.hidden) past.show(false);
    else if (measure.active.value) measure.active.set(false);
    else {
      chips.lit.set(null);
      selection.chosen.set(null);
    }
  });
}
