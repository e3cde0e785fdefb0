// Opens the view that lies in the page; in a notebook, anywidget calls `render`.

import { openPage } from "./src/viewer/page.ts";
import { render } from "./src/viewer/widget.ts";

const data = document.getElementById("orishell-view");
if (data) Object.assign(window, { orishell: openPage(data) });

export default { render };
