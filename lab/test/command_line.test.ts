// What the lab computes is what the command line computes: status, cost and expansions, and, for planners on cells, the
// order in which cells are expanded and reached, for every planner of the registry, on random maps.

import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { beforeAll, describe, expect, test } from 'vitest';
import type { EngineModule } from '../engine/module';
import { plainFrame, type PlannerInfo, type Task } from '../engine/types';
import { readMovingAi, readScenario } from '../formats/moving_ai';
import { good, newEngine, randomFrom, root } from './engine';

const run = promisify(execFile);
const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
const maps = 50;

interface Case {
  width: number;
  height: number;
  cells: Uint8Array;
  start: [number, number];
  goal: [number, number];
}

/** A map with walls, and dear ground if `costs` is set; ends are free. */
function caseOf(seed: number, costs: boolean): Case {
  const random = randomFrom(seed);
  const below = (most: number) => Math.floor(random() * most);
  const width = 6 + below(16);
  const height = 6 + below(12);
  const density = random() * 0.4;
  const cells = Uint8Array.from({ length: width * height }, () => {
    if (random() < density) return 0;
    return costs && random() < 0.3 ? 2 + below(8) : 1;
  });
  const start: [number, number] = [1 + below(width - 2), 1 + below(height - 2)];
  const goal: [number, number] = [1 + below(width - 2), 1 + below(height - 2)];
  for (const [x, y] of [start, goal]) cells[y * width + x] = 1;
  return { width, height, cells, start, goal };
}

/** As a text grid: digits are costs. */
function textOf({ width, height, cells }: Case): string {
  const letter = (cell: number) => (cell === 0 ? '#' : cell === 1 ? '.' : String(cell));
  return Array.from({ length: height }, (_, y) =>
    Array.from(cells.subarray(y * width, (y + 1) * width), letter).join('')).join('\n') + '\n';
}

let engine: EngineModule;
let folder: string;
let planners: PlannerInfo[];
let costsCompared = 0;
let ordersCompared = 0;

beforeAll(async () => {
  engine = await newEngine();
  folder = await mkdtemp(join(tmpdir(), 'wend-lab-'));
  planners = engine.registry().planners.filter(({ needsIndex }) => !needsIndex);
});

/** What it prints, also if there is no path. */
async function wend(args: string[]): Promise<string> {
  try {
    return (await run(program, args)).stdout;
  } catch (fault) {
    const { stdout } = fault as { stdout?: string };
    if (!stdout) throw fault;
    return stdout;
  }
}

async function compareOnRandom(planner: PlannerInfo, seed: number): Promise<void> {
  const each = caseOf(seed, seed % 3 === 0 && planner.terrain !== 'refused');
  const file = join(folder, `${planner.name}-${seed}.txt`);
  await writeFile(file, textOf(each));
  await compare(planner, each, file);
}

async function compare(planner: PlannerInfo, each: Case, file: string): Promise<void> {
  good(engine.load(each.cells, each.width, each.height, plainFrame));
  // Where it is watched, a search on costs goes cell by cell.
  const leaps = planner.options.some(({ name }) => name === 'leaps');
  const middle = planner.onVertices ? 0 : 0.5;
  const task: Task = {
    planner: planner.name + (leaps ? ':leaps=false' : ''), record: false, headings: false,
    start: { x: each.start[0] + middle, y: each.start[1] + middle, heading: 0 },
    goal: { x: each.goal[0] + middle, y: each.goal[1] + middle, heading: 0 },
  };
  const outcome = good(engine.plan(task));
  const place = (cell: [number, number]) => `${cell[0]},${cell[1]}`;
  const orders = !planner.headings && !planner.resumes ? ['--show', 'expansion'] : [];
  const printed = await wend(['plan', file, '--start', place(each.start) + (planner.headings ? ',E' : ''),
    '--goal', place(each.goal), '--planner', planner.name, '--format', 'json', ...orders,
    ...(leaps ? ['--no-leaps'] : [])]);
  const told = JSON.parse(printed);
  const where = `${planner.name}: wend plan ${file}`;
  expect(outcome.status, where).toBe(told.status);
  expect(outcome.expanded, where).toBe(told.metrics.expanded);
  expect(outcome.generated, where).toBe(told.metrics.generated);
  // Without a path, the command line has no cost and no layers.
  if (outcome.status !== 'found') return;
  expect(outcome.cost, where).toBe(told.cost);
  ++costsCompared;
  if (orders.length === 0 || !told.layers) return;
  expect(good(engine.plan({ ...task, record: true })).cost, where).toBe(told.cost);
  // The command line looks back at as many expansions as the search took; alt takes more while it is watched.
  expect(orderOf(each, outcome.expanded), where).toEqual(told.layers.expansion);
  ++ordersCompared;
}

/** The order of expansion as the command line prints it: a number for each cell, null where there is none. */
function orderOf({ width, height }: Case, most: number): (number | null)[][] {
  const order: (number | null)[][] = Array.from({ length: height }, () => new Array<number | null>(width).fill(null));
  engine.expansions().subarray(0, most).forEach((cell, i) => {
    const row = order[Math.floor(cell / width)]!;
    row[cell % width] ??= i + 1;
  });
  return order;
}

describe('equal to the command line', () => {
  test('every planner on random maps', async () => {
    expect(planners.length).toBeGreaterThan(10);
    for (const planner of planners) {
      for (let seed = 1; seed <= maps; ++seed) await compareOnRandom(planner, seed);
    }
    expect(costsCompared).toBeGreaterThan(maps * 7);
    expect(ordersCompared).toBeGreaterThan(maps * 5);
  }, 240_000);

  const data = `${root}../shared/data/`;
  for (const name of ['movingai/dao/arena.map', 'grids/room-100-10.map', 'grids/maze-100-1.map']) {
    test.skipIf(!existsSync(data + name))(`every planner on cells on ${name}`, async () => {
      const { width, height, cells } = readMovingAi(await readFile(data + name, 'utf8'), name);
      const queries = readScenario(await readFile(`${data}${name}.scen`, 'utf8'), name);
      const { start, goal } = queries[queries.length >> 1]!;
      for (const planner of planners.filter(({ headings }) => !headings)) {
        await compare(planner, { width, height, cells, start, goal }, data + name);
      }
    }, 120_000);
  }
});
