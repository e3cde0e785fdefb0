// What the server sends and pages have in them, from orishell.studio.api and orishell.studio.info,
// orishell.io.view, orishell.search.page and orishell.search.variants. Do not edit:
// ORISHELL_WRITE_GOLDEN=1 python -m pytest tests/studio/test_api.py writes it anew.

/** The share of the work that is done, from 0 to 1, and what the work is. */
export interface Advance {
  progress: number;
  what: string;
}

/** Air in what the sheet carries, on the way between where that is joined and the pack. */
export interface Air {
  drives_deg: number[];
  /** What it holds there (cubic metres). */
  volumes: number[];
  /** The pressure that balances own weight there (Pa), negative where the shell goes on by itself; None where volume does not change, or the mass is not known. */
  pressures: (number | null)[];
  /** What it holds at the target (cubic metres). */
  at_target: number;
  /** Where they hold most, and air comes to rest. */
  rest_deg: number;
  /** As far as a fan lifts the shell from its pack, towards where air comes to rest; None if that is not known, or the shell is folded up from flat. */
  fan_to_deg: number | null;
}

/** The shell as a structure. */
export interface Analysis {
  /** Whether it carries all cases; None if that is not known. */
  carries: boolean | null;
  /** What is analysed. */
  model: Model;
  /** All load cases, those with the least stiffness of creases first. */
  cases: CaseResult[];
  /** What is nearest to the end of what it bears; None if that of nothing is known. */
  governs: Governing | null;
  /** What governs each limit state of a code; none if no code combines the cases. */
  envelopes: Envelope[];
  /** What every support asks of the ground, by all cases in equilibrium. */
  anchors: Anchor[];
  /** Sentences an engineer should read, beside what speaks against single cases. */
  warnings: string[];
  /** What codes ask of it, and is not done here. */
  code_asks: string[];
  /** What the analysis says nothing of. */
  not_covered: string[];
}

/** What a supported vertex asks of the ground, of all cases in equilibrium. */
export interface Anchor {
  /** The vertex. */
  at: [number, number];
  /** Down on the ground. */
  push: Worst;
  /** Up: what a peg has to hold. */
  pull: Worst;
  /** Along the ground: what a peg has to hold. */
  sideways: Worst;
  /** Weight at the foot that holds it without a peg. */
  ballast: Worst;
  /** The mass of the ballast (kg). */
  ballast_mass: number;
  /** Coefficient of friction under the ballast: that of the ground there, or else one that is assumed. */
  friction: number;
  /** Coefficient of friction under the ballast: that of the ground there, or else one that is assumed. */
  assumed: boolean;
  /** The ballast that holds it; 0 where none is given (kg). */
  given: number;
}

/** The surface that ever finer shells approach, where it is not f swept along g. */
export interface ApproachReport {
  /** What it is. */
  what: string;
  /** Distances of the shell from it; None if it has no simple form, or they were not measured. */
  max: number | null;
  /** Distances of the shell from it; None if it has no simple form, or they were not measured. */
  rms: number | null;
}

/** Files of several formats in one archive. */
export interface Archive {
  name: string;
  file: string;
  what: string;
  needs: "" | "thickness" | "loads";
  /** The keys of the table [workshop] that matter to it. */
  settings: string[];
}

/** Where an array of the view begins, in bytes behind the header. */
export interface ArrayPlace {
  type: "float32" | "uint32" | "uint8";
  shape: number[];
  offset: number;
}

/** How many creases are mountains and valleys, and whether they stay so. */
export interface AssignmentReport {
  /** Numbers of creases. */
  mountain: number;
  /** Numbers of creases. */
  valley: number;
  /** Numbers of creases. */
  unfolded: number;
  /** Whether no crease changes from one to the other in the whole motion; None if that was not measured. */
  constant: boolean | null;
  /** Whether Maekawa's condition holds at every inner vertex; None if that was not measured. */
  maekawa: boolean | null;
}

/** Something that is largest at a crease. */
export interface AtCrease {
  /** How large it is. */
  size: number;
  /** The two panels beside the crease. */
  panels: [[number, number], [number, number]];
}

/** Something that is largest along an edge of what stiffens a sheet. */
export interface AtEdge {
  /** How large it is. */
  size: number;
  /** A panel of a strip, "box 4 upper 3", or a plate: "gusset 5,3", "plate 4,3". */
  part: string;
  /** What is on the other side of the edge, "panel 3,3" or "the edge from 5,3 to 4,3". */
  beside: string;
}

/** Where the stress of a base rail is largest. */
export interface AtRail {
  /** How large it is. */
  size: number;
  /** The feet beside it. */
  between: [[number, number], [number, number]];
}

/** The foot that uses most of what ballast holds. */
export interface BallastedFoot {
  /** The vertex. */
  at: [number, number];
  /** How it would give way first. */
  kind: "lifts off" | "slips";
  /** By which it is pulled up, or pushed aside (N). */
  force: number;
  /** What holds against that (N). */
  holds: number;
  /** The share of that which is used; infinite if nothing holds. */
  used: number;
  /** The ballast there (kg). */
  mass: number;
  /** The ballast with which it would be held (kg). */
  needed: number;
  /** Gamma, in these. */
  factor: number;
}

/** Bars of one section that join neighbouring feet of a row, stiffly where they meet. */
export interface BaseRail {
  /** What they are made of, by its name in materials.toml. */
  material: string;
  /** Across, level (length). */
  width: number;
  /** (length). */
  height: number;
  /** Thickness of the walls of a hollow section; None if it is solid. */
  wall: number | null;
}

/** Number of boards by the face that they lie on. */
export interface BoardCount {
  /** Boards on the upper and on the lower face of the membrane. */
  top: number;
  /** Boards on the upper and on the lower face of the membrane. */
  bottom: number;
  /** Solid panels. */
  solid: number;
}

/** The booklet of a kit. */
export interface Booklet {
  pages: BookletPicture[];
}

/** A page of the booklet: what its first line says, and all of it. */
export interface BookletPicture {
  title: string;
  svg: string;
}

/** The last line of the answer: the booklet. */
export interface BookletResult {
  result: Booklet;
}

/** Bounding box of a state. */
export interface BoxReport {
  /** Along x, y and z. */
  width: number;
  /** Along x, y and z. */
  depth: number;
  /** Along x, y and z. */
  height: number;
}

/** The largest stress in box girders. */
export interface BoxStress {
  /** Von Mises' stress, averaged over a patch of a fixed share of a panel. */
  size: number;
  /** Which panel of which strip, "box 4 upper 3", or which plate across: "plate 4,3". */
  part: string;
}

/** A wall that closes an end, as it stands. */
export interface BuiltEndWall {
  /**  */
  at: "first" | "last";
  /** Strips, those over its door too. */
  panels: number;
  /** Along the ground (length). */
  width: number;
  /** Of its top over the ground (length). */
  height: number;
  /** Without its door. */
  area: number;
  /** From its inner face to what is nearest of the shell, square to it (length). */
  clearance: number;
  /** From its inner face to that vertex of the border that is farthest from it (length). */
  farthest: number;
  /** How many vertices it is tied to. */
  strings: number;
  /** The length of the shortest of them. */
  shortest_string: number;
  /** The length of the longest of them. */
  longest_string: number;
  /** The opening in it; None if there is none. */
  door: Opening | null;
}

/** How large a shell is, by the keys of the table [target.fit] (lengths). */
export interface BuiltSizes {
  outside: Record<string, number>;
  /** Clear width and depth, and headroom, 0 where there is none; null: it does not stand. */
  inside: Record<string, number> | null;
  /** Up to which width and depth are clear. */
  head_height: number;
}

/** A line of the answer: what was tried so far, and how each trial ended. */
export interface CarryFound {
  found: string[];
}

/** The last line of the answer: designs that carry, or what was tried in vain. */
export interface CarryResult {
  result: CarrySearch;
}

/** What was found: designs that carry, and what was tried in vain. */
export interface CarrySearch {
  /** Whether the file's own design carries; None if that is not known. */
  carries: boolean | null;
  /** What the file's own design does under its loads. */
  words: string;
  /** Designs that carry, the lightest first. */
  found: Carrying[];
  /** Every trial: what it adds to which, and how it ended. */
  tried: string[];
  /** What came nearest, and how that ended; empty if a design carries. */
  near: string;
  /** Whether more would have taken too long. */
  ended: boolean;
}

/** A design that carries all its cases, made and analysed as its file asks. */
export interface Carrying {
  /** What is changed. */
  words: string;
  /** Values by key of the design file; None removes a key. */
  changes: Record<string, unknown>;
  /** Of all that loads it with its own weight (kg); None where that is not known. */
  mass: number | null;
  /** On the site: pieces, what is clipped on, ties and locks. */
  parts: number;
  /** Sides of its pack (length); None without one. */
  pack: [number, number, number] | null;
  /** The share of what is borne that is used by what governs; None if nothing is known. */
  used: number | null;
  /** What governs, in words; empty if nothing does. */
  governs: string;
  /** What nothing but supports does, in words; empty if the shell locks by itself. */
  left: string;
}

