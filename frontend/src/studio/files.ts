// Design files: open, save, examples.

import { formatDesign, parseDesign } from "./api.ts";
import { download, pickFile } from "./dom.ts";
import { faultOf } from "./faults.ts";
import type { Store } from "./store.ts";

export class Files {
  constructor(
    private readonly store: Store,
    /** Called before another design takes the place of the present one. */
    private readonly opening: () => void,
  ) {
    document.addEventListener("dragover", (event) => {
      if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
    });
    document.addEventListener("drop", (event) => {
      const file = event.dataTransfer?.files[0];
      if (!file) return;
      event.preventDefault();
      if (/\.toml$/i.test(file.name)) void this.read(file);
    });
  }

  async open(): Promise<void> {
    const file = await pickFile(".toml");
    if (file) await this.read(file);
  }

  async read(file: File): Promise<void> {
    await this.take(await file.text(), file.name.replace(/\.toml$/i, ""));
  }

  /** Take the text of a design file in place of the present design; undo brings that back. */
  async take(text: string, name: string): Promise<void> {
    await this.guarded(async () => {
      const design = await parseDesign(text);
      this.opening();
      this.store.name.set(name);
      this.store.change(design, `open ${name}`);
    });
  }

  async save(): Promise<void> {
    await this.guarded(async () => {
      const text = await formatDesign(this.store.design.value);
      download(new Blob([text], { type: "application/toml" }), `${this.store.name.value}.toml`);
    });
  }

  private async guarded(act: () => Promise<void>): Promise<void> {
    const { files } = this.store;
    files.set(files.value + 1);
    try {
      await act();
    } catch (error) {
      this.store.fault.set(faultOf(error));
    } finally {
      files.set(files.value - 1);
    }
  }
}
