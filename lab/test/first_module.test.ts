// The first module answers as the whole one does, in what it has, and has what its lists say.

import { readFile } from 'node:fs/promises';
import { beforeAll, expect, test } from 'vitest';
import { EngineModule } from '../engine/module';
import { needsOf, Programs, type Contents } from '../engine/program';
import { initialState } from '../store/state';
import { good, newEngine, root } from './engine';

let first: EngineModule;
let whole: EngineModule;
let contents: Contents;

beforeAll(async () => {
  first = await EngineModule.from(await WebAssembly.compile(await readFile(`${root}build/lab/first.wasm`)));
  whole = await newEngine();
  contents = JSON.parse(await readFile(`${root}build/lab/contents.json`, 'utf8')) as Contents;
});

test('maps and searches are the same', () => {
  let found = 0;
  for (const generator of contents.first.generators) {
    for (const planner of contents.first.planners) {
      for (const [seed, footprint] of [[1, 'point'], [2, 'disc:0.6'], [3, 'point'], [4, 'disc:0.4']] as const) {
        for (const engine of [first, whole]) good(engine.generate(generator, 41, 27, seed));
        expect(first.cells()).toEqual(whole.cells());
        for (const engine of [first, whole]) good(engine.robot(footprint));
        const task = { planner, record: true, headings: false, fields: { nearest: 'true' },
          start: { x: 1.5, y: 1.5, heading: 0 }, goal: { x: 39.5, y: 25.5, heading: 0 } };
        const [one, other] = [first.plan(task), whole.plan(task)];
        expect({ ...one, seconds: 0 }).toEqual({ ...other, seconds: 0 });
        expect(first.knowledge()).toEqual(whole.knowledge());
        if (good(one).status === 'found') ++found;
      }
    }
  }
  expect(found).toBeGreaterThan(12);
});

test('its lists name what it has, and nothing else', () => {
  good(first.generate('rooms', 41, 27, 1));
  for (const { name } of contents.registry.planners) {
    const answer = first.plan({ planner: name, record: false, headings: false,
      start: { x: 1.5, y: 1.5, heading: 0 }, goal: { x: 39.5, y: 25.5, heading: 0 } });
    expect('error' in answer, name).toBe(!contents.first.planners.includes(name));
  }
  for (const { name, defaultWidth, defaultHeight } of contents.registry.generators) {
    expect('error' in first.generate(name, defaultWidth, defaultHeight, 1), name).toBe(!contents.first.generators.includes(name));
  }
});

test('the whole one is loaded once, when something else is needed, and again after a fault', async () => {
  let loads = 0;
  let away = true;
  const [small, large] = [new ArrayBuffer(1), new ArrayBuffer(2)];
  const programs = new Programs(small, contents, async () => {
    ++loads;
    if (away) throw new Error('away');
    return large;
  });
  const needs = (change: object) => needsOf({ ...initialState, ...change }, { planner: 'astar', options: {} });
  expect(await programs.that(needs({}))).toBe(small);
  expect(loads).toBe(0);
  await expect(programs.that({ planner: 'jps' })).rejects.toThrow('could not be loaded');
  away = false;
  for (const change of [{ widest: true }, { smoother: 'gradient' }, { following: { controller: 'pid', robot: '', simulation: '' } }]) {
    expect(await programs.that(needs(change))).toBe(large);
  }
  expect(await programs.that({ generator: 'office' })).toBe(large);
  expect(loads).toBe(2);
  expect(programs.has(large, { planner: 'jps', more: true })).toBe(true);
});