/** A load case with one stiffness of creases. */
export interface CaseResult {
  /** The case. */
  name: string;
  /** What a code combines it for: "ULS" is judged by strength and buckling, "EQU" by equilibrium alone, "SLS" by displacements; None if no code does, then by all. */
  limit_state: "ULS" | "EQU" | "SLS" | null;
  /** Their stiffness. */
  creases: number | "free" | "rigid";
  /** Whether the shell carries these loads; None if that is not known. */
  carries: boolean | null;
  /** What speaks against it, the worst first. */
  findings: Finding[];
  /** What loads it, kind by kind. */
  loads: Load[];
  /** Sum of all loads. */
  load: [number, number, number];
  /** The foot that uses most of what its ballast holds, where equilibrium is judged. */
  ballast: BallastedFoot | null;
  /** What holds it; None if it moves. */
  equilibrium: Equilibrium | null;
}

/** Shares by which the figures of all cases change from the next coarser mesh. */
export interface Changes {
  /** The largest displacement. */
  displacement: number;
  /** The largest stress of panels. */
  stress: number;
  /** The buckling factor. */
  buckling: number;
}

/** The design with the fewest panels, and the others that were looked at. */
export interface Choice {
  /** Distance from the surface that was asked for (length). */
  tolerance: number;
  /**  */
  panel_min: number;
  /** The longest edge that was asked for; None if edges may have any length. */
  panel_max: number | null;
  /**  */
  least_share: number;
  /**  */
  steepest_chamfer_deg: number | null;
  /** Inner vertices. */
  rows: number;
  /** Inner vertices. */
  columns: number;
  /** Number of panels, flaps left out. */
  panels: number;
  /** Distance between shell and target surface, largest both ways (length). */
  error: number;
  /** Edges of its panels in the flat sheet (length). */
  shortest: number;
  /** Edges of its panels in the flat sheet (length). */
  longest: number;
  /** Number of designs measured. */
  designs_tried: number;
  /** Of all trials those that no other beats in both error and number of panels, by panels. */
  tradeoff: Trial[];
}

/** Distances between a curve and a polyline, in the unit of their coordinates. */
export interface Closeness {
  /** The Hausdorff distance: the largest distance of a point of either to the other. */
  max: number;
  /** Root mean square over the curve's length of the distance to the polyline. */
  rms: number;
}

/** Two panels that touch, or that are not proved apart. */
export interface Contact {
  /** The drive angle at which they do. */
  drive_deg: number;
  /** Up to here no panels touch, proved; 0 if the path was not examined. */
  clear_until_deg: number;
  /** The two panels; those of flaps that are clipped on are in the columns beside the sheet's, -1 the one on the left. */
  panels: [[number, number], [number, number]];
  /** Which parts of the sheet they belong to: two flaps of one column (neighbours of these at the end of the motion are what the design means), or of both; a flap on another panel; neighbours about a crease that is folded flat; a panel of the sheet's border on another; panels inside it; boards on panels. */
  kind: "flap on flap" | "opposite flaps" | "flap on panel" | "neighbours" | "at the sheet's edge" | "distant panels" | "boards";
  /** Depth of the corrugation there (length). */
  corrugation_depth: number;
  /** Which boards of the panels touch, "top", "bottom" or, where panels are solid, "panel"; arms of whole boards by their edge, "arm left"; "membrane" on a face without boards; None if panels without a thickness do. */
  sides: [string, string] | null;
  /** How far one reaches into the other, if they were looked at in one state only; None if they touch on the way (length). */
  overlap: number | null;
  /** How far they are apart, at least, if they are not seen to touch and are merely not proved apart; None if they touch (length). */
  apart: number | null;
  /** What the two are called, if one is no panel of the sheet. */
  called: [string, string] | null;
}

/** The largest forces per length along all creases of a kind, on either side of them. */
export interface CreaseForces {
  /** Which creases. */
  kind: "row" | "column";
  /** Square to the crease in the plane of a panel, out of it; 0 if all are pressed. */
  pull: AtCrease;
  /** The same into the panel. */
  push: AtCrease;
  /** Shear along the crease. */
  in_plane: AtCrease;
  /** Shear square to the plane of a panel. */
  across: AtCrease;
  /** Moment about the crease. */
  moment: AtCrease;
}

/** Length of all creases of a kind, in the document's unit. */
export interface CreaseLength {
  mountain: number;
  valley: number;
  unfolded: number;
}

/** The largest force along every crease of a loaded shell: which, and under which load case. */
export interface CreaseLoads {
  /** Empty where there is none. */
  what: string[];
  cases: string[];
}

/** The crease with the largest moment. */
export interface CreaseMoment {
  /** Per length. */
  moment: number;
  /** The two panels beside it. */
  panels: [[number, number], [number, number]];
}

/** The table of a target curve that was read from a file: a path, or points. */
export interface CurveFields {
  path?: string;
  points?: number[][];
  smooth?: boolean;
}

/** The target's curves. */
export interface Curves {
  f: [number, number][];
  g: [number, number][];
}

/** What follows if a shell is cut with errors: to first order, at its target. */
export interface CuttingReport {
  /** Whether boards are cut apart, or creases in one sheet. */
  cutting: "boards" | "sheet";
  /** Standard deviation of a corner along each axis (length). */
  error: number;
  /** By how much boards are too small all around (length). */
  bias: number;
  /** How far the two sides of a hinge are apart at its ends. */
  play: Scatter;
  /** The same if hinges slide along their axes: across and along these. */
  across: Scatter;
  /** The same if hinges slide along their axes: across and along these. */
  along: Scatter;
  /** How far corners of boards stand off their plane if hinges have no play across, and boards twist. */
  lift: Scatter;
  /** How far vertices are from their places; None if that is not small, or if it moves in more ways than one at the target. */
  shape: Scatter | null;
  /** Feet alone, or the first and the last row of a shell without. */
  ends: Scatter | null;
  /** Whether these are feet. */
  on_feet: boolean;
  /** Where its flaps stop it; None if it has none. */
  flaps: FlapStop | null;
}

/** How a shell is deployed, and what holds it at its target. */
export interface DeploymentReport {
  /** What it is folded up or opened from. */
  start: "flat" | "pack";
  /** Whether flaps are part of the folding sheet; None if there are none. */
  flap_attachment: "folded" | "clipped" | null;
  /** How far its hinges close. */
  largest_fold_deg: number;
  /** Thickness of its panels, 0 for none, and the largest with which set-backs take no more of any than they may; None if it is not limited. */
  thickness: number;
  /** Thickness of its panels, 0 for none, and the largest with which set-backs take no more of any than they may; None if it is not limited. */
  largest_thickness: number | null;
  /** As far as it closes, proved if its path was examined. */
  end_drive_deg: number;
  /** What keeps it from closing, and from opening, beyond its target; None if nothing does, or if it is not known to keep all motions of a sheet from it that has several. */
  closing: "flaps" | "clash" | "crease" | "hinges" | "boards" | "unproved" | "clipped flaps" | "gussets" | "plates" | null;
  /** What keeps it from closing, and from opening, beyond its target; None if nothing does, or if it is not known to keep all motions of a sheet from it that has several. */
  opening: "ties" | "gussets" | "plates" | null;
  /** How many gussets are clipped into its folds at the target, and plates into its box girders. */
  gussets: number;
  /** How many gussets are clipped into its folds at the target, and plates into its box girders. */
  plates: number;
  /** Whether any one of them alone, or all together, keep it from both, in all of its motions; None if that is not known. */
  fixed_by: "any" | "all" | null;
  /** The state that packs smallest, of the largest piece where there are pieces; None if that was not asked for. */
  packed: Pack | null;
  /** Of each piece, where there are pieces. */
  pieces: Pack[];
  /** Its ties. */
  ties: Tie[];
  /** What its own weight does; None if it does not stand, or that was not asked for. */
  weight: OwnWeight | null;
  /** Air in its box girders, or cells of its second skin; None if there are none, or that was not asked for. */
  air: Air | null;
  /** Its feet in plan, and the ground that it needs on its way; None likewise. */
  ground: GroundPlan | null;
  /** What it takes to raise it by hand; None likewise, or where it is opened in pieces. */
  raising: Raising | null;
}

/** Distances between a shell and a surface, both ways (length). */
export interface Deviation {
  /** The Hausdorff distance: the largest of both ways. */
  max: number;
  /** Root mean square, the larger of both ways. */
  rms: number;
  /** Mean, the larger of both ways. */
  mean: number;
  /** The distance below which 95 % of the area lies, the larger of both ways. */
  p95: number;
  /** By how much the largest distance may be off. */
  sample_spacing: number;
  /** From all points of the shell to the surface. */
  shell_to_surface: Distances;
  /** From all points of the surface to the shell. */
  surface_to_shell: Distances;
}

/** How close the shell is to what was asked for. */
export interface DeviationReport {
  /** Distances of the polylines that the shell locks on from the target curves, or of the edges of whole boards that take their place; None without them. */
  f: Closeness | null;
  /** Distances of the polylines that the shell locks on from the target curves, or of the edges of whole boards that take their place; None without them. */
  g: Closeness | null;
  /** Of the shell from the surface; None if it was not measured. */
  surface: Deviation | null;
  /** How f or g lie in that surface otherwise than they are drawn; empty where they lie as drawn. */
  tilted: string;
  /** What the family approaches instead, if it does. */
  approached: ApproachReport | null;
  /** Distances of vertices, or of corners of whole boards, from the surfaces beside the one asked for, on which crests and valleys should lie; None where f is swept along g. */
  crests: Closeness | null;
  /** Distances of vertices, or of corners of whole boards, from the surfaces beside the one asked for, on which crests and valleys should lie; None where f is swept along g. */
  valleys: Closeness | null;
}

