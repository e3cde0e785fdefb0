// The studio begins here.

import "../shared/meanings.css";
import "../shared/theme.css";
import "../shared/views.css";
import "./studio.css";
import "./toolbar.css";
import "./controls.css";
import "./curves.css";
import "./drawing.css";
import "./parameters.css";
import "./stage.css";
import "./results.css";
import "./overlays.css";
import "./inspect.css";
import "./tradeoff.css";
import "./export-window.css";
import "./tour.css";
import "./windows.css";
import "./touch.css";
import "./theme.ts";
import { fetchInfo } from "./api.ts";
import { h } from "./dom.ts";
import { askEarly } from "./early-view.ts";
import { ServerFault, faultOf } from "./faults.ts";
import { keepUnsaved, readKept, storageOf } from "./kept.ts";
import { type Named, Store } from "./store.ts";
import type { Design, Info } from "./types.ts";

async function start(root: HTMLElement): Promise<void> {
  const page = import("./app.ts");
  const info = await fetchInfo();
  const first = info.start ?? info.examples[0]!;
  const named: Named = { name: first.name, design: first.design as unknown as Design };
  const kept = broughtBack(info);
  const other = kept !== null && info.start !== null && kept.name !== first.name;
  const store = new Store(info, other ? kept : named);
  if (other) {
    store.open(named);
    store.saved.set(named);
    store.said.set(`Undo brings back your unsaved work on ${kept.name}`);
  } else if (kept) {
    store.open(kept, "work that was not saved");
    store.said.set("Your unsaved work is back; undo leaves it");
  }
  askEarly(store.design.value);
  (await page).buildStudio(root, store);
  keepUnsaved(store, window);
}

/** What was not saved of the design that the studio was started with, or else the latest such work. */
function broughtBack(info: Info): Named | null {
  const storage = storageOf(window);
  const kept = (info.start && readKept(storage, info.start.name)) ?? readKept(storage);
  // Work on a family that this studio does not know is left alone.
  return kept && Object.hasOwn(info.families, kept.design.shell.family) ? kept : null;
}

const root = document.getElementById("studio")!;
start(root).catch((error: unknown) => {
  const { message } = faultOf(error);
  root.replaceChildren(h("p", { class: "no-start", role: "alert" }, `The studio could not start. ${message}`));
  if (!(error instanceof ServerFault)) throw error;
});
