// Opens the front that lies in the page.

import type { FrontPage } from "./src/shared/api-types.ts";
import { Page } from "./src/front/page.ts";

const data = document.getElementById("orishell-front")!;
Object.assign(window, { orishell: new Page(JSON.parse(data.textContent!) as FrontPage) });
data.remove();
