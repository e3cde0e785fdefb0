// The plot of two objectives: points of the front are chosen in it, by pointer or by keys.

import type { FrontPage } from "../shared/api-types.ts";
import { axisAcross, axisUp, type Scale } from "../shared/plot.ts";
import { svg } from "../shared/svg.ts";
import { next, scaleOf, taken, type Point } from "./scales.ts";
import { nameOf, written } from "./words.ts";

const LEFT = 58;
const RIGHT = 16;
const TOP = 20;
const BOTTOM = 46;
/** Of one objective alone there is but a line. */
const LINE = 110;
const REACH = 28;

export class Plot {
  readonly element = svg("svg", { class: "front-plot" });
  /** Members are chosen, or with shift compared. */
  onPick: (number: number, compared: boolean) => void = () => {};
  /** Designs that lie outside. */
  outside = 0;
  private readonly points = svg("g", { role: "listbox", "aria-label": "Designs that no other beats", "aria-orientation": "horizontal" });
  private places: Point[] = [];
  private chosen = 0;
  private pinned: number | null = null;
  private readonly objectives: number;

  constructor(private readonly page: FrontPage, private pair: [number, number]) {
    this.objectives = page.figures.filter(({ minimised }) => minimised).length;
    this.element.addEventListener("click", (event) => this.click(event));
    this.points.addEventListener("keydown", (event) => this.key(event));
  }

  show(pair: [number, number]): void {
    this.pair = pair;
    this.draw();
  }

  mark(chosen: number, pinned: number | null): void {
    [this.chosen, this.pinned] = [chosen, pinned];
    [...this.points.children].forEach((point, number) => {
      point.setAttribute("aria-selected", String(number === chosen));
      point.setAttribute("tabindex", number === chosen ? "0" : "-1");
      point.setAttribute("aria-label", this.label(number));
      point.classList.toggle("pinned", number === pinned);
    });
  }

  draw(): void {
    const width = this.element.parentElement!.clientWidth;
    if (!width) return;
    const height = this.objectives > 1 ? Math.round(Math.min(430, Math.max(250, 0.68 * width))) : LINE;
    const focused = this.points.contains(document.activeElement);
    for (const [name, value] of Object.entries({ width, height, viewBox: `0 0 ${width} ${height}` })) {
      this.element.setAttribute(name, String(value));
    }
    const { members, beaten, begun_with: begun, knee } = this.page;
    const at = (figures: number[]): Point => [figures[this.pair[0]]!, this.objectives > 1 ? figures[this.pair[1]]! : 0];
    const front = members.map(({ figures }) => at(figures));
    const others = beaten.map(at), start = begun ? [at(begun)] : [];
    const [x, y] = ([0, 1] as const).map((axis) => {
      const [one, seen, rest] = [front, start, others].map((points) => points.map((point) => point[axis])) as [number[], number[], number[]];
      return axis ? scaleOf(one, seen, rest, height - BOTTOM, TOP) : scaleOf(one, seen, rest, LEFT, width - RIGHT);
    }) as [Scale, Scale];
    const place = ([u, v]: Point): Point => [x.at(u), y.at(v)];
    const within = others.filter(([u, v]) => x.has(u) && y.has(v));
    this.outside = others.length - within.length;
    this.places = front.map(place);

    const dots = within.map((point) => `M${place(point).map((each) => each.toFixed(1)).join(" ")}h0`).join("");
    const drawn: SVGElement[] = [...this.axes(x, y, width, height), svg("path", { class: "beaten", d: dots })];
    if (this.objectives === 2) drawn.push(svg("polyline", { class: "line", points: this.places.map(String).join(" ") }));
    for (const [u, v] of start.map(place)) drawn.push(svg("path", { class: "begun", d: square(u, v) }));
    const back = svg("g", { "aria-hidden": "true" });
    back.append(...drawn);
    this.points.replaceChildren(...this.places.map(([u, v], number) => {
      const point = svg("g", { role: "option", class: number === knee ? "point knee" : "point" });
      point.append(
        svg("circle", { class: "ring", cx: u, cy: v, r: 10 }),
        number === knee ? svg("path", { class: "dot", d: diamond(u, v) }) : svg("circle", { class: "dot", cx: u, cy: v, r: 5 }),
      );
      point.append(svg("title", {}, this.label(number)));
      return point;
    }));
    const [u, v] = this.places[knee]!;
    const name = svg("text", { class: "knee-name", x: u, y: v - 16, "text-anchor": "middle", "aria-hidden": "true" }, "knee");
    this.element.replaceChildren(back, this.points, name);
    this.mark(this.chosen, this.pinned);
    if (focused) this.focus();
  }

  focus(): void {
    (this.points.children[this.chosen] as SVGElement | undefined)?.focus();
  }

  private label(number: number): string {
    const { members, figures, knee } = this.page;
    const member = members[number]!;
    const said = figures.slice(0, this.objectives).map(({ name }, k) => `${name} ${written(member.figures[k])}`);
    const marks = [number === knee ? "the knee" : "", number === this.pinned ? "compared with" : ""].filter(Boolean);
    return [nameOf(member.file), ...said, ...marks].join(", ");
  }

  private click(event: MouseEvent): void {
    const box = this.element.getBoundingClientRect();
    const before = event.shiftKey ? this.pinned ?? this.chosen : this.chosen;
    const number = taken(this.places, [event.clientX - box.left, event.clientY - box.top], REACH, before);
    if (number < 0) return;
    this.onPick(number, event.shiftKey);
    this.focus();
  }

  private key(event: KeyboardEvent): void {
    // The picture's y axis points up, as its values do.
    const values = this.page.members.map(({ figures }): Point => [figures[this.pair[0]]!, figures[this.pair[1]]!]);
    const last = values.length - 1;
    const to = {
      ArrowRight: () => next(values, this.chosen, 0, true),
      ArrowLeft: () => next(values, this.chosen, 0, false),
      ArrowUp: () => next(values, this.chosen, 1, true),
      ArrowDown: () => next(values, this.chosen, 1, false),
      Home: () => 0,
      End: () => last,
    }[event.key];
    if (!to) return;
    event.preventDefault();
    this.onPick(to(), false);
    this.focus();
  }

  private axes(x: Scale, y: Scale, width: number, height: number): SVGElement[] {
    const frame = { left: LEFT, right: width - RIGHT, top: TOP, bottom: height - BOTTOM };
    const axis = (scale: Scale, about: number, number: 0 | 1) => ({
      ticks: scale.ticks(about), at: (value: number) => scale.at(value), written, name: this.page.figures[this.pair[number]]!.name,
    });
    const across = axisAcross(frame, axis(x, width / 80, 0));
    return this.objectives < 2 ? across : [...across, ...axisUp(frame, axis(y, height / 45, 1))];
  }
}

export function square(x: number, y: number): string {
  return `M${x - 5} ${y - 5}h10v10h-10z`;
}

export function diamond(x: number, y: number): string {
  return `M${x} ${y - 8}l8 8l-8 8l-8 -8z`;
}
