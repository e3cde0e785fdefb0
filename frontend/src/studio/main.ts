// The studio begins here.

import "../shared/meanings.css";
import "../shared/theme.css";
import "../shared/views.css";
import "./page/studio.css";
import "./page/toolbar.css";
import "./parts/controls.css";
import "./parts/front-figure.css";
import "./curves/curves.css";
import "./curves/drawing.css";
import "./curves/sketch.css";
import "./surface/surface.css";
import "./surface/refused-drawing.css";
import "./design/parameters.css";
import "./structure/structure.css";
import "./shell/stage.css";
import "./shell/results.css";
import "./page/overlays.css";
import "./shell/inspect.css";
import "./shell/scene.css";
import "./design/tradeoff.css";
import "./search/search.css";
import "./files/example-cards.css";
import "./files/export-window.css";
import "./page/tour.css";
import "./page/windows.css";
import "./page/touch.css";
import "./parts/theme.ts";
import { fetchInfo, parseDesign } from "./server/api.ts";
import { FIRST } from "./files/example-list.ts";
import { h } from "./parts/dom.ts";
import { askEarly } from "./server/early-view.ts";
import { ServerFault, faultOf } from "./state/faults.ts";
import { keepUnsaved, readKept, readOpen } from "./state/kept.ts";
import { type Named, type Work, isUnsaved } from "./state/named.ts";
import { storageOf, tabStorageOf } from "./state/storage.ts";
import { Store } from "./state/store.ts";
import type { Design, Info } from "./state/types.ts";

async function start(root: HTMLElement): Promise<void> {
  const page = import("./app.ts");
  const info = await fetchInfo();
  const named = await opened(info);
  const open = openBefore(info);
  const kept = open ?? broughtBack(info);
  const other = !open && kept !== null && info.start !== null && kept.name !== named.name;
  // Undo takes work that came back for what it was made of, which is in a file.
  const home = kept && { ...kept.home, file: kept.home.file ?? named };
  const store = new Store(info, other ? kept : home ? { ...home.file, home } : named);
  if (other) {
    store.open(named);
    store.said.set(`Undo brings back your unsaved work on ${kept.name}`);
  } else if (kept && home && isUnsaved(kept)) {
    store.open({ ...kept, home }, "work that was not saved");
    store.said.set("Your unsaved work is back; undo leaves it");
  }
  askEarly(store.design.value);
  (await page).buildStudio(root, store);
  keepUnsaved(store, window);
}

/** The design that the studio was started with, or else an example. */
async function opened({ start }: Info): Promise<Named> {
  return start ? { name: start.name, design: start.design as unknown as Design } : { name: FIRST.name, design: await parseDesign(FIRST.text) };
}

/** What this tab had open before it was loaded again; a studio that was started with a design shows that. */
function openBefore(info: Info): Work | null {
  const [how] = performance.getEntriesByType("navigation") as PerformanceNavigationTiming[];
  return how?.type === "navigate" && info.start ? null : known(info, readOpen(tabStorageOf(window)));
}

/** What was not saved of the design that the studio was started with, or else the latest such work. */
function broughtBack(info: Info): Work | null {
  const storage = storageOf(window);
  return known(info, (info.start && readKept(storage, info.start.name)) ?? readKept(storage));
}

/** Work on a family that this studio does not know is left alone. */
function known(info: Info, work: Work | null): Work | null {
  return work && Object.hasOwn(info.families, work.design.shell.family) ? work : null;
}

const root = document.getElementById("studio")!;
start(root).catch((error: unknown) => {
  const { message } = faultOf(error);
  root.replaceChildren(h("p", { class: "no-start", role: "alert" }, `The studio could not start. ${message}`));
  if (!(error instanceof ServerFault)) throw error;
});
