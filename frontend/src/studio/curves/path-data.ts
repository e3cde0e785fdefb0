// A curve as SVG path data: read into pieces that can be changed, and written again.

import { short } from "../parts/numbers.ts";
import type { Point } from "../state/types.ts";

export interface Arc {
  kind: "A";
  radii: Point;
  /** Turn of the axes in degrees. */
  turn: number;
  large: boolean;
  /** Whether it turns left. */
  sweep: boolean;
  to: Point;
}
/** Straight with no control points, of degree 2 and 3 with one and two. */
export interface Bezier {
  kind: "B";
  control: Point[];
  to: Point;
}
export type Piece = Arc | Bezier;
export interface Path {
  start: Point;
  pieces: Piece[];
}

const COUNTS: Record<string, number> = { M: 2, L: 2, H: 1, V: 1, C: 6, S: 4, Q: 4, T: 2, A: 7 };
const NUMBER = /^[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)/;
const FLAG = /^[\s,]*([01])/;

/** The pieces of one open curve; null where the text is none: the server then says why. */
export function readPath(text: string): Path | null {
  let rest = text;
  const next = (pattern: RegExp): string | null => {
    const found = pattern.exec(rest);
    if (!found) return null;
    rest = rest.slice(found[0].length);
    return found[1]!;
  };
  let start: Point | null = null;
  const pieces: Piece[] = [];
  while (rest.trim()) {
    let letter = next(/^\s*([A-Za-z])/);
    if (!letter || (letter.toUpperCase() === "M") !== (start === null)) return null;
    const count = COUNTS[letter.toUpperCase()];
    if (!count) return null;
    do {
      const numbers: number[] = [];
      for (let k = 0; k < count; k++) {
        const found = next(letter.toUpperCase() === "A" && (k === 3 || k === 4) ? FLAG : NUMBER);
        if (found === null) return null;
        numbers.push(Number(found));
      }
      const here: Point = pieces.at(-1)?.to ?? start ?? [0, 0];
      if (start === null) {
        start = [numbers[0]!, numbers[1]!];
        letter = letter === "m" ? "l" : "L";
      } else {
        pieces.push(pieceOf(letter, numbers, here, pieces.at(-1)));
      }
    } while (NUMBER.test(rest));
  }
  return start && pieces.length ? { start, pieces } : null;
}

function pieceOf(letter: string, numbers: number[], here: Point, before: Piece | undefined): Piece {
  const kind = letter.toUpperCase();
  const [bx, by]: Point = kind === letter ? [0, 0] : here;
  if (kind === "H") return { kind: "B", control: [], to: [bx + numbers[0]!, here[1]] };
  if (kind === "V") return { kind: "B", control: [], to: [here[0], by + numbers[0]!] };
  if (kind === "A") {
    const [rx, ry, turn, large, sweep, x, y] = numbers as [number, number, number, number, number, number, number];
    const to: Point = [bx + x, by + y];
    if (rx === 0 || ry === 0) return { kind: "B", control: [], to };
    return { kind: "A", radii: [Math.abs(rx), Math.abs(ry)], turn, large: large === 1, sweep: sweep === 1, to };
  }
  const points: Point[] = [];
  for (let k = 0; k < numbers.length; k += 2) points.push([bx + numbers[k]!, by + numbers[k + 1]!]);
  const degree = kind === "S" ? 2 : kind === "T" ? 1 : 0;
  if (degree) {
    const last = before?.kind === "B" && before.control.length === degree ? before.control.at(-1)! : here;
    points.unshift([2 * here[0] - last[0], 2 * here[1] - last[1]]);
  }
  return { kind: "B", control: points.slice(0, -1), to: points.at(-1)! };
}

export function writePath(path: Path): string {
  const words = [`M${pair(path.start)}`];
  for (const piece of path.pieces) {
    if (piece.kind === "A") {
      const flags = `${Number(piece.large)} ${Number(piece.sweep)}`;
      words.push(`A${pair(piece.radii)} ${short(piece.turn, 12)} ${flags} ${pair(piece.to)}`);
    } else {
      words.push("LQC"[piece.control.length]! + [...piece.control, piece.to].map(pair).join(" "));
    }
  }
  return words.join(" ");
}

function pair([x, y]: Point): string {
  return `${short(x, 13)} ${short(y, 13)}`;
}
