// Map files read as the command line reads them; damaged ones are refused with their name, and never crash.

import { File as NodeFile } from 'node:buffer';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { deflateSync } from 'node:zlib';
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

/** A PNG of 16 bits a sample, whose rows have random filters. */
function deepPng(width: number, height: number, colour: number, channels: number, sample: () => number, below: (most: number) => number): Buffer {
  const row = 2 * channels * width;
  const pixel = 2 * channels;
  const plain = Buffer.alloc(row * height);
  for (let i = 0; i < plain.length; i += 2) plain.writeUInt16BE(sample(), i);
  const rows = Buffer.alloc((row + 1) * height);
  for (let y = 0; y < height; ++y) {
    const filter = below(5);
    rows[y * (row + 1)] = filter;
    for (let i = 0; i < row; ++i) {
      const left = i < pixel ? 0 : plain[y * row + i - pixel]!;
      const above = y === 0 ? 0 : plain[(y - 1) * row + i]!;
      const corner = i < pixel || y === 0 ? 0 : plain[(y - 1) * row + i - pixel]!;
      const nearest = [left, above, corner].sort((a, b) => Math.abs(left + above - corner - a) - Math.abs(left + above - corner - b))[0]!;
      rows[y * (row + 1) + 1 + i] = plain[y * row + i]! - [0, left, above, (left + above) >> 1, nearest][filter]!;
    }
  }
  const chunk = (kind: string, data: Buffer) => {
    const named = Buffer.concat([Buffer.from(kind, 'latin1'), data]);
    const ends = Buffer.alloc(8);
    ends.writeUInt32BE(data.length, 0);
    ends.writeUInt32BE(crc32(named), 4);
    return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([16, colour], 8);
  return Buffer.concat([Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', header), chunk('IDAT', deflateSync(rows)), chunk('IEND', Buffer.alloc(0))]);
}

/** The check of a chunk; Node.js 18 has none. */
function crc32(bytes: Buffer): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
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

  /** The notes on a file that the command line prints. */
  const printed = (file: string): string[] => {
    const { stderr } = spawnSync(program, ['convert', file, join(folder, 'converted.txt')], { encoding: 'utf8' });
    return stderr.split('\n').filter((line) => line.startsWith(`wend: ${file}: `)).map((line) => line.slice(`wend: ${file}: `.length));
  };
  const yamlOf = (name: string, more: string) => {
    const file = join(folder, `${name}.yaml`);
    writeFileSync(file, `image: ${name}.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n`
      .split('\n').filter((line) => line === '' || !more.includes(`${line.split(':')[0]}:`)).join('\n') + more);
    return file;
  };

  test('notes on maps that are probably not meant are those of the command line', async () => {
    const cases: [string, string, RegExp][] = [
      ['free_thresh: 0.25\n', 'P2 3 1 255 0 205 254\n', /grey 205.*counts as free here \(1 cell\)/],
      ['occupied_thresh: 0.19\nfree_thresh: 0.1\n', 'P2 3 1 255 0 205 205\n', /counts as occupied here \(2 cells\)/],
      ['negate: 1\n', 'P2 3 1 255 0 205 254\n', /with negate: 1/],
      ['origin: [0, 0, 90]\n', 'P2 3 1 255 0 205 254\n', /90 degrees are 1.5708 radians/],
      ['origin: [0, 0, 270]\n', 'P2 3 1 255 0 205 254\n', /270 degrees are -1.5708 radians/],
      ['resolution: 50\n', 'P2 3 1 255 0 205 254\n', /metres a cell: 50 is unusual/],
      ['', 'P2 3 1 65535 0 205 254\n', /the brightest pixel is 254 where white is 65535/],
      ['free_thresh: 0\n', 'P2 2 1 255 0 254\n', /no cell is free/],
      ['', 'P2 2 1 255 200 254\n', /no cell is occupied/],
      ['free_thresh: 0\nnegate: 1\n', 'P2 2 1 255 100 254\n', /negate: 1 makes white occupied/],
      ['author: me\n', 'P2 3 1 255 0 205 254\n', /unknown key 'author'/],
      ['', 'P5 3 1 255 \0ab and more', /9 bytes after the last pixel/],
      ['', 'P2 3 1 255 0 205 254\n', /^$/],
      ['mode: scale\nfree_thresh: 0.25\n', 'P2 3 1 255 0 205 254\n', /^$/],
    ];
    for (const [i, [yaml, image, note]] of cases.entries()) {
      const file = yamlOf(`doubt${i}`, yaml);
      writeFileSync(file.replace('.yaml', '.pgm'), image);
      const { grid } = await opened(file, file.replace('.yaml', '.pgm'));
      expect(grid!.notes.join(' '), yaml).toMatch(note);
      expect(grid!.notes, yaml).toEqual(printed(file));
    }
    const letters = join(folder, 'letters.map');
    writeFileSync(letters, 'type octile\nheight 1\nwidth 4\nmap\n.e@T\n');
    expect((await opened(letters)).grid!.notes).toEqual(printed(letters));
    expect((await opened(letters)).grid!.notes.length).toBe(2);
  });

  test('images of 16 bits are read as by the command line', async () => {
    const random = randomFrom(12);
    const below = (most: number) => Math.floor(random() * most);
    for (const [colour, channels] of [[0, 1], [2, 3], [4, 2], [6, 4]] as const) {
      for (const most of [65536, 255]) {
        const [width, height] = [7 + below(9), 5 + below(9)];
        const file = join(folder, `deep${colour}-${most}.png`);
        writeFileSync(file, deepPng(width, height, colour, channels, () => (random() < 0.2 ? 65535 : below(most)), below));
        const { grid } = await opened(file);
        expect(writeTextGrid(grid!), file).toBe(converted(file));
        expect(grid!.notes, file).toEqual(printed(file));
      }
    }
    const file = join(folder, 'dark.png');
    writeFileSync(file, deepPng(4, 4, 0, 1, () => below(256), below));
    expect((await opened(file)).grid!.notes.join()).toMatch(/where white is 65535/);
    for (let cut = 0; cut < 200; cut += 7) {
      const damaged = readFileSync(file).subarray(0, cut);
      const found = await openFiles([new NodeFile([damaged], 'cut.png') as unknown as File]).catch((reason: Error) => reason.message);
      expect(typeof found === 'string' || cut > 60, `${cut}`).toBe(true);
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
