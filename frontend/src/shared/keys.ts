// Turning and zooming a camera about its target by keys.

import { Vector3 } from "three";

const TURNS: Record<string, [number, number]> = {
  ArrowLeft: [-0.12, 0],
  ArrowRight: [0.12, 0],
  ArrowUp: [0, 0.1],
  ArrowDown: [0, -0.1],
};
const ZOOMS: Record<string, number> = { "+": 0.85, "=": 0.85, "-": 1 / 0.85 };

/** The way from the target to the camera after a key; null if the key means nothing here. */
export function armAfter(key: string, arm: Vector3): Vector3 | null {
  const zoom = ZOOMS[key];
  if (zoom) return arm.clone().multiplyScalar(zoom);
  const turn = TURNS[key];
  if (!turn) return null;
  const size = arm.length();
  const azimuth = Math.atan2(arm.y, arm.x) + turn[0];
  const height = Math.min(1.5, Math.max(-1.5, Math.asin(arm.z / size) + turn[1]));
  return new Vector3(
    size * Math.cos(azimuth) * Math.cos(height),
    size * Math.sin(azimuth) * Math.cos(height),
    size * Math.sin(height),
  );
}
