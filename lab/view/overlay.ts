// The vector picture above the cells: path, ends, arrows to parents, the chain of a cell, the cursor.

import type { Extras } from '../engine/extras';
import type { MapDocument, State } from '../store/state';
import { Camera, type Point } from './camera';
import { drawBreakPoint, drawExtras } from './extras';
import { drawFootprint, drawHeading } from './footprint';
import type { Colours } from './palette';

export interface Overlay {
  state: State;
  map: MapDocument;
  camera: Camera;
  size: { width: number; height: number };
  colours: Colours;
  path: Float64Array | null;
  /** The points of the path that lead out of what blocks the start, with the first free one; 0: none. */
  wayOut: number;
  /** Does the path end at another place because none reaches the goal? */
  fallsShort: boolean;
  chain: Float64Array | null;
  /** The parents of cells, for arrows. */
  parents: Uint32Array | null;
  cursor: Point | null;
  keyboard: boolean;
  /** Does the planner know headings? */
  headings: boolean;
  /** Of the first search. */
  extras: Extras | null;
}

export function drawOverlay(context: CanvasRenderingContext2D, overlay: Overlay): void {
  const { camera, colours, map, state } = overlay;
  if (overlay.parents) drawArrows(context, overlay, overlay.parents);
  if (overlay.chain) {
    drawLine(context, overlay, overlay.chain, colours.halo, 4, []);
    drawLine(context, overlay, overlay.chain, colours.chain, 2, [5, 3]);
  }
  if (overlay.path) {
    const width = Math.max(2, Math.min(camera.zoom / 4, 6));
    drawLine(context, overlay, overlay.path, colours.halo, width + 3, []);
    drawLine(context, overlay, overlay.path.subarray(3 * Math.max(overlay.wayOut - 1, 0)), colours.path, width, []);
    if (overlay.wayOut > 0) drawLine(context, overlay, overlay.path.subarray(0, 3 * overlay.wayOut), colours.path, width, [width * 0.4, width * 1.8]);
    if (overlay.fallsShort) drawGap(context, overlay, overlay.path.subarray(-3), width);
  }
  drawFootprint(context, camera, map, state.start, state.footprint, colours.start);
  drawFootprint(context, camera, map, state.goal, state.footprint, colours.goal);
  const length = 2.2 * markSize(camera);
  if (overlay.headings) drawHeading(context, camera, map, state.start, length, colours.start);
  if (overlay.headings && state.headings) drawHeading(context, camera, map, state.goal, length, colours.goal);
  if (overlay.extras) drawExtras(context, camera, map, state, colours, overlay.extras);
  drawBreakPoint(context, camera, map, state, colours);
  if (overlay.cursor) drawCursor(context, overlay, overlay.cursor);
  drawEnd(context, camera.pixelOf(map, state.start), markSize(camera), colours.start, colours.halo, 'S');
  drawEnd(context, camera.pixelOf(map, state.goal), markSize(camera), colours.goal, colours.halo, 'G');
}

/** The radius of the marks of start and goal, in pixels. */
export function markSize(camera: Camera): number {
  return Math.max(8, Math.min(camera.zoom * 0.6, 14));
}

function drawLine(
  context: CanvasRenderingContext2D, { camera, map }: Overlay, points: Float64Array,
  colour: string, width: number, dashes: number[],
): void {
  context.strokeStyle = colour;
  context.lineWidth = width;
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.setLineDash(dashes);
  context.beginPath();
  for (let i = 0; i + 2 < points.length; i += 3) {
    const { x, y } = camera.pixelOf(map, { x: points[i]!, y: points[i + 1]! });
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  context.stroke();
  context.setLineDash([]);
}

/** From the path's end to the goal that no path reaches. */
function drawGap(context: CanvasRenderingContext2D, overlay: Overlay, end: Float64Array, width: number): void {
  const { x, y, heading } = overlay.state.goal;
  const gap = Float64Array.of(...end, x, y, heading);
  drawLine(context, overlay, gap, overlay.colours.halo, width + 1, []);
  drawLine(context, overlay, gap, overlay.colours.goal, width / 2, [1, width * 1.2]);
}

/** Start is a disc and goal a square: shapes differ, not only colours. */
function drawEnd(
  context: CanvasRenderingContext2D, { x, y }: Point, size: number, colour: string, halo: string, letter: string,
): void {
  context.beginPath();
  if (letter === 'S') context.arc(x, y, size, 0, 2 * Math.PI);
  else context.rect(x - size * 0.9, y - size * 0.9, size * 1.8, size * 1.8);
  context.fillStyle = colour;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = halo;
  context.stroke();
  context.fillStyle = halo;
  context.font = `600 ${Math.round(size * 1.2)}px system-ui, sans-serif`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.fillText(letter, x, y + 0.5);
}

function drawCursor(context: CanvasRenderingContext2D, { camera, map, colours, keyboard }: Overlay, cell: Point): void {
  const corner = camera.pixelOf(map, { x: cell.x, y: map.frame.yUp ? cell.y + 1 : cell.y });
  context.strokeStyle = colours.ink;
  context.lineWidth = keyboard ? 3 : 1.5;
  context.strokeRect(corner.x, corner.y, Math.max(camera.zoom, 4), Math.max(camera.zoom, 4));
}

function drawArrows(context: CanvasRenderingContext2D, { camera, map, colours, size: { width, height } }: Overlay, parents: Uint32Array): void {
  const least = 7;  // pixels: smaller arrows cannot be read
  if (camera.zoom < least) return;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1;
  context.beginPath();
  const first = camera.pointAt(map, { x: 0, y: 0 });
  const last = camera.pointAt(map, { x: width, y: height });
  const rows = [first.y, last.y].sort((a, b) => a - b);
  for (let y = Math.max(0, Math.floor(rows[0]!)); y < Math.min(map.height, Math.ceil(rows[1]!)); ++y) {
    for (let x = Math.max(0, Math.floor(first.x)); x < Math.min(map.width, Math.ceil(last.x)); ++x) {
      const parent = parents[y * map.width + x]!;
      if (parent === 0xffffffff) continue;
      const to = camera.pixelOf(map, { x: (parent % map.width) + 0.5, y: Math.floor(parent / map.width) + 0.5 });
      arrow(context, camera.pixelOf(map, { x: x + 0.5, y: y + 0.5 }), to, camera.zoom * 0.34);
    }
  }
  context.stroke();
}

function arrow(context: CanvasRenderingContext2D, from: Point, to: Point, size: number): void {
  const angle = Math.atan2(to.y - from.y, to.x - from.x);
  const tip = { x: from.x + size * Math.cos(angle), y: from.y + size * Math.sin(angle) };
  context.moveTo(from.x - size * Math.cos(angle), from.y - size * Math.sin(angle));
  context.lineTo(tip.x, tip.y);
  for (const side of [-2.6, 2.6]) {
    context.moveTo(tip.x, tip.y);
    context.lineTo(tip.x + size * 0.7 * Math.cos(angle + side), tip.y + size * 0.7 * Math.sin(angle + side));
  }
}
