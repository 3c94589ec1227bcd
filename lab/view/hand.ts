// Hand: what pointers and keys do on a map: drag ends, paint, pan, pinch, move a cursor of cells.

import { obstacle } from '../engine/types';
import { centreOf, type State } from '../store/state';
import type { Store } from '../store/store';
import { Brush, byteOf } from './brush';
import type { Camera, Point } from './camera';
import { markSize } from './overlay';

export type End = 'start' | 'goal';

/** What a hand needs of the view that it works on. */
export interface Ground {
  readonly store: Store;
  readonly camera: Camera;
  readonly size: { width: number; height: number };
  /** The camera moved. */
  moved(): void;
  /** A cell is pointed at, or none. */
  point(cell: Point | null, keyboard: boolean): void;
  /** A cell is the answer to an exercise. */
  answer(cell: Point): void;
  /** Ends or a brush are being dragged, or no longer. */
  drag(active: boolean): void;
}

const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
};

/** Sets the break-point on a cell, or takes it away. */
export function toggleBreakPoint(store: Store, { x, y }: Point): void {
  const { breakPoint } = store.state;
  store.set({ breakPoint: breakPoint?.x === x && breakPoint.y === y ? null : { x, y } });
}

export class Hand {
  private readonly touches = new Map<number, Point>();
  private brush: Brush | null = null;
  private end: { which: End; before: Partial<State> } | null = null;
  private panning = false;
  private cursor: Point | null = null;

  constructor(private readonly ground: Ground) {}

  down(event: PointerEvent, pixel: Point): void {
    this.touches.set(event.pointerId, pixel);
    if (this.touches.size > 1) return this.beginPan();
    const { store } = this.ground;
    if (store.state.exercise === 'next' && event.button === 0) {
      const cell = this.cellAt(pixel);
      if (cell) this.ground.answer(cell);
      return;
    }
    const end = this.endAt(pixel);
    if (event.button === 0 && end) {
      this.end = { which: end, before: { [end]: store.state[end] } };
      this.ground.drag(true);
    } else if (event.button !== 0 || store.state.tool === 'look') {
      this.panning = true;
    } else {
      const cell = this.cellAt(pixel);
      if (!cell) return;
      if (store.state.tool === 'break') return toggleBreakPoint(store, cell);
      this.ground.drag(true);
      this.brush = this.brushAt(cell);
    }
  }

  move(event: PointerEvent, pixel: Point): void {
    const before = this.touches.get(event.pointerId);
    if (!before) return this.ground.point(this.cellAt(pixel), false);
    this.touches.set(event.pointerId, pixel);
    if (this.touches.size > 1) return this.pinch(event.pointerId, before, pixel);
    const cell = this.cellAt(pixel);
    if (this.end && cell) this.moveEnd(this.end.which, cell);
    if (this.brush && cell) this.brush.moveTo(cell);
    if (this.panning) {
      this.ground.camera.pan(pixel.x - before.x, pixel.y - before.y);
      this.ground.moved();
    }
  }

  up(event: PointerEvent): void {
    this.touches.delete(event.pointerId);
    this.endStroke();
    this.panning = false;
    const end = this.end;
    this.end = null;
    if (!end) return;
    this.ground.drag(false);
    this.ground.store.commitSince(end.before);
  }

  wheel(event: WheelEvent, pixel: Point): void {
    event.preventDefault();
    this.ground.camera.zoomAt(pixel, Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)));
    this.ground.moved();
  }

  /** Returns whether the key was for the map. */
  key(event: KeyboardEvent): boolean {
    const { store, camera, size } = this.ground;
    const map = store.state.map;
    if (!map || event.ctrlKey || event.metaKey || event.altKey) return false;
    const arrow = arrows[event.key];
    this.cursor ??= { x: Math.floor(store.state.start.x), y: Math.floor(store.state.start.y) };
    const cell = this.cursor;
    if (arrow) {
      const step = event.shiftKey ? 10 : 1;
      const dy = map.frame.yUp ? -arrow[1] : arrow[1];
      cell.x = Math.min(Math.max(cell.x + step * arrow[0], 0), map.width - 1);
      cell.y = Math.min(Math.max(cell.y + step * dy, 0), map.height - 1);
      camera.reveal(map, { x: cell.x + 0.5, y: cell.y + 0.5 }, size.width, size.height);
      this.ground.moved();
    } else if (event.key === 'b') {
      toggleBreakPoint(store, cell);
    } else if (event.key === ' ' || event.key === 'Enter') {
      if (store.state.exercise === 'next') this.ground.answer({ ...cell });
      else this.brushAt(cell)?.end();
    } else if (event.key === 's' || event.key === 'g') {
      const end: End = event.key === 's' ? 'start' : 'goal';
      const before = { [end]: store.state[end] };
      this.moveEnd(end, cell);
      store.commitSince(before);
    } else if (event.key === '+' || event.key === '-') {
      camera.zoomAt({ x: size.width / 2, y: size.height / 2 }, event.key === '+' ? 1.25 : 0.8);
      this.ground.moved();
    } else if (event.key === '0') {
      camera.fit(map, size.width, size.height);
      this.ground.moved();
    } else {
      return false;
    }
    this.ground.point({ ...cell }, true);
    return true;
  }

  /** Moves an end to a cell, without a step to undo. Its heading stays. */
  private moveEnd(end: End, { x, y }: Point): void {
    const { store } = this.ground;
    store.set({ [end]: { ...centreOf(x, y), heading: store.state[end].heading } });
  }

  private brushAt(cell: Point): Brush | null {
    const { map, tool, cost, brush } = this.ground.store.state;
    if (!map || tool === 'look' || tool === 'break') return null;
    // A wall that is touched goes away: one tool is enough to play.
    const wallAlready = tool === 'wall' && map.cells[cell.y * map.width + cell.x] === obstacle;
    return new Brush(this.ground.store, wallAlready ? 1 : byteOf(tool, cost), brush, cell);
  }

  private endAt(pixel: Point): End | null {
    const { camera, store } = this.ground;
    const { map } = store.state;
    if (!map) return null;
    const near = (end: End) => {
      const at = camera.pixelOf(map, store.state[end]);
      return Math.hypot(at.x - pixel.x, at.y - pixel.y) <= Math.max(markSize(camera), 14);
    };
    return near('goal') ? 'goal' : near('start') ? 'start' : null;
  }

  private cellAt(pixel: Point): Point | null {
    const { map } = this.ground.store.state;
    if (!map) return null;
    const point = this.ground.camera.pointAt(map, pixel);
    const cell = { x: Math.floor(point.x), y: Math.floor(point.y) };
    return cell.x >= 0 && cell.y >= 0 && cell.x < map.width && cell.y < map.height ? cell : null;
  }

  private beginPan(): void {
    this.endStroke();
    this.panning = false;
  }

  private endStroke(): void {
    if (!this.brush) return;
    this.brush.end();
    this.brush = null;
    this.ground.drag(false);
  }

  /** Two fingers: what lay under them stays under them. */
  private pinch(id: number, before: Point, now: Point): void {
    const other = [...this.touches].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const spread = (point: Point) => Math.max(Math.hypot(point.x - other.x, point.y - other.y), 1);
    const { camera } = this.ground;
    camera.zoomAt({ x: (other.x + before.x) / 2, y: (other.y + before.y) / 2 }, spread(now) / spread(before));
    camera.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    this.ground.moved();
  }
}
