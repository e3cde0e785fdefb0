// The viewer's page: view in space, fold slider, colouring, overlays, pattern, figures, theme.

import { LoadedControls } from "../shared/loaded-controls.ts";
import { Pattern2D } from "../shared/pattern2d.ts";
import { renderFigures } from "../shared/figures.ts";
import { Shell3D, type Colouring, type Overlay } from "../shared/shell3d.ts";
import { stopsOf } from "../shared/stops.ts";
import { decodeView, panelName, stateCount, type View } from "../shared/view.ts";
import { element, toggle } from "./elements.ts";
import { Player } from "./player.ts";

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

const CAPTION = "Solid red: mountain. Dashed blue: valley.";

export class Viewer {
  readonly view: View;
  readonly shell: Shell3D | null;
  readonly pattern: Pattern2D;
  readonly player: Player;
  private readonly loads: LoadedControls | null;

  /** `host` bears the theme: the page's root, or the widget's. */
  constructor(root: HTMLElement, buffer: ArrayBuffer, private readonly host: HTMLElement) {
    this.view = decodeView(buffer);
    root.classList.add("orishell-viewer");
    this.followTheme();
    const { title } = this.view.header;

    const scene = element("section", "scene", { "aria-label": "Shell in space" });
    const side = element("aside", "side", { "aria-label": "Crease pattern and figures" });
    const head = element("header", "head");
    head.append(element("h1", "", {}, title), this.themeButton());
    const drawing = element("section", "pattern", { "aria-label": "Crease pattern" });
    const caption = element("p", "caption", { "aria-live": "polite" });
    const figures = element("section", "figures", { "aria-label": "Figures" });
    side.append(head, drawing, caption, figures);
    root.append(scene, side);

    const stage = element("div", "stage");
    scene.append(stage);
    this.shell = startShell(stage, title);
    this.pattern = new Pattern2D(drawing, { label: "Crease pattern" });
    this.player = new Player(stopsOf(this.view), (share) => this.fold(share));
    this.loads = this.shell && new LoadedControls(this.shell, (on) => this.player.hold(on));
    scene.append(this.toolbar(), this.player.bar);

    const point = (panel: number | null): void => {
      caption.textContent = panel === null ? CAPTION : panelName(this.view, panel);
    };
    this.pattern.show(this.view);
    this.pattern.onHover = (panel) => {
      this.shell?.highlight(panel);
      point(panel);
    };
    if (this.shell) {
      this.shell.show(this.view);
      this.shell.onHover = (panel) => {
        this.pattern.highlight(panel);
        point(panel);
      };
    }
    this.loads?.show(this.view);
    point(null);
    renderFigures(figures, this.view);
    this.player.bar.hidden = stateCount(this.view) < 2;
    this.player.rest();
    root.addEventListener("keydown", (event) => {
      const target = event.composedPath()[0] as HTMLElement;
      if (event.key === " " && target.tagName === "CANVAS") {
        event.preventDefault();
        this.player.toggle();
      }
    });
  }

  dispose(): void {
    this.player.stop();
    this.shell?.dispose();
    this.pattern.dispose();
  }

  setTheme(theme: "light" | "dark"): void {
    this.host.dataset["theme"] = theme;
    document.dispatchEvent(new CustomEvent("themechange"));
  }

  private fold(share: number): void {
    this.shell?.setFold(share);
    const known = this.view.header.drives_deg.every((drive) => drive !== null);
    const drive = this.shell?.drive ?? 0;
    this.player.say(known ? `${drive.toFixed(1)}\u00b0` : `${Math.round(100 * share)} %`);
  }

  private followTheme(): void {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    // JupyterLab has a theme of its own and says so.
    const lab = document.body.dataset["jpThemeLight"];
    this.setTheme((lab === undefined ? dark.matches : lab === "false") ? "dark" : "light");
    dark.addEventListener("change", () => this.setTheme(dark.matches ? "dark" : "light"));
  }

  private themeButton(): HTMLElement {
    const button = element("button", "theme", { type: "button", "aria-label": "Light or dark", title: "Light or dark" });
    button.addEventListener("click", () => this.setTheme(this.host.dataset["theme"] === "dark" ? "light" : "dark"));
    return button;
  }

  private toolbar(): HTMLElement {
    const bar = element("div", "toolbar");
    const choice = element("fieldset", "choice");
    choice.append(element("legend", "hidden", {}, "Colours"));
    for (const [mode, label] of COLOURINGS) {
      if (mode === "distance" && !this.view.distance) continue;
      choice.append(toggle("radio", label, mode === "plain", () => this.shell?.setColouring(mode), "orishell-colouring", mode));
    }
    const shown = element("fieldset", "choice");
    shown.append(element("legend", "hidden", {}, "Shown beside the shell"));
    const present = { surface: this.view.surface, f: this.view.curveF, g: this.view.curveG };
    for (const [name, label, colour] of OVERLAYS) {
      if (!present[name]) continue;
      const item = toggle("checkbox", label, false, (on) => this.shell?.setOverlay(name, on), "orishell-overlay", name);
      item.style.setProperty("--ink", `var(${colour})`);
      if (label.length === 1) item.classList.add("curve");
      shown.append(item);
    }
    if (this.view.boards) {
      const item = toggle("checkbox", "Thickness", true, (on) => this.shell?.setThickness(on), "orishell-overlay", "thickness");
      item.style.setProperty("--ink", "var(--text)");
      item.title = "Panels as the boards they are built of";
      shown.append(item);
    }
    const fit = element("button", "fit", { type: "button", title: "Show all" }, "Fit");
    fit.addEventListener("click", () => this.shell?.fit(true));
    bar.append(choice);
    if (shown.children.length > 1) bar.append(shown);
    if (this.loads && this.view.loaded) bar.append(this.loads.element);
    bar.append(fit);
    return bar;
  }
}

function startShell(stage: HTMLElement, label: string): Shell3D | null {
  try {
    return new Shell3D(stage, { label: `Shell in space: ${label}` });
  } catch {
    stage.replaceChildren(element("p", "failed", {}, "This browser offers no WebGL 2, which the view in space needs."));
    return null;
  }
}
