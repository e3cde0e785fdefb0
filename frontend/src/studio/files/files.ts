// Design files: open, save, examples.

import { exportDesign, formatDesign, parseDesign } from "../server/api.ts";
import { download, pickFile } from "../parts/dom.ts";
import { ServerFault, faultOf, ownFault } from "../state/faults.ts";
import { brokenLink, designOf, fragmentOf, isLink } from "./link.ts";
import { settled } from "../state/sizing.ts";
import { ofFile } from "../state/stale.ts";
import { hasEnding } from "../parts/file-target.ts";
import type { Store } from "../state/store.ts";
import { tomlOf } from "./toml.ts";

export class Files {
  /** Whether the address holds the present design. */
  private linked = false;

  constructor(
    private readonly store: Store,
    /** Files of other kinds that open as a design, and what takes them. */
    private readonly patterns: { endings: string; read: (file: File) => void },
  ) {
    // A reload is to bring back what was made of the design of a link.
    store.steps.watch(() => this.linked && this.leaveLink());
  }

  async open(): Promise<void> {
    const { endings, read } = this.patterns;
    const file = await pickFile(`.toml,${endings}`);
    if (file && hasEnding(file, endings)) read(file);
    else if (file) await this.read(file);
  }

  async read(file: File): Promise<void> {
    await this.take(await file.text(), file.name.replace(/\.toml$/i, ""));
  }

  /** Take the text of a design file in place of the present design; undo brings that back. */
  async take(text: string, name: string): Promise<void> {
    await this.guarded(async () => {
      this.store.open({ name, design: await parseDesign(text) });
    });
  }

  async save(): Promise<void> {
    const { named } = this.store;
    await this.guarded(async () => {
      const text = await formatDesign(named.design).catch((error: unknown) => {
        // Work is saved without the server, too.
        if (faultOf(error).kind !== "network") throw error;
        return tomlOf(named.design);
      });
      download(new Blob([text], { type: "application/toml" }), `${named.name}.toml`);
      this.store.save(named);
    });
  }

  /** Hand over the shell in one file, which folds in any browser; nobody needs the studio for it. */
  async share(): Promise<void> {
    const { store } = this;
    if (store.freshness.value !== "current") return store.said.set("There is no shell to share yet");
    store.said.set("Writing the shell into one file\u2026");
    await this.guarded(async () => {
      const design = settled(store.info, store.design.value, store.report.value);
      const { name, blob } = await exportDesign(design, "html", "target", store.name.value).catch((error: unknown) => {
        store.said.set("");
        throw error;
      });
      const file = new File([blob], name, { type: "text/html" });
      // Phones hand it to a message; where that is not possible, or not wanted, it is a file.
      if (matchMedia("(pointer: coarse)").matches && navigator.canShare?.({ files: [file] })) {
        store.said.set("");
        await navigator.share({ files: [file], title: store.name.value }).catch(() => undefined);
        return;
      }
      download(blob, name);
      store.said.set(`${name}: the shell in one file, which folds in any browser`);
    });
  }

  /** Put a link that holds the design on the clipboard. */
  async link(): Promise<void> {
    await this.guarded(async () => {
      const fragment = await fragmentOf(this.store.named);
      if (!fragment) {
        throw new ServerFault(ownFault("input", "This design is too long for a link", "save it as a file"));
      }
      try {
        await navigator.clipboard.writeText(new URL(fragment, location.href).href);
        this.store.said.set("The link is on the clipboard");
      } catch {
        // Pages of other machines may not write there.
        history.replaceState(null, "", fragment);
        this.linked = true;
        this.store.said.set("The link is in the address bar");
      }
    });
  }

  /** Take the design that the address holds, if it holds one; undo brings the present one back.
   *
   * It is as it is in the link, so it is kept no sooner than it is changed. */
  async follow(): Promise<void> {
    if (!isLink(location.hash)) return;
    await this.guarded(async () => {
      try {
        const brought = await designOf(location.hash);
        if (!Object.hasOwn(this.store.info.families, brought.design.shell.family)) throw brokenLink();
        this.linked = false;
        this.store.open(brought, "the design of the link");
      } catch (error) {
        this.leaveLink();
        throw error;
      }
      this.linked = true;
      this.store.said.set("The design of the link; undo brings back the one before");
    });
  }

  private leaveLink(): void {
    this.linked = false;
    history.replaceState(null, "", location.pathname + location.search);
  }

  private async guarded(act: () => Promise<void>): Promise<void> {
    const { files } = this.store;
    files.set(files.value + 1);
    try {
      await act();
    } catch (error) {
      const fault = faultOf(error);
      // A server that answers again does mend that it did not.
      this.store.fault.set(fault.kind === "network" ? fault : ofFile(fault));
    } finally {
      files.set(files.value - 1);
    }
  }
}
