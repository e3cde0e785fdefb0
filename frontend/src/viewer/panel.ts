// The viewer's page: view in space, fold slider, colouring, overlays, pattern, figures, theme.

import { LoadedControls } from "../shared/loaded-controls.ts";
import { Pattern2D } from "../shared/pattern2d.ts";
import { renderFigures } from "../shared/figures.ts";
import { shareTogether, stopsOf, targetShare } from "../shared/stops.ts";
import { Verdict } from "../shared/verdict.ts";
import { panelName, stateCount, type View } from "../shared/view.ts";
import { element } from "./elements.ts";
import { Player } from "./player.ts";
import type { StandingShell } from "./standing-shell.ts";
import { Theme } from "./theme.ts";
import { drawAs, makeToolbar, plainly, startShell } from "./toolbar.ts";

const CAPTION = "Solid red: mountain. Dashed blue: valley.";

export class Viewer {
  view!: View;
  player!: Player;
  readonly shell: StandingShell | null;
  readonly pattern: Pattern2D;
  readonly theme: Theme;
  protected readonly head = element("header", "head");
  private readonly scene = element("section", "scene", { "aria-label": "Shell in space" });
  private readonly figures = element("section", "figures", { "aria-label": "Figures" });
  private readonly verdict = new Verdict();
  private readonly caption = element("p", "caption", { "aria-live": "polite" });
  private readonly title = element("h1", "");
  private readonly loads: LoadedControls | null;
  private readonly drawing = plainly();

  /** `host` bears the theme: the page's root, or the widget's. */
  constructor(root: HTMLElement, view: View, host: HTMLElement) {
    root.classList.add("orishell-viewer");
    this.theme = new Theme(host);
    const side = element("aside", "side", { "aria-label": "Crease pattern and figures" });
    this.head.append(this.title, this.theme.button());
    const drawing = element("section", "pattern", { "aria-label": "Crease pattern" });
    side.append(this.head, drawing, this.caption, this.verdict.element, this.figures);
    root.append(this.scene, side);

    const stage = element("div", "stage");
    this.scene.append(stage);
    this.shell = startShell(stage, view.header.title);
    this.pattern = new Pattern2D(drawing, { label: "Crease pattern" });
    this.loads = this.shell && new LoadedControls(this.shell, (on) => this.player.hold(on));
    this.pattern.onHover = (panel) => {
      this.shell?.highlight(panel);
      this.point(panel);
    };
    if (this.shell) {
      this.shell.onHover = (panel) => {
        this.pattern.highlight(panel);
        this.point(panel);
      };
    }
    this.show(view);
    root.addEventListener("keydown", (event) => {
      const target = event.composedPath()[0] as HTMLElement;
      if (event.key === " " && target.tagName === "CANVAS") {
        event.preventDefault();
        this.player.toggle();
      }
    });
  }

  /** Show a shell; one that is shown after another is seen from where that was, as far folded. */
  show(view: View): void {
    const before = this.view ? { view: this.view, share: this.player.share } : null;
    this.view = view;
    this.title.textContent = view.header.title;
    this.pattern.show(view);
    if (this.shell) {
      this.shell.show(view, before !== null);
      drawAs(this.shell, this.drawing);
    }
    const stops = stopsOf(view);
    if (before) this.player.stop();
    this.player = new Player(stops, (share) => this.fold(share));
    this.player.bar.hidden = stateCount(view) < 2;
    this.loads?.show(view);
    for (const old of this.scene.querySelectorAll(":scope > :not(.stage)")) old.remove();
    const switches = this.loads && view.loaded ? [this.loads.element] : [];
    const fit = (): void => this.shell?.fit(true);
    this.scene.append(makeToolbar([view], this.shell ? [this.shell] : [], this.drawing, fit, switches), this.player.bar);
    this.point(null);
    this.verdict.show(view.header.report);
    renderFigures(this.figures, view);
    this.player.set(before ? shareTogether(before.view, view, before.share) : targetShare(stops));
  }

  dispose(): void {
    this.player.stop();
    this.shell?.dispose();
    this.pattern.dispose();
  }

  private point(panel: number | null): void {
    this.caption.textContent = panel === null ? CAPTION : panelName(this.view, panel);
  }

  private fold(share: number): void {
    this.shell?.setFold(share);
    const known = this.view.header.drives_deg.every((drive) => drive !== null);
    const drive = this.shell?.drive ?? 0;
    this.player.say(known ? `${drive.toFixed(1)}\u00b0` : `${Math.round(100 * share)} %`);
  }
}
