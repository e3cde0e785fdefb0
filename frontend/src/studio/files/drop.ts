// Files that are dropped onto the page: a design file opens, a mesh becomes the surface, a drawing f or g, as asked.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import type { CurveName } from "../state/types.ts";

const MESH = /\.(obj|stl|ply|glb|gltf)$/i;
const DRAWING = /\.(csv|txt|svg|dxf)$/i;

export interface DropEvents {
  design(file: File): void;
  curve(name: CurveName, file: File): void;
  surface(file: File): void;
  /** Said of a file that is none of these. */
  refused(words: string): void;
}

export class Drop {
  readonly element: HTMLDialogElement;
  private readonly question = h("h2", { id: "drop-title" });
  private file: File | null = null;

  constructor(private readonly events: DropEvents) {
    const choice = (name: CurveName, text: string): HTMLButtonElement =>
      button({ label: text, text, class: "button primary", testid: `drop-as-${name}`, act: () => this.use(name) });
    this.element = h(
      "dialog",
      { class: "dialog drop-choice", "aria-labelledby": "drop-title", "data-testid": "drop-choice" },
      this.question,
      h(
        "div",
        { class: "actions" },
        choice("f", "As f, the profile"),
        choice("g", "As g, the path"),
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
      this.take(file);
    });
  }

  private take(file: File): void {
    if (/\.toml$/i.test(file.name)) return this.events.design(file);
    if (MESH.test(file.name)) return this.events.surface(file);
    if (!DRAWING.test(file.name)) {
      return this.events.refused(`${file.name} is no design file (TOML), drawing (CSV, SVG, DXF) or mesh (OBJ, STL, PLY, glTF)`);
    }
    this.file = file;
    this.question.textContent = `Which curve is ${file.name}?`;
    if (!this.element.open) this.element.showModal();
  }

  private use(name: CurveName): void {
    this.element.close();
    if (this.file) this.events.curve(name, this.file);
    this.file = null;
  }
}

function holdsFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}
