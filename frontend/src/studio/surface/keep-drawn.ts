// Keeps the drawing of the target surface up with the design: one request at a time, the newest waiting.

import { fetchSurface } from "../server/api.ts";
import { ServerFault } from "../state/faults.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";
import { decodeSurface } from "./drawn-surface.ts";

export function keepSurfaceDrawn(store: Store): void {
  let under = false;
  /** The design of which the server drew no surface, whatever of it was wrong: another is asked anew. */
  let refused: Design | null = null;
  const draw = async (): Promise<void> => {
    const design = store.design.value;
    const table = design.target?.surface;
    if (!table) {
      store.surface.set(null);
      store.surfaceAt.set(null);
    }
    if (under || !table || (table === store.surfaceAt.value && (!refused || refused === design))) return;
    under = true;
    refused = null;
    try {
      const drawn = decodeSurface(await fetchSurface(design));
      if (store.design.value.target?.surface) store.surface.set(drawn);
    } catch (error) {
      // What is wrong with it is said when the shell is asked for; the last one stays.
      if (!(error instanceof ServerFault)) throw error;
      refused = design;
    } finally {
      under = false;
    }
    store.surfaceAt.set(table);
    void draw();
  };
  store.design.bind((design, before) => {
    if (design.target?.surface !== before.target?.surface || !store.surface.value || refused) void draw();
  });
}
