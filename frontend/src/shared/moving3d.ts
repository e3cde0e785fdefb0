// What moves with the shell beside its panels: ties, the place where panels touch, feet and flaps, and
// outlines of a panel or crease that is chosen.

import { Vector3 } from "three";
import type { Theme } from "./colours.ts";
import { feetOf, groundOf } from "./ground.ts";
import { Dots3D, type Drawing, type Guest, Lines3D } from "./marks3d.ts";
import type { Uniforms } from "./parts.ts";
import type { Motion } from "./rigid.ts";
import { contactOf } from "./stops.ts";
import { cornersOf, stateOfTie, type TieLine, tiesOf } from "./ties.ts";
import { nearestOf } from "./touching.ts";
import type { View } from "./view.ts";

/** Dashes of a slack tie. */
const DASHES = 24;
/** Drives nearer to the contact than this show its place (degrees). */
const NEAR = 1;

const from = new Vector3(), to = new Vector3();

/** Ties: whole lines where they are taut, dashes where they are slack. */
export class Ties3D implements Guest {
  private readonly taut;
  private readonly slack;
  private ties: TieLine[] = [];
  private corners: Uint32Array = new Uint32Array();
  private shown = true;

  constructor(uniforms: Uniforms) {
    this.taut = new Lines3D(uniforms, { width: 2.4 });
    this.slack = new Lines3D(uniforms, { width: 1.6 });
  }

  get drawn() {
    return [...this.taut.drawn, ...this.slack.drawn];
  }

  show(view: View, motion: Motion): void {
    this.ties = tiesOf(view);
    if (this.ties.length) this.corners = cornersOf(motion.faces, view);
    this.setVisible(this.shown);
  }

  setVisible(on: boolean): void {
    this.shown = on;
    this.taut.visible = this.slack.visible = on && this.ties.length > 0;
  }

  move(motion: Motion): void {
    if (!this.ties.length || !this.shown) return;
    const taut: number[] = [], slack: number[] = [];
    for (const tie of this.ties) {
      const [a, b] = tie.ends.map((vertex) => this.corners[vertex]!);
      motion.at(a!, from);
      motion.at(b!, to);
      const state = stateOfTie(tie, from.distanceTo(to));
      if (state === "taut") taut.push(...from, ...to);
      else if (state === "slack") {
        for (let k = 0; k < DASHES; k += 2) {
          slack.push(...from.clone().lerp(to, (k + 0.5) / DASHES), ...from.clone().lerp(to, (k + 1.5) / DASHES));
        }
      }
    }
    this.taut.set(Float32Array.from(taut));
    this.slack.set(Float32Array.from(slack));
  }

  paint(theme: Theme): void {
    this.taut.setColour(theme.linear("--tie"));
    this.slack.setColour(theme.linear("--tie"));
  }

  dispose(): void {
    this.taut.dispose();
    this.slack.dispose();
  }
}

/** The point at which two panels touch. */
export class Touch3D implements Guest {
  private readonly dot;
  private view: View | null = null;

  constructor(uniforms: Uniforms) {
    this.dot = new Dots3D(uniforms, { width: 11, through: 0.85 });
    this.dot.visible = false;
  }

  get drawn() {
    return this.dot.drawn;
  }

  show(view: View): void {
    this.view = view;
    this.dot.visible = false;
  }

  move(motion: Motion, { drive }: Drawing): void {
    const contact = this.view && contactOf(this.view);
    const here = contact && Math.abs(drive - contact.drive_deg) < NEAR;
    this.dot.visible = here === true;
    if (!here) return;
    const [one, other] = contact.panels.map((panel) => [0, 1, 2, 3].map((k) => motion.at(4 * panel + k, new Vector3())));
    this.dot.set(Float32Array.from(nearestOf(one!, other!).point));
  }

  paint(theme: Theme): void {
    this.dot.setColour(theme.linear("--contact"));
  }

  dispose(): void {
    this.dot.dispose();
  }
}

/** Vertices that stand on the ground, and outlines of the flaps. */
export class Feet3D implements Guest {
  private readonly feet;
  private readonly flaps;
  private corners: number[] = [];
  private sides: [number, number][] = [];

  constructor(uniforms: Uniforms) {
    this.feet = new Dots3D(uniforms, { width: 7 });
    this.flaps = new Lines3D(uniforms, { width: 2 });
  }

  get drawn() {
    return [...this.feet.drawn, ...this.flaps.drawn];
  }

  show(view: View, motion: Motion): void {
    const corners = cornersOf(motion.faces, view);
    this.corners = feetOf(view, groundOf(view)).map((vertex) => corners[vertex]!);
    this.sides = flapSides(view).map(([a, b]) => [corners[a]!, corners[b]!]);
  }

  move(motion: Motion, { atTarget }: Drawing): void {
    this.feet.visible = atTarget && this.corners.length > 0;
    if (atTarget) this.feet.set(Float32Array.from(this.corners.flatMap((corner) => [...motion.at(corner, from)])));
    this.flaps.visible = this.sides.length > 0;
    this.flaps.set(Float32Array.from(this.sides.flatMap(([a, b]) => [...motion.at(a, from), ...motion.at(b, to)])));
  }

  paint(theme: Theme): void {
    this.feet.setColour(theme.linear("--foot"));
    this.flaps.setColour(theme.linear("--flap"));
  }

  dispose(): void {
    this.feet.dispose();
    this.flaps.dispose();
  }
}

/** Ends of the lines around the flaps of the sheet: its first and last column of panels. */
export function flapSides(view: View): [number, number][] {
  const { grid, report } = view.header;
  if (!grid || report.deployment?.flap_attachment !== "folded") return [];
  const [rows, columns] = grid;
  const sides: [number, number][] = [];
  for (const [outer, inner] of [[0, 1], [columns - 1, columns - 2]] as const) {
    for (let row = 0; row < rows; row++) {
      const at = row * columns;
      if (row + 1 < rows) sides.push([at + outer, at + columns + outer], [at + inner, at + columns + inner]);
      if (row === 0 || row === rows - 1) sides.push([at + outer, at + inner]);
    }
  }
  return sides;
}

/** Lines between vertices, and dots at places, that are chosen. */
export class Chosen3D implements Guest {
  private readonly lines;
  private readonly dots;
  private readonly points: (motion: Motion) => { lines: Vector3[]; dots: Vector3[] };

  constructor(uniforms: Uniforms, private readonly ink: string, points: (motion: Motion) => { lines: Vector3[]; dots: Vector3[] }, readonly withLoads = false) {
    this.points = points;
    this.lines = new Lines3D(uniforms, { width: 3.2, through: 0.5 });
    this.dots = new Dots3D(uniforms, { width: 10, through: 0.7 });
  }

  get drawn() {
    return [...this.lines.drawn, ...this.dots.drawn];
  }

  move(motion: Motion): void {
    const { lines, dots } = this.points(motion);
    this.lines.set(Float32Array.from(lines.flatMap((each) => [...each])));
    this.dots.set(Float32Array.from(dots.flatMap((each) => [...each])));
    this.lines.visible = lines.length > 0;
    this.dots.visible = dots.length > 0;
  }

  paint(theme: Theme): void {
    this.lines.setColour(theme.linear(this.ink));
    this.dots.setColour(theme.linear(this.ink));
  }

  dispose(): void {
    this.lines.dispose();
    this.dots.dispose();
  }
}
