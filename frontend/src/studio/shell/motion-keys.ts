// Arrow keys fold the shell wherever they mean nothing else.

import type { FoldBar } from "./fold-bar.ts";

/** What uses arrow keys itself, or scrolls by them. Buttons do not. */
export const CONTROLS = "input, select, textarea, canvas, dialog, :popover-open, [tabindex='0'], svg [tabindex], [role=radio], [role=slider]";

export function foldByKeys(fold: FoldBar): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || (event.target as HTMLElement).closest(CONTROLS)) return;
    if (fold.key(event)) event.preventDefault();
  });
}
