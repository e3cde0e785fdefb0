// The variant that is pointed at among others, as a ghost beside the shell.

import { Ghost3D } from "../../shared/ghost3d.ts";
import { decodeView, type View } from "../../shared/view.ts";
import { fetchView } from "../server/api.ts";
import { isSlow } from "../state/aims.ts";
import { ServerFault } from "../state/faults.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";
import type { Stage } from "./stage.ts";

/** Who points at a variant for so long wants to see it (milliseconds). */
const REST = 80;
/** States of its motion: enough for where it stands. */
const STATES = 3;

export class Preview {
  private readonly ghost: Ghost3D;
  private readonly redraw: () => void;
  private timer = 0;
  private asked = new AbortController();
  private readonly known = new WeakMap<Design, View>();

  constructor(
    store: Store,
    private readonly stage: Stage,
  ) {
    this.ghost = new Ghost3D(stage.shell.uniforms);
    this.redraw = stage.shell.add(this.ghost);
    store.design.watch(() => store.pointed.set(null));
    store.pointed.watch((design) => {
      clearTimeout(this.timer);
      this.asked.abort();
      // A sheet that is fitted takes seconds.
      if (!design || isSlow(design)) return this.show(null);
      this.timer = window.setTimeout(() => void this.find(design), REST);
    });
  }

  private async find(design: Design): Promise<void> {
    const { signal } = (this.asked = new AbortController());
    try {
      const view = this.known.get(design) ?? decodeView((await fetchView(design, STATES, signal)).bytes);
      this.known.set(design, view);
      if (!signal.aborted) this.show(view);
    } catch (error) {
      // A variant that cannot be made by now has no ghost.
      if (!signal.aborted && !(error instanceof ServerFault)) throw error;
    }
  }

  private show(view: View | null): void {
    this.ghost.set(view);
    this.stage.element.dataset["preview"] = String(view !== null);
    this.stage.shell.explainMark("variant", view !== null);
    this.redraw();
  }
}
