// Light or dark: as the system has it, as JupyterLab has it, or as is chosen.

import { element } from "./elements.ts";

export class Theme {
  /** `host` bears the theme: the page's root, or the widget's. */
  constructor(private readonly host: HTMLElement) {
    const dark = matchMedia("(prefers-color-scheme: dark)");
    // JupyterLab has a theme of its own and says so.
    const lab = document.body.dataset["jpThemeLight"];
    this.set((lab === undefined ? dark.matches : lab === "false") ? "dark" : "light");
    dark.addEventListener("change", () => this.set(dark.matches ? "dark" : "light"));
  }

  button(): HTMLElement {
    const button = element("button", "theme", { type: "button", "aria-label": "Light or dark", title: "Light or dark" });
    button.addEventListener("click", () => this.set(this.host.dataset["theme"] === "dark" ? "light" : "dark"));
    return button;
  }

  set(theme: "light" | "dark"): void {
    this.host.dataset["theme"] = theme;
    document.dispatchEvent(new CustomEvent("themechange"));
  }
}
