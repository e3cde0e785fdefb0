// The card of a panel or crease: briefly while one points at it, whole when it is chosen.

import { area, length, threeDigits } from "../../shared/quantities.ts";
import { edgeLength, foldAngle, isFlap, sectorAngles, sheetOf, SIDES } from "../../shared/inspect.ts";
import { stressOf, worstUsed } from "../../shared/loaded.ts";
import type { Shell3D } from "../../shared/shell3d.ts";
import { contactOf } from "../../shared/stops.ts";
import { Assignment, type Loaded, panelName, type View } from "../../shared/view.ts";
import { button } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { type Chosen, feetIn, type Selection } from "./selection.ts";
import { setThere } from "./set-there.ts";
import type { Signal } from "../state/signal.ts";
import type { Store } from "../state/store.ts";

const KINDS: Record<number, string> = {
  [Assignment.border]: "Edge of the sheet",
  [Assignment.mountain]: "Mountain crease",
  [Assignment.valley]: "Valley crease",
  [Assignment.unfolded]: "Unfolded crease",
  [Assignment.cut]: "Cut",
};

export class InspectCard {
  readonly element = h("section", { class: "inspect-card", "aria-label": "Panel or crease", "data-testid": "inspect-card", hidden: true });
  private readonly title = h("h3", { "aria-live": "polite" });
  private readonly close = button({ label: "Close the card", icon: "close", keys: "Escape", testid: "inspect-close", act: () => this.selection.chosen.set(null) });
  private readonly head = h("header", {}, this.title);
  private request = 0;
  private worst: { of: Loaded; used: ReturnType<typeof worstUsed> } | null = null;

  constructor(
    private readonly store: Store,
    private readonly selection: Selection,
    private readonly shell: Shell3D,
    share: Signal<number>,
  ) {
    this.element.append(this.head);
    const later = (): void => {
      this.request ||= requestAnimationFrame(() => {
        this.request = 0;
        this.draw();
      });
    };
    selection.chosen.watch(later);
    selection.pointed.watch(later);
    store.proof.watch(later);
    store.view.watch(later);
    shell.onLoaded = later;
    share.watch(() => {
      if (!this.element.hidden) later();
    });
  }

  private draw(): void {
    const view = this.store.view.value;
    const chosen = this.selection.chosen.value;
    const about = chosen ?? this.selection.pointed.value;
    this.element.hidden = !about || !view;
    this.element.dataset["whole"] = String(chosen !== null);
    if (!about || !view) return;
    const title = this.titleOf(view, about);
    const body = about.foot !== undefined ? this.foot(view, about.foot) : about.edge === null ? this.panel(view, about.panel, chosen !== null) : this.crease(view, about.edge);
    const kind = about.foot !== undefined ? "foot" : about.edge !== null ? "crease" : isFlap(view, about.panel) ? "flap" : "panel";
    if (this.title.textContent !== title) this.title.textContent = title;
    if (chosen === null) this.close.remove();
    else if (!this.close.isConnected) this.head.append(this.close);
    // The head stays: its button may have the focus.
    while (this.element.lastChild !== this.head) this.element.lastChild!.remove();
    this.element.append(
      ...notesOf(view, about).map((note) => h("p", { class: "inspect-note" }, note)),
      ...body,
      ...(chosen ? setThere(kind) : []),
    );
  }

  private titleOf(view: View, { panel, edge, foot }: Chosen): string {
    if (foot !== undefined) return `Foot ${feetIn(view)[foot]!.number}`;
    if (edge !== null) return KINDS[view.assignment[edge]!]!;
    const name = panelName(view, panel);
    return name[0]!.toUpperCase() + name.slice(1);
  }

