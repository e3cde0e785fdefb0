// How shells are drawn: colours, what is shown beside them, whether boards are.

import { Shell3D, type Colouring, type Overlay } from "../shared/shell3d.ts";
import type { View } from "../shared/view.ts";
import { element, toggle } from "./elements.ts";

const COLOURINGS: [Colouring, string][] = [
  ["plain", "Plain"],
  ["signs", "Mountain, valley"],
  ["angle", "Fold angle"],
  ["distance", "Distance"],
];
const OVERLAYS: [Overlay, string, string][] = [
  ["surface", "Target", "--target"],
  ["f", "f", "--curve-f"],
  ["g", "g", "--curve-g"],
];

/** What is chosen in the toolbar. */
export interface Drawing {
  colouring: Colouring;
  overlays: Set<Overlay>;
  thickness: boolean;
}

export function plainly(): Drawing {
  return { colouring: "plain", overlays: new Set(), thickness: true };
}

/** Switches for what at least one of the views has; `more` are further ones. */
export function makeToolbar(
  views: View[], shells: Shell3D[], drawing: Drawing, fit: () => void, more: HTMLElement[] = [],
): HTMLElement {
  const bar = element("div", "toolbar");
  const choice = element("fieldset", "choice");
  choice.append(element("legend", "hidden", {}, "Colours"));
  for (const [mode, label] of COLOURINGS) {
    if (mode === "distance" && !views.some((view) => view.distance)) continue;
    const set = (): void => {
      drawing.colouring = mode;
      for (const shell of shells) shell.setColouring(mode);
    };
    choice.append(toggle("radio", label, mode === drawing.colouring, set, "orishell-colouring", mode));
  }
  const shown = element("fieldset", "choice");
  shown.append(element("legend", "hidden", {}, "Shown beside the shell"));
  const present = { surface: "surface", f: "curveF", g: "curveG" } as const;
  for (const [name, label, colour] of OVERLAYS) {
    if (!views.some((view) => view[present[name]])) continue;
    const set = (on: boolean): void => {
      drawing.overlays[on ? "add" : "delete"](name);
      for (const shell of shells) shell.setOverlay(name, on);
    };
    const item = toggle("checkbox", label, drawing.overlays.has(name), set, "orishell-overlay", name);
    item.style.setProperty("--ink", `var(${colour})`);
    if (label.length === 1) item.classList.add("curve");
    shown.append(item);
  }
  if (views.some((view) => view.boards)) {
    const set = (on: boolean): void => {
      drawing.thickness = on;
      for (const shell of shells) shell.setThickness(on);
    };
    const item = toggle("checkbox", "Thickness", drawing.thickness, set, "orishell-overlay", "thickness");
    item.style.setProperty("--ink", "var(--text)");
    item.title = "Panels as the boards they are built of";
    shown.append(item);
  }
  const button = element("button", "fit", { type: "button", title: "Show all" }, "Fit");
  button.addEventListener("click", fit);
  bar.append(choice);
  if (shown.children.length > 1) bar.append(shown);
  bar.append(...more, button);
  return bar;
}

/** Draw a shell as was chosen for another one. */
export function drawAs(shell: Shell3D, { colouring, overlays, thickness }: Drawing): void {
  shell.setColouring(colouring);
  for (const [name] of OVERLAYS) shell.setOverlay(name, overlays.has(name));
  shell.setThickness(thickness);
}

export function startShell(stage: HTMLElement, label: string): Shell3D | null {
  try {
    return new Shell3D(stage, { label: `Shell in space: ${label}` });
  } catch {
    stage.replaceChildren(element("p", "failed", {}, "This browser offers no WebGL 2, which the view in space needs."));
    return null;
  }
}
