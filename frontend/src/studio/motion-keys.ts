// Arrow keys fold the shell wherever no control has the focus.

import type { FoldBar } from "./fold-bar.ts";

const CONTROLS = "input, select, textarea, button, summary, a, canvas, dialog, [popover], [role], [tabindex='0']";

export function foldByKeys(fold: FoldBar): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || (event.target as HTMLElement).closest(CONTROLS)) return;
    if (fold.key(event)) event.preventDefault();
  });
}
