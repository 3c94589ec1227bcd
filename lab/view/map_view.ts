// <lab-map>: the map and one search on it, on two canvases: cells, which the engine paints, and lines above.

import { css, html, LitElement } from 'lit';
import type { Engine } from '../engine/engine';
import type { Extras } from '../engine/extras';
import type { Runner } from '../engine/runner';
import { pathAt, type CellInfo, type Window } from '../engine/types';
import type { Clock } from '../store/clock';
import type { State } from '../store/state';
import type { Store } from '../store/store';
import { Camera, type Point } from './camera';
import { Hand, type Ground } from './hand';
import { drawOverlay } from './overlay';
import { type Colours, paletteOf } from './palette';

export interface Pointed {
  cell: Point;
  info: CellInfo;
  runner: Runner;
}

export class MapView extends LitElement implements Ground {
  static override styles = css`
    :host { position: relative; display: block; overflow: hidden; min-width: 0; min-height: 0; }
    canvas { position: absolute; inset: 0; width: 100%; height: 100%; image-rendering: pixelated; }
    canvas + canvas { touch-action: none; cursor: crosshair; outline-offset: -3px; }
    .embedded { touch-action: pan-y !important; }
    canvas + canvas:focus-visible { outline: 3px solid var(--accent); }
  `;
  static override properties = {
    label: { type: String },
  };

  declare label: string;
  store!: Store;
  clock!: Clock;
  runner!: Runner;
  camera!: Camera;
  colours!: Colours;
  /** Does its planner know headings? */
  headings = false;
  /** On a page of other things: the wheel scrolls that page, and zooms with Ctrl only. */
  embedded = false;
  /** Of the first search; null for others. */
  extras: Extras | null = null;
  /** The replay's step for this search, from the clock. */
  stepOf: () => number = () => this.clock.step;

  private hand = new Hand(this);
  private painting = false;
  private stale = true;
  /** Is an end or a brush dragged on this view? */
  private dragging = false;
  /** What the canvas of the cells shows. */
  private painted: Window | null = null;
  private paletteOf: Colours | null = null;
  private paletteEngine: Engine | null = null;
  private cursor: Point | null = null;
  private keyboard = false;
  private info: CellInfo | null = null;
  /** Which answer of the runner is drawn. */
  shown = -1;
  private infoVersion = -1;
  private infoCells: Uint8Array | undefined;
  private parents: Uint32Array | null = null;
  private parentsVersion = -1;
  private observer = new ResizeObserver(() => this.resized());

  constructor() {
    super();
    this.label = '';
  }

  get size(): { width: number; height: number } {
    return { width: this.clientWidth, height: this.clientHeight };
  }

  override render() {
    return html`
      <canvas aria-hidden="true"></canvas>
      <canvas class=${this.embedded ? 'embedded' : ''} tabindex="0" role="application" aria-label=${this.label} aria-roledescription="map"
        @pointerdown=${this.down} @pointermove=${this.move} @pointerup=${this.up} @pointercancel=${this.up}
        @pointerleave=${() => this.point(null, false)} @keydown=${this.key}
        @wheel=${this.wheel}
        @contextmenu=${(event: Event) => event.preventDefault()}></canvas>`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
  }

  /** Draws again as soon as possible. */
  refresh(): void {
    this.stale = true;
    if (!this.painting) void this.paintAll();
  }

  /** What the view shows, as PNG. */
  async picture(): Promise<Blob | null> {
    const canvases = this.canvases();
    if (!canvases) return null;
    const both = new OffscreenCanvas(canvases[0].width, canvases[0].height);
    const context = both.getContext('2d')!;
    for (const canvas of canvases) context.drawImage(canvas, 0, 0);
    return both.convertToBlob({ type: 'image/png' });
  }

  moved(): void {
    this.dispatchEvent(new CustomEvent('camera'));
  }

  answer(cell: Point): void {
    this.dispatchEvent(new CustomEvent('answer', { detail: cell }));
  }

  drag(active: boolean): void {
    this.dragging = active;
    this.dispatchEvent(new CustomEvent('drag', { detail: active }));
  }

  point(cell: Point | null, keyboard: boolean): void {
    if (cell?.x === this.cursor?.x && cell?.y === this.cursor?.y && keyboard === this.keyboard) return;
    this.cursor = cell;
    this.keyboard = keyboard;
    this.ask().catch(unlessEnded);
  }

  private async ask(): Promise<void> {
    const cell = this.cursor;
    const { version } = this.runner;
    this.info = null;
    this.infoVersion = version;
    this.infoCells = this.store.state.map?.cells;
    if (cell && this.store.state.map) {
      const info = await this.runner.engine.call('cell', cell.x, cell.y);
      if (cell !== this.cursor) return;
      if (!('error' in info)) this.info = info;
    }
    const detail: Pointed | null = cell && this.info ? { cell, info: this.info, runner: this.runner } : null;
    this.dispatchEvent(new CustomEvent('pointed', { detail }));
    this.refresh();
  }

