// "Break greedy": the visitor paints obstacles so that greedy's path costs as many times the cheapest as possible.

import type { Choice } from '../store/state';

export const runs: Choice[] = [{ planner: 'greedy', options: {} }, { planner: 'astar', options: {} }];
/** The cells that may be changed, and how many times the cheapest counts as broken. */
export const budget = 40;
export const wanted = 1.3;

export interface Attempt {
  /** Cost of greedy's path over the lowest cost; null: no path, or no answer yet. */
  ratio: number | null;
  changed: number;
}

export function changedCells(before: Uint8Array, now: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < now.length; ++i) if (now[i] !== before[i]) ++count;
  return count;
}

/** Does an attempt count? It stays in the budget and leaves a path. */
export function counts({ ratio, changed }: Attempt): boolean {
  return ratio !== null && changed <= budget;
}

export function told(attempt: Attempt, best: number): string {
  const { ratio, changed } = attempt;
  const cells = `${changed} of ${budget} cells changed.`;
  if (changed > budget) return `${cells} That is too many: take some back.`;
  if (ratio === null) return `${cells} There is no path, so this attempt does not count.`;
  const now = `Greedy pays ${ratio.toFixed(2)} times the cheapest. ${cells}`;
  return best >= wanted ? `${now} Greedy is broken: ${best.toFixed(2)} times is your best.` : `${now} Make it ${wanted} times.`;
}
