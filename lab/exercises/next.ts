// "What is expanded next?": the visitor names a cell, the search answers, and the page keeps score.

import type { CellInfo, Failure } from '../engine/types';
import { scored, type Score } from './score';

/** What a search tells for an answer; EngineModule has it. */
export interface Told {
  expandedAt(step: number): Promise<number> | number;
  cell(x: number, y: number): Promise<CellInfo | Failure> | CellInfo | Failure;
}

/** Compares a cell with the expansion after `step`, which the search must have. */
export async function guess(told: Told, width: number, step: number, cell: { x: number; y: number }, score: Score): Promise<Score> {
  const next = await told.expandedAt(step + 1);
  const at = { x: next % width, y: Math.floor(next / width) };
  const [named, truth] = await Promise.all([told.cell(cell.x, cell.y), told.cell(at.x, at.y)]);
  const right = at.x === cell.x && at.y === cell.y;
  return scored(score, right, right ? `Right. ${why(truth)}` : `No: (${at.x}, ${at.y}) is next. ${why(truth)} ${whyNot(named, step)}`);
}

function why(info: CellInfo | Failure): string {
  if ('error' in info || typeof info.f !== 'number') return '';
  const { g, h, f } = info;
  return `Its priority f is ${text(f)}${typeof g === 'number' && typeof h === 'number' && h > 0 ? `, with g ${text(g)} and h ${text(h)}` : ''}.`;
}

function whyNot(info: CellInfo | Failure, step: number): string {
  if ('error' in info) return '';
  if (info.blocked) return `Your cell is blocked: ${info.blocked}.`;
  if (!info.generation || info.generation > Math.max(step, 1)) return 'Your cell has not been reached: it is not in the frontier.';
  if (info.expansion && info.expansion <= step) return 'Your cell has been expanded already.';
  return typeof info.f === 'number' ? `Your cell is in the frontier, with f ${text(info.f)}.` : 'Your cell is in the frontier.';
}

function text(value: number): string {
  return value.toLocaleString('en', { maximumFractionDigits: 3 });
}
