// GIFs as Chromium reads them; traces as the command line writes them.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { plainFrame } from '../engine/types';
import { writeGif, type Frame } from '../formats/gif';
import { posthocTrace } from '../formats/posthoc';
import { openBrowser, type Opened } from './browser';
import { good, newEngine, randomFrom, root } from './engine';

let opened: Opened;
beforeAll(async () => {
  opened = await openBrowser();
}, 60_000);
afterAll(async () => opened.close());

/** The pixels of each frame, red, green, blue and alpha, as the browser decodes them. */
async function decoded(gif: Uint8Array): Promise<number[][]> {
  const page = await opened.browser.newPage();
  await page.goto(`${opened.address}licences.html`);
  const frames = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const { ImageDecoder } = window as unknown as { ImageDecoder: new (options: unknown) => {
      tracks: { ready: Promise<void>; selectedTrack: { frameCount: number } }; completed: Promise<void>;
      decode(options: unknown): Promise<{ image: CanvasImageSource & { displayWidth: number; displayHeight: number } }>;
    } };
    // The address of the server is a secure context, where decoders are.
    const decoder = new ImageDecoder({ data: bytes, type: 'image/gif' });
    await decoder.tracks.ready;
    await decoder.completed;
    const all: number[][] = [];
    for (let frameIndex = 0; frameIndex < decoder.tracks.selectedTrack.frameCount; ++frameIndex) {
      const { image } = await decoder.decode({ frameIndex });
      const context = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext('2d')!;
      context.drawImage(image, 0, 0);
      all.push([...context.getImageData(0, 0, image.displayWidth, image.displayHeight).data]);
    }
    return all;
  }, Buffer.from(gif).toString('base64'));
  await page.close();
  return frames;
}

test('a GIF has the pixels of its frames', async () => {
  const random = randomFrom(3);
  // Noise fills the table of codes many times; areas make long codes.
  const colours = Array.from({ length: 200 }, (_, i) => [(i % 8) * 32, (Math.floor(i / 8) % 8) * 32, Math.floor(i / 64) * 64]);
  const frame = (areas: boolean): Frame => {
    const data = new Uint8ClampedArray(4 * 130 * 90);
    let colour = colours[0]!;
    for (let at = 0; at < data.length; at += 4) {
      if (!areas || random() < 0.01) colour = colours[Math.floor(random() * colours.length)]!;
      data.set([...colour, 255], at);
    }
    return { width: 130, height: 90, data };
  };
  const frames = [frame(false), frame(true), frame(false), { ...frame(true), data: new Uint8ClampedArray(4 * 130 * 90).fill(255) }];
  const seen = await decoded(writeGif(frames, 10, 100));
  expect(seen.length).toBe(4);
  frames.forEach(({ data }, i) => expect(Buffer.from(seen[i]!).equals(Buffer.from(data.buffer)), `frame ${i}`).toBe(true));
  expect((await decoded(writeGif([{ width: 1, height: 1, data: Uint8ClampedArray.of(8, 16, 24, 255) }], 1, 1)))[0]).toEqual([8, 16, 24, 255]);
}, 60_000);

test('a trace has the events of the command line', async () => {
  const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
  const folder = mkdtempSync(join(tmpdir(), 'wend-lab-'));
  const engine = await newEngine();
  for (const seed of [1, 2, 3, 4, 5, 6]) {
    const random = randomFrom(seed);
    const [width, height] = [14, 10];
    const cells = Uint8Array.from({ length: width * height }, () => (random() < 0.25 ? 0 : 1));
    cells[0] = cells[width * height - 1] = 1;
    const file = join(folder, `${seed}.txt`);
    writeFileSync(file, Array.from({ length: height }, (_, y) => Array.from(cells.subarray(y * width, (y + 1) * width), (cell) => '#.'[cell]!).join('')).join('\n') + '\n');
    good(engine.load(cells, width, height, plainFrame));
    const [start, goal] = [{ x: 0.5, y: 0.5, heading: 0 }, { x: width - 0.5, y: height - 0.5, heading: 0 }];
    const plan = good(engine.plan({ planner: 'astar', record: true, headings: false, start, goal }));
    const trace = JSON.parse(posthocTrace({ name: '', width, height, frame: plainFrame, cells, version: 0 }, start, goal,
      engine.expansions(), engine.knowledge(), plan.status === 'found'));
    const theirs = join(folder, `${seed}.trace.json`);
    try {
      execFileSync(program, ['plan', file, '--start', '0,0', '--goal', `${width - 1},${height - 1}`, '--planner', 'astar', '--trace', theirs], { stdio: 'pipe' });
    } catch (fault) {
      // There is no path: the trace is written all the same.
      expect((fault as { status: number }).status).toBe(1);
    }
    const told = JSON.parse(readFileSync(theirs, 'utf8'));
    const order = (events: { type: string; id: number }[], type: string) => events.filter((event) => event.type === type).map(({ id }) => id);
    for (const type of ['source', 'destination', 'expanding', 'closing', 'end']) {
      expect(order(trace.events, type), `${type}, seed ${seed}`).toEqual(order(told.events, type));
    }
    const sorted = (events: { type: string; id: number }[]) => order(events, 'generating').sort((a, b) => a - b);
    expect(sorted(trace.events)).toEqual(sorted(told.events));
    const covered = (events: { type: string; blocked: [number, number, number, number][] }[]) => {
      const seen = new Set<number>();
      for (const [x, y, across, down] of events.find(({ type }) => type === 'map')!.blocked) {
        for (let row = y; row < y + down; ++row) for (let column = x; column < x + across; ++column) seen.add(row * width + column);
      }
      return [...seen].sort((a, b) => a - b);
    };
    expect(covered(trace.events)).toEqual(covered(told.events));
    expect(Object.keys(trace).sort()).toEqual(Object.keys(told).sort());
  }
});
