// The exercise against the search itself: naming the cells in the order of expansion is always right, any other is not.

import { expect, test } from 'vitest';
import { plainFrame } from '../engine/types';
import { guess, noScore } from '../exercises/next';
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
