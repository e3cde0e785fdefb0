// viewer.html: the view lies in the page, in base64.

import { Viewer } from "./panel.ts";
import { adoptStyles } from "./styles.ts";

export function openPage(data: HTMLElement): Viewer {
  adoptStyles(document);
  const text = atob(data.textContent!.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  data.remove();
  const root = document.createElement("main");
  document.body.append(root);
  return new Viewer(root, bytes.buffer, document.documentElement);
}
