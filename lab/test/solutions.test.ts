// The solutions of an anytime search: as the command line tells them, and on the map at each step.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import type { EngineModule } from '../engine/module';
import { pathAt, plainFrame, type Outcome } from '../engine/types';
import { good, newEngine, randomFrom, root } from './engine';

const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
const maps = 25;

let engine: EngineModule;
beforeAll(async () => {
  engine = await newEngine();
});

interface Case {
  width: number;
  height: number;
  cells: Uint8Array;
}

function caseOf(seed: number): Case {
  const random = randomFrom(seed);
  const below = (most: number) => Math.floor(random() * most);
  const [width, height] = [12 + below(40), 12 + below(30)];
  const cells = Uint8Array.from({ length: width * height }, () => (random() < 0.3 ? 0 : 1));
  cells[0] = cells[cells.length - 1] = 1;
  return { width, height, cells };
}

function planIn({ width, height, cells }: Case, planner: string, record = true): Outcome {
  good(engine.load(cells, width, height, plainFrame));
  return good(engine.plan({ planner, record, headings: false,
    start: { x: 0.5, y: 0.5, heading: 0 }, goal: { x: width - 0.5, y: height - 0.5, heading: 0 } }));
}

function lengthOf(path: Float64Array): number {
  let sum = 0;
  for (let i = 3; i < path.length; i += 3) sum += Math.hypot(path[i]! - path[i - 3]!, path[i + 1]! - path[i - 2]!);
  return sum;
}

test('they are those of the command line, and true', () => {
  const folder = mkdtempSync(join(tmpdir(), 'wend-lab-'));
  let several = 0;
  for (let seed = 1; seed <= maps; ++seed) {
    const map = caseOf(seed);
    const outcome = planIn(map, 'ara_star:initial_weight=4,weight_step=0.2');
    const file = join(folder, `${seed}.txt`);
    const rows = Array.from({ length: map.height }, (_, y) => Array.from(map.cells.subarray(y * map.width, (y + 1) * map.width), (cell) => '#.'[cell]).join(''));
    writeFileSync(file, `${rows.join('\n')}\n`);
    if (outcome.status !== 'found') {
      expect(outcome.solutions).toEqual([]);
      continue;
    }
    const told = JSON.parse(execFileSync(program, ['plan', file, '--start', '0,0', '--goal', `${map.width - 1},${map.height - 1}`,
      '--planner', 'ara_star', '--initial-weight', '4', '--weight-step', '0.2', '--format', 'json'], { encoding: 'utf8' }));
    expect(outcome.solutions.map(({ cost, bound, step }) => ({ cost, bound, expanded: step })))
      .toEqual((told.solutions as { cost: number; bound: number; expanded: number }[]).map(({ cost, bound, expanded }) => ({ cost, bound, expanded })));
    const least = planIn(map, 'dijkstra').cost!;
    outcome.solutions.forEach(({ cost, bound, path }) => {
      expect(lengthOf(path)).toBeCloseTo(cost, 9);
      expect(cost / bound!).toBeLessThanOrEqual(least + 1e-9);
      expect([path[0], path[1], path.at(-3), path.at(-2)]).toEqual([0.5, 0.5, map.width - 0.5, map.height - 0.5]);
    });
    expect(outcome.solutions.at(-1)!.path).toEqual(outcome.path);
    if (outcome.solutions.length > 1) ++several;
  }
  expect(several).toBeGreaterThan(maps / 4);
});

test('a step shows the last path that was found until then', () => {
  const outcome = planIn(caseOf(3), 'ara_star:initial_weight=4,weight_step=0.2');
  const { solutions, steps } = outcome;
  for (let step = 0; step <= steps; ++step) {
    const known = solutions.filter((solution) => solution.step <= step);
    expect(pathAt(outcome, step)).toEqual(step === steps ? outcome.path : known.at(-1)?.path ?? null);
  }
});

test('other planners, and searches that are not written down, have none', () => {
  expect(planIn(caseOf(3), 'astar').solutions).toEqual([]);
  expect(planIn(caseOf(3), 'ara_star', false).solutions).toEqual([]);
});