/** The largest displacement. */
export interface Displacement {
  /** How large it is. */
  size: number;
  /** Along x, y and z. */
  vector: [number, number, number];
  /** A panel that has the place. */
  panel: [number, number];
  /** Of the shell's height. */
  share: number;
}

/** Distances from all of one surface to the nearest points of another (length). */
export interface Distances {
  /** The largest. */
  max: number;
  /** Root mean square, mean, and the distance below which 95 % of the area lies. */
  rms: number;
  /** Root mean square, mean, and the distance below which 95 % of the area lies. */
  mean: number;
  /** Root mean square, mean, and the distance below which 95 % of the area lies. */
  p95: number;
  /** What is not known: the largest distance lies between max - sample_spacing and max + sample_spacing. */
  sample_spacing: number;
  /** The same for rms, mean and p95; in practice these are far better known. */
  grid_spacing: number;
}

/** What a drawing that was dropped onto the page is, as far as its lines tell. */
export interface DrawingLook {
  /** Whether it has mountains, valleys and a border. */
  pattern: boolean;
}

/** One drawing for the workshop. */
export interface DrawnSheet {
  /** The name of the file that it is exported to, without its ending. */
  file: string;
  title: string;
  /** The drawing; its lines are wider than in the file, where that makes them visible. */
  svg: string;
}

/** What is known of a drawn sheet before a shell is made of it. */
export interface DrawnSheetFacts {
  rows: Row[];
}

/** A target surface, to be drawn before a shell is fitted to it; arrays in base64. */
export interface DrawnSurface {
  /** (rows, columns, 3) in single precision. */
  points: string;
  /** Rows and columns. */
  lattice: [number, number];
  /** (K, 3) once around, in single precision. */
  rim: string;
  /** Which points of the rim are its corners. */
  corners: [number, number, number, number];
  /** What of it is covered; null: it is given in another way. */
  patch: Patch | null;
  /** By which x, y and z of its table are multiplied. */
  factor: [number, number, number];
}

/** A curve whose file was dropped onto the page, and a note on how it was read. */
export interface DroppedCurve {
  table: CurveFields;
  note: string;
}

/** A surface or a drawn sheet whose file was dropped onto the page, and how it was read. */
export interface DroppedTarget {
  table: Record<string, unknown>;
  note: string;
}

/** What governs one limit state. */
export interface Envelope {
  /** Which. */
  limit_state: "ULS" | "EQU" | "SLS";
  /** Number of its cases. */
  cases: number;
  /** Number of those under which the shell moves, with any stiffness of creases. */
  moves: number;
  /** The case that governs, and the stiffness of its creases. */
  case: string;
  /** The case that governs, and the stiffness of its creases. */
  creases: number | "free" | "rigid";
  /** What is largest there: "panels", "creases", "ties" or "buckling"; "displacement"; "friction" or "ballast"; null if the shell moves, or nothing is known of it. */
  part: string | null;
  /** Its share of what can be borne, of the shell's height, or of the friction that there is. */
  share: number | null;
}

/** A shell in equilibrium with its loads. */
export interface Equilibrium {
  /** Sum of all reactions. */
  reaction: [number, number, number];
  /** What is missing between loads and reactions, of forces and moments the larger, relative to the loads. */
  residual: number;
  /** The largest. */
  displacement: Displacement;
  /** The largest displacement once it has crept (length): EN 1995-1-1, 2.2.3. */
  crept: number;
  /** Of all supported vertices. */
  reactions: Reaction[];
  /** The largest share of its friction that a foot uses; None where none is rough. */
  friction: number | null;
  /** On the ground: which stick, slip or lift. */
  feet: Foot[];
  /** Forces in ties, the largest first. */
  ties: PairForce[];
  /** Forces of flaps that press on each other, the largest first. */
  flaps: PairForce[];
  /** The largest moment about a crease; None where they are free. */
  crease: CreaseMoment | null;
  /** The largest forces per length along row creases and along column creases. */
  creases: CreaseForces[];
  /** The largest force per length that a crease line has to bear. */
  lines: AtCrease;
  /** The crease line that uses most of what it bears; None if nothing is known of any. */
  used_line: AtCrease | null;
  /** The largest. */
  stress: Stress;
  /** The largest structural stress of solid panels at creases; None if they are not solid. */
  beside: AtCrease | null;
  /** The largest stress where one of two boards is left beside a crease; None if nowhere. */
  lone_board: AtCrease | null;
  /** The largest stress of the membrane in a crease; None if there is none between boards. */
  membrane: AtCrease | null;
  /** The largest stress of the arms of hinges beside creases; None if there are none. */
  arms: AtCrease | null;
  /** The largest stress of gussets; None if there are none. */
  gussets: PlateStress | null;
  /** The largest stress of box girders; None if there are none. */
  boxes: BoxStress | null;
  /** Forces along hinges of box girders; None without any. */
  box_lines: JudgedEdges | null;
  /** Forces along edges of gussets, and of plates across box girders; None without any. */
  plate_edges: JudgedEdges | null;
  /** The largest stress of base rails; None without them. */
  rail: AtRail | null;
  /** What is missing for the balance of a panel with its loads and the forces at its edges, relative to all loads. */
  panel_residual: number;
  /** Of all that bears something. */
  utilisation: Utilisation;
  /** The lowest buckling factor; None if it does not buckle. */
  buckling: number | null;
  /** The lowest factors by which all loads grow until the shell buckles, by linear theory; none if it does not. */
  buckling_factors: number[];
  /** The lowest natural frequencies (Hz), loaded as it is: ties that are slack are left out, and free motions, which have none. */
  frequencies: number[];
  /** The way there, where large displacements are followed: then all but frequencies is of the shell as it is moved, at the end of the path. */
  path: LoadPath | null;
  /** Why it was not followed though it buckles soon; None if it was, or does not. */
  unfollowed: "work" | "lost" | "hinges" | "fails" | null;
  /** How long its loads last. */
  duration: "permanent" | "long" | "medium" | "short" | "instantaneous";
  /** What panels bear under loads that last as long; None if that is not known. */
  strength: number | null;
}

/** A design to begin with: its tables, and the text of its file. */
export interface Example {
  name: string;
  title: string;
  text: string;
  design: Record<string, unknown>;
}

/** What one writes files for. */
export interface ExportTask {
  name: string;
  label: string;
  /** What is written, in a sentence. */
  what: string;
  /** They come before its formats. */
  archives: Archive[];
  /** The names of its formats. */
  formats: string[];
  /** The keys of the table [workshop] that matter to it. */
  settings: string[];
  /** Whether its files show one state, which is chosen. */
  state: boolean;
  /** What is shown of it before it is written. */
  preview: "sheets" | "paper" | "booklet" | "shell";
}

/** A line of the answer: what the families make of the target that were tried so far. */
export interface FamiliesFound {
  found: FamilyTrial[];
}

/** The last line of the answer: what all make of it, and the one that is taken. */
export interface FamiliesResult {
  result: FamilyChoice;
}

/** A family of crease patterns. */
export interface Family {
  label: string;
  what: string;
  /** What the panels beside its inner columns are. */
  borders: string;
  /** What its shells can follow. */
  aims: ("curves" | "surface" | "drawing" | "none")[];
  parameters: Parameter[];
}

/** The families that were tried, and the one that was taken. */
export interface FamilyChoice {
  /** That was taken. */
  family: string;
  /** By which it was taken. */
  rule: string;
  tried: FamilyTrial[];
}

/** What a family makes of the target. */
export interface FamilyTrial {
  family: string;
  /** The largest distance between shell and surface, both ways (length); None if there is no shell. */
  distance: number | null;
  /** Number of panels. */
  panels: number | null;
  /** Area of its flat sheet, or of all of its strips. */
  sheet_area: number | null;
  /** Whether its motion ends with all panels in one plane. */
  packs_flat: boolean | null;
  /** Whether anything in it stops it closing at the target, in all of its motions. */
  locks: boolean | null;
  /** How many motions its sheet has; None if that is not known, or there is no shell. */
  degrees_of_freedom: number | null;
  /** Why there is no shell. */
  why_not: string;
  /** Whether it is no one sheet, but made in strips that are joined. */
  in_strips: boolean;
}

/** What is wrong with a request or its design. */
export interface Fault {
  kind: "input" | "design" | "limit" | "time" | "key" | "fault";
  /** All of it in one text. */
  message: string;
  what: string;
  where: string;
  /** The keys of the design file that it is about, the tables in front of them. */
  keys: string[];
  got: string;
  expected: string;
  remedy: string;
  detail: string;
  place: string;
  size: string;
  /** What stands in the way, where nothing was found that works. */
  limit: string;
  /** What was tried and works, the nearest first. */
  remedies: Remedy[];
}

/** What a locked shell stands on, flaps left out. */
export interface Feet {
  /** The rows of vertices that are its feet, the lowest towards each end. */
  rows: [number, number];
  /** Height of the lowest of their vertices. */
  z: number;
  /** By how much the highest lies above it, 0 where they are level. */
  uneven: number;
  /** Whether all are at one height. */
  level: boolean;
  /** Where it stands on single vertices of its border: those, all at one height, or nearly for whole boards; the columns that have one in both rows are its feet. */
  points: [number, number][];
  /** How far vertices of flaps reach below the lowest foot; 0 if none do. */
  below: number;
}

/** A format of files that a shell can be written in. */
export interface FileFormat {
  name: string;
  file: string;
  what: string;
  /** What the design must have for it: panels with a thickness, or loads; empty where any will do. */
  needs: "" | "thickness" | "loads";
}

