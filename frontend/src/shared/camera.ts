// Where the camera stands: the direction that shows a shell well, and the place that holds it all.

import { PerspectiveCamera, Vector3 } from "three";

/** Of larger clouds every k-th point is asked. */
const ASKED = 40_000;

export interface Extent {
  centre: Vector3;
  radius: number;
  low: Vector3;
  high: Vector3;
}

/** Box of points (n, 3) and the ball about its centre that holds them. */
export function extentOf(clouds: Float32Array[]): Extent {
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
  for (const points of clouds) {
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i]!, y = points[i + 1]!, z = points[i + 2]!;
      if (x < low.x) low.x = x;
      if (y < low.y) low.y = y;
      if (z < low.z) low.z = z;
      if (x > high.x) high.x = x;
      if (y > high.y) high.y = y;
      if (z > high.z) high.z = z;
    }
  }
  if (!(low.x <= high.x)) {
    low.set(-1, -1, -1);
    high.set(1, 1, 1);
  }
  const centre = low.clone().add(high).multiplyScalar(0.5);
  let square = 0;
  for (const points of clouds) {
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i]! - centre.x, y = points[i + 1]! - centre.y, z = points[i + 2]! - centre.z;
      square = Math.max(square, x * x + y * y + z * z);
    }
  }
  return { centre, radius: Math.sqrt(square) || 1, low, high };
}

/** Towards the camera: from before the longer side of the plan, a little to one end, from above. */
export function goodDirection(points: Float32Array): Vector3 {
  let sx = 0, sy = 0, xx = 0, xy = 0, yy = 0;
  const count = points.length / 3 || 1;
  for (let i = 0; i < points.length; i += 3) {
    sx += points[i]!;
    sy += points[i + 1]!;
  }
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i]! - sx / count, y = points[i + 1]! - sy / count;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  // A plan that is about as wide as deep has no longer side: x is it.
  const difference = Math.hypot(xx - yy, 2 * xy), sum = xx + yy || 1;
  let axis = difference / sum < 0.1 ? 0 : 0.5 * Math.atan2(2 * xy, xx - yy);
  if (Math.cos(axis) < 0) axis += Math.PI;
  const azimuth = axis - Math.PI / 2 - 0.52, height = 0.5;
  return new Vector3(Math.cos(azimuth) * Math.cos(height), Math.sin(azimuth) * Math.cos(height), Math.sin(height));
}

/** Nearest place in a direction from which all points are seen; returns the point looked at. */
export function placeCamera(camera: PerspectiveCamera, clouds: Float32Array[], towards: Vector3, margin = 1.1): Vector3 {
  const back = towards.clone().normalize();
  const right = new Vector3().crossVectors(new Vector3(0, 0, 1), back).normalize();
  const up = new Vector3().crossVectors(back, right);
  const slopeY = Math.tan((camera.fov * Math.PI) / 360) / margin, slopeX = slopeY * camera.aspect;
  let east = -Infinity, west = -Infinity, north = -Infinity, south = -Infinity, nearest = -Infinity, farthest = Infinity;
  for (const points of clouds) {
    const stride = 3 * Math.max(1, Math.floor(points.length / 3 / ASKED));
    for (let i = 0; i < points.length; i += stride) {
      const x = points[i]!, y = points[i + 1]!, z = points[i + 2]!;
      const r = x * right.x + y * right.y + z * right.z;
      const u = x * up.x + y * up.y + z * up.z;
      const b = x * back.x + y * back.y + z * back.z;
      east = Math.max(east, r + slopeX * b);
      west = Math.max(west, -r + slopeX * b);
      north = Math.max(north, u + slopeY * b);
      south = Math.max(south, -u + slopeY * b);
      nearest = Math.max(nearest, b);
      farthest = Math.min(farthest, b);
    }
  }
  const depth = Math.max((east + west) / (2 * slopeX), (north + south) / (2 * slopeY));
  const middle = (nearest + farthest) / 2;
  const across = new Vector3()
    .addScaledVector(right, (east - west) / 2)
    .addScaledVector(up, (north - south) / 2);
  const target = across.clone().addScaledVector(back, middle);
  camera.position.copy(across).addScaledVector(back, depth);
  camera.lookAt(target);
  return target;
}

/** How far points reach in the picture, from its middle (0) to its rim (1) and beyond. */
export function reachIn(camera: PerspectiveCamera, clouds: Float32Array[]): number {
  camera.updateMatrixWorld();
  const at = new Vector3();
  let reach = 0;
  for (const points of clouds) {
    const stride = 3 * Math.max(1, Math.floor(points.length / 3 / ASKED));
    for (let i = 0; i < points.length; i += stride) {
      at.set(points[i]!, points[i + 1]!, points[i + 2]!).applyMatrix4(camera.matrixWorldInverse);
      if (at.z >= 0) return Infinity;
      at.applyMatrix4(camera.projectionMatrix);
      reach = Math.max(reach, Math.abs(at.x), Math.abs(at.y));
    }
  }
  return reach;
}

/** 1, 2 or 5 times a power of ten, about a given size. */
export function roundLength(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const digit = size / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}
