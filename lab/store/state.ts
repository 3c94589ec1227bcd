// State: everything that the page shows and that a link carries. Values; the store replaces them.

import type { Frame, Layer } from '../engine/types';

/** A recipe for a map: the same recipe gives the same map everywhere. */
export interface Recipe {
  generator: string;
  options: Record<string, string>;
  width: number;
  height: number;
  seed: number;
}

export interface MapDocument {
  name: string;
  width: number;
  height: number;
  frame: Frame;
  /** A byte a cell, see lab/wasm/cells.hpp. Strokes change it in place and count up `version`. */
  cells: Uint8Array;
  version: number;
  /** What it was made from, and the cells as they were then. */
  recipe?: Recipe;
  original?: Uint8Array;
}

/** A place in grid coordinates, with a heading in radians. */
export interface Place {
  x: number;
  y: number;
  heading: number;
}

export interface Choice {
  planner: string;
  options: Record<string, string>;
}

export type Tool = 'wall' | 'cost' | 'erase' | 'look' | 'break';
export type Pace = 'expansions' | 'time';

/** The exercises of lab/exercises; empty: none. */
export const exercises = ['', 'next', 'heuristic', 'greedy'] as const;
export type Exercise = (typeof exercises)[number];

/** How a simulated robot follows the path, as the engine takes it. An empty controller: it does not. */
export interface Following {
  controller: string;
  robot: string;
  simulation: string;
}

export const notFollowing: Following = { controller: '', robot: 'robot', simulation: 'simulation' };

export interface State {
  map: MapDocument | null;
  start: Place;
  goal: Place;
  /** One to four, side by side. */
  runs: Choice[];
  /** "point", "disc:0.3" or the corners of a polygon, in metres; in cells on a map without a resolution. */
  footprint: string;
  /** A smoother and its options, as the command line takes them; empty: none. */
  smoother: string;
  /** Does the heading of the goal count? */
  headings: boolean;
  /** What else is set of the robot, and of the request: fields of the registry, with lengths in units of the footprint. */
  robotFields: Record<string, string>;
  requestFields: Record<string, string>;
  layer: Layer;
  arrows: boolean;
  tool: Tool;
  brush: number;
  /** The cost that the brush paints. */
  cost: number;
  pace: Pace;
  /** The exercise that the page asks; empty: none. */
  exercise: Exercise;
  following: Following;
  /** Is the widest path shown? */
  widest: boolean;
  /** A replay stops where this cell is expanded. */
  breakPoint: { x: number; y: number } | null;
}

export const initialState: State = {
  map: null,
  start: { x: 1.5, y: 1.5, heading: 0 },
  goal: { x: 1.5, y: 1.5, heading: 0 },
  runs: [{ planner: 'astar', options: {} }],
  footprint: 'point',
  smoother: '',
  headings: false,
  robotFields: {},
  requestFields: {},
  layer: '',
  arrows: false,
  tool: 'wall',
  brush: 1,
  cost: 5,
  pace: 'expansions',
  exercise: '',
  following: notFollowing,
  widest: false,
  breakPoint: null,
};

/** Fields that the page sets by itself: the robot's shape, ends that it moves, its patience; and those that only a program needs. */
export const fieldsOfThePage: ReadonlySet<string> = new Set(['robot_radius', 'nearest', 'nearest_limit', 'time_limit', 'keep', 'explain', 'from_field']);

/** May a path begin with a way out of a blocked start? */
export const leadsOut = ({ requestFields }: State): boolean => Number(requestFields['escape'] ?? 0) > 0;
/** Does a path end at the closest place if none reaches the goal? */
export const endsAtClosest = ({ requestFields }: State): boolean => requestFields['closest'] === 'true';

/** "astar:weight=2,heuristic=euclidean", as the command line takes it. */
export function specOf(name: string, options: Record<string, string>): string {
  const words = Object.entries(options).map(([option, value]) => `${option}=${value}`);
  return words.length === 0 ? name : `${name}:${words.join(',')}`;
}

/** The words of a spec: "pid:kp=1,ki=2" has the name pid. */
export function readSpec(spec: string): { name: string; options: Record<string, string> } {
  const [name, list = ''] = spec.split(/:(.*)/s) as [string, string?];
  const pairs = list.split(',').filter((pair) => pair.includes('=')).map((pair) => pair.split('=', 2) as [string, string]);
  return { name, options: Object.fromEntries(pairs) };
}

export function centreOf(x: number, y: number): Place {
  return { x: x + 0.5, y: y + 0.5, heading: 0 };
}