/** What speaks against a case, or is in doubt. */
export interface Finding {
  /** Whether it fails, or wants attention. */
  sign: "fails" | "warns" | "holds" | "says";
  /** How. */
  kind: "moves" | "slips" | "lifts off" | "gives way" | "exceeds strength" | "buckles" | "displaced" | "unknown";
  /** By how much: what follows on "the shell". */
  text: string;
  /** How many times too much it is, for what is known; None where nothing resists, or no measure is. */
  excess: number | null;
}

/** Two panels that touch. */
export interface FirstContact {
  /** Drive angle at which they do. */
  drive_deg: number;
  /** Their numbers. */
  panels: [number, number];
}

/** A line of the answer: the view of a coarser sheet, in base64. */
export interface FitFound {
  found: string;
}

/** The last line of the answer: the view of the sheet that was fitted, in base64. */
export interface FitResult {
  result: string;
}

/** The sizes that were asked for and that the built shell has, by their keys (lengths). */
export interface FittedSize {
  of: "outside" | "inside";
  /** Up to which it is clear; None where no clear size is asked for. */
  head_height: number | null;
  asked: Record<string, number>;
  found: Record<string, number>;
  /** What keys of the design file would say for the shell to be as large as it is: ``scale`` of a target, lengths of edges of a sheet without one. */
  scales: Record<string, number | number[]>;
  /** Shells that were tried without a proof. */
  trials: number;
}

/** Where flaps stop a shell that is cut with errors; 95 % of sheets do not exceed these. */
export interface FlapStop {
  /** By how much the fold angle of the hinge that moves most is off where they shut. */
  off_deg: number;
  /** What the last pair of flaps then still lacks. */
  last_deg: number;
  /** How far that leaves vertices from their places, rms over the shell (length). */
  shape: number;
}

/** A foot on the ground, which pushes and rubs, and does not pull. */
export interface Foot {
  /** The vertex. */
  at: [number, number];
  /** What it does. */
  state: "sticks" | "slips" | "lifted";
  /** How far it slips, along x and y. */
  slip: [number, number];
  /** How far it slips. */
  slipped: number;
  /** How far it is lifted. */
  gap: number;
  /** The share of its friction that it uses; None without, or where it is lifted. */
  used: number | null;
}

/** How many motions a sheet has, and what folds by itself. */
export interface FreedomOfSheet {
  /** Whether the sheet has one motion only, in which all of it is felt to move. */
  one_motion: boolean;
  /** How many there would be without couplings too weak to be felt; None if that is not known. */
  nearly: number | null;
  /** What folds by itself; None if it is one motion, or parts of no whole lines. */
  lines: "rows" | "columns" | null;
  /** First and last row or column of inner vertices (the grid's numbers) of each part that folds by itself. */
  parts: [number, number][];
  /** In how many folded states they were counted. */
  states: number;
  /** The largest number that counts as zero there. */
  largest_zero: number;
  /** The least that does not; None if there is none. */
  least_other: number | null;
}

/** A design that no other beats. */
export interface FrontMember {
  /** Which it is of all designs that were sent, from 0. */
  number: number;
  /** What a step to it from the knee gains and costs, in words; empty for the knee. */
  costs: string;
}

/** What the page of a search shows. */
export interface FrontPage {
  /** The name of the design. */
  title: string;
  /** How many designs were made, and what became of them. */
  said: string;
  /** Keys of the design file. */
  variables: string[];
  figures: PageFigure[];
  /** By their first objective. */
  members: PageMember[];
  /** Number of the member at the knee. */
  knee: number;
  /** Objectives of designs that keep all limits and are not on the front. */
  beaten: number[][];
  /** Objectives of the design that the file has; null if it cannot be made. */
  baseline: number[] | null;
}

/** What is nearest to the end of what it bears, of all cases. */
export interface Governing {
  /** What it is. */
  part: "panels" | "panel_shear" | "rolling_shear" | "core_shear" | "wrinkling" | "membrane" | "creases" | "lines" | "arms" | "gussets" | "boxes" | "box_lines" | "plate_edges" | "ties" | "rail" | "buckling";
  /** The load case, and the stiffness of its creases. */
  case: string;
  /** The load case, and the stiffness of its creases. */
  creases: number | "free" | "rigid";
  /** The share of what it bears. */
  utilisation: number;
}

/** A foot, and what the structure asks of the ground there. */
export interface GroundFoot {
  /** From 1, row by row. */
  number: number;
  /** Row and column of its vertex in the whole grid. */
  at: [number, number];
  /** Where it is, from the corner, and how high over the lowest foot (length). */
  x: number;
  /** Where it is, from the corner, and how high over the lowest foot (length). */
  y: number;
  /** Where it is, from the corner, and how high over the lowest foot (length). */
  z: number;
  /** The largest forces on the ground: down, up, and along it (N); None without a structure. */
  push: number | null;
  /** The largest forces on the ground: down, up, and along it (N); None without a structure. */
  pull: number | null;
  /** The largest forces on the ground: down, up, and along it (N); None without a structure. */
  sideways: number | null;
  /** Mass that holds it without an anchor (kg); None likewise. */
  ballast: number | null;
}

/** A plan of the feet of a shell at its target. */
export interface GroundPlan {
  /** The corner in world coordinates, x and y. */
  corner: [number, number];
  /**  */
  feet: GroundFoot[];
  /** The corners of the convex hull of the shell. */
  outline: [number, number][];
  /** The ground that it needs on its way; None where it is opened in pieces, or moves so fast somewhere that nobody knows. */
  swept: SweptGround | null;
}

/** The header of a view: what the shell is, and where its arrays are. */
export interface Header {
  version: number;
  title: string;
  unit: string;
  /** Rows and columns of vertices; null if they are no grid's. Flaps beside it come after it. */
  grid: [number, number] | null;
  /** Of panels, where there are others than those of the grid. */
  names?: string[];
  /** From which drive on a part is there that moves with the sheet, if not always. */
  joined_from_deg?: number;
  /** Was subtracted from all coordinates in space before they were rounded. */
  origin: [number, number, number];
  /** Drive of every state, in the order of the motion. */
  drives_deg: (number | null)[];
  /** Numbers of the states that have a name: flat, target, pack. */
  named: Record<string, number>;
  /** The fields of ``report.json``; if there is none, what the verdict says of sizes. */
  report: Record<string, unknown>;
  /** The fields of ``report.json``; if there is none, what the verdict says of sizes. */
  contact: FirstContact | null;
  /** The fields of ``report.json``; if there is none, what the verdict says of sizes. */
  arrays: Record<string, ArrayPlace>;
  /** In the studio. */
  curves?: Curves;
  /** Load cases, where the shell was analysed as a structure. */
  cases?: NamedCase[];
  /** In the order of ``crease_forces``. */
  creases?: CreaseLoads;
  /** Numbers of what stiffens a shell that was analysed, behind those of panels, by its names. */
  stiffeners?: Record<string, number>;
}

/** Hinges of whole boards and their arms; lengths in the document's unit. */
export interface HingeBill {
  /** Number of hinges. */
  count: number;
  /** How many of them stand on an arm on either side. */
  on_arms: number;
  /** Of all hinges together. */
  length: number;
  /** Holes in boards, and in the fins of arms. */
  screws: number;
  /** Number of arms. */
  arms: number;
  /** How many different ones there are. */
  arm_kinds: number;
  /** Of the sheet that they are bent of. */
  arm_area: number;
}

/** Whole boards, their hinges and arms. */
export interface HingedReport {
  /** The share of the sheet that boards cover. */
  board_share: number;
  /** How far a hinge stands off a board at most, and on the mean of those that do. */
  longest_arm: number;
  /** How far a hinge stands off a board at most, and on the mean of those that do. */
  mean_arm: number;
  /** Number of fins that carry hinges. */
  arms: number;
  /** How thick they are. */
  arm_width: number;
  /** How far corners of boards, half way up, lie at the target from those of the panels that meet it, at most and root mean square; without a target from the sheet without a thickness. */
  offset_max: number;
  /** How far corners of boards, half way up, lie at the target from those of the panels that meet it, at most and root mean square; without a target from the sheet without a thickness. */
  offset_rms: number;
  /** One if the sheet is whole. */
  pieces: PieceReport[];
  /** None if the sheet is whole. */
  joints: JointReport | null;
  /** What errors of hinges ask of the others. */
  play: PlayReport;
}

/** What the page loads first: what there is to choose from, limits, the design to open. */
export interface Info {
  version: string;
  units: string[];
  families: Record<string, Family>;
  examples: Example[];
  formats: FileFormat[];
  tasks: ExportTask[];
  workshop: Parameter[];
  tables: Record<string, TableWords>;
  materials: MaterialFacts[];
  search: SearchInfo;
  limits: Largest;
  start: NamedDesign | null;
}

/** Where pieces are joined at the target. */
export interface JointReport {
  /** Number of creases along which there are joints, and no hinges. */
  creases: number;
  /** How far boards are cut back from them at most. */
  largest_cut: number;
  /** How far boards are apart there, on the faces on which they close. */
  open_max: number;
  /** How far boards are apart there, on the faces on which they close. */
  open_rms: number;
}

/** Forces per length along edges that bear alike, each the largest and where it is. */
export interface JudgedEdges {
  /** In any direction. */
  largest: AtEdge;
  /** The share of what is borne; None if nothing is known of that. */
  used: AtEdge | null;
  /** In directions in which no strength is known. */
  unknown: AtEdge;
}

