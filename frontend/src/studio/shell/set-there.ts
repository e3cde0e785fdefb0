// What may be set where one points, and the way to its control.

import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";

/** Controls by what is chosen. */
const CONTROLS = {
  panel: [["Thickness", "panel-thickness"], ["Thickness under loads", "structure-thickness"], ["Material", "structure-material"]],
  flap: [["Flaps", "param-flap"], ["Thickness", "panel-thickness"], ["Material", "structure-material"]],
  crease: [["Hinges", "structure-creases"], ["Gap", "panel-gap"], ["Thickness", "panel-thickness"]],
  foot: [["Supports", "structure-kind-pinned"], ["Ballast", "structure-ballast"], ["Base rail", "structure-rail"], ["Loads", "structure-material"]],
} as const;

/** Buttons that go to the controls that there are now. */
export function setThere(what: keyof typeof CONTROLS): HTMLElement[] {
  const there = CONTROLS[what].flatMap(([name, testid]) => {
    const control = document.querySelector<HTMLElement>(`.inputs [data-testid="${testid}"]`);
    return control && !control.closest("[hidden]") ? [button({ label: `Set: ${name}`, text: name, testid: `set-${testid}`, act: () => goTo(control) })] : [];
  });
  return there.length ? [h("div", { class: "inspect-set", role: "group", "aria-label": "Set here" }, ...there)] : [];
}

function goTo(control: HTMLElement): void {
  for (let at = control.closest("details"); at; at = at.parentElement?.closest("details") ?? null) at.open = true;
  control.scrollIntoView({ block: "center" });
  control.focus({ preventScroll: true });
}
