// Random queries on a map, by several planners: for the scatter of the charts. Workers share the queries.

import { specOf, type Choice, type MapDocument, type Place, type State } from '../store/state';
import { centreOf } from '../store/state';
import { obstacle, unknown, type Failure, type Outcome, type Task } from './types';
import type { EngineModule } from './module';

/** What a worker of the page does for it; also an EngineModule itself. */
export interface Planning {
  load(...args: Parameters<EngineModule['load']>): Promise<unknown> | unknown;
  robot(...args: Parameters<EngineModule['robot']>): Promise<unknown> | unknown;
  plan(task: Task): Promise<Outcome | Failure> | Outcome | Failure;
}

export interface Ends {
  start: Place;
  goal: Place;
}

/** A query, and what each planner made of it: null if it found no path. */
export interface Sample extends Ends {
  answers: ({ cost: number; expanded: number; seconds: number } | null)[];
}

/** Seconds that a search may take. */
const patience = 10;

/** Pairs of free cells, drawn from a seed; none if no cell is free. */
export function drawQueries(map: MapDocument, count: number, seed: number): Ends[] {
  const free: number[] = [];
  map.cells.forEach((cell, i) => { if (cell !== obstacle && cell !== unknown) free.push(i); });
  if (free.length === 0) return [];
  let state = seed >>> 0;
  const draw = (): Place => {
    // Numbers of a linear congruence: their upper bits are good enough to pick cells.
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const index = free[Math.floor((state / 2 ** 32) * free.length)]!;
    return centreOf(index % map.width, Math.floor(index / map.width));
  };
  return Array.from({ length: count }, () => ({ start: draw(), goal: draw() }));
}

/**
 * Answers the queries with all planners, each worker one query after another. `tell` gets the number that is done; if it
 * returns false, the rest is left out.
 */
export async function sample(
  workers: Planning[], state: State, queries: Ends[], tell: (done: number) => boolean,
): Promise<Sample[]> {
  const samples: Sample[] = new Array<Sample>(queries.length);
  const map = state.map!;
  let next = 0;
  let done = 0;
  let going = true;
  await Promise.all(workers.map(async (worker) => {
    await worker.load(map.cells, map.width, map.height, map.frame);
    await worker.robot(state.footprint, state.robotFields);
    while (going && next < queries.length) {
      const index = next++;
      const answers: Sample['answers'] = [];
      for (const run of state.runs) answers.push(await answerOf(worker, run, queries[index]!));
      samples[index] = { ...queries[index]!, answers };
      going = tell(++done) && going;
    }
  }));
  return samples.filter((each) => each !== undefined);
}

async function answerOf(worker: Planning, run: Choice, { start, goal }: Ends): Promise<Sample['answers'][number]> {
  const outcome = await worker.plan({
    planner: specOf(run.planner, run.options), start, goal, headings: false, record: false,
    fields: { nearest: 'true', time_limit: String(patience) },
  });
  if ('error' in outcome || outcome.cost === undefined) return null;
  return { cost: outcome.cost, expanded: outcome.expanded, seconds: outcome.seconds };
}

/** What the samples say of each planner. */
export interface Summary {
  solved: number;
  expanded: number;  // median
  seconds: number;  // median
  /** The mean of the cost over the least cost of any of the planners. */
  ratio: number;
}

export function summaryOf(samples: Sample[], run: number): Summary {
  const solved = samples.filter(({ answers }) => answers[run]);
  const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
  const ratios = solved.map(({ answers }) => {
    const least = leastCost(answers);
    return least > 0 ? answers[run]!.cost / least : 1;
  });
  return {
    solved: solved.length,
    expanded: median(solved.map(({ answers }) => answers[run]!.expanded)),
    seconds: median(solved.map(({ answers }) => answers[run]!.seconds)),
    ratio: ratios.reduce((sum, each) => sum + each, 0) / ratios.length,
  };
}

export function leastCost(answers: Sample['answers']): number {
  return Math.min(...answers.map((answer) => answer?.cost ?? Infinity));
}
