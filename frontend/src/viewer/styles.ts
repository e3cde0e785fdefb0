// The style sheets, as text inside the bundle.

import meanings from "../shared/meanings.css?inline";
import theme from "../shared/theme.css?inline";
import views from "../shared/views.css?inline";
import viewer from "./viewer.css?inline";

/** Give a page or a shadow root the viewer's looks, and more; nothing outside it is touched. */
export function adoptStyles(root: DocumentOrShadowRoot, more = ""): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(meanings + theme + views + viewer + more);
  root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
}
