// What all readers of map files make, and how they fail. They read as the C++ library does (wend/io/map), and refuse
// what it refuses.

import { plainFrame, type Frame } from '../engine/types';

export interface GridFile {
  width: number;
  height: number;
  frame: Frame;
  /** A byte a cell, see lab/wasm/cells.hpp; the first row is that of the frame's row 0. */
  cells: Uint8Array;
  /** What is unusual or probably not meant in the file: sentences, as the library's. */
  notes: string[];
}

export const mostSide = 4096;

/** Why a file is not a map, with the line. */
export class FileFault extends Error {}

export function fault(file: string, line: number, what: string): FileFault {
  return new FileFault(line > 0 ? `${file}:${line}: ${what}` : `${file}: ${what}`);
}

export function checkSize(file: string, width: number, height: number): void {
  if (width > mostSide || height > mostSide) {
    throw fault(file, 0, `${width} x ${height} cells are too many, the lab takes ${mostSide} x ${mostSide}`);
  }
}

export function plainGrid(width: number, height: number, cells: Uint8Array, notes: string[] = []): GridFile {
  return { width, height, frame: plainFrame, cells, notes };
}

/** Lines without their ends, LF or CRLF. */
export function linesOf(text: string): string[] {
  const lines = text.split('\n').map((line) => (line.endsWith('\r') ? line.slice(0, -1) : line));
  if (lines.at(-1) === '') lines.pop();
  return lines;
}
