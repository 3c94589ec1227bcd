// Random queries: the same for the same seed, whatever the number of workers; what optimal planners say agrees.

import { expect, test } from 'vitest';
import { drawQueries, leastCost, sample, summaryOf } from '../engine/sampling';
import { plainFrame } from '../engine/types';
import { initialState, type MapDocument, type State } from '../store/state';
import { newEngine, randomFrom } from './engine';

const random = randomFrom(4);
const cells = Uint8Array.from({ length: 40 * 30 }, () => (random() < 0.3 ? 0 : random() < 0.05 ? 255 : 1));
const map: MapDocument = { name: '', width: 40, height: 30, frame: plainFrame, cells, version: 0 };
const state: State = { ...initialState, map, runs: ['astar', 'dijkstra', 'greedy'].map((planner) => ({ planner, options: {} })) };

test('queries lie on free cells, and differ by seed', () => {
  const queries = drawQueries(map, 500, 7);
  expect(queries).toEqual(drawQueries(map, 500, 7));
  expect(queries).not.toEqual(drawQueries(map, 500, 8));
  for (const place of queries.flatMap(({ start, goal }) => [start, goal])) {
    expect(cells[Math.floor(place.y) * 40 + Math.floor(place.x)]).toBe(1);
  }
  expect(new Set(queries.map(({ start }) => `${start.x} ${start.y}`)).size).toBeGreaterThan(200);
  expect(drawQueries({ ...map, cells: new Uint8Array(1200) }, 5, 1)).toEqual([]);
});

test('one worker and three answer alike', async () => {
  const queries = drawQueries(map, 60, 1);
  const one = await sample([await newEngine()], state, queries, () => true);
  const three = await sample(await Promise.all([newEngine(), newEngine(), newEngine()]), state, queries, () => true);
  const timeless = (all: typeof one) => all.map(({ answers }) => answers.map((each) => each && [each.cost, each.expanded]));
  expect(timeless(three)).toEqual(timeless(one));
  expect(one.length).toBe(60);
  const solved = one.filter(({ answers }) => answers[0]);
  expect(solved.length).toBeGreaterThan(20);
  for (const { answers } of solved) {
    expect(answers[1]!.cost).toBe(answers[0]!.cost);
    expect(answers[2]!.cost).toBeGreaterThanOrEqual(leastCost(answers));
  }
  expect(summaryOf(one, 0).ratio).toBe(1);
  expect(summaryOf(one, 2).ratio).toBeGreaterThan(1);
  expect(summaryOf(one, 1).expanded).toBeGreaterThan(summaryOf(one, 0).expanded);
});

test('it stops when it is told to', async () => {
  const some = await sample([await newEngine()], state, drawQueries(map, 60, 1), (done) => done < 5);
  expect(some.length).toBe(5);
});
