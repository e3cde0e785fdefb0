// What tests and the curious may look at: window.__orishell.

import type { Shell3D } from "../shared/shell3d.ts";
import type { Live } from "./server/live.ts";
import type { Stage } from "./shell/stage.ts";
import type { Store } from "./state/store.ts";
import type { Report } from "./state/types.ts";

export interface Probe {
  /** The whole state; see store.ts. `store.design.value` is the design. */
  readonly store: Store;
  /** The report of the shell on the screen. */
  readonly report: Report | null;
  /** 0 the first state ... 1 the last. */
  readonly fold: number;
  readonly shell3d: Shell3D;
  /** From input event to drawn frame, in milliseconds, newest last: one for every shell drawn,
   * counted from the event that made its design. */
  readonly latencies: readonly number[];
  /** Nothing is read, computed, waited for or verified. */
  readonly idle: boolean;
}

declare global {
  interface Window {
    __orishell?: Probe;
  }
}

export function publishProbe(store: Store, live: Live, stage: Stage): void {
  window.__orishell = {
    store,
    get report() {
      return store.report.value;
    },
    get fold() {
      return stage.fold.share.value;
    },
    shell3d: stage.shell,
    latencies: live.latencies,
    get idle() {
      return live.idle && store.files.value === 0;
    },
  };
}
