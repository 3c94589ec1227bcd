// Map files read as the command line reads them; damaged ones are refused with their name, and never crash.

import { File as NodeFile } from 'node:buffer';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { openFiles } from '../formats/files';
import { byteOf, luma, readPnm, usualMeaning } from '../formats/image';
import { readMapYaml, writeMapYaml } from '../formats/map_yaml';
import { readMovingAi, readScenario } from '../formats/moving_ai';
import { pathCsv } from '../formats/save';
import { readTextGrid, writeTextGrid } from '../formats/text_grid';
import { randomFrom, root } from './engine';

const program = process.env['WEND_CLI'] ?? `${root}build/release/bin/wend`;
const data = `${root}../shared/data/`;
const folder = mkdtempSync(join(tmpdir(), 'wend-lab-'));

/** The map of a file as the command line writes it as a text grid. */
function converted(file: string): string {
  const to = join(folder, `${basename(file)}.txt`);
  execFileSync(program, ['convert', file, to], { stdio: 'pipe' });
  return readFileSync(to, 'utf8');
}

function fileOf(path: string): File {
  // Node.js 18 has no File of its own.
  return new NodeFile([readFileSync(path)], basename(path)) as unknown as File;
}

async function opened(...paths: string[]) {
  const found = await openFiles(paths.map(fileOf));
  if (typeof found === 'string') throw new Error(found);
  return found;
}

describe.skipIf(!existsSync(data))('maps of shared/data', () => {
  for (const name of ['movingai/dao/arena.map', 'movingai/dao/brc202d.map', 'grids/room-100-10.map', 'grids/gppc-rmtst01.map']) {
    test(`${name} is read as by the command line`, async () => {
      const { grid } = await opened(data + name);
      expect(writeTextGrid(grid!)).toBe(converted(data + name));
    });
  }
  for (const name of ['pal_small_office', 'pal_office']) {
    test(`ros/${name} is read as by the command line`, async () => {
      const yaml = `${data}ros/${name}/map.yaml`;
      const { grid } = await opened(yaml, yaml.replace('.yaml', '.pgm'));
      expect(writeTextGrid(grid!)).toBe(converted(yaml));
    });
  }
  test('a scenario comes with its map', async () => {
    const { queries, grid } = await opened(`${data}movingai/dao/arena.map`, `${data}movingai/dao/arena.map.scen`);
    expect(queries.length).toBeGreaterThan(100);
    expect(grid!.width).toBe(queries[0]!.width);
  });
  test('bad files are refused with a reason', async () => {
    const names = readdirSync(`${data}bad/map`).filter((name) => name.endsWith('.map'));
    for (const name of names) {
      const found = await openFiles([fileOf(`${data}bad/map/${name}`)]);
      const refused = spawnFails(`${data}bad/map/${name}`);
      if (refused) expect(found, name).toContain(name);
    }
    expect(names.length).toBeGreaterThan(3);
  });
});

function spawnFails(file: string): boolean {
  try {
    execFileSync(program, ['info', file], { stdio: 'pipe' });
    return false;
  } catch {
    return true;
  }
}

describe('readers', () => {
  const text = 'type octile\nheight 2\nwidth 3\nmap\n..@\n.GT\n';

  test('cut or changed texts are read or refused by name', () => {
    const random = randomFrom(5);
    const scenario = 'version 1\n0\tm.map\t3\t2\t0\t0\t1\t1\t1.41\n';
    const yaml = 'image: m.png\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n';
    for (let round = 0; round < 3000; ++round) {
      const damaged = (whole: string) => {
        const letters = [...whole];
        for (let i = 0; i < 2; ++i) letters[Math.floor(random() * letters.length)] = String.fromCharCode(Math.floor(random() * 128));
        return letters.join('').slice(0, Math.floor(random() * letters.length * 1.2));
      };
      for (const read of [() => readMovingAi(damaged(text), 'f'), () => readTextGrid(damaged('..#\n.3?\n'), 'f'),
        () => readScenario(damaged(scenario), 'f'), () => readMapYaml(damaged(yaml), 'f'),
        () => readPnm(new TextEncoder().encode(damaged('P2\n2 2\n255\n0 1 2 3\n')), 'f')]) {
        try {
          read();
        } catch (reason) {
          expect((reason as Error).message).toMatch(/^f[:.]/);
        }
      }
    }
  });

  test('sizes that no file has are refused before memory is taken', () => {
    expect(() => readMovingAi('type octile\nheight 99999\nwidth 99999\nmap\n', 'f')).toThrow(/too many/);
    expect(() => readPnm(new TextEncoder().encode('P5 999999 999999 255\n'), 'f')).toThrow(/too many/);
  });

  test('grey values by the thresholds of a map.yaml', () => {
    expect([0, 90, 205, 254].map((value) => byteOf(value, 255, usualMeaning))).toEqual([0, 255, 255, 1]);
    expect(byteOf(100, 255, { ...usualMeaning, mode: 'raw' })).toBe(0);
    expect(byteOf(0, 255, { ...usualMeaning, negate: true })).toBe(1);
  });

  test('colours have the grey of the command line', async () => {
    expect([luma(255, 0, 0), luma(0, 255, 0), luma(255, 255, 0), luma(205, 205, 205)]).toEqual([76, 150, 226, 205]);
    const random = randomFrom(5);
    for (const kind of ['P3', 'P6']) {
      const samples = Array.from({ length: 40 * 30 * 3 }, () => Math.floor(random() * 256));
      const file = join(folder, `colours${kind}.ppm`);
      const header = Buffer.from(`${kind}\n40 30\n255\n`);
      writeFileSync(file, Buffer.concat([header, kind === 'P6' ? Buffer.from(samples) : Buffer.from(samples.join('\n'))]));
      const { grid } = await opened(file);
      expect(writeTextGrid(grid!)).toBe(converted(file));
    }
  });

  test('text grids come back as they were', () => {
    const random = randomFrom(9);
    for (let round = 0; round < 100; ++round) {
      const width = 1 + Math.floor(random() * 20);
      const rows = Array.from({ length: 1 + Math.floor(random() * 20) }, () =>
        Array.from({ length: width }, () => '.#?23456789'[Math.floor(random() * 11)]).join(''));
      const grid = `${rows.join('\n')}\n`;
      expect(writeTextGrid(readTextGrid(grid, 'f'))).toBe(grid);
    }
  });

  test('a path is saved in cells and metres', () => {
    const map = { name: '', width: 4, height: 4, cells: new Uint8Array(16), version: 0,
      frame: { resolution: 0.5, originX: 1, originY: -1, originYaw: 0, yUp: true, metric: true } };
    expect(pathCsv(map, Float64Array.of(0.5, 1.5, 0))).toBe('x,y,heading,x_m,y_m\n0.5,1.5,0,1.25,-0.25\n');
  });

  test("the origin's angle of a map.yaml turns metres", () => {
    const text = 'image: m.pgm\nresolution: 0.5\norigin: [1, -1, 1.5707963267948966]\n';
    const { frame } = readMapYaml(text, 'f');
    const map = { name: '', width: 4, height: 4, cells: new Uint8Array(16), version: 0, frame };
    const [, row] = pathCsv(map, Float64Array.of(0.5, 1.5, 0)).split('\n');
    const [, , , x, y] = row!.split(',').map(Number);
    expect(x).toBeCloseTo(1 - 0.75, 12);
    expect(y).toBeCloseTo(-1 + 0.25, 12);
    expect(readMapYaml(writeMapYaml('m.pgm', frame), 'f').frame).toEqual(frame);
  });
});
