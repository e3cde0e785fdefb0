// A colour map as a texture.

import { ClampToEdgeWrapping, DataTexture, LinearFilter } from "three";

export function mapTexture(texels: Uint8Array): DataTexture {
  const texture = new DataTexture(texels, texels.length / 4, 1);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.wrapS = ClampToEdgeWrapping;
  texture.needsUpdate = true;
  return texture;
}
