// Flat walls that close the ends of the shell once it stands, with or without a door: the tables [[end_wall]].

import type { KeyWords } from "../../shared/api-types.ts";
import { numberBox, setNumber } from "../parts/controls.ts";
import { h } from "../parts/dom.ts";
import { short } from "../parts/numbers.ts";
import type { Store } from "../state/store.ts";
import type { Design } from "../state/types.ts";
import { DOOR, type DoorSize, doorOf, type End, ENDS, usualDoor, walled, wallAt, withWall } from "./end-wall-table.ts";

const GAP = "auto";

export class EndWallControls {
  readonly element: HTMLElement;
  private readonly show: ((design: Design) => void)[] = [];
  private walls = 0;

  constructor(private readonly store: Store) {
    const { label } = store.info.tables["end_wall"]!;
    const title = "end-walls-title";
    const details = h("details", {}, h("summary", { "data-testid": "end-walls" }, h("h2", { id: title }, label)), ...ENDS.map((at) => this.wall(at)));
    this.element = h("section", { class: "end-walls folding", "aria-labelledby": title }, details);
    store.design.bind((design) => {
      const walls = design.end_wall?.length ?? 0;
      if (walls && !this.walls) details.open = true;
      this.walls = walls;
      for (const each of this.show) each(design);
    });
  }

  private wall(at: End): HTMLElement {
    const { keys } = this.store.info.tables["end_wall"]!;
    const door = this.store.info.tables["end_wall.door"]!.keys;
    const id = (key: string): string => `end-wall-${at}-${key}`;
    const { store } = this;
    const stands = check(id("wall"), (on) => this.put(at, on ? { at } : undefined));
    const gap = this.box(id("gap"), { min: 0, placeholder: GAP }, (size, gesture) => this.set(at, "gap", size, gesture));
    gap.addEventListener("change", () => gap.value === "" && this.set(at, "gap", null));
    const opens = check(id("door"), (on) => this.set(at, "door", on ? usualDoor(store.design.value) : null));
    const sizes = Object.fromEntries(
      DOOR.map((key) => [key, this.box(id(key), key === "offset" ? {} : { min: 0 }, (size, gesture) => this.setDoor(at, key, size, gesture))]),
    ) as Record<DoorSize, HTMLInputElement>;
    const units = [gap, ...Object.values(sizes)].map(() => h("span", { class: "unit" }));
    const frame = h("div", {}, ...DOOR.map((key, k) => row(id(key), door[key]!, sizes[key], units[k + 1]!)));
    const rest = h("div", { class: "parameter-part" }, row(id("gap"), keys["gap"]!, gap, units[0]!), row(id("door"), keys["door"]!, opens), frame);
    this.show.push((design) => {
      const wall = wallAt(design, at), opening = doorOf(wall);
      stands.checked = wall !== undefined;
      rest.hidden = !wall;
      opens.checked = opening !== undefined;
      frame.hidden = !opening;
      setNumber(gap, typeof wall?.["gap"] === "number" ? short(wall["gap"], 8) : "");
      for (const key of DOOR) setNumber(sizes[key], short(Number(opening?.[key] ?? 0), 8));
      for (const each of units) each.textContent = design.shell.unit;
    });
    const { help, choices } = keys["at"]!;
    return h("div", { class: "parameter-list" }, row(id("wall"), { ...keys["at"]!, label: choices[at]!, help }, stands), rest);
  }

  private put(at: End, wall: Parameters<typeof withWall>[2], gesture = ""): void {
    const { store } = this;
    store.set({ end_wall: withWall(store.design.value, at, wall) }, "end walls", gesture);
  }

  private set(at: End, key: string, value: unknown, gesture = ""): void {
    this.put(at, walled(wallAt(this.store.design.value, at), at, key, value), gesture);
  }

  private setDoor(at: End, key: DoorSize, size: number, gesture: string): void {
    const before = doorOf(wallAt(this.store.design.value, at));
    // An opening has a width and a height.
    if (before && (size > 0 || key === "offset")) this.set(at, "door", { ...before, [key]: size }, gesture);
  }

  private box(id: string, limits: Record<string, string | number>, set: (size: number, gesture: string) => void): HTMLInputElement {
    return numberBox({ ...limits, step: "any", id, "data-testid": id }, (size) => set(size, `type-${id}`));
  }
}

function check(id: string, act: (on: boolean) => void): HTMLInputElement {
  const input: HTMLInputElement = h("input", { type: "checkbox", id, "data-testid": id, onchange: () => act(input.checked) });
  return input;
}

function row(id: string, { label, help }: KeyWords, ...controls: HTMLElement[]): HTMLElement {
  return h("div", { class: "parameter-head", title: help }, h("label", { for: id }, label), ...controls);
}
