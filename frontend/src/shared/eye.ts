// From where a shell is seen: the camera, how hands and keys move it, and what it makes of a place in the window.

import { PerspectiveCamera, Plane, Raycaster, Vector2, Vector3, type Ray } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { placeCamera, type Extent } from "./camera.ts";
import { Following } from "./following.ts";
import { armAfter } from "./keys.ts";

/** From where one looks: the way from what is looked at to the camera, and how far that was moved
 * from the middle of what was last fitted. */
export interface Sight {
  arm: Vector3;
  moved: Vector3;
}

export class Eye {
  readonly camera = new PerspectiveCamera(28, 1, 0.1, 100);
  /** Whether all of a shell was brought into view before. */
  fitted = false;
  private readonly controls: OrbitControls;
  private readonly following: Following;
  /** The middle of what was last fitted. */
  private readonly middle = new Vector3();
  private readonly caster = new Raycaster();
  private width = 1;
  private height = 1;

  /** `moved` is told when it has moved. */
  constructor(private readonly canvas: HTMLCanvasElement, moved: () => void) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.09;
    this.controls.rotateSpeed = 0.75;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", moved);
    this.following = new Following(this.camera, this.controls.target);
  }

  get arm(): Vector3 {
    return this.camera.position.clone().sub(this.controls.target);
  }

  get sight(): Sight {
    return { arm: this.arm, moved: this.controls.target.clone().sub(this.middle) };
  }

  set sight({ arm, moved }: Sight) {
    this.controls.target.copy(this.middle).add(moved);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
  }

  /** Neither nearer nor elsewhere than what was fitted. */
  get turnedOnly(): boolean {
    return this.fitted && this.following.turnedOnly;
  }

  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /** Bring points into view, seen from a direction. */
  look(points: Float32Array[], towards: Vector3, extent: Extent): void {
    this.middle.copy(placeCamera(this.camera, points, towards));
    this.controls.target.copy(this.middle);
    this.fitted = this.canvas.clientWidth > 0;
    this.limitDistance(extent);
    this.following.fitted(extent);
  }

  /** Follow another shell, whose origin is elsewhere; true if it should be brought into view anew. */
  follow(shift: Vector3, extent: Extent, points: () => Float32Array[]): boolean {
    this.following.shift(shift);
    const anew = this.following.follow(extent, points());
    if (!anew) this.limitDistance(extent);
    return anew;
  }

  /** What is left of a turn or a shift by hand goes on; or not, from another place. */
  update(): void {
    this.controls.update();
  }

  stopGliding(): void {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
  }

  /** Never nearer or farther than the camera is put: a narrow picture wants it far away. */
  limitDistance(extent: Extent): void {
    const away = this.arm.length();
    this.controls.minDistance = Math.min(0.02 * extent.radius, away);
    this.controls.maxDistance = Math.max(14 * extent.radius, away);
    this.controls.update();
  }

  /** Ready to draw a shell; returns the pixels of a unit of length, where one looks. */
  prepare({ centre, radius }: Extent): number {
    const { camera } = this;
    const away = camera.position.distanceTo(centre);
    camera.near = Math.max(0.01 * radius, away - 4.7 * radius);
    camera.far = away + 4.7 * radius;
    camera.updateProjectionMatrix();
    const slope = Math.tan((camera.fov * Math.PI) / 360);
    return this.height / 2 / (slope * this.arm.length());
  }

  /** Turn or zoom by a key, if it means that. */
  key(key: string): boolean {
    const arm = armAfter(key, this.arm);
    if (arm) this.camera.position.copy(this.controls.target).add(arm);
    return arm !== null;
  }

  /** What is seen at a place of the picture, -1 to 1 both ways. */
  through(at: Vector2): Ray {
    this.caster.setFromCamera(at, this.camera);
    return this.caster.ray;
  }

  /** What is seen at a place of the window. */
  ray(x: number, y: number): Ray {
    const box = this.canvas.getBoundingClientRect();
    return this.through(new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height));
  }

  /** Where a level plane is seen at a place of the window; null beyond the horizon. */
  onLevel(x: number, y: number, height: number): Vector3 | null {
    return this.ray(x, y).intersectPlane(new Plane(new Vector3(0, 0, 1), -height), new Vector3());
  }

  /** Where a point is in the window. */
  onScreen(point: Vector3): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    const { x, y } = point.clone().project(this.camera);
    return [box.left + (0.5 + 0.5 * x) * box.width, box.top + (0.5 - 0.5 * y) * box.height];
  }

  /** Where a point is in the picture as it was laid out last (pixels). */
  inPicture(point: Vector3): [number, number] {
    const { x, y } = point.clone().project(this.camera);
    return [(0.5 + 0.5 * x) * this.width, (0.5 - 0.5 * y) * this.height];
  }

  get size(): [width: number, height: number] {
    return [this.width, this.height];
  }

  dispose(): void {
    this.controls.dispose();
  }
}
