// Where the wind blows: an arrow on the ground beside the shell, which is turned by hand or by keys.

import { Vector3 } from "three";
import { extentOf } from "../../shared/camera.ts";
import type { Theme } from "../../shared/colours.ts";
import { groundOf } from "../../shared/ground.ts";
import { type Drawing, type Guest, Lines3D } from "../../shared/marks3d.ts";
import type { Uniforms } from "../../shared/parts.ts";
import type { Motion } from "../../shared/rigid.ts";
import { targetPoints, type View } from "../../shared/view.ts";
import { h, setAttribute } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import { casesOf, caseWith, withLoad } from "../structure/table.ts";
import type { Pinned } from "./pinned.ts";
import type { Stage } from "./stage.ts";

/** Of the plan's radius: where it begins and ends, and its head. */
const [TAIL, TIP, HEAD, WIDE] = [1.3, 1.03, 0.1, 0.05];
/** A turn by hand catches at these steps, by keys it takes them (degrees). */
const STEP = 5;
const STRIDE = 45;

class Arrow implements Guest {
  readonly withLoads = true;
  readonly middle = new Vector3();
  /** The end that is held; null while it is not seen. */
  tail: Vector3 | null = null;
  /** Where it blows to, degrees from x; null without wind. */
  direction: number | null = null;
  private readonly lines;
  private radius = 0;

  constructor(uniforms: Uniforms) {
    this.lines = new Lines3D(uniforms, { width: 3, through: 0.35 });
  }

  get drawn() {
    return this.lines.drawn;
  }

  show(view: View): void {
    const points = targetPoints(view);
    this.radius = 0;
    if (!points) return;
    const { low, high } = extentOf([points]);
    this.radius = Math.hypot(high.x - low.x, high.y - low.y) / 2;
    this.middle.set((low.x + high.x) / 2, (low.y + high.y) / 2, groundOf(view).atTarget);
  }

  /** All round: the shell does not move while the wind is turned. */
  get reach(): Float32Array {
    const { x, y, z } = this.middle, far = TAIL * this.radius;
    return Float32Array.from(this.tail ? [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [x + far * Math.cos((k * Math.PI) / 4), y + far * Math.sin((k * Math.PI) / 4), z]) : []);
  }

  move(_: Motion, { atTarget }: Drawing): void {
    const seen = atTarget && this.direction !== null && this.radius > 0;
    this.lines.visible = seen;
    this.tail = null;
    if (!seen) return;
    const angle = (this.direction! * Math.PI) / 180, { radius } = this;
    const along = new Vector3(Math.cos(angle), Math.sin(angle), 0), across = new Vector3(-along.y, along.x, 0);
    const at = (back: number, aside = 0): Vector3 => this.middle.clone().addScaledVector(along, -back * radius).addScaledVector(across, aside * radius);
    const tip = at(TIP);
    this.tail = at(TAIL);
    this.lines.set(Float32Array.from([this.tail, tip, tip, at(TIP + HEAD, WIDE), tip, at(TIP + HEAD, -WIDE)].flatMap((each) => [...each])));
  }

  paint(theme: Theme): void {
    this.lines.setColour(theme.linear("--load"));
  }

  dispose(): void {
    this.lines.dispose();
  }
}

export class WindArrow {
  private readonly arrow: Arrow;
  private readonly handle = h("div", { class: "scene-handle wind", role: "slider", tabindex: 0, "aria-label": "Wind blows to", "aria-valuemin": -360, "aria-valuemax": 360, "data-testid": "wind-arrow" }, h("span", { class: "scene-handle-value", "aria-hidden": "true" }));

  constructor(
    private readonly store: Store,
    stage: Stage,
    pinned: Pinned,
  ) {
    const { shell } = stage;
    this.arrow = new Arrow(shell.uniforms);
    const redraw = shell.add(this.arrow);
    pinned.add(this.handle, () => this.arrow.tail);
    store.design.bind(() => {
      const before = this.arrow.direction;
      this.show();
      redraw();
      if ((before === null) !== (this.arrow.direction === null)) shell.refit();
    });
    let held = false;
    this.handle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      held = true;
      this.handle.setPointerCapture(event.pointerId);
      event.preventDefault();
      this.handle.focus({ preventScroll: true });
    });
    this.handle.addEventListener("pointermove", (event) => {
      const place = held ? shell.eye.onLevel(event.clientX, event.clientY, this.arrow.middle.z) : null;
      if (!place) return;
      const { x, y } = this.arrow.middle.clone().sub(place);
      const angle = (Math.atan2(y, x) * 180) / Math.PI, step = event.altKey ? 0.1 : STEP;
      this.turn(step * Math.round(angle / step), "turn-wind!");
    });
    for (const end of ["pointerup", "pointercancel"]) {
      this.handle.addEventListener(end, () => {
        held = false;
        store.rest();
      });
    }
    this.handle.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowLeft: 1, ArrowDown: -1, ArrowRight: -1 }[event.key];
      if (!way || this.arrow.direction === null) return;
      event.preventDefault();
      this.turn(this.arrow.direction + way * (event.shiftKey ? STRIDE : STEP), "step-wind");
    });
  }

  /** Between -180 and 180 degrees. */
  private turn(angle: number, gesture: string): void {
    const direction = Number(short(angle - 360 * Math.ceil((angle - 180) / 360), 6)) + 0;
    if (direction !== this.arrow.direction) this.store.set(withLoad(this.store.design.value, "wind", "direction_deg", direction), "wind direction", gesture);
  }

  private show(): void {
    const design = this.store.design.value;
    const wind = casesOf(design)[caseWith(design, "wind")]?.["wind"] as Record<string, unknown> | undefined;
    const direction = design.structure && wind ? Number(wind["direction_deg"] ?? 0) : NaN;
    this.arrow.direction = Number.isFinite(direction) ? direction : null;
    if (this.arrow.direction === null) return;
    const said = `${short(direction, 4)}\u00b0`;
    this.handle.firstElementChild!.textContent = `Wind ${short(Number(wind!["speed"]), 3)} m/s, ${said}`;
    this.handle.title = "Drag to turn the wind, or press arrow keys";
    setAttribute(this.handle, "aria-valuenow", direction);
    setAttribute(this.handle, "aria-valuetext", `${said} from x`);
  }
}
