// What the engine takes and answers. lab/wasm/answers.cpp and registry_text.cpp write it.

export interface OptionInfo {
  name: string;
  kind: 'flag' | 'integer' | 'number' | 'choice';
  default: string;
  help: string;
  least: number;
  greatest: number;
  choices: string[];
}

export interface PlannerInfo {
  name: string;
  summary: string;
  idea: string;
  citation: string;
  guarantee: string;
  guaranteeText: string;
  when: string;
  time: string;
  memory: string;
  costName: string;
  motion: string;
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

export interface Registry {
  version: string;
  planners: PlannerInfo[];
  generators: GeneratorInfo[];
  smoothers: SmootherInfo[];
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
  nearest?: boolean;
  /** The most expansions and seconds; 0: no limit. */
  expansions?: number;
  seconds?: number;
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
  expanded: number;
  generated: number;
  maxFrontier: number;
  seconds: number;
  /** The steps that can be replayed. */
  steps: number;
  /** x, y and heading of each point, in grid coordinates. */
  path: Float64Array;
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
