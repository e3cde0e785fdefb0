// The shells of one member, or of two beside each other: one scale, one direction, one fold slider.

import { shareTogether, stopsOf, targetShare } from "../shared/stops.ts";
import { stateCount, type View } from "../shared/view.ts";
import { element } from "../viewer/elements.ts";
import { Player } from "../viewer/player.ts";
import type { StandingShell } from "../viewer/standing-shell.ts";
import { drawAs, makeToolbar, plainly, startShell } from "../viewer/toolbar.ts";

export interface Shown {
  name: string;
  /** Null where it is not drawn, with the reason. */
  view: View | null;
  missing: string;
}

class Stage {
  readonly frame = element("figure", "frame");
  readonly name = element("figcaption", "frame-name");
  readonly missing = element("p", "missing");
  private readonly stage = element("div", "place");
  shell: StandingShell | null = null;
  shown: Shown | null = null;

  constructor(mark: string) {
    this.frame.append(this.stage, this.missing, this.name);
    this.name.classList.add(mark);
  }

  set(shown: Shown, keep: boolean): void {
    const again = this.shown?.view === shown.view;
    this.shown = shown;
    this.name.textContent = shown.name;
    this.missing.textContent = shown.missing;
    this.missing.hidden = shown.view !== null;
    this.stage.hidden = shown.view === null;
    if (!shown.view) return;
    this.shell ??= startShell(this.stage, "of the design that is chosen");
    if (!again) this.shell?.show(shown.view, keep);
    this.shell?.canvas.setAttribute("aria-label", `Shell in space: ${shown.name}. Arrow keys turn it, plus and minus zoom, 0 shows all.`);
  }
}

export class Shells {
  readonly element = element("section", "scene", { "aria-label": "Shells in space" });
  player: Player | null = null;
  private readonly stages = [new Stage("chosen"), new Stage("pinned")] as const;
  private readonly row = element("div", "frames");
  private readonly drawing = plainly();
  private share: number | null = null;
  private following = false;

  constructor() {
    this.row.append(this.stages[0].frame);
    this.element.append(this.row);
    this.element.addEventListener("keydown", (event) => {
      if (event.key === " " && (event.target as HTMLElement).tagName === "CANVAS") {
        event.preventDefault();
        this.player?.toggle();
      }
    });
  }

  /** The shells that are drawn. */
  get drawn(): StandingShell[] {
    return this.active.flatMap(({ shell }) => (shell ? [shell] : []));
  }

  show(chosen: Shown, pinned: Shown | null): void {
    const before = this.active[0]?.shown?.view ?? null;
    this.player?.stop();
    this.row.replaceChildren(...this.stages.slice(0, pinned ? 2 : 1).map(({ frame }) => frame));
    this.row.classList.toggle("two", pinned !== null);
    this.stages[0].set(chosen, true);
    if (pinned) this.stages[1].set(pinned, true);
    else this.stages[1].shown = null;
    for (const shell of this.drawn) drawAs(shell, this.drawing);
    this.dress(before);
    if (this.drawn.length === 2) this.fit(false);
    this.drawn.forEach((shell, number) => {
      shell.onSight = () => this.follow(shell, this.drawn[1 - number]);
    });
  }

  private get active(): Stage[] {
    return this.stages.filter(({ shown }) => shown?.view);
  }

  /** Toolbar and slider for what is drawn; the fold stays where it was. */
  private dress(before: View | null): void {
    const views = this.active.map(({ shown }) => shown!.view!);
    const first = views[0];
    for (const old of this.element.querySelectorAll(":scope > :not(.frames)")) old.remove();
    this.player = null;
    if (!first) return;
    const stops = stopsOf(first);
    this.player = new Player(stops, (share) => this.fold(share));
    this.player.bar.hidden = stateCount(first) < 2;
    this.element.prepend(makeToolbar(views, this.drawn, this.drawing, () => this.fit(true)));
    this.element.append(this.player.bar);
    this.player.set(before && this.share !== null ? shareTogether(before, first, this.share) : targetShare(stops));
  }

  private fold(share: number): void {
    this.share = share;
    const [first, other] = this.active;
    first!.shell?.setFold(share);
    other?.shell?.setFold(shareTogether(first!.shown!.view!, other.shown!.view!, share));
    const known = first!.shown!.view!.header.drives_deg.every((drive) => drive !== null);
    const percent = `${Math.round(100 * share)} %`;
    this.player?.say(known && !other && first!.shell ? `${first!.shell.drive.toFixed(1)}\u00b0` : percent);
  }

  /** Show all, of both at the scale of the larger. */
  private fit(turn: boolean): void {
    const [first, other] = this.drawn;
    this.following = true;
    first?.fit(turn);
    if (first && other) {
      other.sight = first.sight;
      other.fit();
      const sights = [first.sight, other.sight];
      const far = Math.max(...sights.map(({ arm }) => arm.length()));
      for (const shell of [first, other]) {
        const { arm, moved } = shell.sight;
        shell.sight = { arm: arm.setLength(far), moved };
      }
    }
    this.following = false;
  }

  private follow(turned: StandingShell, other: StandingShell | undefined): void {
    if (this.following || !other) return;
    this.following = true;
    other.sight = turned.sight;
    this.following = false;
  }
}
