// MovingAI's `.map` and `.scen`; see wend/io/map/moving_ai_map.cpp for the format.

import { checkSize, fault, linesOf, plainGrid, type GridFile } from './grid';

const bytes = new Map<string, number>();
for (const letter of '.GSE') bytes.set(letter, 1).set(letter.toLowerCase(), 1);
for (const letter of '@OTW') bytes.set(letter, 0).set(letter.toLowerCase(), 0);

export function readMovingAi(text: string, file: string): GridFile {
  const lines = linesOf(text);
  const type = words(lines[0] ?? '');
  if (type.length !== 2 || type[0] !== 'type') throw fault(file, 1, "the first line must be 'type octile'");
  if (type[1] !== 'octile') throw fault(file, 1, `map type '${type[1]}' is not supported, only 'octile' is`);
  let at = 1;
  const sizes = new Map<string, number>();
  for (; ; ++at) {
    const line = words(lines[at] ?? 'end of file');
    if (line.length === 1 && line[0] === 'map') break;
    const [name, value] = line;
    if (line.length !== 2 || (name !== 'height' && name !== 'width')) {
      throw fault(file, at + 1, "unexpected header line: expected 'height', 'width' or 'map'");
    }
    if (sizes.has(name)) throw fault(file, at + 1, `duplicate '${name}'`);
    if (!/^\d{1,9}$/.test(value!) || Number(value) === 0) throw fault(file, at + 1, `${name} '${value}' is not a positive whole number`);
    sizes.set(name, Number(value));
  }
  const width = sizes.get('width');
  const height = sizes.get('height');
  if (!width || !height) throw fault(file, at + 1, `the header has no line '${height ? 'width' : 'height'}'`);
  checkSize(file, width, height);
  const rows = lines.slice(at + 1, at + 1 + height);
  if (rows.length < height) throw fault(file, lines.length, `only ${rows.length} of the ${height} rows that the header declares`);
  const cells = new Uint8Array(width * height);
  rows.forEach((row, y) => {
    if (row.length !== width) throw fault(file, at + 2 + y, `row ${y} has ${row.length} columns, the header declares ${width}`);
    for (let x = 0; x < width; ++x) {
      const byte = bytes.get(row[x]!);
      if (byte === undefined) throw fault(file, at + 2 + y, `unknown terrain letter '${row[x]}' at row ${y} column ${x}`);
      cells[y * width + x] = byte;
    }
  });
  const extra = lines.slice(at + 1 + height).findIndex((line) => line.trim() !== '');
  if (extra >= 0) throw fault(file, at + 2 + height + extra, `extra row after the ${height} rows that the header declares`);
  const letters = rows.join('');
  const notes: string[] = [];
  if (/e/i.test(letters)) notes.push('terrain E (emitter) is read as free');
  if (/[a-z]/.test(letters)) notes.push('lower-case letters are read as upper-case ones');
  return plainGrid(width, height, cells, notes);
}

export interface ScenarioQuery {
  start: [number, number];
  goal: [number, number];
  length: number;
  width: number;
  height: number;
}

export function readScenario(text: string, file: string): ScenarioQuery[] {
  const queries: ScenarioQuery[] = [];
  linesOf(text).forEach((line, i) => {
    const fields = words(line);
    if (fields.length === 0 || fields[0] === 'version') return;
    const numbers = fields.slice(2).map(Number);
    if (fields.length !== 9 || numbers.some((number) => Number.isNaN(number))) {
      throw fault(file, i + 1, 'expected bucket, map, width, height, start x, start y, goal x, goal y and length');
    }
    const [width, height, startX, startY, goalX, goalY, length] = numbers as [number, number, number, number, number, number, number];
    const inside = (x: number, y: number) => Number.isInteger(x) && Number.isInteger(y) && x >= 0 && y >= 0 && x < width && y < height;
    if (!inside(startX, startY) || !inside(goalX, goalY)) throw fault(file, i + 1, 'start or goal lies outside the map');
    queries.push({ start: [startX, startY], goal: [goalX, goalY], length, width, height });
  });
  if (queries.length === 0) throw fault(file, 0, 'the scenario has no queries');
  return queries;
}

function words(line: string): string[] {
  return line.split(/\s+/).filter((word) => word !== '');
}
