// A design as a link: its tables, compressed, in the fragment of the address, which browsers keep to
// themselves.

import { handlesIn } from "../curves/curve-table.ts";
import type { Named } from "../state/store.ts";
import type { Design } from "../state/types.ts";

const PREFIX = "#design=";
/** Longer ones are refused by programs that links are sent with. */
const LONGEST = 16_000;

/** The fragment that stands for a design; null where it would be too long. */
export async function fragmentOf(named: Named): Promise<string | null> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(named)), new CompressionStream("deflate-raw"));
  // Four letters for three bytes: looked at first, as only short ones can be arguments of a call.
  if (Math.ceil((4 * bytes.length) / 3) > LONGEST) return null;
  const text = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return PREFIX + text;
}

export function isLink(fragment: string): boolean {
  return fragment.startsWith(PREFIX);
}

/** The design of a fragment; null if it is none, or broken. */
export async function designOf(fragment: string): Promise<Named | null> {
  if (!isLink(fragment)) return null;
  try {
    const text = atob(fragment.slice(PREFIX.length).replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(text, (each) => each.charCodeAt(0));
    const plain = await through(bytes, new DecompressionStream("deflate-raw"));
    return namedOf(JSON.parse(new TextDecoder().decode(plain)));
  } catch {
    return null;
  }
}

/** What was read, if it is a design with its name; throws where the points of a curve are none. */
export function namedOf(value: unknown): Named | null {
  const found = value as Partial<Named> | null;
  const design = found?.design as Partial<Design> | undefined;
  if (typeof found?.name !== "string" || typeof design?.shell?.family !== "string") return null;
  const { pattern, target } = design;
  if (![pattern, target, target?.f, target?.g].every(isTable)) return null;
  for (const table of [target!.f, target!.g]) handlesIn(table);
  return { name: found.name, design: design as Design };
}

function isTable(value: unknown): boolean {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const piped = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}
