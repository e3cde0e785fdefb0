// The plot of two objectives: points of the front are chosen in it, by pointer or by keys.

import type { FrontPage } from "../shared/api-types.ts";
import type { Point } from "../shared/chooser.ts";
import { Scatter } from "../shared/scatter.ts";
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
  /** Members are chosen, or with shift compared. */
  onPick: (number: number, compared: boolean) => void = () => {};
  /** Designs that lie outside. */
  outside = 0;
  private readonly scatter = new Scatter("Designs that no other beats", {
    walked: (number) => this.onPick(number, false),
    picked: (number, compared) => this.onPick(number, compared),
  });
  readonly element = this.scatter.element;
  private readonly objectives: number;

  constructor(private readonly page: FrontPage, private pair: [number, number]) {
    this.objectives = page.figures.filter(({ minimised }) => minimised).length;
    this.element.classList.add("front-plot");
  }

  show(pair: [number, number]): void {
    this.pair = pair;
    this.draw();
  }

  mark(chosen: number, pinned: number | null): void {
    this.scatter.chooser.mark(chosen, chosen, pinned ?? undefined);
  }

  draw(): void {
    const width = this.element.parentElement!.clientWidth;
    if (!width) return;
    const { page, pair, objectives } = this;
    const plane = objectives > 1;
    const height = plane ? Math.round(Math.min(430, Math.max(250, 0.68 * width))) : LINE;
    for (const [name, value] of Object.entries({ width, height, viewBox: `0 0 ${width} ${height}` })) {
      this.element.setAttribute(name, String(value));
    }
    const frame = { left: LEFT, right: width - RIGHT, top: TOP, bottom: height - BOTTOM };
    const at = (figures: number[]): Point => [figures[pair[0]]!, plane ? figures[pair[1]]! : 0];
    const front = page.members.map(({ figures }) => at(figures));
    const others = page.beaten.map(at), start = page.baseline ? [at(page.baseline)] : [];
    const scale = (axis: 0 | 1, from: number, to: number) => {
      const [one, seen, rest] = [front, start, others].map((points) => points.map((point) => point[axis])) as [number[], number[], number[]];
      return scaleOf(one, seen, rest, from, to);
    };
    const x = scale(0, frame.left, frame.right), y = scale(1, frame.bottom, frame.top);
    const dots = others.filter(([u, v]) => x.has(u) && y.has(v));
    this.outside = others.length - dots.length;
    this.scatter.marks.replaceChildren(...start.map(([u, v]) => svg("path", { class: "begun", d: square(x.at(u), y.at(v)) })));
    const name = (axis: 0 | 1): string => page.figures[pair[axis]]!.name;
    this.scatter.draw({
      frame,
      across: { scale: x, about: width / 80, name: name(0) },
      up: { scale: y, about: height / 45, name: plane ? name(1) : "" },
      written,
      dots,
      best: front.map((each, number) => ({ at: each, label: this.label(number) })),
      joined: objectives === 2,
      knee: page.knee,
    });
  }

  private label(number: number): string {
    const { members, figures } = this.page;
    const member = members[number]!;
    const said = figures.slice(0, this.objectives).map(({ name }, k) => `${name} ${written(member.figures[k])}`);
    return [nameOf(member.file), ...said].join(", ");
  }
}

export function square(x: number, y: number): string {
  return `M${x - 5} ${y - 5}h10v10h-10z`;
}
