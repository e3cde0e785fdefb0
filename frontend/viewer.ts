// Opens what lies in the page, a view or variants; in a notebook, anywidget calls `render`.

import { openPage, openVariants } from "./src/viewer/page.ts";
import { render } from "./src/viewer/widget.ts";

const view = document.getElementById("orishell-view"), variants = document.getElementById("orishell-variants");
if (view) Object.assign(window, { orishell: openPage(view) });
if (variants) void openVariants(variants).then((orishell) => Object.assign(window, { orishell }));

export default { render };
