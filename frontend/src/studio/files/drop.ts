// Files that are dropped onto the page: a design file opens, a mesh becomes the surface, a crease pattern the
// sheet; a drawing is one, or f or g, as asked.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import type { CurveName } from "../state/types.ts";

const MESH = /\.(obj|stl|ply|glb|gltf)$/i;
const PATTERN = /\.fold$/i;
const EITHER = /\.(svg|dxf)$/i;
const DRAWING = /\.(csv|txt|svg|dxf)$/i;

export interface DropEvents {
  design(file: File): void;
  curve(name: CurveName, file: File): void;
  surface(file: File): void;
  pattern(file: File): void;
  looksLikePattern(file: File): Promise<boolean>;
  /** Said of a file that is none of these. */
  refused(words: string): void;
}

export class Drop {
  readonly element: HTMLDialogElement;
  private readonly question = h("h2", { id: "drop-title" });
  private readonly pattern: HTMLButtonElement;
  private file: File | null = null;

  constructor(private readonly events: DropEvents) {
    const choice = (name: CurveName | "pattern", text: string): HTMLButtonElement =>
      button({ label: text, text, class: "button primary", testid: `drop-as-${name}`, act: () => this.use(name) });
    this.pattern = choice("pattern", "A crease pattern");
    this.element = h(
      "dialog",
      { class: "dialog drop-choice", "aria-labelledby": "drop-title", "data-testid": "drop-choice" },
      this.question,
      h(
        "div",
        { class: "actions" },
        choice("f", "f, the profile"),
        choice("g", "g, the path"),
        this.pattern,
        button({ label: "Cancel", text: "Cancel", act: () => this.element.close() }),
      ),
    );
    this.listen();
  }

  private listen(): void {
    const { classList } = document.documentElement;
    let inside = 0;
    document.addEventListener("dragenter", (event) => {
      if (holdsFiles(event) && ++inside === 1) classList.add("dropping-file");
    });
    document.addEventListener("dragleave", (event) => {
      if (holdsFiles(event) && --inside <= 0) classList.remove("dropping-file");
    });
    document.addEventListener("dragover", (event) => {
      if (holdsFiles(event)) event.preventDefault();
    });
    // Before a curve's plane takes the file.
    document.addEventListener("drop", () => {
      inside = 0;
      classList.remove("dropping-file");
    }, { capture: true });
    document.addEventListener("drop", (event) => {
      const file = event.dataTransfer?.files[0];
      if (!file) return;
      event.preventDefault();
      void this.take(file);
    });
  }

  private async take(file: File): Promise<void> {
    if (/\.toml$/i.test(file.name)) return this.events.design(file);
    if (MESH.test(file.name)) return this.events.surface(file);
    if (PATTERN.test(file.name)) return this.events.pattern(file);
    if (!DRAWING.test(file.name)) {
      return this.events.refused(`${file.name} is no design file (TOML), drawing (CSV, SVG, DXF), crease pattern (FOLD) or mesh (OBJ, STL, PLY, glTF)`);
    }
    // Red, blue and black lines are no curve.
    if (EITHER.test(file.name) && (await this.events.looksLikePattern(file))) return this.events.pattern(file);
    this.file = file;
    this.question.textContent = `What is ${file.name}?`;
    this.pattern.hidden = !EITHER.test(file.name);
    if (!this.element.open) this.element.showModal();
  }

  private use(name: CurveName | "pattern"): void {
    this.element.close();
    const { file, events } = this;
    this.file = null;
    if (!file) return;
    if (name === "pattern") events.pattern(file);
    else events.curve(name, file);
  }
}

function holdsFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}
