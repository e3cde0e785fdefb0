// What is drawn beside the shell, and in which colours: ground, target, curves f and g.

import { Vector2, Vector3, type Scene } from "three";
import { roundLength, type Extent } from "./camera.ts";
import type { Theme } from "./colours.ts";
import type { Uniforms } from "./parts.ts";
import { CurveLine, makeGround, makeSurface, setLattice } from "./surroundings.ts";
import type { Lattice, View } from "./view.ts";

export type Overlay = "surface" | "f" | "g";

export class Overlays {
  private readonly groundUniforms = {
    middle: { value: new Vector3() },
    gridOrigin: { value: new Vector2() },
    gridColour: { value: [0, 0, 0] },
    shadowColour: { value: [0, 0, 0] },
    reach: { value: 1 },
    cell: { value: 1 },
    shadowStrength: { value: 0 },
  };
  private readonly surfaceUniforms = { ink: { value: [0, 0, 0] }, cells: { value: new Vector2(8, 8) } };
  private readonly ground;
  private readonly surface;
  private readonly curves;

  constructor(scene: Scene, shared: Uniforms) {
    this.ground = makeGround({ ...shared, ...this.groundUniforms });
    this.surface = makeSurface({ ...shared, ...this.surfaceUniforms });
    this.curves = { f: new CurveLine(shared), g: new CurveLine(shared) };
    scene.add(this.ground, this.surface, ...this.curves.f.meshes, ...this.curves.g.meshes);
    for (const name of ["surface", "f", "g"] as const) this.setVisible(name, false);
  }

  show(view: View): void {
    this.setSurface(view.surface);
    this.curves.f.show(view.curveF);
    this.curves.g.show(view.curveG);
  }

  /** Draw another surface, moved from where it is given. */
  setSurface(surface: Lattice | undefined, shift?: Vector3): void {
    const moved = surface && shift ? { ...surface, points: surface.points.map((value, k) => value + shift.getComponent(k % 3)) } : surface;
    setLattice(this.surface, moved);
    if (moved) this.surfaceUniforms.cells.value.set(...cellsOf(moved));
  }

  setVisible(name: Overlay, visible: boolean): void {
    if (name === "surface") this.surface.visible = visible;
    else this.curves[name].visible = visible;
  }

  /** Height of the ground that the state drawn stands on. */
  setLevel(level: number): void {
    this.groundUniforms.middle.value.z = level;
  }

  /** Ground below the shell, lines on round numbers of the world; returns their distance. */
  placeGround({ centre, radius, low, high }: Extent, origin: Vector3): number {
    const u = this.groundUniforms;
    u.middle.value.set(centre.x, centre.y, low.z - 0.004 * radius);
    u.reach.value = 3.2 * radius;
    const cell = roundLength((high.x - low.x + high.y - low.y) / 24);
    u.cell.value = cell;
    // Of the origin only what is less than five cells counts: numbers stay exact.
    u.gridOrigin.value.set(-remainder(origin.x, 5 * cell), -remainder(origin.y, 5 * cell));
    return cell;
  }

  paint(theme: Theme): void {
    this.groundUniforms.gridColour.value = theme.rgb("--grid");
    this.groundUniforms.shadowColour.value = theme.rgb("--shadow");
    this.groundUniforms.shadowStrength.value = theme.number("--shadow-strength");
    this.surfaceUniforms.ink.value = theme.linear("--target");
    this.curves.f.setColour(theme.linear("--curve-f"));
    this.curves.g.setColour(theme.linear("--curve-g"));
  }

  dispose(): void {
    for (const curve of Object.values(this.curves)) curve.dispose();
    for (const mesh of [this.ground, this.surface]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }
}

function remainder(value: number, step: number): number {
  return value - step * Math.floor(value / step);
}

/** Cells of about equal sides, the longer way 16. */
function cellsOf({ rows, columns, points }: Lattice): [number, number] {
  const between = (a: number, b: number): number =>
    Math.hypot(points[3 * a]! - points[3 * b]!, points[3 * a + 1]! - points[3 * b + 1]!, points[3 * a + 2]! - points[3 * b + 2]!);
  let down = 0, across = 0;
  const row = Math.floor(rows / 2), column = Math.floor(columns / 2);
  for (let i = 1; i < rows; i++) down += between(i * columns + column, (i - 1) * columns + column);
  for (let j = 1; j < columns; j++) across += between(row * columns + j, row * columns + j - 1);
  const side = Math.max(down, across) / 16 || 1;
  return [Math.max(1, Math.round(down / side)), Math.max(1, Math.round(across / side))];
}
