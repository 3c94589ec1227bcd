// A replay after another: an engine that has searched tells and draws the same as a new one.

import { readFile } from 'node:fs/promises';
import { expect, test } from 'vitest';
import { EngineModule } from '../engine/module';
import { plainFrame } from '../engine/types';
import { light, paletteOf } from '../view/palette';
import { good, randomFrom, root } from './engine';

test('nothing of an earlier search is left in a later one', async () => {
  const module = await WebAssembly.compile(await readFile(`${root}build/lab/wend.wasm`));
  const used = await EngineModule.from(module);
  used.setPalette(paletteOf(light));
  let sparse = 0;
  for (let seed = 1; seed <= 12; ++seed) {
    const random = randomFrom(seed);
    const below = (most: number) => Math.floor(random() * most);
    const [width, height] = [20 + below(40), 20 + below(40)];
    const cells = Uint8Array.from({ length: width * height }, () => [0, 1, 1, 1, 1, 3][below(6)]!);
    const place = () => {
      const [x, y] = [below(width), below(height)];
      cells[y * width + x] = 1;
      return { x: x + 0.5, y: y + 0.5, heading: 0 };
    };
    const ends = Array.from({ length: 6 }, () => ({ start: place(), goal: place() }));
    good(used.load(cells, width, height, plainFrame));
    for (const { start, goal } of ends) {
      const planner = ['astar', 'greedy', 'dijkstra', 'car:lattice_resolution=1', 'ara_star'][below(5)]!;
      const task = { planner, record: random() < 0.8, headings: false, start, goal };
      const fresh = await EngineModule.from(module);
      fresh.setPalette(paletteOf(light));
      good(fresh.load(cells, width, height, plainFrame));
      const [outcome, expected] = [used.plan(task), fresh.plan(task)];
      const comparable = (answer: object) => ({ ...answer, seconds: 0 });
      expect(comparable(outcome)).toEqual(comparable(expected));
      expect(used.knowledge()).toEqual(fresh.knowledge());
      const { steps } = good(outcome);
      if (steps > 0 && steps < cells.length / 4) ++sparse;
      for (const side of [1 / 2, 2.5, 8]) {
        const window = { width: 30, height: 20, left: -2, top: -3, cells: side };
        const step = below(steps + 1);
        expect(used.paint(window, step), `${planner}, ${side} cells a pixel, step ${step}`).toEqual(fresh.paint(window, step));
      }
    }
  }
  expect(sparse).toBeGreaterThan(10);
});
