// A design as a link: its tables, compressed, in the fragment of the address, which browsers keep to
// themselves.

import { ServerFault, ownFault } from "../state/faults.ts";
import { type Named, namedOf } from "../state/named.ts";

const PREFIX = "#design=";
/** Longer ones are refused by programs that links are sent with. */
const LONGEST = 16_000;
/** Bytes of a design in a link, at most, and of what is inflated at a time: a thousand times that. */
const LARGEST = 10_000_000;
const PIECE = 1024;

/** The fragment that stands for a design; null where it would be too long. */
export async function fragmentOf({ name, design }: Named): Promise<string | null> {
  const plain = new Blob([JSON.stringify({ name, design })]).stream();
  const bytes = new Uint8Array(await new Response(plain.pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer());
  // Four letters for three bytes: looked at first, as only short ones can be arguments of a call.
  if (Math.ceil((4 * bytes.length) / 3) > LONGEST) return null;
  const text = btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return PREFIX + text;
}

export function isLink(fragment: string): boolean {
  return fragment.startsWith(PREFIX);
}

/** The design of a fragment; throws ServerFault if it is none, broken, or far too large. */
export async function designOf(fragment: string): Promise<Named> {
  try {
    const text = atob(fragment.slice(PREFIX.length).replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(text, (each) => each.charCodeAt(0));
    const found = namedOf(JSON.parse(await inflated(bytes)));
    if (found) return found;
  } catch (error) {
    if (error instanceof ServerFault) throw error;
  }
  throw brokenLink();
}

export function brokenLink(): ServerFault {
  return new ServerFault(ownFault("input", "The link of this design is broken", "copy the whole of it; some programs cut long links"));
}

/** The text that was compressed; no more of it than is allowed is ever held. */
async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  let at = 0;
  const pieces = new ReadableStream<Uint8Array<ArrayBuffer>>({
    pull(into) {
      if (at < bytes.length) into.enqueue(bytes.subarray(at, (at += PIECE)));
      else into.close();
    },
  });
  const reader = pieces.pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const found: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return new Blob(found).text();
    found.push(value);
    size += value.length;
    if (size > LARGEST) {
      // What is left is not read, whatever becomes of it.
      reader.cancel().catch(() => undefined);
      const remedy = "ask who sent it for the design file";
      throw new ServerFault(ownFault("input", `The design of this link has more than ${LARGEST / 1e6} MB`, remedy));
    }
  }
}
