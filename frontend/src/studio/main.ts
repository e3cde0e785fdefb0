// The studio begins here.

import "../shared/meanings.css";
import "../shared/theme.css";
import "../shared/views.css";
import "./studio.css";
import "./toolbar.css";
import "./controls.css";
import "./curves.css";
import "./parameters.css";
import "./stage.css";
import "./results.css";
import "./overlays.css";
import "./tour.css";
import "./windows.css";
import "./touch.css";
import "./theme.ts";
import { fetchInfo, parseDesign } from "./api.ts";
import { buildStudio } from "./app.ts";
import { h } from "./dom.ts";
import { ServerFault, faultOf } from "./faults.ts";
import { keepUnsaved, readKept, storageOf } from "./kept.ts";
import { designOf } from "./link.ts";
import { Store } from "./store.ts";
import type { Design } from "./types.ts";

async function start(root: HTMLElement): Promise<void> {
  const info = await fetchInfo();
  const first = info.start ?? info.examples[0]!;
  const design = "design" in first ? (first.design as unknown as Design) : await parseDesign(first.text);
  const store = new Store(info, design);
  store.name.set(first.name);
  const brought = await designOf(location.hash);
  const found = brought ?? (info.start ? null : readKept(storageOf(window)));
  if (found) {
    store.name.set(found.name);
    store.change(found.design, brought ? "the design of the link" : "work that was not saved");
    store.said.set(brought ? "The design of the link" : "Your unsaved work is back; undo leaves it");
    // A link that was taken does not come back with a reload.
    if (brought) history.replaceState(null, "", location.pathname + location.search);
  }
  buildStudio(root, store);
  keepUnsaved(store, window);
}

const root = document.getElementById("studio")!;
start(root).catch((error: unknown) => {
  const { message } = faultOf(error);
  root.replaceChildren(h("p", { class: "no-start", role: "alert" }, `The studio could not start. ${message}`));
  if (!(error instanceof ServerFault)) throw error;
});
