// What the shaders are told about colours: theme, colouring, marks.

import { Vector2 } from "three";
import { AMOUNT_MAP, DISTANCE_MAP, mapTexels, type Colouring, type Theme } from "./colours.ts";
import { mapTexture } from "./maps.ts";

const MODES: Colouring[] = ["plain", "signs", "angle", "distance"];
/** Colours and widths of creases: border, mountain, valley, unfolded, cut. */
const PLAIN = { inks: ["--crease", "--crease", "--crease", "--crease", "--crease"], widths: [1.4, 1, 1, 0.7, 1.4] };
const SIGNS = { inks: ["--border-crease", "--mountain", "--valley", "--unfolded", "--border-crease"], widths: [1.6, 2.1, 2.1, 1, 1.6] };

export class Look {
  colouring: Colouring = "plain";
  private readonly maps = { angle: mapTexture(mapTexels(AMOUNT_MAP)), distance: mapTexture(mapTexels(DISTANCE_MAP)) };
  readonly uniforms = {
    front: { value: [1, 1, 1] },
    back: { value: [1, 1, 1] },
    sky: { value: [1, 1, 1] },
    earth: { value: [0, 0, 0] },
    hoverColour: { value: [0, 0, 0] },
    contactColour: { value: [0, 0, 0] },
    colouring: { value: 0 },
    hovered: { value: -1 },
    touching: { value: new Vector2(-1, -1) },
    map: { value: this.maps.angle },
    range: { value: 1 },
    palette: { value: new Float32Array(15) },
    widths: { value: new Float32Array(5) },
  };

  setColouring(mode: Colouring, theme: Theme): void {
    this.colouring = mode;
    this.uniforms.colouring.value = MODES.indexOf(mode);
    this.uniforms.map.value = mode === "distance" ? this.maps.distance : this.maps.angle;
    this.paintCreases(theme);
  }

  paint(theme: Theme): void {
    const u = this.uniforms;
    u.front.value = theme.linear("--panel-front");
    u.back.value = theme.linear("--panel-back");
    u.sky.value = theme.linear("--sky");
    u.earth.value = theme.linear("--earth");
    u.hoverColour.value = theme.linear("--hover");
    u.contactColour.value = theme.linear("--contact");
    this.paintCreases(theme);
  }

  /** Panel pointed at and panels that touch. */
  get marked(): number[] {
    const { x, y } = this.uniforms.touching.value;
    return [x, y, this.uniforms.hovered.value].filter((panel) => panel >= 0);
  }

  dispose(): void {
    for (const map of Object.values(this.maps)) map.dispose();
  }

  private paintCreases(theme: Theme): void {
    const { inks, widths } = this.colouring === "signs" ? SIGNS : PLAIN;
    inks.forEach((name, k) => this.uniforms.palette.value.set(theme.linear(name), 3 * k));
    this.uniforms.widths.value.set(widths);
  }
}
