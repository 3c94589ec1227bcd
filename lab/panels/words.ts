// Outcomes and cells in words.

import { obstacle, unknown, type CellInfo, type Failure, type Outcome, type Places } from '../engine/types';
import type { State } from '../store/state';
import type { Point } from '../view/camera';
import { sentence } from './option_field';

export function number(value: number, digits = 2): string {
  return value.toLocaleString('en', { maximumFractionDigits: digits });
}

/** "0.8 ms" */
export function duration(seconds: number): string {
  // Browsers count in tenths of milliseconds.
  if (seconds < 1e-4) return '< 0.1 ms';
  return seconds < 1 ? `${number(seconds * 1000, 1)} ms` : `${number(seconds, 2)} s`;
}

/** For the live text: how a search ended. */
export function outcomeInWords(planner: string, outcome: Outcome | null, failure: Failure | null): string {
  if (failure) return `${planner}: ${failure.error}.`;
  if (!outcome) return `${planner} is searching.`;
  const work = `${number(outcome.expanded)} expanded`;
  if (outcome.status !== 'found') return `${planner}: ${sentence(outcome.message ?? outcome.status)} ${sentence(work)}`;
  const found = `${planner}: found a path of cost ${number(outcome.cost!, 4)}, ${work}.`;
  return [found, ...(outcome.notes ?? []).map((note) => sentence(note))].join(' ');
}

/** By how much the ends of a state are moved; empty if they are not. */
export function movedInWords({ map, start, goal }: State, moved: Places): string {
  const { metric, resolution } = map!.frame;
  const parts = ([['start', start, moved.start], ['goal', goal, moved.goal]] as const).flatMap(([name, from, to]) => {
    const cells = Math.hypot(to.x - from.x, to.y - from.y);
    if (cells < 1e-9) return [];
    return [`the ${name} is moved by ${metric ? `${number(cells * resolution)} m` : `${number(cells)} ${cells === 1 ? 'cell' : 'cells'}`}`];
  });
  return parts.length === 0 ? '' : `The robot does not fit there: ${parts.join(' and ')}.`;
}

function groundInWords(info: CellInfo): string {
  if (info.byte === obstacle) return 'obstacle';
  if (info.byte === unknown) return 'unknown';
  return info.terrain > 1 ? `free, costs ${number(info.terrain)} times as much` : 'free';
}

/** Everything about a cell at a step of the search, as lines of a name and a value. */
export function cellInWords(cell: Point, info: CellInfo, step: number): [string, string][] {
  const lines: [string, string][] = [[`Cell (${cell.x}, ${cell.y})`, groundInWords(info)]];
  if (info.blocked) lines.push(['Blocked', info.blocked]);
  else if (info.clearance !== null) lines.push(['Clearance', `${number(info.clearance)} cells`]);
  if (info.generation && info.generation <= step) {
    const { g, h, f } = info;
    const expanded = info.expansion && info.expansion <= step;
    lines.push(['Search', expanded ? `expanded as number ${number(info.expansion!)}` : 'in the frontier']);
    if (typeof g === 'number') lines.push(['g, from the start', number(g, 3)]);
    if (typeof h === 'number') lines.push(['h, estimate to the goal', number(h, 3)]);
    if (typeof f === 'number') lines.push(['f, priority', number(f, 3)]);
  } else if (!info.blocked) {
    lines.push(['Search', 'not reached so far']);
  }
  return lines;
}
