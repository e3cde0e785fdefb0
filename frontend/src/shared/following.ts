// The camera follows a shell that grows, shrinks or moves, from the angle that was chosen.

import { Vector3, type PerspectiveCamera } from "three";
import { reachIn, type Extent } from "./camera.ts";

/** A whole shell that reaches farther than this (1: the rim), or less far, is fitted anew. */
const OUTSIDE = 1;
const SMALL = 0.45;
/** A part of a shell is followed when the shell has grown so many times, or to this share. */
const GROWN = 1.5;
const SHRUNK = 0.6;

export class Following {
  private readonly aim = new Vector3();
  private readonly centre = new Vector3();
  private away = 0;
  private radius = 1;

  /** `target` is what the camera turns about; it is moved with it. */
  constructor(private readonly camera: PerspectiveCamera, private readonly target: Vector3) {}

  /** All of a shell has been brought into view. */
  fitted(extent: Extent): void {
    this.aim.copy(this.target);
    this.away = this.camera.position.distanceTo(this.target);
    this.remember(extent);
  }

  /** The origin of the scene has moved; the camera stays where it is in the world. */
  shift(by: Vector3): void {
    for (const place of [this.camera.position, this.target, this.aim, this.centre]) place.add(by);
  }

  /** All was in view, and the camera has been turned since at most. */
  get turnedOnly(): boolean {
    const size = this.camera.position.distanceTo(this.target);
    return this.target.distanceTo(this.aim) < 1e-3 * this.radius && Math.abs(size / this.away - 1) < 1e-3;
  }

  /** Follow another shell; true if all of it should be brought into view anew. */
  follow(extent: Extent, clouds: Float32Array[]): boolean {
    if (this.turnedOnly) {
      const reach = reachIn(this.camera, clouds);
      return reach > OUTSIDE || reach < SMALL;
    }
    const growth = extent.radius / this.radius;
    const gone = extent.centre.distanceTo(this.centre) > this.radius;
    if (growth < GROWN && growth > SHRUNK && !gone) return false;
    // The same part of the shell stays in view, as large as it was.
    for (const place of [this.camera.position, this.target]) {
      place.sub(this.centre).multiplyScalar(growth).add(extent.centre);
    }
    this.remember(extent);
    return false;
  }

  private remember(extent: Extent): void {
    this.centre.copy(extent.centre);
    this.radius = extent.radius;
  }
}
