// Speeds of the lab, in this process: searches beside the native program, and the painter. ./run bench lab

import { execFileSync } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { benchDragging } from './bench_drag';
import { benchFirstReplay } from './bench_first';
import { EngineModule } from './engine/module';
import { readMovingAi } from './formats/moving_ai';
import { plainFrame, type Window } from './engine/types';
import { good, newEngine } from './test/engine';
import { paletteOf, light } from './view/palette';
import { readFileSync } from 'node:fs';

const program = process.env['WEND_CLI']!;
const folder = mkdtempSync(join(tmpdir(), 'wend-lab-'));
const rounds = 7;

// CPU time, as the native program reports it: the engine reads this clock.
const cpuMilliseconds = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};
const wallMilliseconds = performance.now.bind(performance);
performance.now = cpuMilliseconds;

function generate(kind: string, side: number): string {
  const file = join(folder, `${kind}-${side}.map`);
  execFileSync(program, ['generate', kind, '--size', `${side}x${side}`, '--seed', '5', '-o', file], { stdio: 'pipe' });
  return file;
}

function nativeSeconds(file: string, planner: string, end: number): number {
  const args = ['plan', file, '--start', '1,1', '--goal', `${end},${end}`, '--planner', planner, '--nearest', '--format', 'json'];
  return JSON.parse(execFileSync(program, args, { encoding: 'utf8', maxBuffer: 1 << 28 })).times.search_us / 1e6;
}

function planIn(engine: EngineModule, file: string, planner: string, record: boolean) {
  const { cells, width, height } = readMovingAi(readFileSync(file, 'latin1'), file);
  good(engine.load(cells, width, height, plainFrame));
  const end = width - 1.5;
  return good(engine.plan({ planner, record, headings: false, fields: { nearest: 'true' },
    start: { x: 1.5, y: 1.5, heading: 0 }, goal: { x: end, y: end, heading: 0 } }));
}

const engine = await newEngine();
console.log(`First search on a map of 1024 x 1024 cells: CPU time, the least of ${rounds}, native and here in turn`);
for (const kind of ['rooms', 'random', 'maze']) {
  const file = generate(kind, kind === 'maze' ? 1023 : 1024);
  for (const planner of ['astar', 'dijkstra', 'jps']) {
    const native: number[] = [];
    const here: number[] = [];
    let expanded = 0;
    for (let i = 0; i < rounds; ++i) {
      native.push(nativeSeconds(file, planner, (kind === 'maze' ? 1023 : 1024) - 2));
      const outcome = planIn(engine, file, planner, false);
      here.push(outcome.seconds);
      expanded = outcome.expanded;
    }
    const [there, our] = [Math.min(...native), Math.min(...here)];
    console.log(`${kind} ${planner}: native ${(there * 1e3).toFixed(1)} ms, here ${(our * 1e3).toFixed(1)} ms, speed ${(there / our).toFixed(2)} of native, ${expanded} expanded`);
  }
}

const large = await newEngine();
const began = performance.now();
const outcome = planIn(large, generate('random', 4096), 'dijkstra', true);
console.log(`4096 x 4096: loaded, searched and written down in ${(performance.now() - began).toFixed(0)} ms, ${outcome.steps} steps`);
large.setPalette(paletteOf(light));
for (const [what, cells] of [['whole map', 4096 / 1080], ['1 cell a pixel', 1], ['8 pixels a cell', 1 / 8]] as const) {
  const window: Window = { width: 1920, height: 1080, left: 0, top: 0, cells };
  const times: number[] = [];
  for (let i = 1; i <= 60; ++i) {
    const step = Math.floor((outcome.steps * ((i * 37) % 60)) / 60);
    const start = performance.now();
    large.paint(window, step);
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  console.log(`painting 1920 x 1080 while scrubbing, ${what}: median ${times[30]!.toFixed(1)} ms, most ${times.at(-1)!.toFixed(1)} ms`);
}

// Wall-clock times: other work on the machine shows here.
performance.now = wallMilliseconds;
await benchFirstReplay();
await benchDragging();