/** A key of the design file in words. */
export interface KeyWords {
  label: string;
  /** One line on what it does. */
  help: string;
  /** Of its values: "length" is the design's unit. */
  unit: "length" | "deg" | "kg/m" | "kg/m\u00b2" | "";
  /** Its values and their labels, the default first; empty where they are not listed. */
  choices: Record<string, string>;
}

/** Limits of the studio: vertices of a sheet, bytes of a request, seconds of a design. */
export interface Largest {
  vertices: number;
  bytes: number;
  seconds: number;
}

/** A layer of the drawings, its name in words and its colour ("#rrggbb"). */
export interface LayerPen {
  layer: "CUT" | "MOUNTAIN" | "VALLEY" | "ENGRAVE" | "LABEL";
  label: string;
  colour: string;
}

/** What crease lines bear, by direction; None where that is not known. */
export interface LineStrength {
  /** What lines are, by its name in hinge_lines.toml: what is not given is taken from there. */
  kind: string | null;
  /** What they bear (force per length). */
  pull: number | null;
  /** The same into the panel. */
  push: number | null;
  /** Shear along the line. */
  along: number | null;
  /** Shear square to a panel. */
  across: number | null;
}

/** What one kind of load adds to a case. */
export interface Load {
  /** The case that has it: another one where that is combined. */
  case: string;
  /** By which it is combined. */
  factor: number;
  /** What it is. */
  kind: "self_weight" | "pressure" | "snow" | "wind" | "points" | "person";
  /** What it comes from: the pressure, snow on the ground, wind's peak velocity pressure; None for own weight and forces at points. */
  pressure: number | null;
  /** How it comes from that, in words. */
  rule: string;
  /** Sum of its forces, times the factor. */
  force: [number, number, number];
}

/** Load against displacement. */
export interface LoadPath {
  /** Whether it ends under the full load. */
  carries: boolean;
  /** How it ends. */
  ending: "carries" | "snaps" | "branches" | "lost";
  /** The largest factor of the loads on it; 1 where the shell carries them. */
  reached: number;
  /** Factors of the loads, point by point. */
  factors: number[];
  /** The largest displacement at each. */
  displacements: number[];
  /** By linear theory: the largest displacement, and the factor at which it buckles; None if it does not. */
  linear_displacement: number;
  /** By linear theory: the largest displacement, and the factor at which it buckles; None if it does not. */
  linear_buckling: number | null;
  /** How far the shell is off its shape as built, at most (length). */
  imperfection: number;
}

/** How a motion ends. */
export interface Lock {
  /** Where it ends; None if nothing ends it. */
  drive_deg: number | null;
  /** What ends it: flaps folded onto each other as designed, panels that clash, another crease that is folded flat, hinges that close no further, or boards, which meet there or would leave too little of a panel; or the proof, beyond which it is not known whether two panels meet. */
  cause: "flaps" | "clash" | "crease" | "hinges" | "boards" | "unproved" | null;
  /** Where the shell meets its target. */
  target_drive_deg: number;
  /** At the target, the mean distance (length) of inner vertices from the line between those above and below. */
  corrugation_depth: number;
  /** The panels that touch first, if any do. */
  first_contact: Contact | null;
  /** Pairs of panels that touch at the end of the motion and are not meant to. */
  touching_at_end: [[number, number], [number, number]][];
  /** What flaps that are clipped on at the target meet there; None if nothing, or if there are none. */
  clipped_contact: Contact | null;
  /** How contact was looked for; None if it was not. */
  path: ProofRecord | null;
}

/** A place in a flat sheet, and what is wrong there. */
export interface Mark {
  /** Where. */
  x: number;
  y: number;
  /** In a few words. */
  what: string;
}

/** What panels may be made of. */
export interface MaterialFacts {
  name: string;
  /** Young's modulus (N/m2). */
  modulus: number;
  /** What it bears (N/m2). */
  strength: number;
  /** Mass by volume (kg/m3). */
  density: number;
  /** Whether it bears by its grain. */
  grain: boolean;
  /** Whether it is faces on a core. */
  sandwich: boolean;
  /** What is on the safe side in these values, and what is not. */
  conservative: string;
}

/** Where boards of flaps meet at the target. */
export interface MeetingReport {
  /** Number of row creases of flaps about which two boards meet. */
  creases: number;
  /** Along how much of a crease they meet at least, and of all together. */
  shortest: number;
  /** Along how much of a crease they meet at least, and of all together. */
  total: number;
  /** How far apart they are at most, where a gap sets them farther back. */
  largest_play: number;
  /** By how much a flap could fold further at most until they meet. */
  largest_turn_deg: number;
}

/** The last line of the answer: what does away with a note. */
export interface MendResult {
  result: Mended;
}

/** A note that a change of the design may mend, which nobody has tried yet. */
export interface Mendable {
  /** Which. */
  note: string;
  /** What it is about. */
  about: "columns" | "idle columns" | "depth" | "board" | "roll" | "unit" | "stock" | "reach" | "sheet" | "taut" | "off" | "no flaps" | "closes" | "uneven" | "opens" | "chamfers" | "play" | "open joints" | "cut joints" | "arms" | "points" | "patch" | "pulled" | "weight" | "cells" | "linear";
  /** Whether to try takes long. */
  slow: boolean;
}

/** What does what the notes on a matter say; null where nothing that was tried does. */
export interface Mended {
  mend: Remedy | null;
}

/** What is analysed. */
export interface Model {
  /** Nodes of the mesh. */
  nodes: number;
  /** Triangles of the mesh. */
  triangles: number;
  /** Degrees of freedom of the mesh. */
  freedoms: number;
  /** Cells along every side of a panel. */
  cells: number;
  /** By how much figures still change with the mesh. */
  change: Changes;
  /** Why cells are no finer although ``refine`` asks for it. */
  stopped: "work" | "memory" | "cells" | null;
  /** Of all panels (kg). */
  mass: number;
  /** Of the shell between its flaps. */
  height: number;
  /** Of panels. */
  thickness: number;
  /** What panels are made of, by its name in materials.toml: what is not given is taken from there. */
  material: string | null;
  /** Which way the grain of the faces runs, of a material that has one: along row creases or along column creases; None if nobody knows, and both ways bear what the weaker does. */
  grain: "along rows" | "along columns" | null;
  /** What boards are of whose faces are on a core; None if they are solid, or as the material is. */
  sandwich: Sandwich | null;
  /** Young's modulus of panels or boards, of their section as a whole, or of the faces of a sandwich; None if it is that of the material (force per area). */
  modulus: number;
  /** Poisson's ratio of panels. */
  poisson: number;
  /** Young's modulus of the membrane between boards; 0 if it is not counted (force per area). */
  membrane_modulus: number;
  /** Of the sections of panels, the least and the largest: force per length by strain. */
  membrane_stiffness: [number, number];
  /** Of the sections of panels, the least and the largest: moment per length by curvature. */
  bending_stiffness: [number, number];
  /** Of boards with a core, across them, likewise: force per length by shear strain. */
  shear_stiffness: [number, number] | null;
  /** The least and the largest with which all is analysed. */
  crease_stiffness: [number | "free" | "rigid", number | "free" | "rigid"];
  /** Force by strain; None if ties do not stretch. */
  tie_stiffness: number | null;
  /** What panels bear, or the faces of a sandwich, its design value; None if it is that of the material (force per area). */
  strength: number | null;
  /** What creases bear: moment per length; None if that is not known (force). */
  crease_strength: number | null;
  /** What a tie bears; None if that is not known (N). */
  tie_strength: number | null;
  /** What creases bear as crease lines, by direction; None if that is not known (force per length). */
  line_strength: LineStrength | null;
  /** What holds edges of gussets, and of plates across box girders, bears, by direction; None if that is not known (force per length). */
  edge_strength: LineStrength | null;
  /** Lever arm of what locks creases: as asked, or the most that there is room for. */
  lever: number;
  /** Stress that the membrane between boards bears; None if that is not known (force per area). */
  membrane_strength: number | null;
  /** Young's modulus of the arms that hinges of whole boards stand on; None for rigid ones (force per area). */
  arm_modulus: number | null;
  /** Stress that these arms bear; None if that is not known (force per area). */
  arm_strength: number | null;
  /** How far it may be displaced (length); None if nobody says so. */
  displacement_limit: number | null;
  /** How far the shape is off as built: so much at most, as the first way in which it buckles; only where large displacements are followed; None for what codes allow there where it buckles under less than three times its loads (length). */
  imperfection: number | null;
  /** What holds it. */
  supports: Support[];
  /** Bars that join neighbouring feet of a row; None without them. */
  rail: BaseRail | null;
}

/** A load case: its name, whether the shell fails under it, and whether it is in balance. */
export interface NamedCase {
  name: string;
  sign: "fails" | "warns" | "holds" | "says";
  balanced: boolean;
  /** Stress (MPa) that panels bear under loads that last as long; null if that is not known, or without balance. */
  strength: number | null;
  /** The same of what stiffens the sheet, which may be of another material. */
  parts_strength: number | null;
}

/** The design file that the studio was started with. */
export interface NamedDesign {
  name: string;
  design: Record<string, unknown>;
}

/** A figure that is to be small, and its name with its unit. */
export interface Objective {
  name: string;
  label: string;
}

