// A quiet word to who is new here: there is a tour. It is said once.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { storageOf } from "../state/storage.ts";
import type { Store } from "../state/store.ts";

const KEY = "orishell.tour";

/** Gone when it was answered, and when work has begun; null for who has seen it. */
export function tourHint(store: Store, show: () => void): HTMLElement | null {
  const storage = storageOf(window);
  if (storage?.getItem(KEY)) return null;
  const answered = (): void => {
    element.remove();
    stop();
    try {
      storage?.setItem(KEY, "seen");
    } catch {
      // A browser that keeps nothing says it again the next time.
    }
  };
  const stop = store.design.watch(answered);
  const element = h(
    "section",
    { class: "tour-hint", "aria-label": "New here?", "data-testid": "tour-hint" },
    h("span", {}, "New here?"),
    button({
      label: "Show me around", text: "Show me around", testid: "tour-start",
      act: () => {
        answered();
        show();
      },
    }),
    button({ label: "No, thanks", text: "No", testid: "tour-no", act: answered }),
  );
  return element;
}
