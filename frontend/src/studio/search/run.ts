// A search under way: what is found is put together, until it ends, is stopped, or fails.

import { sentence } from "../../shared/words.ts";
import { searchDesigns } from "../server/api.ts";
import { faultOf } from "../state/faults.ts";
import { Signal } from "../state/signal.ts";
import type { Design } from "../state/types.ts";
import { type Found, joined } from "./found.ts";

export interface Run {
  state: "none" | "running" | "done" | "stopped" | "failed";
  found: Found | null;
  /** Why it failed. */
  message: string;
  /** Since its first design was asked for (seconds). */
  seconds: number;
}
const NONE: Run = { state: "none", found: null, message: "", seconds: 0 };

export class Search {
  readonly run = new Signal<Run>(NONE);
  private stopping = new AbortController();

  async begin(design: Design, name: string): Promise<void> {
    this.forget();
    this.stopping = new AbortController();
    const { signal } = this.stopping;
    const begun = performance.now();
    let found: Found | null = null;
    const tell = (state: Run["state"], message = ""): void => {
      if (!signal.aborted) this.run.set({ state, found, message, seconds: (performance.now() - begun) / 1000 });
    };
    tell("running");
    try {
      const last = await searchDesigns(design, name, signal, (state) => {
        found = joined(found, state);
        tell("running");
      });
      found = joined(found, last);
      tell("done");
    } catch (error) {
      const { message, remedy } = faultOf(error);
      tell("failed", [sentence(message), remedy && !message.includes(remedy) ? sentence(remedy) : ""].join(" ").trim());
    }
  }

  /** End it with what there is. */
  stop(): void {
    this.stopping.abort();
    this.run.set({ ...this.run.value, state: "stopped" });
  }

  forget(): void {
    this.stopping.abort();
    this.run.set(NONE);
  }
}
