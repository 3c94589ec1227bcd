// Edits of a map in the engine: what is painted, and what is planned, is that of a map that was loaded so.

import { describe, expect, test } from 'vitest';
import type { EngineModule } from '../engine/module';
import { plainFrame, type Task } from '../engine/types';
import { light, paletteOf } from '../view/palette';
import { good, newEngine, randomFrom } from './engine';

const task = (planner: string, width: number, height: number): Task => ({
  planner, record: true, headings: false, start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: width - 0.5, y: height - 0.5, heading: 0 },
});

function painted(engine: EngineModule, width: number, height: number): string {
  engine.setPalette(paletteOf(light));
  const zooms = [1 / 3, 1, 2, 3.7, 8];
  return zooms.map((cells) => Buffer.from(engine.paint(
    { width: Math.ceil(width / cells) + 1, height: Math.ceil(height / cells) + 1, left: 0, top: 0, cells }, 5)).toString('base64')).join(' ');
}

describe('edits', () => {
  test('leave the map as if it had been loaded so', async () => {
    const edited = await newEngine();
    const loaded = await newEngine();
    for (let seed = 1; seed <= 60; ++seed) {
      const random = randomFrom(seed);
      const below = (most: number) => Math.floor(random() * most);
      const [width, height] = [1 + below(37), 1 + below(29)];
      const byte = () => [0, 0, 1, 1, 1, 1, 5, 200, 255][below(9)]!;
      const cells = Uint8Array.from({ length: width * height }, byte);
      good(edited.load(cells, width, height, plainFrame));
      const robot = seed % 2 === 0 ? 'disc:1.3' : 'point';
      for (const engine of [edited, loaded]) good(engine.robot(robot));
      for (let stroke = 0; stroke < 4; ++stroke) {
        const indices = Array.from({ length: 1 + below(9) }, () => below(cells.length));
        const bytes = indices.map(byte);
        indices.forEach((index, i) => { cells[index] = bytes[i]!; });
        // The same cell twice in one edit: the last one counts.
        good(edited.edit(indices, indices.map((index) => cells[index]!)));
        good(loaded.load(cells, width, height, plainFrame));
        expect(edited.cells()).toEqual(cells);
        for (const engine of [edited, loaded]) engine.plan(task('astar', width, height));
        expect(painted(edited, width, height), `seed ${seed}`).toBe(painted(loaded, width, height));
      }
    }
  });

  test('that do not fit the map change nothing', async () => {
    const engine = await newEngine();
    const cells = Uint8Array.from({ length: 12 }, () => 1);
    good(engine.load(cells, 4, 3, plainFrame));
    expect('error' in engine.edit([2, 12], [0, 0])).toBe(true);
    expect(engine.cells()).toEqual(cells);
  });

  test('are followed by planners with an index', async () => {
    const engine = await newEngine();
    for (let seed = 1; seed <= 20; ++seed) {
      const random = randomFrom(seed);
      const [width, height] = [12, 9];
      const cells = Uint8Array.from({ length: width * height }, (_, i) => (random() < 0.25 && i > 0 && i + 1 < width * height ? 0 : 1));
      good(engine.load(cells, width, height, plainFrame));
      for (let edit = 0; edit < 3; ++edit) {
        const pairs = [['hub_labels', 'dijkstra'], ['euclidean_labels', 'any_angle']] as const;
        for (const [planner, reference] of pairs) {
          const truth = good(engine.plan(task(reference, width, height)));
          const found = engine.plan(task(planner, width, height));
          expect('error' in found ? found.error : found.status, `${planner}, seed ${seed}`).toBe(truth.status);
          expect(good(found).cost ?? -1, `${planner}, seed ${seed}`).toBeCloseTo(truth.cost ?? -1, 9);
        }
        const index = 1 + Math.floor(random() * (cells.length - 2));
        cells[index] = 1 - cells[index]!;
        good(engine.edit([index], [cells[index]!]));
      }
    }
  });
});

describe('a robot', () => {
  test('finds places near both ends where it fits, on the car park too', async () => {
    const engine = await newEngine();
    const made = good(engine.generate('car_park', 203, 147, 3));
    const polygon = [[1, 0.6], [1, -0.6], [-1, -0.6], [-1, 0.6]]
      .map(([x, y]) => `${x! * made.resolution},${y! * made.resolution}`).join('; ');
    good(engine.robot(polygon));
    for (const [planner, headings] of [['hybrid_astar', true], ['astar', false]] as const) {
      const corners = { start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: 202.5, y: 146.5, heading: 0 } };
      expect(engine.plan({ ...task(planner, 203, 147), ...corners })).toMatchObject({ status: expect.stringMatching(/blocked/) });
      const places = good(engine.places(corners.start, corners.goal, headings));
      expect(good(engine.plan({ ...task(planner, 203, 147), ...places })).status, planner).toBe('found');
      expect(good(engine.places(places.start, places.goal, headings)), 'it stays where it fits').toEqual(places);
    }
  });
});
