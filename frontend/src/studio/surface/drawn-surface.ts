// The surface that is asked for, as the server draws it.

import type * as Api from "../../shared/api-types.ts";
import type { Lattice } from "../../shared/view.ts";
import { decodeFloats } from "../server/api.ts";
import type { Place } from "../state/types.ts";
import type { Patch } from "./patch.ts";

export interface DrawnSurface {
  /** As it stands in space. */
  glass: Lattice;
  /** Its rim, once around, and its corners there. */
  rim: Place[];
  corners: Place[];
  /** The rectangle that is covered; null: the surface is given in another way. */
  patch: Patch | null;
  /** By which coordinates of its table are multiplied. */
  factor: [number, number, number];
}

export function decodeSurface(answer: Api.DrawnSurface): DrawnSurface {
  const [rows, columns] = answer.lattice;
  const flat = decodeFloats(answer.rim);
  const rim = Array.from({ length: flat.length / 3 }, (_, k): Place => [flat[3 * k]!, flat[3 * k + 1]!, flat[3 * k + 2]!]);
  const corners = answer.corners.map((k) => rim[k]!);
  return { glass: { rows, columns, points: decodeFloats(answer.points) }, rim, corners, patch: answer.patch, factor: answer.factor };
}