/** The opening of a door, from the ground up. */
export interface Opening {
  /** Length. */
  width: number;
  /** Length. */
  height: number;
  /** How far its middle is from that of the wall, to the right as seen from outside (length). */
  offset: number;
}

/** One line of the order; lengths and areas in the document's unit, None where not known. */
export interface OrderRow {
  /** What it is for: "boards", "membrane", "sheet", "arms", "ties", "base rail", a hinge. */
  item: string;
  /** In words, with its thickness. */
  what: string;
  /** How many sheets, rolls, bars or coils; None if nobody says how it is sold. */
  count: number | null;
  /** How few would do at least, where it is proved that fewer cannot. */
  least: number | null;
  /** Of one: width and height, or length; empty if nobody says. */
  size: number[];
  /** Of what is used: "m2" for areas, "m" for lengths. */
  unit: string;
  /** Area or length of all parts. */
  used: number;
  /** Share of what is ordered that is not used. */
  waste: number | null;
  /** Of the parts. */
  mass_kg: number | null;
  /** Of all that is ordered. */
  price: number | null;
}

/** A shell under its own weight, from flat to packed, without ties and flaps clipped on. */
export interface OwnWeight {
  /** Newtons, or the shell's weight if its mass is not known. */
  force_unit: "N" | "weight";
  /** Its weight. */
  total: number;
  /** Force at the target by which the feet, all of one side together, push outwards: positive where own weight opens the shell and ties carry it, negative where flaps do. */
  at_feet: number;
  /** The largest force at the feet on the way from the end of the motion to the target. */
  largest_from_pack: number;
  /** Drives at which the shell would fall to either side. */
  tipping_deg: number[];
  /** What raising it takes: work, in the unit of force times metres. */
  raise_from_flat: number;
  /** What raising it takes: work, in the unit of force times metres. */
  raise_from_pack: number;
  /** The force at the feet along the motion; None where none raises or holds it. */
  drives_deg: number[];
  /** The force at the feet along the motion; None where none raises or holds it. */
  forces: (number | null)[];
}

/** The state of a motion that fits into the smallest box, panels with their thickness. */
export interface Pack {
  /** Its drive angle. */
  drive_deg: number;
  /** The longest side of its box. */
  length: number;
  /** The side between. */
  width: number;
  /** The shortest side. */
  height: number;
  /** How many panels lie on top of each other: boards make it that many times as thick. */
  layers: number;
}

/** A figure that designs are compared by. */
export interface PageFigure {
  /** Its name, with its unit if that is known. */
  name: string;
  /** Its limits, in words; empty if it has none. */
  note: string;
  /** Whether it was to be as small as can be. These come first. */
  minimised: boolean;
}

/** A design that no other beats. */
export interface PageMember {
  /** Its design file. */
  file: string;
  /** Values of its variables. */
  values: unknown[];
  /** Its figures. */
  figures: number[];
  /** To its neighbours, by the first objective. */
  steps: Step[];
  /** The view of its shell, deflated, in base64; null if it is not drawn. */
  view: string | null;
  /** Why it is not drawn. */
  missing: string;
}

/** The force between two vertices: of a tie, or of two panels of a flap on each other. */
export interface PairForce {
  /** The vertices. */
  ends: [[number, number], [number, number]];
  /** How much a tie pulls, or flaps push. */
  force: number;
}

/** What panels with a thickness are made of; lengths and areas in the document's unit. */
export interface PanelBill {
  /** How many boards there are, those that are clipped on included. */
  boards: BoardCount;
  /** Area of all boards, each at its largest. */
  board_area: number;
  /** Area of the membrane, without tabs and strips; 0 if there is none. */
  membrane_area: number;
  /** Area of the boards' faces on the membrane. */
  glue_area: number;
  /** Length of the creases that fold, or of the hinges of whole boards. */
  hinge_length: number;
  /** Mass by part. */
  mass_kg: PanelMass;
  /** Of the shell at its target, in the world; None if its mass is not known. */
  centre_of_mass: [number, number, number] | null;
  /** Number of sheets of stock for the boards; None if there is no stock, or that was not asked for. */
  stock_sheets: number | null;
  /** Hinges of whole boards; None for others. */
  hinges: HingeBill | null;
}

/** Mass of panels with a thickness (kg). */
export interface PanelMass {
  /** Of boards, or of solid panels; None if their density is not known. */
  boards: number | null;
  /** Of the membrane; None if its density is not known, 0 if there is none. */
  membrane: number | null;
  /** Of boards, membrane, and arms, hinges and ties where these are known; None if one of the first is not known. */
  total: number | null;
  /** Of arms and their feet; None if their density is not known. */
  arms: number | null;
  /** Of hinges, tape left out; None if it is not known. */
  hinges: number | null;
  /** Of ties; None if it is not known. */
  ties: number | null;
}

/** Panels as they are built. */
export interface PanelReport {
  /** What they are made of. */
  construction: "sandwich" | "bevel" | "hinged";
  /** What they are made of. */
  thickness: number;
  /** What they are made of. */
  membrane: number;
  /** What they are made of. */
  gap: number;
  /** The faces of the flat sheet that boards of a membrane are on. */
  sides: "both" | "top" | "bottom";
  /** By how much flaps stop short of folding flat. */
  stop_deg: number;
  /** The drive up to which boards are set back. */
  set_back_for_deg: number;
  /** The largest fold angle of a crease on the way there. */
  largest_fold_deg: number;
  /** How far boards stand back at most. */
  largest_setback: number;
  /** The least share of a panel that a board covers, on the face on which that is least; flaps that are clipped on are left out. */
  least_share: number;
  /** How far a chamfer of solid panels leans from a square cut at most; None if there is none. */
  steepest_chamfer_deg: number | null;
  /** Their number, those of clipped flaps and of strips of box girders included. */
  boards: number;
  /** Number of vertices at which corners of boards are cut off, and how far at most. */
  corners_cut: number;
  /** Number of vertices at which corners of boards are cut off, and how far at most. */
  largest_cut: number;
  /** Where boards of flaps meet at the target; None if there are none. */
  meeting: MeetingReport | null;
  /** How contact of boards was looked for; None if it was not. */
  path: ProofRecord | null;
  /** Whole boards on hinges; None for others. */
  hinged: HingedReport | null;
}

/** A paper model on its pages. */
export interface PaperPages {
  /** Its scale and pages in words; why there is none, if it takes too many. */
  says: string;
  /** A picture of the model with the frames and numbers of its pages; empty then. */
  svg: string;
}

/** A parameter of a family, or a setting of the workshop, as a control shows it. */
export interface Parameter {
  key: string;
  label: string;
  help: string;
  kind: "integer" | "number" | "choice" | "angles4" | "switch" | "size";
  auto: boolean;
  unit: "length" | "deg" | "kg/m" | "kg/m\u00b2" | "";
  choices: string[];
  /** Null: the design must give it. */
  default: number | string | boolean | null;
  /** The target without which it has no meaning. */
  only: "curves" | "surface" | "drawing" | "none" | null;
  /** Whether it is folded away until it is asked for. */
  advanced: boolean;
  /** How far the slider reaches; left out where that depends on the curves. */
  slider?: [number, number];
  /** Between two of its places. */
  step?: number;
}

/** The tables of a design file, read from its text. */
export interface Parsed {
  design: Record<string, unknown>;
}

/** A rectangle in plan: what of a surface is to be covered. */
export interface Patch {
  centre: [number, number];
  /** Along its own x and y. */
  size: [number, number];
  /** From the plan's x to its own. */
  turn_deg: number;
}

/** A piece that folds by itself. */
export interface PieceReport {
  /** Its first and last row of panels. */
  first_row: number;
  /** Its first and last row of panels. */
  last_row: number;
  /** Its first and last row of panels. */
  longest_arm: number;
}

/** The largest stress in plates that stiffen a sheet. */
export interface PlateStress {
  /** Von Mises' stress, averaged over a patch of a fixed share of a plate. */
  size: number;
  /** The vertex that the plate goes from. */
  at: [number, number];
}

/** How far boards are from fitting in a state, in errors of their hinges (root mean square). */
export interface Play {
  /** How far the loop about a vertex is open, where that is most. */
  loop: number;
  /** The play that each hinge has where all share in it, on the mean of hinges. */
  hinge: number;
  /** How far boards then lie beside their places, on the mean of boards. */
  board: number;
}

/** What hinges beside their places ask of the others, in lengths by length of their errors. */
export interface PlayReport {
  /** At the target. */
  target: Play;
  /** Where boards fold no further: at the target, or in the pack. */
  end: Play;
}

/** How contact was excluded along the whole path. */
export interface ProofRecord {
  /** Numbers of states computed, ranges of the drive proved clear, and pairs of panels, or of groups of panels, compared. */
  states: number;
  /** Numbers of states computed, ranges of the drive proved clear, and pairs of panels, or of groups of panels, compared. */
  ranges: number;
  /** Numbers of states computed, ranges of the drive proved clear, and pairs of panels, or of groups of panels, compared. */
  tests: number;
  /** The longest and the shortest of these ranges. */
  largest_step_deg: number;
  /** The longest and the shortest of these ranges. */
  smallest_step_deg: number;
  /** Distance at which panels touch (length). */
  contact_tolerance: number;
  /** What the proof rests on, in words. */
  bound: string;
}

