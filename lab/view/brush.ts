// Brush: the cells that a stroke changes, each once, in the order in which it came to them.

import { obstacle } from '../engine/types';
import type { MapDocument, Tool } from '../store/state';
import type { Store, Stroke } from '../store/store';
import type { Point } from './camera';

/** The byte that a tool paints. */
export function byteOf(tool: Tool, cost: number): number {
  if (tool === 'wall') return obstacle;
  return tool === 'cost' ? cost : 1;
}

/** The cells between two, both included, each a neighbour of the one before. */
export function cellsBetween(from: Point, to: Point): Point[] {
  const steps = Math.max(Math.abs(to.x - from.x), Math.abs(to.y - from.y));
  return Array.from({ length: steps + 1 }, (_, i) => {
    const share = steps === 0 ? 0 : i / steps;
    return { x: Math.round(from.x + share * (to.x - from.x)), y: Math.round(from.y + share * (to.y - from.y)) };
  });
}

export class Brush {
  private readonly painted = new Map<number, number>();  // the byte before
  private last: Point;

  constructor(
    private readonly store: Store, private readonly byte: number, private readonly size: number, cell: Point,
  ) {
    this.last = cell;
    this.paint([cell]);
  }

  moveTo(cell: Point): void {
    this.paint(cellsBetween(this.last, cell));
    this.last = cell;
  }

  /** The stroke becomes one step to undo. */
  end(): void {
    const map = this.store.state.map;
    if (!map || this.painted.size === 0) return;
    const indices = Uint32Array.from(this.painted.keys());
    const stroke: Stroke = {
      indices,
      before: Uint8Array.from(this.painted.values()),
      after: new Uint8Array(indices.length).fill(this.byte),
    };
    this.store.commitStroke(stroke);
  }

  private paint(cells: Point[]): void {
    const map = this.store.state.map;
    if (!map) return;
    const fresh: number[] = [];
    for (const cell of cells) this.paintAround(map, cell, fresh);
    if (fresh.length === 0) return;
    this.store.paint(Uint32Array.from(fresh), new Uint8Array(fresh.length).fill(this.byte));
  }

  /** Notes the cells around one that are not painted yet. */
  private paintAround(map: MapDocument, cell: Point, fresh: number[]): void {
    const left = cell.x - Math.floor(this.size / 2);
    const top = cell.y - Math.floor(this.size / 2);
    const right = Math.min(left + this.size, map.width);
    const below = Math.min(top + this.size, map.height);
    for (let y = Math.max(top, 0); y < below; ++y) {
      for (let x = Math.max(left, 0); x < right; ++x) {
        const index = y * map.width + x;
        if (map.cells[index] === this.byte || this.painted.has(index)) continue;
        this.painted.set(index, map.cells[index]!);
        fresh.push(index);
      }
    }
  }
}
