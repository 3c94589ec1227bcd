// A search as a trace for Posthoc (version 1.4.0), as wend/report/posthoc_trace.cpp writes it. The page keeps of each cell
// what the search knew of it last, so g, h, f and the parent of an event are the last ones, and events of costs that fall
// are left out.

import { obstacle, type Knowledge } from '../engine/types';
import type { MapDocument, Place } from '../store/state';

const none = 0xffffffff;
/** More events make files that Posthoc cannot open. */
export const mostEvents = 500_000;

const views = {
  main: [
    {
      $: 'rect', $if: "${{ $.type == 'map' }}", $for: { $let: 'i', $from: 0, $to: '${{ $.blocked.length }}', $step: 1 },
      x: '${{ $.blocked[$.i][0] }}', y: '${{ $.blocked[$.i][1] }}', width: '${{ $.blocked[$.i][2] }}', height: '${{ $.blocked[$.i][3] }}',
      fill: '${{ theme.foreground }}',
    },
    { $: 'rect', $if: "${{ $.type != 'map' }}", x: '${{ $.x }}', y: '${{ $.y }}', width: 1, height: 1, fill: '${{ color[$.type] }}' },
  ],
};

/** The trace of a search: `expansions` are the cells in their order. */
export function posthocTrace(
  map: MapDocument, start: Place, goal: Place, expansions: Uint32Array, knowledge: Knowledge, found: boolean,
): string {
  const { width, height, frame } = map;
  const events: Record<string, unknown>[] = [];
  const blocked = blockedRuns(map);
  if (blocked.length > 0) events.push({ type: 'map', id: 'map', blocked });
  const rowOf = (y: number) => (frame.yUp ? height - 1 - y : y);
  const indexOf = ({ x, y }: Place) => Math.floor(y) * width + Math.floor(x);
  const at = (type: string, index: number) => ({ type, id: index, x: index % width, y: rowOf(Math.floor(index / width)) });
  const parentOf = (index: number) => (knowledge.parent[index] === none ? null : knowledge.parent[index]!);
  const told = (type: string, index: number) => {
    const [g, h, f] = knowledge.known.subarray(3 * index, 3 * index + 3);
    const number = (value: number | undefined) => (value !== undefined && Number.isFinite(value) ? value : null);
    return { ...at(type, index), pId: parentOf(index), f: number(f), g: number(g), h: number(h) };
  };
  const reached = reachedAt(knowledge.generation, expansions.length);
  events.push(at('source', indexOf(start)), at('destination', indexOf(goal)));
  if (expansions.length > 0) events.push(told('generating', indexOf(start)));
  for (let step = 1; step <= expansions.length && events.length < mostEvents; ++step) {
    const cell = expansions[step - 1]!;
    events.push(told('expanding', cell));
    for (const index of reached.of(step)) if (index !== indexOf(start)) events.push(told('generating', index));
    events.push(at('closing', cell));
  }
  if (found) events.push({ ...at('end', indexOf(goal)), pId: parentOf(indexOf(goal)) });
  return JSON.stringify({ version: '1.4.0', schema: 1, views, pivot: { x: '${{ $.x + 0.5 }}', y: '${{ $.y + 0.5 }}', scale: 1 }, events });
}

/** The cells that were reached at each step, in a list for all steps. */
function reachedAt(generation: Uint32Array, steps: number): { of(step: number): Uint32Array } {
  const begin = new Uint32Array(steps + 2);
  for (const step of generation) if (step > 0 && step <= steps) ++begin[step + 1]!;
  for (let step = 1; step < begin.length; ++step) begin[step]! += begin[step - 1]!;
  const cells = new Uint32Array(begin[steps + 1]!);
  const next = begin.slice();
  generation.forEach((step, index) => { if (step > 0 && step <= steps) cells[next[step]!++] = index; });
  return { of: (step) => cells.subarray(begin[step]!, begin[step + 1]!) };
}

/** Obstacles as x, y, width and height: runs of a row, joined with equal ones of the row before. */
function blockedRuns({ width, height, cells, frame }: MapDocument): number[][] {
  const all: number[][] = [];
  let above = new Map<string, number[]>();
  for (let row = 0; row < height; ++row) {
    const y = frame.yUp ? height - 1 - row : row;
    const here = new Map<string, number[]>();
    for (let x = 0; x < width;) {
      const begin = x;
      while (x < width && cells[y * width + x] === obstacle) ++x;
      if (x > begin) {
        const key = `${begin} ${x}`;
        const run = above.get(key) ?? [begin, row, x - begin, 0];
        if (run[3] === 0) all.push(run);
        ++run[3]!;
        here.set(key, run);
      } else {
        ++x;
      }
    }
    above = here;
  }
  return all;
}
