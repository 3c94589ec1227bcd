// Text grids: a letter a cell; see wend/io/map/text_grid.cpp.

import { unknown } from '../engine/types';
import { checkSize, fault, linesOf, plainGrid, type GridFile } from './grid';

function byteOf(letter: string): number | undefined {
  if (letter === '.' || letter === '0') return 1;
  if (letter === '#' || letter === '@' || letter === '1') return 0;
  if (letter === '?') return unknown;
  if (letter === '~') return 2;
  return letter >= '2' && letter <= '9' ? Number(letter) : undefined;
}

export function readTextGrid(text: string, file: string): GridFile {
  const rows: number[][] = [];
  let blank = 0;
  linesOf(text).forEach((line, i) => {
    if (line.trim() === '') {
      blank ||= i + 1;
      return;
    }
    if (blank > 0) throw fault(file, blank, 'blank line before a row of cells');
    const row: number[] = [];
    [...line].forEach((letter, column) => {
      if (letter === ' ' || letter === '\t') return;
      const byte = byteOf(letter);
      if (byte === undefined) throw fault(file, i + 1, `unknown letter '${letter}' in column ${column + 1}`);
      row.push(byte);
    });
    const first = rows[0] ?? row;
    if (row.length !== first.length) throw fault(file, i + 1, `expected ${first.length} cells as in the first row, not ${row.length}`);
    rows.push(row);
  });
  if (rows.length === 0) throw fault(file, 0, 'the text grid has no cells');
  const width = rows[0]!.length;
  checkSize(file, width, rows.length);
  const cells = new Uint8Array(width * rows.length);
  rows.forEach((row, y) => cells.set(row, y * width));
  return plainGrid(width, rows.length, cells);
}

/** A text grid, the row that is drawn first on top. Costs of 10 and more become 9. */
export function writeTextGrid({ width, height, frame, cells }: Omit<GridFile, 'notes'>): string {
  const letter = (byte: number) => (byte === 0 ? '#' : byte === unknown ? '?' : byte === 1 ? '.' : String(Math.min(byte, 9)));
  const rows = Array.from({ length: height }, (_, y) => {
    const row = frame.yUp ? height - 1 - y : y;
    return Array.from(cells.subarray(row * width, (row + 1) * width), letter).join('');
  });
  return `${rows.join('\n')}\n`;
}