/** Totals of the sheet and its clipped boards; lengths and areas in the document's unit. */
export interface Quantities {
  /**  */
  panels: number;
  /** How many of them are panels of boards that are clipped on at the target. */
  clipped: number;
  /** Area of all panels. */
  area: number;
  /** Length of the creases by their assignment. */
  crease_length: CreaseLength;
  /** Length of the outlines and of cuts within them. */
  outline_length: number;
  /** Sheets of stock for the sheet, or for panels that are solid, and what of them is not used; None if that was not asked for. */
  stock: Waste | null;
  /** Mass by the areal density, and of hinges and ties where these are weighed by their length; None if the areal density is not known. */
  mass_kg: number | null;
  /** Boards, membrane and hinges; None if panels have no thickness. */
  built: PanelBill | null;
  /** How many people carry all of it; None if its mass is not known. */
  carried_by: number | null;
  /** What to order. */
  order: OrderRow[];
}

/** The way of a shell from flat or packed to its target, by its own weight. */
export interface Raising {
  /** The row of vertices that is highest at the target: where it is lifted. */
  row: number;
  /** What one person is taken to pull or lift (N). */
  person: number;
  /** From where it begins to the target. */
  stages: Stage[];
}

/** Values of a parameter that were tried, and those that work. */
export interface Range {
  /** Those that were tried. */
  span: [number, number];
  /** Those that work. */
  intervals: [number, number][];
  /** Whether all works that was tried below the first interval, and above the last. */
  beyond: [boolean, boolean];
  /** Why values below the lowest interval, or above the highest, fail; empty at the span's end. */
  below: string;
  /** Why values below the lowest interval, or above the highest, fail; empty at the span's end. */
  above: string;
}

/** Values that work, for every parameter by its key. */
export interface Ranges {
  ranges: Record<string, Range>;
}

/** The force of a support on the shell. */
export interface Reaction {
  /** The supported vertex. */
  at: [number, number];
  /** Along x, y and z. */
  force: [number, number, number];
}

/** The answer to a request that failed; of a design, with the curves that can be drawn. */
export interface Refusal {
  error: Fault;
  curves?: Curves;
  /** Of a drawn sheet. */
  drawing?: RefusedDrawing;
}

/** A drawn sheet that is refused, to be shown with what is wrong with it. */
export interface RefusedDrawing {
  /** From x, y to x, y. */
  lines: [number, number, number, number][];
  /** What each is, as in FOLD. */
  letters: string;
  marks: Mark[];
}

/** A change of the design that was tried and works. */
export interface Remedy {
  text: string;
  /** Values of keys of the design file, the tables in front of them; null removes a key. */
  changes: Record<string, unknown>;
}

/** All that ``report.json`` says of a shell. */
export interface Report {
  /** What was designed. */
  family: string;
  /** What was designed. */
  unit: string;
  /** What was designed. */
  rows: number;
  /** What was designed. */
  columns: number;
  /** What the family used and found. */
  parameters: Record<string, number | string | number[] | string[]>;
  /** What all families make of the target, if the file leaves the family open. */
  families: FamilyChoice | null;
  /** With which values of its keys the design file asks for the same shell by f and g, where these were fitted to a surface. */
  by_curves: Record<string, unknown>;
  /** How the rectangle of its surface is turned, if the file leaves that open. */
  turned: TurnChoice | null;
  /** How rows and columns were chosen, if there was a tolerance. */
  chosen: Choice | null;
  /** How its target was scaled, if sizes were asked for. */
  fitted: FittedSize | null;
  /** Whether it reaches its target without contact; None if that was not examined, or not proved. */
  feasible: boolean | null;
  /** How many motions its sheet has, of a sheet in pieces that of the piece that has most; None if that is not known. */
  degrees_of_freedom: number | null;
  /** What tells them, and what folds by itself. */
  freedom: FreedomOfSheet;
  /** Sentences a user should read. */
  warnings: string[];
  /** How exactly it folds; None if that was not measured. */
  residuals: Residuals | null;
  /** How exactly it folds; None if that was not measured. */
  assignment: AssignmentReport;
  /** How the motion ends. */
  lock: Lock;
  /** What was left out on request. */
  not_checked: string[];
  /** What it stands on; None if it cannot stand. */
  stands: Feet | null;
  /** How close it is to its target; None without one. */
  deviation: DeviationReport | null;
  /** What closes its ends. */
  end_walls: BuiltEndWall[];
  /** Size of the flat sheet. */
  sheet: SheetReport;
  /** The box around what folds, its boards where panels have a thickness; and around all that is built, with flaps that are clipped on. */
  deployed: BoxReport;
  /** The box around what folds, its boards where panels have a thickness; and around all that is built, with flaps that are clipped on. */
  outside: BoxReport;
  /** How it is deployed and held, and how small it packs. */
  deployment: DeploymentReport;
  /** What follows if it is cut with errors; None if the file gives none. */
  cutting: CuttingReport | null;
  /** Panels as they are built; None if they have no thickness. */
  panel: PanelReport | null;
  /** The shell as a structure; None if it was not analysed. */
  structure: Analysis | null;
  /** Bill of quantities. */
  quantities: Quantities;
  /** The findings, worst first. */
  verdict: Row[];
}

/** Worst departures from a rigid folding of a flat sheet, over the states measured. */
export interface Residuals {
  /** Change of the six distances of a panel's corners against the flat sheet, relative to the sheet's diagonal. */
  panel_length: number;
  /** Distance between a panel's two diagonals, relative to the sheet's diagonal. */
  planarity: number;
  /** Difference of the four sector angles at an inner vertex from 2 pi, or, where the sheet is not flat at drive 0, from what they are there (radians). */
  sector_sum_rad: number;
  /** Difference of the fold angles measured from the positions from the closed form (radians). */
  fold_angle_rad: number;
}

/** The last line of the answer: the verified shell. */
export interface Result {
  result: Verified;
}

/** A finding. */
export interface Row {
  /** What it means for the shell. */
  sign: "fails" | "warns" | "holds" | "says";
  /** What it is about, in a word. */
  subject: string;
  /** What was found, in a line. */
  finding: string;
  /** What mends it, which has been tried; empty if nothing was found that does. */
  remedy: string;
  /** The same as values of keys of the design file; empty where it is none of these. */
  changes: Record<string, unknown>;
  /** Whether anybody looked; if not, the finding says that nobody did. */
  known: boolean;
}

/** Faces and core of boards. */
export interface Sandwich {
  /** What is None is that of the material. */
  face: number | null;
  /** Of the core (force per area). */
  core_shear_modulus: number | null;
  /** Young's modulus of the core across the board (force per area). */
  core_modulus: number | null;
  /** What the core bears in shear, its design value; None if that is not known (force per area). */
  core_shear_strength: number | null;
}

/** How large something is in sheets that are cut with errors. */
export interface Scatter {
  /** Root mean square over sheets and places (length). */
  rms: number;
  /** The largest in a sheet, which 95 % of sheets do not exceed (length). */
  largest: number;
}

/** The last line of the answer: the search has come to its end. */
export interface SearchAnswer {
  result: SearchState;
}

/** A figure that a search can make small, or keep within limits. */
export interface SearchFigure {
  name: string;
  /** Its name in words. */
  words: string;
  /** Its unit, "{unit}" standing for that of lengths; empty where it has none. */
  unit: string;
  /** Whether it is there only where the design has a table [structure]. */
  of_structure: boolean;
  /** Its limit where the table [search] sets none; null if it has none then. */
  most: number | null;
}

/** A line of the answer: how far the search has come. */
export interface SearchFound {
  found: SearchState;
}

/** What a search can be for. */
export interface SearchInfo {
  figures: SearchFigure[];
  /** Designs that are made at most where the table [search] does not say it. */
  evaluations: number;
  /** The command that installs what a search needs; empty where that is installed. */
  install: string;
}

/** How far a search has come. */
export interface SearchState {
  objectives: Objective[];
  /** The design as it was opened; null if it cannot be made. */
  baseline: SearchedDesign | null;
  /** Those that keep all limits and were not sent before. */
  designs: SearchedDesign[];
  /** Those that no other beats, by their first objective. */
  front: FrontMember[];
  /** Place of the knee in the front; -1 where nothing is in it. */
  knee: number;
  /** Designs that were made, or cannot be, and of how many at most. */
  made: number;
  /** Designs that were made, or cannot be, and of how many at most. */
  total: number;
  /** Why designs cannot be made or break limits, the commonest reason first, and how many do. */
  refused: [string, number][];
}

/** A design that was made. */
export interface SearchedDesign {
  /** What keys of the design file have in it, the tables in front of them. */
  values: Record<string, unknown>;
  /** Its figures, by name. */
  figures: Record<string, number>;
}

/** Size of the flat sheet, or of the strips that it is made of. */
export interface SheetReport {
  /** Its bounding box, or that of the largest strip. */
  width: number;
  /** Its bounding box, or that of the largest strip. */
  height: number;
  /** Area of all panels. */
  area: number;
  /** How many strips there are; 0 for one sheet. */
  strips: number;
}

/** The drawings that a workshop gets, and what they come to. */
export interface Sheets {
  sheets: DrawnSheet[];
  unit: string;
  /** Those that are drawn somewhere, in the order of work. */
  layers: LayerPen[];
  /** What the palette is for. */
  palette: string;
  /** Sheets, waste, and length of cuts and creases, boards not counted. */
  stock: Waste;
  /** Sheets of stock for boards; null if there are none, or no stock. */
  boards: number | null;
  paper: PaperPages;
}

