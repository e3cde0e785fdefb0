// The key light and what it does not reach: one picture of depths, seen from the light.

import {
  DepthTexture, LessEqualCompare, LinearFilter, Matrix4, type Object3D, OrthographicCamera, Scene,
  UnsignedIntType, Vector3, type WebGLRenderer, WebGLRenderTarget,
} from "three";
import type { Extent } from "./camera.ts";

const SIZE = 1024;
const LIGHT = new Vector3(-0.62, -0.42, 0.8).normalize();

export class Sun {
  readonly uniforms = {
    light: { value: LIGHT },
    shadowMap: { value: null as DepthTexture | null },
    shadowMatrix: { value: new Matrix4() },
    shadowTexel: { value: 1 / SIZE },
    shadowTaps: { value: 12 },
    shadowBias: { value: 0 },
  };
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, { depthBuffer: true });

  constructor() {
    const depths = new DepthTexture(SIZE, SIZE, UnsignedIntType);
    depths.compareFunction = LessEqualCompare;
    depths.minFilter = depths.magFilter = LinearFilter;
    this.target.depthTexture = depths;
    this.uniforms.shadowMap.value = depths;
  }

  add(caster: Object3D): void {
    this.scene.add(caster);
  }

  /** Let the light see all of the motion. */
  place({ centre, radius }: Extent): void {
    const reach = 1.02 * radius, camera = this.camera;
    Object.assign(camera, { left: -reach, right: reach, bottom: -reach, top: reach, near: 0, far: 4.5 * reach });
    camera.position.copy(centre).addScaledVector(LIGHT, 1.5 * reach);
    camera.up.set(0, 0, 1);
    camera.lookAt(centre);
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    this.uniforms.shadowBias.value = 0.004 * radius;
    this.uniforms.shadowMatrix.value
      .makeScale(0.5, 0.5, 0.5)
      .setPosition(0.5, 0.5, 0.5)
      .multiply(camera.projectionMatrix)
      .multiply(camera.matrixWorldInverse);
  }

  draw(renderer: WebGLRenderer): void {
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.target.depthTexture?.dispose();
    this.target.dispose();
  }
}
