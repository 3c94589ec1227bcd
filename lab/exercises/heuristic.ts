// "Which heuristic is this?": the visitor sees what a search expanded, and names the estimate that it used.

import type { PlannerInfo } from '../engine/types';
import type { Choice } from '../store/state';
import { scored, type Score } from './score';

const planner = 'astar';

/** The estimates that can be asked about, of those that the registry names. */
export function heuristics(planners: readonly PlannerInfo[]): string[] {
  const choices = planners.find(({ name }) => name === planner)?.options.find(({ name }) => name === 'heuristic')?.choices ?? [];
  return choices.filter((name) => name in marks);
}

/** The estimate of a search; 'auto' is the exact one of its moves. */
export function heuristicOf(run: Choice): string {
  const given = run.options['heuristic'];
  if (given !== undefined && given !== 'auto') return given;
  return run.options['connectivity'] === '4' ? 'manhattan' : 'octile';
}

/** The search to ask about: as it is, if it is that of A*; else A* as it usually is. */
export function asked(run: Choice | undefined): Choice {
  return run?.planner === planner ? run : { planner, options: {} };
}

/** The same search with another estimate: which one, `draw` says, from 0 up to 1. */
export function another(run: Choice, planners: readonly PlannerInfo[], draw: number): Choice {
  const others = heuristics(planners).filter((name) => name !== heuristicOf(run));
  return { ...run, options: { ...run.options, heuristic: others[Math.floor(draw * others.length)] ?? 'octile' } };
}

/** Compares a name with the truth. Estimates that expand the same cells at the same costs are equally right. */
export function named(name: string, truth: string, same: boolean, score: Score): Score {
  if (name === truth) return scored(score, true, `Right: ${name}. ${marks[truth] ?? ''}`);
  if (same) return scored(score, true, `Right: ${name} expands the same cells here as ${truth}, which it was.`);
  return scored(score, false, `No: not ${name}. ${marks[name] ?? ''}`);
}

/** How one sees it. */
const marks: Record<string, string> = {
  zero: 'Without an estimate, the search spreads evenly: it is Dijkstra’s algorithm.',
  manhattan: 'It counts straight steps only. Where diagonal steps are allowed it is too large, so the search is narrow and may miss the cheapest path.',
  euclidean: 'It is the straight line: never too large, but smaller than a path of steps, so the search is wider than with octile.',
  octile: 'It is the exact cost without obstacles, so the search is narrow and finds the cheapest path.',
};