/** The last line of the answer: the drawings. */
export interface SheetsResult {
  result: Sheets;
}

/** A state on the way, and what moves the shell on from there. */
export interface Stage {
  /**  */
  drive_deg: number;
  /** What it takes to get there (force times metres). */
  work: number;
  /** Force on all feet of either side along their way; negative where they must be held back, None where none moves the shell. */
  force: number | null;
  /** How many people have that force, on either side; None where it or the mass is unknown. */
  people: number | null;
  /** Upward force on the row that is highest at the target, negative and None likewise. */
  lift: number | null;
  /** How many people lift with that force; None likewise. */
  lifting_people: number | null;
}

/** What it gains and costs to take a neighbour on the front instead. */
export interface Step {
  /** Number of the neighbour. */
  to: number;
  /** What it gains and costs. */
  words: string;
}

/** The largest stress in panels, averaged over patches of a fixed share of a panel. */
export interface Stress {
  /** Von Mises' stress. */
  size: number;
  /** Where. */
  panel: [number, number];
  /** On which face of the panel, upper as seen from +z on the flat sheet. */
  face: "lower" | "upper";
  /** The largest and the least principal stress of all panels: pull and pressure. */
  largest: number;
  /** The largest and the least principal stress of all panels: pull and pressure. */
  least: number;
}

/** What holds some vertices. */
export interface Support {
  /** The rows that are feet, the first and last columns, or vertices. */
  at: "feet" | "ends" | [number, number][];
  /** How they are held. */
  kind: "pinned" | "fixed" | "sliding" | "friction";
  /** Coefficient of friction of the ground, under ballast where that holds them. */
  friction: number;
  /** Whether edges of panels are held, too, whose ends are both among these vertices. */
  edges: boolean;
  /** Radius of what is held around each vertex, as a base plate does; 0 for points (length). */
  patch: number;
  /** Mass of the ballast that holds each of these vertices down; 0 where it is held otherwise (kg). */
  ballast: number;
}

/** The ground that a shell needs on its way to the target: it is proved to stay inside. */
export interface SweptGround {
  /** The corners of its outline. */
  outline: [number, number][];
  /** Size of the rectangle around it along x and y (length), and its area. */
  width: number;
  /** Size of the rectangle around it along x and y (length), and its area. */
  depth: number;
  /** Size of the rectangle around it along x and y (length), and its area. */
  area: number;
  /** The greatest height of a state, from its lowest place to its highest (length). */
  height: number;
  /** The drive at which it is so high. */
  highest_at_deg: number;
  /** How far parts get below the middle between the feet (length). */
  below: number;
  /** The drive at which they do. */
  lowest_at_deg: number;
  /** What outline and heights have in addition for the way between the states that were made. */
  margin: number;
  /** How many these are. */
  states: number;
}

/** A table of the design file in words. */
export interface TableWords {
  /** The section of the page that has its controls; empty where there is none. */
  label: string;
  keys: Record<string, KeyWords>;
}

/** A cable between two vertices of one column, taut at the target. */
export interface Tie {
  /** Its vertices by row and column of the whole grid. */
  ends: [[number, number], [number, number]];
  /** Their distance at the target, in the flat sheet, and at the end of the motion (length). */
  length: number;
  /** Their distance at the target, in the flat sheet, and at the end of the motion (length). */
  flat: number;
  /** Their distance at the target, in the flat sheet, and at the end of the motion (length). */
  packed: number;
  /** Whether it is proved that its vertices move apart all the way from the end of the motion to the flat sheet; None if the family does not say, or they are on whole boards. */
  grows: boolean | null;
  /** Whether it is proved to be slack from the end of the motion to the target; None where it is fixed there, to pieces that are joined. */
  slack: boolean | null;
  /** Where its vertices do not move apart, or are not proved to be nearer than at the target, nearest to the target. */
  fails_at_deg: number | null;
}

/** Sheets of many sizes, and the best of them. */
export interface Tradeoff {
  /** All sheets that were made, measured quickly, by panels. */
  tried: Trial[];
  /** Those that no other beats, or nearly so, in both error and number of panels, with edges as long as the design's tolerance allows, measured carefully. */
  best: Trial[];
  /** Number of sizes that the family refuses. */
  refused: number;
  /** Keys of the pattern, besides rows and columns, that the design leaves open, with the values that all trials have. */
  settled: Record<string, unknown>;
}

/** The last line of the answer: what fewer panels cost. */
export interface TradeoffResult {
  result: Tradeoff;
}

/** A design that was tried. */
export interface Trial {
  /** Inner vertices. */
  rows: number;
  /** Inner vertices. */
  columns: number;
  /** Number of panels, flaps left out. */
  panels: number;
  /** Distance between shell and target surface, largest both ways (length). */
  error: number;
  /** Edges of its panels in the flat sheet (length). */
  shortest: number;
  /** Edges of its panels in the flat sheet (length). */
  longest: number;
}

/** The turns that were tried, and the one that was taken: the nearest. */
export interface TurnChoice {
  /** That was taken (degrees). */
  turn_deg: number;
  tried: TurnTrial[];
}

/** A turn of the rectangle, and what comes of it. */
export interface TurnTrial {
  /** From x (degrees). */
  turn_deg: number;
  /** The largest distance between a shell of few panels and the surface, both ways (length); None if there is none. */
  distance: number | null;
  /** Why there is no shell. */
  why_not: string;
}

/** Shares of what is borne, by what can be borne. */
export interface Utilisation {
  /** Of their strength; None where that is not known. */
  panels: number | null;
  /** Of boards with a grain, shear in the plane, which is in the first, too, and rolling of plies. */
  panel_shear: number | null;
  /** Of boards with a grain, shear in the plane, which is in the first, too, and rolling of plies. */
  rolling_shear: number | null;
  /** Of boards with a core, shear of that, and the pressure at which faces wrinkle on it. */
  core_shear: number | null;
  /** Of boards with a core, shear of that, and the pressure at which faces wrinkle on it. */
  wrinkling: number | null;
  /** None, too, where panels have none. */
  membrane: number | null;
  /** Of the moments that they bear. */
  creases: number | null;
  /** Of the forces that creases bear as crease lines. */
  lines: number | null;
  /** None, too, where hinges have none. */
  arms: number | null;
  /** None, too, where there are none. */
  gussets: number | null;
  /** Likewise. */
  boxes: number | null;
  /** Of the forces that their hinges bear as crease lines. */
  box_lines: number | null;
  /** Of what edges of gussets and plates are held by. */
  plate_edges: number | null;
  /**  */
  ties: number | null;
  /** None, too, without base rails. */
  rail: number | null;
  /** Of the load at which the shell buckles; None if it does not. */
  buckling: number | null;
  /** The largest of these; None if there is none. */
  governs: "panels" | "panel_shear" | "rolling_shear" | "core_shear" | "wrinkling" | "membrane" | "creases" | "lines" | "arms" | "gussets" | "boxes" | "box_lines" | "plate_edges" | "ties" | "rail" | "buckling" | null;
}

/** A key of the design file that has a slider. */
export interface Variable {
  /** Its name in words. */
  label: string;
  /** Of its values; empty where they have none. */
  unit: string;
  /** Those that were tried, in the order of the slider. */
  values: unknown[];
  /** Where each lies on the slider, from 0 to 1. */
  shares: number[];
}

/** A design that was tried. */
export interface Variant {
  /** Number of its value, for each variable. */
  at: number[];
  /** Its figures; none if it cannot be made or breaks a limit. */
  figures: number[];
  /** The view of its shell, deflated, in base64; null if there is none. */
  view: string | null;
  /** Why there is none. */
  missing: string;
}

/** What a page of variants shows. */
export interface VariantsPage {
  /** The name of the design. */
  title: string;
  /** How many designs were tried, and of how many there is a shell. */
  said: string;
  variables: Variable[];
  /** Names of the figures. */
  figures: string[];
  variants: Variant[];
  /** Number of the one that is shown first. */
  first: number;
}

/** A shell that has been verified: its report, contact and distances. */
export interface Verified {
  report: Report;
  contact: FirstContact | null;
  /** Distances of the vertices from the surface: single precision, in base64; empty without one. */
  distance: string;
  /** Why the design is refused although its shell can be shown: panels meet before it locks. */
  refusal: Fault | null;
  /** Notes that a change may mend, which nobody has tried. */
  mendable: Mendable[];
  sizes: BuiltSizes;
  /** A view in base64 that takes the place of the one shown; null: that one stays. */
  view: string | null;
}

/** A line of the answer: what is known before the structure of the shell is. */
export interface VerifiedSoFar {
  found: Verified;
}

/** How much of stock or rolls is used, and how long cuts and creases are (document's unit). */
export interface Waste {
  /** Number of sheets of stock. */
  sheets: number;
  /** Their area; without stock, that of the sheet's bounding rectangle along the axes. */
  stock_area: number;
  /** Area of all parts, with tabs and strips. */
  used_area: number;
  /** Share of the stock that is not used. */
  waste: number;
  /** Length of all that is cut: outlines, cuts within them and relief holes. */
  cut_length: number;
  /** Length of all that is scored, engraved, or cut in dashes, along creases, those of tabs and strips too. */
  crease_length: number;
}

/** The largest of a force, and the load case that has it. */
export interface Worst {
  /** How large (N). */
  force: number;
  /** The load case; None where the force is 0 in all. */
  case: string | null;
}

/** The text of a design file, made from its tables. */
export interface Written {
  text: string;
}
