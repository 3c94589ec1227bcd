// The outline of a robot at a place, for the overlay.

import type { MapDocument, Place } from '../store/state';
import type { Camera } from './camera';

export interface Rectangle { length: number; width: number; ahead: number }

/** The sides of "rect:0.8x0.5,0.2", and how far its centre lies ahead of the base point; null for other shapes. In metres. */
export function rectangleOf(footprint: string): Rectangle | null {
  const [, length, width, ahead] = /^\s*rect:([^x,]+)x([^x,]+)(?:,([^x,]+))?$/.exec(footprint) ?? [];
  if (length === undefined || width === undefined) return null;
  return { length: Number(length), width: Number(width), ahead: Number(ahead ?? 0) };
}

export function rectangleText({ length, width, ahead }: Rectangle): string {
  return `rect:${length}x${width}${ahead === 0 ? '' : `,${ahead}`}`;
}

/** The radius of "disc:0.3", or the corners of "x,y; x,y; ..." or of a rectangle; null for a point. In metres. */
export function outlineOf(footprint: string): number | [number, number][] | null {
  if (footprint === 'point') return null;
  if (footprint.startsWith('disc:')) return Number(footprint.slice(5)) || null;
  const rectangle = rectangleOf(footprint);
  if (rectangle) {
    const { ahead, length, width } = rectangle;
    const [front, rear, side] = [ahead + length / 2, ahead - length / 2, width / 2];
    return [[front, side], [rear, side], [rear, -side], [front, -side]];
  }
  const numbers = footprint.match(/-?[\d.]+(?:e-?\d+)?/gi)?.map(Number) ?? [];
  const corners: [number, number][] = [];
  for (let i = 0; i + 1 < numbers.length; i += 2) corners.push([numbers[i]!, numbers[i + 1]!]);
  return corners.length < 3 ? null : corners;
}

export function drawFootprint(
  context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, place: Place, footprint: string, colour: string,
): void {
  const outline = outlineOf(footprint);
  if (outline === null) return;
  const scale = 1 / map.frame.resolution;
  context.beginPath();
  if (typeof outline === 'number') {
    const { x, y } = camera.pixelOf(map, place);
    context.arc(x, y, outline * scale * camera.zoom, 0, 2 * Math.PI);
  } else {
    const cos = Math.cos(place.heading) * scale;
    const sin = Math.sin(place.heading) * scale;
    for (const [ahead, aside] of outline) {
      const { x, y } = camera.pixelOf(map, { x: place.x + ahead * cos - aside * sin, y: place.y + ahead * sin + aside * cos });
      context.lineTo(x, y);
    }
    context.closePath();
  }
  context.globalAlpha = 0.25;
  context.fillStyle = colour;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = 1.5;
  context.strokeStyle = colour;
  context.stroke();
}

/** An arrow along a heading, where headings count. */
export function drawHeading(
  context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, place: Place, length: number, colour: string,
): void {
  const from = camera.pixelOf(map, place);
  const up = map.frame.yUp ? -1 : 1;
  const to = { x: from.x + length * Math.cos(place.heading), y: from.y + up * length * Math.sin(place.heading) };
  context.lineWidth = 4;
  context.strokeStyle = colour;
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(to.x, to.y);
  context.stroke();
}