  /** What is known of the cell under the pointer belongs to a search: another one is asked again. */
  private askAgain(): void {
    if (!this.cursor || this.dragging) return;
    const otherMap = this.infoCells !== this.store.state.map?.cells;
    if (otherMap) this.info = null;
    if (otherMap || this.infoVersion !== this.runner.version) this.ask().catch(unlessEnded);
  }

  private canvases(): [HTMLCanvasElement, HTMLCanvasElement] | null {
    const found = this.renderRoot.querySelectorAll('canvas');
    return found.length === 2 ? [found[0]!, found[1]!] : null;
  }

  private resized(): void {
    this.dispatchEvent(new CustomEvent('resized'));
    this.refresh();
  }

  private async paintAll(): Promise<void> {
    this.painting = true;
    while (this.stale) {
      this.stale = false;
      try {
        await this.paintOnce(this.store.state);
      } catch {
        break;  // the engine was ended: another view takes over
      }
    }
    this.painting = false;
  }

  private async paintOnce(state: State): Promise<void> {
    const canvases = this.canvases();
    const { width, height } = this.size;
    const map = state.map;
    if (!canvases || !map || width === 0 || height === 0) return;
    if (this.paletteOf !== this.colours || this.paletteEngine !== this.runner.engine) {
      this.paletteOf = this.colours;
      this.paletteEngine = this.runner.engine;
      this.runner.engine.call('setPalette', paletteOf(this.colours)).catch(unlessEnded);
    }
    this.askAgain();
    const ratio = Math.min(devicePixelRatio, 2);
    const [cells, lines] = canvases;
    const camera = this.camera.copy();
    const window = this.windowOf(camera, ratio);
    // The engine paints after its search. Until then only the lines change.
    const later = this.runner.busy && this.painted !== null && same(window, this.painted);
    const { version } = this.runner;
    if (!later) {
      const began = performance.now();
      const pixels = await this.pixelsAt(window, this.stepOf());
      this.dataset['paint'] = (performance.now() - began).toFixed(1);
      await this.fetchParents(state);
      size(cells, window);
      cells.getContext('2d', { alpha: false })!.putImageData(pixels, 0, 0);
      this.painted = window;
    }
    size(lines, window);
    const context = lines.getContext('2d')!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    this.drawLines(context, camera, this.stepOf());
    if (!later) this.shown = version;
  }

  /** What the view shows at a step, at one pixel a point of the screen; null if there is nothing. */
  async frame(step: number): Promise<ImageData | null> {
    const { width, height } = this.size;
    if (!this.store.state.map || width === 0 || height === 0) return null;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    const camera = this.camera.copy();
    context.putImageData(await this.pixelsAt(this.windowOf(camera, 1), step), 0, 0);
    this.drawLines(context as unknown as CanvasRenderingContext2D, camera, step);
    return context.getImageData(0, 0, width, height);
  }

  private windowOf(camera: Camera, ratio: number): Window {
    const { width, height } = this.size;
    return {
      width: Math.round(width * ratio), height: Math.round(height * ratio),
      left: camera.left, top: camera.top, cells: 1 / (camera.zoom * ratio),
    };
  }

  private async pixelsAt(window: Window, step: number): Promise<ImageData> {
    return new ImageData(await this.runner.engine.call('paint', window, step), window.width, window.height);
  }

  private drawLines(context: CanvasRenderingContext2D, camera: Camera, step: number): void {
    const { state } = this.store;
    const { outcome } = this.runner;
    const path = outcome ? pathAt(outcome, step) : null;
    // The paths that an anytime planner finds before have neither.
    const answer = outcome && path === outcome.path ? outcome : null;
    drawOverlay(context, {
      state, map: state.map!, camera, size: this.size, colours: this.colours, path,
      wayOut: answer?.wayOutPoints ?? 0, fallsShort: (answer?.remaining?.metres ?? 0) > 0,
      chain: this.info?.chain ?? null, parents: state.arrows ? this.parents : null,
      cursor: this.cursor, keyboard: this.keyboard, headings: this.headings, extras: this.extras,
    });
  }

  private async fetchParents(state: State): Promise<void> {
    if (!state.arrows || this.parentsVersion === this.runner.version) return;
    this.parentsVersion = this.runner.version;
    const parents = await this.runner.engine.call('parents');
    this.parents = parents.length > 0 ? parents : null;
  }

  private pixelOf(event: MouseEvent): Point {
    const box = this.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.hand.down(event, this.pixelOf(event));
  }
  private move(event: PointerEvent): void {
    this.hand.move(event, this.pixelOf(event));
  }
  private up(event: PointerEvent): void {
    this.hand.up(event);
  }
  private wheel(event: WheelEvent): void {
    if (!this.embedded || event.ctrlKey) this.hand.wheel(event, this.pixelOf(event));
  }
  private key(event: KeyboardEvent): void {
    if (this.hand.key(event)) event.preventDefault();
  }
}

/** An engine that was ended does not answer: the one in its place is asked again. */
const unlessEnded = () => undefined;

function same(one: Window, other: Window): boolean {
  return one.width === other.width && one.height === other.height && one.left === other.left && one.top === other.top && one.cells === other.cells;
}

function size(canvas: HTMLCanvasElement, { width, height }: Window): void {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

customElements.define('lab-map', MapView);
