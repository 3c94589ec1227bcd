// The painter against what the engine tells of each cell: the colour of every pixel, at any step, drawn from either end.

import { expect, test } from 'vitest';
import { plainFrame } from '../engine/types';
import { bytesOf, light, paletteOf } from '../view/palette';
import { good, newEngine, randomFrom } from './engine';

test('every pixel has the colour of its cell at that step', async () => {
  const engine = await newEngine();
  engine.setPalette(paletteOf(light));
  for (let seed = 1; seed <= 30; ++seed) {
    const random = randomFrom(seed);
    const below = (most: number) => Math.floor(random() * most);
    const [width, height, yUp] = [5 + below(40), 5 + below(30), seed % 2 === 0];
    const cells = Uint8Array.from({ length: width * height }, () => [0, 1, 1, 1, 255][below(5)]!);
    cells[0] = cells[cells.length - 1] = 1;
    good(engine.load(cells, width, height, { ...plainFrame, yUp }));
    const { steps } = good(engine.plan({ planner: 'bfs', record: true, headings: false,
      start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: width - 0.5, y: height - 0.5, heading: 0 } }));
    const { expansion, generation } = engine.knowledge();
    const order = engine.expansions();
    for (const [side, step] of [[1, 0], [1, steps], [3, below(steps + 1)], [8, below(steps + 1)]] as const) {
      const window = { width: side * width + 9, height: side * height + 9, left: -4 / side, top: -4 / side, cells: 1 / side };
      const pixels = new Uint32Array(engine.paint(window, step).buffer);
      const wrong = [...pixels.keys()].filter((pixel) => {
        const x = Math.floor((pixel % window.width - 4) / side);
        const row = Math.floor((Math.floor(pixel / window.width) - 4) / side);
        const index = (yUp ? height - 1 - row : row) * width + x;
        const outside = x < 0 || row < 0 || x >= width || row >= height;
        const by = (at: number) => at > 0 && at <= step;
        const role = outside ? 'page' : cells[index] === 0 ? 'obstacle' : step > 0 && order[step - 1] === index ? 'current'
          : by(expansion[index]!) ? 'expanded' : by(generation[index]!) ? 'frontier' : cells[index] === 255 ? 'unknown' : 'free';
        return pixels[pixel] !== bytesOf(light[role]);
      });
      expect(wrong.length, `seed ${seed}, ${side} pixels a cell, step ${step}`).toBe(0);
    }
  }
});
