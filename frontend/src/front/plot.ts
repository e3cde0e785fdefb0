// The plot of two objectives: points of the front are chosen in it, by pointer or by keys.

import type { FrontPage } from "../shared/api-types.ts";
import { Chooser, type Point } from "../shared/chooser.ts";
import { axisAcross, axisUp, type Scale } from "../shared/plot.ts";
import { svg } from "../shared/svg.ts";
import { scaleOf } from "./scales.ts";
import { written } from "../shared/written.ts";
import { nameOf } from "./words.ts";

const LEFT = 58;
const RIGHT = 16;
const TOP = 20;
const BOTTOM = 46;
/** Of one objective alone there is but a line. */
const LINE = 110;

export class Plot {
  readonly element = svg("svg", { class: "front-plot" });
  /** Members are chosen, or with shift compared. */
  onPick: (number: number, compared: boolean) => void = () => {};
  /** Designs that lie outside. */
  outside = 0;
  private readonly back = svg("g", { "aria-hidden": "true" });
  private readonly chooser: Chooser;
  private readonly objectives: number;

  constructor(private readonly page: FrontPage, private pair: [number, number]) {
    this.objectives = page.figures.filter(({ minimised }) => minimised).length;
    this.chooser = new Chooser(this.element, "Designs that no other beats", {
      walked: (number) => this.onPick(number, false),
      picked: (number, compared) => this.onPick(number, compared),
    });
    this.element.append(this.back, this.chooser.element);
  }

  show(pair: [number, number]): void {
    this.pair = pair;
    this.draw();
  }

  mark(chosen: number, pinned: number | null): void {
    this.chooser.mark(chosen, chosen, pinned ?? undefined);
  }

  draw(): void {
    const width = this.element.parentElement!.clientWidth;
    if (!width) return;
    const height = this.objectives > 1 ? Math.round(Math.min(430, Math.max(250, 0.68 * width))) : LINE;
    for (const [name, value] of Object.entries({ width, height, viewBox: `0 0 ${width} ${height}` })) {
      this.element.setAttribute(name, String(value));
    }
    const { members, beaten, baseline: begun, knee } = this.page;
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
    const places = front.map(place);

    const dots = within.map((point) => `M${place(point).map((each) => each.toFixed(1)).join(" ")}h0`).join("");
    const drawn: SVGElement[] = [...this.axes(x, y, width, height), svg("path", { class: "beaten", d: dots })];
    if (this.objectives === 2) drawn.push(svg("polyline", { class: "line", points: places.map(String).join(" ") }));
    for (const [u, v] of start.map(place)) drawn.push(svg("path", { class: "begun", d: square(u, v) }));
    this.back.replaceChildren(...drawn);
    this.chooser.draw(places.map((at, number) => ({ at, label: this.label(number) })), knee);
  }

  private label(number: number): string {
    const { members, figures } = this.page;
    const member = members[number]!;
    const said = figures.slice(0, this.objectives).map(({ name }, k) => `${name} ${written(member.figures[k])}`);
    return [nameOf(member.file), ...said].join(", ");
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
