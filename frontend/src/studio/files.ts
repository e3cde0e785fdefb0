// Design files: open, save, examples.

import { formatDesign, parseDesign } from "./api.ts";
import { download, pickFile } from "./dom.ts";
import { ServerFault, faultOf, ownFault } from "./faults.ts";
import { fragmentOf } from "./link.ts";
import { ofFile } from "./stale.ts";
import type { Store } from "./store.ts";
import { tomlOf } from "./toml.ts";

export class Files {
  constructor(
    private readonly store: Store,
    /** Called before another design takes the place of the present one. */
    private readonly opening: () => void,
  ) {}

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
      this.store.saved.set(design);
      this.store.change(design, `open ${name}`);
    });
  }

  async save(): Promise<void> {
    const design = this.store.design.value;
    await this.guarded(async () => {
      const text = await formatDesign(design).catch((error: unknown) => {
        // Work is saved without the server, too.
        if (faultOf(error).kind !== "network") throw error;
        return tomlOf(design);
      });
      download(new Blob([text], { type: "application/toml" }), `${this.store.name.value}.toml`);
      this.store.saved.set(design);
    });
  }

  /** Put a link that holds the design on the clipboard. */
  async link(): Promise<void> {
    await this.guarded(async () => {
      const { name, design } = this.store;
      const fragment = await fragmentOf({ name: name.value, design: design.value });
      if (!fragment) {
        throw new ServerFault(ownFault("input", "This design is too long for a link", "save it as a file"));
      }
      await navigator.clipboard.writeText(new URL(fragment, location.href).href);
      this.store.said.set("The link is on the clipboard");
    });
  }

  private async guarded(act: () => Promise<void>): Promise<void> {
    const { files } = this.store;
    files.set(files.value + 1);
    try {
      await act();
    } catch (error) {
      this.store.fault.set(ofFile(faultOf(error)));
    } finally {
      files.set(files.value - 1);
    }
  }
}
