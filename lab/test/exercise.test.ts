// The exercise against the search itself: naming the cells in the order of expansion is always right, any other is not.

import { expect, test } from 'vitest';
import * as greedy from '../exercises/greedy';
import * as heuristic from '../exercises/heuristic';
import { plainFrame } from '../engine/types';
import { guess } from '../exercises/next';
import { noScore } from '../exercises/score';
import { good, newEngine } from './engine';

test('only the next expansion is right', async () => {
  const engine = await newEngine();
  const width = 9;
  good(engine.load(new Uint8Array(width * 9).fill(1), width, 9, plainFrame));
  for (const planner of ['astar', 'bfs', 'greedy']) {
    const { steps } = good(engine.plan({
      planner, record: true, headings: false, start: { x: 0.5, y: 4.5, heading: 0 }, goal: { x: 8.5, y: 4.5, heading: 0 },
    }));
    const order = [...engine.expansions()];
    let score = noScore;
    for (let step = 1; step < steps; ++step) {
      score = await guess(engine, width, step, { x: order[step]! % width, y: Math.floor(order[step]! / width) }, score);
      expect(score.said, planner).toMatch(/^Right/);
      const before = { x: order[step - 1]! % width, y: Math.floor(order[step - 1]! / width) };
      const wrong = await guess(engine, width, step, before, score);
      expect(wrong).toMatchObject({ right: score.right, asked: score.asked + 1 });
      expect(wrong.said, planner).toMatch(/^No: .*expanded already/);
    }
    expect(score).toMatchObject({ right: steps - 1, asked: steps - 1 });
  }
});

test('the heuristics that are asked about exist, differ on a map, and have a mark each', async () => {
  const engine = await newEngine();
  const { planners } = engine.registry();
  const names = heuristic.heuristics(planners);
  expect(names).toEqual(expect.arrayContaining(['zero', 'manhattan', 'euclidean', 'octile']));
  good(engine.generate('rooms', 41, 21, 3));
  const expanded = names.map((name) => good(engine.plan({
    planner: `astar:heuristic=${name}`, record: true, headings: false,
    start: { x: 1.5, y: 1.5, heading: 0 }, goal: { x: 39.5, y: 19.5, heading: 0 },
  })).expanded);
  expect(new Set(expanded).size).toBe(names.length);
  for (const name of names) expect(heuristic.named(name, name, false, noScore)).toMatchObject({ right: 1, asked: 1, said: expect.stringMatching(/^Right: \w+\. \w/) });
});

test('only the heuristic of the search is right, or one that expands the same cells', () => {
  expect(heuristic.heuristicOf({ planner: 'astar', options: {} })).toBe('octile');
  expect(heuristic.heuristicOf({ planner: 'astar', options: { connectivity: '4', heuristic: 'auto' } })).toBe('manhattan');
  expect(heuristic.named('zero', 'octile', false, noScore)).toMatchObject({ right: 0, asked: 1, said: expect.stringMatching(/^No: not zero/) });
  expect(heuristic.named('zero', 'octile', true, noScore)).toMatchObject({ right: 1, asked: 1 });
});

test('another heuristic is never the same one', async () => {
  const { planners } = (await newEngine()).registry();
  for (const draw of [0, 0.3, 0.6, 0.999]) {
    for (const name of heuristic.heuristics(planners)) {
      const next = heuristic.another({ planner: 'astar', options: { heuristic: name, weight: '2' } }, planners, draw);
      expect(next.options['heuristic']).not.toBe(name);
      expect(next.options['weight']).toBe('2');
    }
  }
});

test('greedy is broken within the budget only, and where there is a path', () => {
  const before = new Uint8Array(100).fill(1);
  const after = before.slice();
  after.fill(0, 0, 41);
  expect(greedy.changedCells(before, after)).toBe(41);
  expect(greedy.counts({ ratio: 9, changed: 41 })).toBe(false);
  expect(greedy.counts({ ratio: null, changed: 1 })).toBe(false);
  expect(greedy.counts({ ratio: 1.2, changed: 40 })).toBe(true);
  expect(greedy.told({ ratio: 1.2, changed: 40 }, 1.2)).toMatch(/Make it 1.3 times/);
  expect(greedy.told({ ratio: 1.2, changed: 40 }, 1.6)).toMatch(/broken: 1.60 times/);
});

test('a cup before the goal breaks greedy within the budget', async () => {
  const engine = await newEngine();
  good(engine.generate('random:density=0', 41, 21, 1));
  const before = engine.cells();
  const cup: number[] = [];
  for (let y = 2; y < 19; ++y) cup.push(y * 41 + 25);
  for (let x = 19; x < 25; ++x) cup.push(2 * 41 + x, 18 * 41 + x);
  good(engine.edit(cup, cup.map(() => 0)));
  const [greedyCost, best] = greedy.runs.map(({ planner }) => good(engine.plan({
    planner, record: false, headings: false, start: { x: 5.5, y: 10.5, heading: 0 }, goal: { x: 35.5, y: 10.5, heading: 0 },
  })).cost!);
  const attempt = { ratio: greedyCost! / best!, changed: greedy.changedCells(before, engine.cells()) };
  expect(greedy.counts(attempt)).toBe(true);
  expect(attempt.ratio).toBeGreaterThanOrEqual(greedy.wanted);
});
