// viewer.html: the view lies in the page, in base64; or a page of variants, as JSON.

import type { VariantsPage } from "../shared/api-types.ts";
import { inflated } from "../shared/packed.ts";
import { decodeView } from "../shared/view.ts";
import { Viewer } from "./panel.ts";
import { adoptStyles } from "./styles.ts";
import { Variants } from "./variants.ts";

export function openPage(data: HTMLElement): Viewer {
  const text = atob(takenFrom(data));
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Viewer(rootOf(), decodeView(bytes.buffer), document.documentElement);
}

export async function openVariants(data: HTMLElement): Promise<Variants> {
  const page = JSON.parse(takenFrom(data)) as VariantsPage;
  const first = decodeView(await inflated(page.variants[page.first]!.view!));
  return new Variants(rootOf(), page, first, document.documentElement);
}

function takenFrom(data: HTMLElement): string {
  adoptStyles(document);
  data.remove();
  return data.textContent!.trim();
}

function rootOf(): HTMLElement {
  const root = document.createElement("main");
  document.body.append(root);
  return root;
}
