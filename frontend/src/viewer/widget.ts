// The viewer in a notebook (anywidget): in a shadow root, so that neither styles the other.

import { decodeView } from "../shared/view.ts";
import { nextGroup } from "./elements.ts";
import { Viewer } from "./panel.ts";
import { adoptStyles } from "./styles.ts";

interface Model {
  get(name: string): unknown;
  on(event: string, callback: () => void): void;
  off(event: string, callback: () => void): void;
}

export function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  const host = document.createElement("div");
  // Keys pressed here are not the notebook's.
  host.dataset["lmSuppressShortcuts"] = "true";
  el.append(host);
  const shadow = host.attachShadow({ mode: "open" });
  adoptStyles(shadow);
  let viewer: Viewer | null = null;

  function open(): void {
    viewer?.dispose();
    nextGroup();
    host.style.cssText = `display:block;height:${Number(model.get("height"))}px`;
    const root = document.createElement("div");
    shadow.replaceChildren(root);
    const data = model.get("view") as DataView;
    // Arrays of the view begin at multiples of four of their own block.
    viewer = new Viewer(root, decodeView(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength) as ArrayBuffer), host);
  }

  open();
  model.on("change:view", open);
  return () => {
    model.off("change:view", open);
    viewer?.dispose();
  };
}
