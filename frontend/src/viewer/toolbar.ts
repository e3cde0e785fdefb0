// How shells are drawn: colours, what is shown beside them, whether boards are.

import type { Colouring, Overlay } from "../shared/shell3d.ts";
import type { View } from "../shared/view.ts";
import { element, toggle } from "./elements.ts";
import { BESIDE, type Beside, StandingShell } from "./standing-shell.ts";

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

const STANDING: [Beside, string, string, string][] = [
  ["person", "Person", "--person", "A person of 1.75 m, for the size"],
  ["ties", "Ties", "--tie", "Taut: a line; slack: dashes"],
];

/** What is chosen in the toolbar. */
export interface Drawing {
  colouring: Colouring;
  overlays: Set<Overlay>;
  beside: Set<Beside>;
  thickness: boolean;
}

export function plainly(): Drawing {
  return { colouring: "plain", overlays: new Set(), beside: new Set(["person", "ties"]), thickness: true };
}

/** Switches for what at least one of the views has; `more` are further ones. */
export function makeToolbar(
  views: View[], shells: StandingShell[], drawing: Drawing, fit: () => void, more: HTMLElement[] = [],
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
  for (const [name, label, colour, hint] of STANDING) {
    if (!views.some(BESIDE[name])) continue;
    const set = (on: boolean): void => {
      drawing.beside[on ? "add" : "delete"](name);
      for (const shell of shells) shell.setBeside(name, on);
    };
    const item = toggle("checkbox", label, drawing.beside.has(name), set, "orishell-overlay", name);
    item.style.setProperty("--ink", `var(${colour})`);
    item.title = hint;
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
export function drawAs(shell: StandingShell, { colouring, overlays, beside, thickness }: Drawing): void {
  shell.setColouring(colouring);
  for (const [name] of STANDING) shell.setBeside(name, beside.has(name));
  for (const [name] of OVERLAYS) shell.setOverlay(name, overlays.has(name));
  shell.setThickness(thickness);
}

export function startShell(stage: HTMLElement, label: string): StandingShell | null {
  try {
    return new StandingShell(stage, { label: `Shell in space: ${label}` });
  } catch {
    stage.replaceChildren(element("p", "failed", {}, "This browser offers no WebGL 2, which the view in space needs."));
    return null;
  }
}
