// Drives and widest paths in the engine are those of the command line.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { plainFrame, sampleSize } from '../engine/types';
import { good, newEngine, randomFrom, root } from './engine';

const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
const folder = mkdtempSync(join(tmpdir(), 'wend-lab-'));

test('a drive is that of wend follow, for every controller', async () => {
  const engine = await newEngine();
  const [width, height] = [30, 12];
  const cells = new Uint8Array(width * height).fill(1);
  for (let y = 2; y < height; ++y) cells[y * width + 12] = 0;
  const file = join(folder, 'follow.txt');
  writeFileSync(file, Array.from({ length: height }, (_, y) => Array.from(cells.subarray(y * width, (y + 1) * width), (cell) => '#.'[cell]!).join('')).join('\n') + '\n');
  good(engine.load(cells, width, height, plainFrame));
  const { controllers } = engine.registry();
  expect(controllers.map(({ name }) => name)).toContain('pure_pursuit');
  for (const { name } of controllers) {
    good(engine.plan({ planner: 'astar', record: false, headings: false, start: { x: 2.5, y: 8.5, heading: 0 }, goal: { x: 26.5, y: 9.5, heading: 0 } }));
    const report = good(engine.drive(name, 'robot:speed=1', 'simulation:latency=0.05'));
    const told = JSON.parse(execFileSync(program, ['follow', file, '--start', '2,8', '--goal', '26,9', '--controller', name, '--speed', '1',
      '--latency', '0.05', '--format', 'json'], { encoding: 'utf8' }));
    const drive = told.drives?.[0] ?? told.drive ?? told;
    expect(report.outcome, name).toBe('reached');
    expect(report.time, name).toBeCloseTo(drive.time_s ?? drive.time, 9);
    expect(report.rms, name).toBeCloseTo(drive.cross_track_rms_m ?? drive.cross_track_rms, 9);
    expect(report.samples.length % sampleSize).toBe(0);
    expect(Math.max(...report.samples.filter((_, i) => i % sampleSize === 5).map(Math.abs))).toBeCloseTo(report.largest, 9);
  }
});

test('what cannot drive is refused with a reason', async () => {
  const engine = await newEngine();
  good(engine.generate('random:density=0', 10, 10, 1));
  expect(engine.drive('pid', 'robot', 'simulation')).toMatchObject({ error: 'there is no path to follow' });
  good(engine.plan({ planner: 'astar', record: false, headings: false, start: { x: 1.5, y: 1.5, heading: 0 }, goal: { x: 8.5, y: 8.5, heading: 0 } }));
  for (const [controller, robot, simulation] of [['x', 'robot', 'simulation'], ['pid:x=1', 'robot', 'simulation'], ['pid', 'robot:speed=-1', 'simulation'],
    ['pid', 'robot', 'simulation:rate=x'], ['p', 'robot:drivetrain=bicycle', 'simulation'], ['', '', '']] as const) {
    expect(engine.drive(controller, robot, simulation), `${controller} ${robot}`).toHaveProperty('error');
  }
});

test('a disc of the widest radius gets through, and a larger one does not', async () => {
  const engine = await newEngine();
  let joined = 0;
  for (let seed = 1; seed <= 60; ++seed) {
    const random = randomFrom(seed);
    const cells = Uint8Array.from({ length: 20 * 15 }, () => (random() < 0.12 ? 0 : 1));
    const [start, goal] = [{ x: 1.5, y: 1.5, heading: 0 }, { x: 18.5, y: 13.5, heading: 0 }];
    for (const [x, y] of [[1, 1], [18, 13]] as const) cells[y * 20 + x] = 1;
    good(engine.load(cells, 20, 15, plainFrame));
    good(engine.robot('point'));
    const found = engine.plan({ planner: 'astar', record: false, headings: false, start, goal });
    const widest = good(engine.widest(start, goal));
    expect(widest.joined, `seed ${seed}`).toBe(good(found).status === 'found');
    if (!widest.joined || widest.radius === null || widest.radius === 0) continue;
    ++joined;
    for (const [factor, status] of [[0.999, 'found'], [1.001, 'not']] as const) {
      good(engine.robot(`disc:${widest.radius * factor}`));
      const plan = engine.plan({ planner: 'astar', record: false, headings: false, start, goal });
      expect(good(plan).status === 'found', `seed ${seed}, ${status}`).toBe(status === 'found');
    }
  }
  expect(joined).toBeGreaterThan(20);
});
