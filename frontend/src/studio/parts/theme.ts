// Light or dark: the system's wish until the user says otherwise.

import { Signal } from "../state/signal.ts";

export type Theme = "light" | "dark";
const KEY = "orishell-theme";

export const theme = new Signal<Theme>(stored() ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));

theme.bind((value) => {
  document.documentElement.dataset["theme"] = value;
  announceTheme();
});

/** Make the drawings read the page's colours again. */
export function announceTheme(): void {
  document.dispatchEvent(new CustomEvent("themechange", { detail: theme.value }));
}

export function toggleTheme(): void {
  theme.set(theme.value === "dark" ? "light" : "dark");
  try {
    localStorage.setItem(KEY, theme.value);
  } catch {
    // A browser that keeps nothing: the choice lasts as long as the page.
  }
}

function stored(): Theme | null {
  try {
    const value = localStorage.getItem(KEY);
    return value === "light" || value === "dark" ? value : null;
  } catch {
    return null;
  }
}
