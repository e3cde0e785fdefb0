// How large files are that the studio reads.

import { short } from "../parts/numbers.ts";
import { ServerFault, ownFault } from "./faults.ts";

/** Of the bytes of a request those of a file at most: base64 has four characters for three. */
const SHARE = 0.74;

/** Refuse a file that is too large for a request of so many bytes. */
export function requireSmall(file: File, bytes: number, what: string, remedy = ""): void {
  const most = (SHARE * bytes) / 1e6, size = file.size / 1e6;
  if (size <= most) return;
  const limit = `the studio reads ${what} of up to ${short(most, 3)} MB${remedy}`;
  throw new ServerFault(ownFault("page", `${file.name} has ${short(size, 3)} MB; ${limit}`));
}
