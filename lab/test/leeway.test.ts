// Ways out of blocked starts and closest places: what the lab answers is what the command line answers, for every planner,
// on random maps whose ends lie anywhere, with and without metres.

import { execFile } from 'node:child_process';
import { mkdtemp, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { beforeAll, describe, expect, test } from 'vitest';
import type { EngineModule } from '../engine/module';
import { plainFrame, type Frame, type Outcome, type PlannerInfo, type Task } from '../engine/types';
import { mapSvg } from '../formats/save';
import { documentOf } from '../store/maps';
import { light } from '../view/palette';
import { good, newEngine, randomFrom, root } from './engine';

const run = promisify(execFile);
const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
const metres: Frame = { resolution: 0.1, originX: -1, originY: 2, originYaw: 0, yUp: true, metric: true };

let engine: EngineModule;
let folder: string;
let planners: PlannerInfo[];

beforeAll(async () => {
  engine = await newEngine();
  folder = await mkdtemp(join(tmpdir(), 'wend-lab-'));
  planners = engine.registry().planners.filter(({ needsIndex }) => !needsIndex);
});

interface Case {
  width: number;
  height: number;
  cells: Uint8Array;
  frame: Frame;
  start: [number, number];
  goal: [number, number];
  /** Cells. */
  radius: number;
  escape: number;
  closest: boolean;
}

function caseOf(seed: number): Case {
  const random = randomFrom(seed);
  const below = (most: number) => Math.floor(random() * most);
  const width = 8 + below(12);
  const height = 8 + below(10);
  const density = 0.1 + random() * 0.3;
  const cells = Uint8Array.from({ length: width * height }, () => (random() < density ? 0 : 1));
  const cell = (): [number, number] => [1 + below(width - 2), 1 + below(height - 2)];
  return {
    width, height, cells, frame: seed % 2 === 0 ? metres : plainFrame, start: cell(), goal: cell(), radius: seed % 3 === 0 ? 0.8 : 0,
    escape: [0, 1, 4][below(3)]!, closest: random() < 0.7,
  };
}

/** Its file; PGM rows begin at the top. */
async function fileOf(each: Case, name: string): Promise<string> {
  const { width, height, cells, frame } = each;
  const rows = Array.from({ length: height }, (_, y) => cells.subarray(y * width, (y + 1) * width));
  if (!frame.metric) {
    const file = join(folder, `${name}.txt`);
    await writeFile(file, rows.map((row) => Array.from(row, (byte) => (byte === 0 ? '#' : '.')).join('')).join('\n') + '\n');
    return file;
  }
  const grey = rows.reverse().map((row) => Array.from(row, (byte) => (byte === 0 ? 0 : 254)).join(' '));
  await writeFile(join(folder, `${name}.pgm`), `P2\n${width} ${height}\n255\n${grey.join('\n')}\n`);
  await writeFile(join(folder, `${name}.yaml`), `image: ${name}.pgm\nresolution: ${frame.resolution}\norigin: [${frame.originX}, ${frame.originY}, 0]\n` +
    'negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n');
  return join(folder, `${name}.yaml`);
}

async function told(args: string[]) {
  const printed = await run(program, args).catch((fault: { stdout?: string }) => fault);
  if (!printed.stdout) throw printed;
  return JSON.parse(printed.stdout);
}

/** The lab's answer and the command line's; a car's ends are vertices. */
async function both(planner: PlannerInfo, each: Case, name: string) {
  const { frame, escape, closest } = each;
  good(engine.load(each.cells, each.width, each.height, frame));
  const unit = frame.metric ? frame.resolution : 1;
  good(engine.robot(each.radius > 0 ? `disc:${each.radius * unit}` : 'point'));
  const middle = planner.onVertices && !frame.metric ? 0 : 0.5;
  const place = ([x, y]: [number, number]) => ({ x: x + middle, y: y + middle, heading: 0 });
  const leaps = planner.options.some((option) => option.name === 'leaps');
  const task: Task = {
    planner: planner.name + (leaps ? ':leaps=false' : ''), record: false, headings: false, start: place(each.start), goal: place(each.goal),
    fields: { escape: String(escape * unit), closest: String(closest) },
  };
  const outcome = good(engine.plan(task));
  const typed = ([x, y]: [number, number]) =>
    frame.metric ? `${frame.originX + (x + 0.5) * unit},${frame.originY + (y + 0.5) * unit}` : `${x},${y}`;
  const answer = await told(['plan', await fileOf(each, name), `--start=${typed(each.start)}${planner.headings ? ',E' : ''}`,
    `--goal=${typed(each.goal)}`, '--robot-radius', String(each.radius * unit), '--planner', planner.name, '--escape', String(escape * unit),
    ...(closest ? ['--closest'] : []), ...(leaps ? ['--no-leaps'] : []), '--format', 'json']);
  return { outcome, answer, task };
}

function compare(outcome: Outcome, answer: Awaited<ReturnType<typeof told>>, frame: Frame, where: string): void {
  expect(outcome.status, where).toBe(answer.status);
  if (outcome.status !== 'found') return;
  expect(outcome.cost, where).toBe(answer.cost);
  expect(outcome.expanded, where).toBe(answer.metrics.expanded);
  const notes = outcome.notes!.filter((note) => !note.includes('from what was asked'));
  expect(notes, where).toEqual(answer.notes);
  expect(outcome.wayOut?.metres, where).toBe(answer.lead_out?.length_m);
  expect(outcome.remaining?.metres, where).toBe(answer.remaining?.m);
  const [x, y] = outcome.path.slice(-3);
  const end = answer.path_m?.at(-1) ?? answer.path.at(-1);
  if (frame.metric && answer.path_m) {
    expect(frame.originX + x! * frame.resolution, where).toBeCloseTo(end[0], 6);
    expect(frame.originY + y! * frame.resolution, where).toBeCloseTo(end[1], 6);
  }
}

describe('where the robot cannot be', () => {
  test('every planner on cells answers as the command line does', async () => {
    let ledOut = 0;
    let closest = 0;
    for (const planner of planners.filter(({ headings }) => !headings)) {
      for (let seed = 1; seed <= 24; ++seed) {
        const each = caseOf(seed);
        const { outcome, answer } = await both(planner, each, `${planner.name}-${seed}`);
        compare(outcome, answer, each.frame, `${planner.name}, seed ${seed}`);
        if (outcome.wayOut) ++ledOut;
        if (outcome.remaining?.metres) ++closest;
      }
    }
    expect(ledOut).toBeGreaterThan(planners.length);
    expect(closest).toBeGreaterThan(planners.length);
  }, 240_000);

  /** A start from which a disc of 0.8 cells touches a wall, and a goal that is walled in. */
  const walled = (frame: Frame): Case => {
    const rows = ['....................', '....................', '....................', '............######..', '............#....#..',
      '............#....#..', '............######..', '....................', '....................', '....................', '....................', '....................'];
    const cells = Uint8Array.from(rows.join(''), (letter) => (letter === '#' ? 0 : 1));
    return { width: 20, height: 12, cells, frame, start: [14, 2], goal: [14, 4], radius: 0.8, escape: 4, closest: true };
  };

  test('every planner with headings answers as the command line does', async () => {
    for (const planner of planners.filter(({ headings }) => headings)) {
      for (const frame of [plainFrame, metres]) {
        const each = walled(frame);
        const { outcome, answer } = await both(planner, each, `${planner.name}-${frame.metric}`);
        compare(outcome, answer, frame, `${planner.name}, ${frame.metric ? 'metres' : 'cells'}`);
        expect(outcome.status, planner.name).toBe('found');
        // On a vertex beside the cell, the robot fits.
        if (!planner.onVertices) expect(outcome.wayOut!.metres, planner.name).toBeGreaterThan(0);
        expect(outcome.remaining!.metres, planner.name).toBeGreaterThan(0);
        expect(outcome.notes!.join(), planner.name).not.toContain('the goal 3 cells from what was asked');
      }
    }
  }, 240_000);

  test('a replay shows the search that answers, from the end of the way out', async () => {
    const astar = planners.find(({ name }) => name === 'astar')!;
    const each = walled(plainFrame);
    const { outcome, task } = await both(astar, each, 'replay');
    const replayed = good(engine.plan({ ...task, record: true }));
    expect(replayed.expanded).toBe(outcome.expanded);
    expect(replayed.steps).toBe(outcome.expanded);
    expect(replayed.path).toEqual(outcome.path);
    const first = engine.expandedAt(1);
    const free = outcome.path.slice(3 * (outcome.wayOutPoints! - 1), 3 * outcome.wayOutPoints!);
    expect([first % each.width + 0.5, Math.floor(first / each.width) + 0.5]).toEqual([...free.slice(0, 2)]);
  });

  test('a way out is the beginning of the path, in words too', async () => {
    good(engine.load(Uint8Array.from('........####....', (letter) => (letter === '#' ? 0 : 1)), 16, 1, plainFrame));
    good(engine.robot('point'));
    const task: Task = { planner: 'astar', record: false, headings: false, start: { x: 9.5, y: 0.5, heading: 0 }, goal: { x: 1.5, y: 0.5, heading: 0 } };
    expect(good(engine.plan(task))).toMatchObject({ status: 'start_blocked', message: expect.stringContaining('a longest way out of 2 lets the robot leave it') });
    expect(good(engine.plan({ ...task, fields: { escape: '1' } }))).toMatchObject({ status: 'start_blocked', message: expect.stringContaining('longer than the 1 cell allowed') });
    const outcome = good(engine.plan({ ...task, fields: { escape: '2' } }));
    expect(outcome).toMatchObject({ status: 'found', cost: 6, wayOut: { metres: 2, text: '2 cells' }, wayOutPoints: 3 });
    expect([...outcome.path].filter((_, i) => i % 3 === 0)).toEqual([9.5, 8.5, 7.5, 6.5, 5.5, 4.5, 3.5, 2.5, 1.5]);
    expect(outcome.notes).toEqual(['the start (9,0) is blocked: the cell is an obstacle; the path begins with a way out of 2 cells, to cell (7,0)']);
    const map = documentOf('m', { ...plainFrame, width: 16, height: 1 }, engine.cells());
    expect(mapSvg(map, outcome.path, light, outcome.wayOutPoints).match(/<polyline points="9.5,0.5 8.5,0.5 7.5,0.5"[^>]*dasharray/)).toBeTruthy();
    expect(mapSvg(map, outcome.path, light, outcome.wayOutPoints)).toContain('<polyline points="7.5,0.5 6.5,0.5');
    expect(mapSvg(map, outcome.path, light)).not.toContain('dasharray');
  });

  test('an end that moves is told', async () => {
    good(engine.load(new Uint8Array(100).fill(1), 10, 10, metres));
    good(engine.robot('point'));
    const end = (x: number, y: number) => ({ x, y, heading: 0.5 });
    const car = good(engine.plan({ planner: 'car', record: false, headings: false, start: end(2.5, 3), goal: end(7, 7) }));
    expect(car.notes).toContain("the path's ends: the start 0.05 m and 28.6 degrees from what was asked");
    const astar = good(engine.plan({ planner: 'astar', record: false, headings: false, start: end(2.2, 3.3), goal: end(7.9, 7.1) }));
    expect(astar.notes).toEqual([]);
  });

  test('lengths that are not are refused', () => {
    for (const escape of ['-1', 'NaN', '']) {
      expect(engine.plan({ planner: 'astar', record: false, headings: false, start: { x: 1, y: 1, heading: 0 }, goal: { x: 2, y: 2, heading: 0 }, fields: { escape } }))
        .toMatchObject({ status: 'invalid_option' });
    }
  });
});
