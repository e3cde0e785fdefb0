// Keeps the drawing of the target surface up with the design: one request at a time, the newest waiting.

import { fetchSurface } from "../server/api.ts";
import { ServerFault } from "../state/faults.ts";
import type { Store } from "../state/store.ts";
import { decodeSurface } from "./drawn-surface.ts";

export function keepSurfaceDrawn(store: Store): void {
  let under = false;
  const draw = async (): Promise<void> => {
    const design = store.design.value;
    const table = design.target?.surface;
    if (!table) store.surface.set(null);
    if (under || !table || table === store.surfaceAt.value) return;
    under = true;
    try {
      const drawn = decodeSurface(await fetchSurface(design));
      if (store.design.value.target?.surface) store.surface.set(drawn);
    } catch (error) {
      // What is wrong with it is said when the shell is asked for; the last one stays.
      if (!(error instanceof ServerFault)) throw error;
    } finally {
      under = false;
    }
    store.surfaceAt.set(table);
    void draw();
  };
  store.design.bind((design, before) => {
    if (design.target?.surface !== before.target?.surface || !store.surface.value) void draw();
  });
}
