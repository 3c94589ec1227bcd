// What the engine takes and answers. lab/wasm/answers.cpp and registry_text.cpp write it.

export interface OptionInfo {
  name: string;
  kind: 'flag' | 'integer' | 'number' | 'choice';
  default: string;
  help: string;
  least: number;
  /** null: no limit. */
  greatest: number | null;
  choices: string[];
}

/** What is set of a robot or a request by name. */
export interface FieldInfo extends OptionInfo {
  /** "m", "rad", "s" or empty; metres are cells on a map without them. */
  unit: string;
}

export interface PlannerInfo {
  name: string;
  summary: string;
  idea: string;
  citation: string;
  guarantee: string;
  guaranteeText: string;
  when: string;
  terrain: string;
  headings: boolean;
  canStep: boolean;
  /** A search goes on from the last one; the command line shows no layers of it. */
  resumes: boolean;
  /** Its states lie on corners of cells, not in their middle. */
  onVertices: boolean;
  needsIndex: boolean;
  options: OptionInfo[];
}

export interface GeneratorInfo {
  name: string;
  summary: string;
  leastWidth: number;
  leastHeight: number;
  defaultWidth: number;
  defaultHeight: number;
  freeCorner: number;
  options: OptionInfo[];
}

export interface SmootherInfo {
  name: string;
  summary: string;
  citation: string;
  /** For paths of poses, and only these. */
  drives: boolean;
  options: OptionInfo[];
}

export interface ControllerInfo {
  name: string;
  summary: string;
  citation: string;
  turnsInPlace: boolean;
  options: OptionInfo[];
}

export interface Registry {
  version: string;
  planners: PlannerInfo[];
  generators: GeneratorInfo[];
  smoothers: SmootherInfo[];
  controllers: ControllerInfo[];
  robotFields: FieldInfo[];
  requestFields: FieldInfo[];
}

/** How the cells lie in the world. Row 0 of the cells is drawn last if yUp is set. */
export interface Frame {
  resolution: number;
  originX: number;
  originY: number;
  /** Radians. */
  originYaw: number;
  yUp: boolean;
  metric: boolean;
}

export const plainFrame: Frame = { resolution: 1, originX: 0, originY: 0, originYaw: 0, yUp: false, metric: false };

export interface MapInfo extends Frame {
  width: number;
  height: number;
}

/** A request that could not be carried out; nothing has changed. */
export interface Failure {
  status: string;
  error: string;
}

/** A pose in grid coordinates: a cell has the size 1; the heading is in radians. */
export interface Pose {
  x: number;
  y: number;
  heading: number;
}

export interface Task {
  planner: string;
  smoother?: string;
  start: Pose;
  goal: Pose;
  /** Does the goal's heading count? */
  headings: boolean;
  /** Write the search down, for a replay? */
  record: boolean;
  /** What else is asked: see Registry.requestFields. */
  fields?: Record<string, string>;
}

/** A length as a number and in words. */
export interface Length {
  metres: number;
  text: string;
}

/** A path that an anytime planner found on the way: see docs/anytime.md. */
export interface Solution {
  cost: number;
  /** Its cost is at most this times the least; null: no guarantee. */
  bound: number | null;
  /** The expansions until then. */
  step: number;
  /** As Outcome.path. */
  path: Float64Array;
}

export interface Outcome {
  status: string;
  /** Why there is no path. */
  message?: string;
  cost?: number;
  /** null: no guarantee. */
  bound?: number | null;
  length?: number;
  notes?: string[];
  /** How the path begins if the robot does not fit at the start; the cost is that of the rest. */
  wayOut?: Length;
  /** The points of the path up to the first free one. */
  wayOutPoints?: number;
  /** From the path's end to the goal, if the closest place was asked for. */
  remaining?: Length;
  expanded: number;
  generated: number;
  maxFrontier: number;
  seconds: number;
  /** The steps that can be replayed. */
  steps: number;
  /** x, y and heading of each point, in grid coordinates. */
  path: Float64Array;
  /** Of a recorded search of an anytime planner; the last one is the answer. */
  solutions: Solution[];
}

/** The path that is known at a step of a replay; null: none yet. */
export function pathAt(outcome: Outcome, step: number): Float64Array | null {
  if (step >= outcome.steps) return outcome.path;
  return outcome.solutions.findLast((solution) => solution.step <= step)?.path ?? null;
}

export interface CellInfo {
  byte: number;
  clearance: number | null;
  terrain: number;
  blocked?: string;
  /** The step of its expansion, from 1; 0: never. */
  expansion?: number;
  generation?: number;
  g?: number | null;
  h?: number | null;
  f?: number | null;
  /** The chain of parents to the start, as points. */
  chain: Float64Array;
}

/** Where the robot fits, near both ends. */
export interface Places {
  start: Pose;
  goal: Pose;
}

/** The largest robot that gets from the start to the goal, in cells, and its narrowest place. */
export type Widest = { joined: false } | {
  joined: true;
  /** null: no obstacle limits it. */
  radius: number | null;
  x: number;
  y: number;
  path: Float64Array;
};

/** A simulated drive along the last path. Metres, seconds, radians. */
export interface DriveReport {
  outcome: string;
  told: string;
  time: number;
  distance: number;
  rms: number;
  largest: number;
  finalError: number;
  swings: number;
  oscillates: boolean;
  /** Seven numbers for each command: see sampleSize. */
  samples: Float64Array;
}
/** Time, x, y, heading (grid coordinates), speed, distance from the path to the left, heading error. */
export const sampleSize = 7;

/** What a search knew of each cell, for a trace of it. */
export interface Knowledge {
  expansion: Uint32Array;
  generation: Uint32Array;
  parent: Uint32Array;
  /** g, h and f of each cell. */
  known: Float32Array;
}

export interface Window {
  width: number;
  height: number;
  /** The cell at the left and the top, and the cells that a pixel covers. */
  left: number;
  top: number;
  cells: number;
}

export interface Range {
  least: number;
  greatest: number;
}

export const obstacle = 0;
export const unknown = 255;

/** Names of layers that the engine computes; '' shows what the search did. */
export type Layer = '' | 'expansion' | 'g' | 'h' | 'f' | 'cost' | 'clearance';