  private panel(view: View, panel: number, whole: boolean): HTMLElement[] {
    const unit = view.header.unit;
    const sheet = sheetOf(view);
    const facts: [string, string][] = [["Area", area(sheet.areas[panel]!, unit)], ...this.used(view, panel)];
    if (!whole) return [list([...facts, ["Shortest side", length(sheet.shortest[panel]!, unit)]])];
    facts.push(["Corners", sectorAngles(view, panel).map(degrees).join("  ")]);
    const rows = SIDES.flatMap((side, k) =>
      (sheet.hinges.get(4 * panel + k) ?? [sheet.edges[4 * panel + k]!]).map((edge) =>
        h(
          "tr",
          {},
          h("th", { scope: "row" }, side),
          h("td", {}, edge < 0 ? "" : length(edgeLength(view, edge), unit)),
          ...this.angles(view, edge).map((text) => h("td", {}, text)),
        ),
      ),
    );
    const heads = ["Side", "Length", "Fold now", "At target"].map((text) => h("th", { scope: "col" }, text));
    return [list(facts), h("table", {}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows))];
  }

  /** How much of its strength the panel uses, and under which loads. */
  private used({ loaded }: View, panel: number): [string, string][] {
    if (!loaded) return [];
    if (this.worst?.of !== loaded) this.worst = { of: loaded, used: worstUsed(loaded) };
    const { used } = this.worst;
    const share = used?.shares[panel];
    const { load } = this.shell;
    const facts: [string, string][] = share ? [["Utilisation", `${threeDigits(100 * share)} %, under ${loaded.cases[used!.cases[panel]!]!.name}`]] : [];
    if (load?.deflection.balanced) facts.push([`Stress, ${load.deflection.name}`, `${threeDigits(stressOf(loaded, load.deflection.number, panel))} MPa`]);
    return facts;
  }

  /** What the ground has to bear there, of all load cases. */
  private foot(view: View, foot: number): HTMLElement[] {
    const { push, pull, sideways, ballast } = feetIn(view)[foot]!;
    if (push === null) return [list([["Bears", "not known without loads"]])];
    const newtons = (force: number | null): string => (force === null ? "not known" : force >= 1000 ? `${threeDigits(force / 1000)} kN` : `${threeDigits(force)} N`);
    const facts: [string, string][] = [["Down", newtons(push)], ["Up", newtons(pull)], ["Sideways", newtons(sideways)]];
    if (ballast) facts.push(["Ballast that holds it", `${threeDigits(ballast)} kg`]);
    return [list(facts)];
  }

  /** The largest force along a crease, of all load cases. */
  private borne({ loaded }: View, panels: readonly number[]): [string, string][] {
    const { creases } = loaded ?? {};
    if (!creases || panels.length < 2) return [];
    for (let k = 0; k < creases.forces.length; k++) {
      const beside = creases.panels.subarray(2 * k, 2 * k + 2);
      if (panels.every((panel) => beside.includes(panel)) && creases.what[k]) {
        return [["Bears", `${threeDigits(creases.forces[k]! / 1000)} kN/m ${creases.what[k]}, under ${creases.cases[k]}`]];
      }
    }
    return [];
  }

  private crease(view: View, edge: number): HTMLElement[] {
    const beside = [...sheetOf(view).beside.subarray(2 * edge, 2 * edge + 2)].filter((panel) => panel >= 0);
    const facts: [string, string][] = [
      [beside.length > 1 ? "Between" : "Of", beside.map((panel) => panelName(view, panel).replace("panel ", "")).join(" and ")],
      ["Length", length(edgeLength(view, edge), view.header.unit)],
    ];
    if (beside.length > 1) {
      const [now, target] = this.angles(view, edge);
      facts.push(["Fold now", now!], ["At target", target!], ...this.borne(view, beside));
    }
    return [list(facts)];
  }

  /** Fold angle of an edge now and at the target. */
  private angles(view: View, edge: number): [string, string] {
    const motion = this.shell.motion;
    const now = edge < 0 || !motion ? null : foldAngle(view, motion, edge);
    if (now === null) return ["edge", "\u2013"];
    const target = view.foldAngles[edge]!;
    return [degrees(now), Number.isNaN(target) ? "\u2013" : degrees(target)];
  }
}

/** What is remarkable about a panel. */
function notesOf(view: View, { panel, edge, foot }: Chosen): string[] {
  if (edge !== null || foot !== undefined) return [];
  const { smallest, largest } = sheetOf(view);
  const contact = contactOf(view);
  const notes = [isFlap(view, panel) && "flap", panel === smallest && "smallest panel", panel === largest && "largest panel"].filter((note) => note !== false);
  const other = contact?.panels.includes(panel) ? contact.panels.find((each) => each !== panel) : undefined;
  if (other !== undefined) notes.push(`touches ${panelName(view, other)} at ${threeDigits(contact!.drive_deg)}\u00b0`);
  return notes.length ? [notes.join(", ")] : [];
}

function list(facts: [string, string][]): HTMLElement {
  return h("dl", {}, ...facts.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
}

/** Of a fold: positive a valley. */
function degrees(angle: number): string {
  const text = angle.toFixed(1);
  return `${text === "-0.0" ? "0.0" : text.replace("-", "\u2212")}\u00b0`;
}
