// The viewer's page: view in space, fold slider, colouring, overlays, pattern, figures, theme.

import { LoadedControls } from "../shared/loaded-controls.ts";
import { Pattern2D } from "../shared/pattern2d.ts";
import { renderFigures } from "../shared/figures.ts";
import type { Shell3D } from "../shared/shell3d.ts";
import { stopsOf } from "../shared/stops.ts";
import { Verdict } from "../shared/verdict.ts";
import { decodeView, panelName, stateCount, type View } from "../shared/view.ts";
import { element } from "./elements.ts";
import { Player } from "./player.ts";
import { Theme } from "./theme.ts";
import { makeToolbar, plainly, startShell } from "./toolbar.ts";

const CAPTION = "Solid red: mountain. Dashed blue: valley.";

export class Viewer {
  readonly view: View;
  readonly shell: Shell3D | null;
  readonly pattern: Pattern2D;
  readonly player: Player;
  readonly theme: Theme;
  private readonly loads: LoadedControls | null;

  /** `host` bears the theme: the page's root, or the widget's. */
  constructor(root: HTMLElement, buffer: ArrayBuffer, host: HTMLElement) {
    this.view = decodeView(buffer);
    root.classList.add("orishell-viewer");
    this.theme = new Theme(host);
    const { title } = this.view.header;

    const scene = element("section", "scene", { "aria-label": "Shell in space" });
    const side = element("aside", "side", { "aria-label": "Crease pattern and figures" });
    const head = element("header", "head");
    head.append(element("h1", "", {}, title), this.theme.button());
    const drawing = element("section", "pattern", { "aria-label": "Crease pattern" });
    const caption = element("p", "caption", { "aria-live": "polite" });
    const figures = element("section", "figures", { "aria-label": "Figures" });
    const verdict = new Verdict();
    verdict.show(this.view.header.report);
    side.append(head, drawing, caption, verdict.element, figures);
    root.append(scene, side);

    const stage = element("div", "stage");
    scene.append(stage);
    this.shell = startShell(stage, title);
    this.pattern = new Pattern2D(drawing, { label: "Crease pattern" });
    this.player = new Player(stopsOf(this.view), (share) => this.fold(share));
    this.loads = this.shell && new LoadedControls(this.shell, (on) => this.player.hold(on));
    const switches = this.loads && this.view.loaded ? [this.loads.element] : [];
    const fit = (): void => this.shell?.fit(true);
    scene.append(makeToolbar([this.view], this.shell ? [this.shell] : [], plainly(), fit, switches), this.player.bar);

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

  private fold(share: number): void {
    this.shell?.setFold(share);
    const known = this.view.header.drives_deg.every((drive) => drive !== null);
    const drive = this.shell?.drive ?? 0;
    this.player.say(known ? `${drive.toFixed(1)}\u00b0` : `${Math.round(100 * share)} %`);
  }
}
