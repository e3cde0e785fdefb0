// Colour maps of the panels, and the theme's colours as numbers.

export type Rgb = [number, number, number];
export type Colouring = "plain" | "signs" | "angle" | "distance";

/** None to the most, light and calm to deep, in even steps of lightness: fold angles to 180 degrees,
 * displacements, stresses. */
export const AMOUNT_MAP = ["#f7f1dc", "#f3d9a4", "#e9b06f", "#d6815a", "#b4565b", "#803a63", "#45285a"];

/** Below the target to above it, the target itself in the middle. */
export const DISTANCE_MAP = ["#0b4f6c", "#2f7f9a", "#7db3c0", "#c9dde0", "#f6f1e6", "#ecd0a6", "#d79a55", "#ad6320", "#6d370c"];

export function parseColour(text: string): Rgb {
  const hex = text.trim().replace("#", "");
  const full = hex.length === 3 ? [...hex].map((digit) => digit + digit).join("") : hex;
  const number = parseInt(full, 16);
  return [((number >> 16) & 255) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}

/** Light as the screen sends it, from the number in the style sheet. */
export function toLinear(rgb: Rgb): Rgb {
  return rgb.map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)) as Rgb;
}

/** The map as a row of texels (RGBA bytes), for the shader. */
export function mapTexels(map: string[], size = 256): Uint8Array {
  const colours = map.map(parseColour);
  const texels = new Uint8Array(4 * size);
  for (let i = 0; i < size; i++) {
    const at = (i / (size - 1)) * (colours.length - 1);
    const k = Math.min(colours.length - 2, Math.floor(at));
    for (let c = 0; c < 3; c++) {
      texels[4 * i + c] = Math.round(255 * (colours[k]![c]! * (k + 1 - at) + colours[k + 1]![c]! * (at - k)));
    }
    texels[4 * i + 3] = 255;
  }
  return texels;
}

export class Theme {
  constructor(private readonly style: CSSStyleDeclaration) {}

  text(name: string): string {
    return this.style.getPropertyValue(name).trim() || "#808080";
  }

  rgb(name: string): Rgb {
    return parseColour(this.text(name));
  }

  linear(name: string): Rgb {
    return toLinear(this.rgb(name));
  }

  number(name: string): number {
    return Number(this.style.getPropertyValue(name)) || 0;
  }
}

/** The colours that hold for an element; asked again at every `themechange` of the document. */
export function themeOf(element: Element): Theme {
  return new Theme(getComputedStyle(element));
}

/** Largest distance, 0 if none is known. */
export function largest(values: Float32Array): number {
  let most = 0;
  for (const value of values) if (Math.abs(value) > most) most = Math.abs(value);
  return most;
}
