// The shell in space: orbit, fold, colours, overlays, hover. Drawn only when something changed.

import { Group, type PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { extentOf, goodDirection, type Extent } from "./camera.ts";
import { Clipped3D } from "./clipped3d.ts";
import { largest, themeOf, type Colouring } from "./colours.ts";
import { length } from "./quantities.ts";
import { Eye, type Sight } from "./eye.ts";
import { renderLegend, type Mark } from "./legend.ts";
import { Loaded3D, type Drawn, type Shown } from "./loaded3d.ts";
import { Look } from "./look.ts";
import type { Guest } from "./marks3d.ts";
import { Overlays, type Overlay } from "./overlays.ts";
import { Pace, type Quality } from "./pace.ts";
import { Pointing } from "./pointing.ts";
import { Sheet3D } from "./sheet3d.ts";
import { contactOf, stopsOf, targetShare } from "./stops.ts";
import { groundOf, type Ground } from "./ground.ts";
import type { Uniforms } from "./parts.ts";
import type { Motion } from "./rigid.ts";
import { shareTouch } from "./touch.ts";
import { Sun } from "./sun.ts";
import { assignmentCounts, targetPoints, type Lattice, type View } from "./view.ts";

export type { Colouring, Overlay, Sight };

/** Drives nearer than this are the same (degrees), and so are shares. */
const SAME = 1e-4;
const SAME_SHARE = 1e-6;
/** Of more panels every k-th is asked how far the shell reaches. */
const ASKED = 5000;

export class Shell3D {
  onHover: ((panel: number | null) => void) | null = null;
  /** Told when the camera has moved. */
  onSight: (() => void) | null = null;
  /** Another load case is shown, or none. */
  onLoaded: (() => void) | null = null;
  /** Told when a frame was drawn. */
  readonly onFrame = new Set<() => void>();

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  readonly eye: Eye;
  private readonly legend: HTMLElement;
  private readonly scale: HTMLElement;
  private readonly observer: ResizeObserver;
  private readonly look = new Look();
  private readonly sun = new Sun();
  private readonly u = {
    ...this.sun.uniforms,
    ...this.look.uniforms,
    screen: { value: new Vector2(1, 1) },
    density: { value: 1 },
    near: { value: 0.1 },
  };
  private readonly sheet = new Sheet3D(this.u);
  private readonly clipped = new Clipped3D(this.u);
  /** The shell without loads; hidden while it is shown with them. */
  private readonly unloaded = new Group();
  private readonly loaded = new Loaded3D(this.u);
  private readonly overlays: Overlays;
  private readonly pace: Pace;
  private readonly guests: Guest[] = [];
  /** Guests that are to be posed anew, though the shell is not. */
  private readonly moved = new Set<Guest>();
  private readonly beside = new Group();
  /** What is drawn with loads and without. */
  private readonly around = new Group();
  private ground: Ground | null = null;

  private view: View | null = null;
  private extent: Extent | null = null;
  private origin = new Vector3();
  private share = 0;
  /** Share of the state that is the shell as it stands. */
  private target = 1;
  private readonly marks = new Set<Mark>();
  private contact: { panels: [number, number]; drive: number } | null = null;
  private distances: Float32Array | null = null;
  private readonly pointing: Pointing;
  private request = 0;
  private quality: Quality = { density: 1, taps: 12 };
  /** The poses are those of `share`; the card has them; so has the shadow. */
  private posed = false;
  private sent = false;
  private shaded = false;

  constructor(private readonly container: HTMLElement, options: { label?: string } = {}) {
    container.classList.add("orishell-scene");
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "high-performance" });
    this.renderer.autoClear = false;
    const canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", `${options.label ?? "Shell in space"}. Arrow keys turn it, plus and minus zoom, 0 fits it into view.`);
    container.append(canvas);
    this.legend = overlay(container, "orishell-legend");
    this.scale = overlay(container, "orishell-scale");

    this.eye = new Eye(canvas, () => {
      this.invalidate();
      this.onSight?.();
    });
    shareTouch(canvas, (x, y) => this.under(x, y) !== null);

    this.unloaded.add(...this.sheet.drawn, this.clipped.solids, this.beside);
    this.scene.add(this.unloaded, this.loaded.drawn, this.around);
    for (const depth of [this.sheet.depth, this.clipped.depths]) this.sun.add(depth);
    this.overlays = new Overlays(this.scene, this.u);
    this.pace = new Pace((quality) => this.setQuality(quality), () => this.draw());

    this.pointing = new Pointing(canvas, this.invalidate, () => this.hover(null));
    canvas.addEventListener("dblclick", () => this.fit());
    canvas.addEventListener("keydown", this.onKey);
    canvas.addEventListener("webglcontextrestored", this.onRestored);
    document.addEventListener("themechange", this.onTheme);
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.onTheme();
    this.resize();
  }

  get fold(): number {
    return this.share;
  }

  /** Drive of the state drawn, in degrees where states have drives. */
  get drive(): number {
    return this.sheet.motion?.driveAt(this.share) ?? 0;
  }

  /** The load case that is shown, and where it is worst. */
  get load(): Drawn | null {
    return this.loaded.shown;
  }

  /** The state drawn is the shell as it stands. */
  get atTarget(): boolean {
    return Math.abs(this.share - this.target) < SAME_SHARE;
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get camera(): PerspectiveCamera {
    return this.eye.camera;
  }

  get sight(): Sight {
    return this.eye.sight;
  }

  /** Two shells seen with the same sight are seen at the same scale. */
  set sight(sight: Sight) {
    this.eye.sight = sight;
    this.invalidate();
  }

  /** What drawings in the same space share. */
  get uniforms(): Uniforms {
    return this.u;
  }

  /** The motion, posed as it is drawn. */
  get motion(): Motion | null {
    this.pose();
    return this.sheet.motion;
  }

  /** Draw something else as well; it may ask for another frame. */
  add(guest: Guest): () => void {
    this.guests.push(guest);
    (guest.withLoads ? this.around : this.beside).add(...guest.drawn);
    guest.paint(themeOf(this.container));
    const again = (): void => {
      this.moved.add(guest);
      this.invalidate();
    };
    again();
    return again;
  }

  /** What lies under a place of the window: the panel and the point on it, about the origin. */
  under(x: number, y: number): { panel: number; point: Vector3 } | null {
    const { origin: o, direction: d } = this.eye.ray(x, y);
    const { picking } = this.loaded;
    const hit = picking ? picking.hit(o, d) : this.motion?.hit(o.x, o.y, o.z, d.x, d.y, d.z);
    return hit ? { panel: hit.panel, point: o.clone().addScaledVector(d, hit.along) } : null;
  }

  /** Where a corner of the faces is drawn, displaced where a load case is shown. */
  corner(corner: number): Vector3 {
    const place = this.sheet.motion!.at(corner, new Vector3());
    return this.loaded.picking?.moved(corner >> 2, place) ?? place;
  }

  /** Where a point about the origin is in the window. */
  onScreen(point: Vector3): [number, number] {
    return this.eye.onScreen(point);
  }

  /** A small picture of the shell alone. */
  picture(width: number, height: number): HTMLCanvasElement {
    const small = Object.assign(document.createElement("canvas"), { width, height });
    this.beside.visible = this.around.visible = false;
    this.draw();
    this.beside.visible = this.around.visible = true;
    const { width: w, height: h } = this.canvas;
    const scale = Math.max(width / w, height / h);
    small.getContext("2d")?.drawImage(this.canvas, (width - w * scale) / 2, (height - h * scale) / 2, w * scale, h * scale);
    this.draw();
    return small;
  }

  /** Times between the latest frames of a motion (ms), for measuring. */
  get frameTimes(): readonly number[] {
    return this.pace.times;
  }

  show(view: View, keepCamera = false): void {
    this.view = view;
    this.target = targetShare(stopsOf(view));
    this.sheet.show(view);
    this.clipped.show(view.clipped);
    this.extent = extentOf(this.allPoints());
    this.overlays.show(view);
    this.loaded.show(view.loaded ?? null);
    this.setLoaded(null);
    this.setDistance(view.distance ?? null);
    const contact = contactOf(view);
    this.setContact(contact && contact.panels, contact?.drive_deg);
    const origin = new Vector3(...view.header.origin);
    const shift = this.origin.clone().sub(origin);
    this.origin = origin;
    this.sun.place(this.extent);
    this.scale.textContent = `grid ${length(this.overlays.placeGround(this.extent, origin), view.header.unit)}`;
    this.ground = groundOf(view);
    for (const guest of this.guests) guest.show?.(view, this.sheet.motion!);
    this.posed = false;
    this.highlight(null);
    if (!keepCamera || !this.eye.fitted) this.fit(true);
    else if (this.eye.follow(shift, this.extent, () => this.seenPoints())) this.lookFrom(this.eye.arm);
    this.invalidate();
  }

  setFold(share: number): void {
    if (!Number.isFinite(share)) return;
    this.share = Math.min(1, Math.max(0, share));
    this.posed = false;
    this.markContact();
    this.invalidate();
  }

  /** How much of what is put in at the target is there, from 0 to 1. */
  setPut(share: number): void {
    this.clipped.put = share;
    this.posed = false;
    this.invalidate();
  }

  setColouring(mode: Colouring): void {
    this.look.setColouring(mode, themeOf(this.container));
    this.explain();
    this.invalidate();
  }

  /** Signed distance of each vertex from the target; null if not known. */
  setDistance(values: Float32Array | null): void {
    this.distances = values;
    this.sheet.setValues(values);
    this.u.range.value = (values && largest(values)) || 1;
    this.explain();
    this.invalidate();
  }

  /** Panels that touch; marked from the drive on at which they do, at the target if none is given. */
  setContact(panels: [number, number] | null, driveDeg?: number): void {
    const drive = driveDeg ?? this.sheet.motion?.driveAt(this.target) ?? 0;
    this.contact = panels && { panels, drive };
    this.markContact();
    this.invalidate();
  }

  setOverlay(name: Overlay, visible: boolean): void {
    this.overlays.setVisible(name, visible);
    this.explainMark(name, visible);
    this.invalidate();
  }

  /** Draw another target, given in the world, until the next shell brings its own; its lowest point is
   * put where that of the present one is. */
  setSurface(surface: Lattice): void {
    const shift = this.origin.clone().negate();
    const level = this.view?.surface ? lowest(this.view.surface) : -this.origin.z;
    shift.z = level - lowest(surface);
    this.overlays.setSurface(surface, shift);
    this.invalidate();
  }

  /** Say in the legend what a mark's colour means, while it is seen. */
  explainMark(mark: Mark, seen: boolean): void {
    if (this.marks.has(mark) === seen) return;
    if (seen) this.marks.add(mark);
    else this.marks.delete(mark);
    this.explain();
  }

  /** Panels as the boards they are built of, where they have a thickness. */
  setThickness(visible: boolean): void {
    this.sheet.boards.setVisible(visible);
    this.clipped.setThickness(visible);
    this.invalidate();
  }

  /** Under a load case, which belongs to the target; null: without loads. */
  setLoaded(shown: Shown | null): void {
    this.loaded.set(shown);
    this.unloaded.visible = !this.loaded.shown;
    for (const guest of this.guests) if (guest.withLoads) this.moved.add(guest);
    this.onLoaded?.();
    this.hover(null);
    this.explain();
    this.invalidate();
  }

  highlight(panel: number | null): void {
    if ((panel ?? -1) === this.u.hovered.value) return;
    this.u.hovered.value = panel ?? -1;
    this.sheet.mark(this.look.marked);
    this.invalidate();
  }

  /** Show the state drawn, from where one looks, or from a good direction; and those to which it is
   * folded, until one comes nearer or goes elsewhere. */
  fit(turn = false): void {
    if (!this.view) return;
    const towards = turn ? goodDirection(targetPoints(this.view) ?? this.drawnPoints()) : this.eye.arm;
    this.eye.stopGliding();
    this.lookFrom(towards);
  }

  /** Bring all into view again, unless one has come nearer or gone elsewhere. */
  refit(): void {
    if (this.eye.turnedOnly) this.lookFrom(this.eye.arm);
  }

  maxPanelStrain(): number {
    this.pose();
    return this.sheet.motion?.maxStrain() ?? 0;
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.pace.stop();
    this.observer.disconnect();
    document.removeEventListener("themechange", this.onTheme);
    this.eye.dispose();
    this.sheet.dispose();
    this.clipped.dispose();
    this.loaded.dispose();
    this.overlays.dispose();
    for (const guest of this.guests) guest.dispose();
    this.sun.dispose();
    this.look.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.container.replaceChildren();
  }

  private allPoints(): Float32Array[] {
    if (this.view?.positions.length) return [this.view.positions, ...this.clipped.points];
    this.sheet.motion!.setFold(this.share);
    return [this.corners(), ...this.clipped.points];
  }

  /** What is to be in view: the state drawn, and what stands beside it. */
  private seenPoints(): Float32Array[] {
    const drawn = this.drawnPoints();
    return [drawn, ...(this.atTarget ? this.clipped.standing : []), ...this.guests.flatMap(({ reach }) => reach ?? [])];
  }

  private drawnPoints(): Float32Array {
    this.pose();
    return this.corners();
  }

  /** Corners of the panels in the state that was set last; of many panels, of every k-th. */
  private corners(): Float32Array {
    const motion = this.sheet.motion!;
    const every = Math.ceil(motion.panels / ASKED) || 1, count = Math.ceil(motion.panels / every);
    const points = new Float32Array(12 * count);
    for (let k = 0; k < count; k++) motion.place(k * every, points.subarray(12 * k, 12 * k + 12));
    return points;
  }

  /** All that is to be in view, seen from a direction. */
  private lookFrom(towards: Vector3): void {
    this.eye.look(this.seenPoints(), towards, this.extent!);
    this.invalidate();
  }

  private markContact(): void {
    const marked = this.contact !== null && this.drive >= this.contact.drive - SAME;
    this.explainMark("contact", marked);
    const [first, second] = marked ? this.contact!.panels : ([-1, -1] as const);
    if (this.u.touching.value.x === first && this.u.touching.value.y === second) return;
    this.u.touching.value.set(first, second);
    this.sheet.mark(this.look.marked);
  }

  private readonly onTheme = (): void => {
    const theme = themeOf(this.container);
    this.look.paint(theme);
    this.overlays.paint(theme);
    this.loaded.paint(theme);
    for (const guest of this.guests) guest.paint(theme);
    this.invalidate();
  };

  private explain(): void {
    if (!this.view) return;
    renderLegend(this.legend, {
      colouring: this.look.colouring,
      unit: this.view.header.unit,
      range: this.distances ? largest(this.distances) : 0,
      counts: assignmentCounts(this.view),
      loaded: this.loaded.shown,
      marks: this.marks,
    });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (!width || !height) return;
    this.eye.resize(width, height);
    this.setQuality(this.quality);
    if (this.view && !this.eye.fitted) this.fit(true);
    else this.refit();
    this.draw();
  }

  private setQuality(quality: Quality): void {
    this.quality = quality;
    const ratio = Math.min(2, window.devicePixelRatio || 1) * quality.density;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.container.clientWidth, this.container.clientHeight, false);
    this.renderer.getDrawingBufferSize(this.u.screen.value);
    this.u.density.value = ratio;
    this.u.shadowTaps.value = quality.taps;
  }

  private pose(): void {
    const { motion } = this.sheet;
    if (!motion || (this.posed && !this.moved.size)) return;
    if (!this.posed) motion.setFold(this.share);
    const { drive, atTarget } = this;
    const ground = this.ground?.levelAt(drive) ?? 0;
    for (const guest of this.posed ? this.moved : this.guests) guest.move?.(motion, { drive, atTarget, ground });
    this.moved.clear();
    if (this.posed) return;
    this.clipped.pose(this.share, drive, atTarget);
    this.overlays.setLevel(ground - 0.004 * this.extent!.radius);
    this.posed = true;
    this.sent = this.shaded = false;
  }

  private readonly invalidate = (): void => {
    this.request ||= requestAnimationFrame(this.frame);
  };

  private readonly frame = (now: number): void => {
    this.request = 0;
    this.pace.step(now);
    this.eye.update();
    this.pick();
    this.draw();
  };

  private draw(): void {
    if (!this.view) return;
    const { renderer, eye } = this;
    this.pose();
    if (!this.sent) {
      this.sheet.upload();
      this.refit();
    }
    this.sent = true;
    if (!this.shaded && this.quality.taps) {
      this.sun.draw(renderer);
      this.shaded = true;
    }
    const pixels = eye.prepare(this.extent!);
    this.u.near.value = eye.camera.near;
    this.sheet.setScale(pixels);
    this.clipped.setScale(pixels);
    renderer.clear();
    renderer.render(this.scene, eye.camera);
    for (const told of this.onFrame) told();
  }

  private pick(): void {
    const at = this.pointing.take();
    if (!at || this.loaded.shown) return;
    const { origin: o, direction: d } = this.eye.through(at);
    this.pose();
    const found = this.sheet.motion?.pick(o.x, o.y, o.z, d.x, d.y, d.z) ?? -1;
    this.hover(found < 0 ? null : found);
  }

  private hover(panel: number | null): void {
    if ((panel ?? -1) === this.u.hovered.value) return;
    this.highlight(panel);
    this.onHover?.(panel);
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "0" || event.key === "Home") this.fit();
    else if (!this.eye.key(event.key)) return;
    event.preventDefault();
    this.invalidate();
  };

  private readonly onRestored = (): void => {
    this.sent = this.shaded = false;
    this.invalidate();
  };
}

function lowest({ points }: Lattice): number {
  let found = Infinity;
  for (let k = 2; k < points.length; k += 3) found = Math.min(found, points[k]!);
  return found;
}

function overlay(container: HTMLElement, name: string): HTMLElement {
  const element = document.createElement("div");
  element.className = name;
  container.append(element);
  return element;
}
