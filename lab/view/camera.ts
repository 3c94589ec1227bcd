// Camera: which part of the map a view shows. Rows are counted as they are drawn, from the top.

import type { MapDocument } from '../store/state';

export interface Point {
  x: number;
  y: number;
}

const leastZoom = 1 / 64;  // pixels a cell
const mostZoom = 96;

export class Camera {
  /** The point at the upper left corner, and the pixels that a cell takes. */
  left = 0;
  top = 0;
  zoom = 8;

  /** Shows the whole map in a view of this size. */
  fit(map: { width: number; height: number }, width: number, height: number): void {
    const margin = 12;
    const zoom = Math.min((width - 2 * margin) / map.width, (height - 2 * margin) / map.height);
    // Whole pixels a cell where there are some, so that all cells look alike.
    this.zoom = clamp(zoom >= 4 ? Math.floor(zoom) : zoom, leastZoom, 48);
    this.left = (map.width - width / this.zoom) / 2;
    this.top = (map.height - height / this.zoom) / 2;
  }

  /** Zooms by a factor around a pixel. */
  zoomAt(pixel: Point, factor: number): void {
    const zoom = clamp(this.zoom * factor, leastZoom, mostZoom);
    this.left += pixel.x / this.zoom - pixel.x / zoom;
    this.top += pixel.y / this.zoom - pixel.y / zoom;
    this.zoom = zoom;
  }

  pan(dx: number, dy: number): void {
    this.left -= dx / this.zoom;
    this.top -= dy / this.zoom;
  }

  /** Moves as little as needed so that a point in grid coordinates is in a view of this size. */
  reveal(map: MapDocument, point: Point, width: number, height: number): void {
    const pixel = this.pixelOf(map, point);
    const margin = 24;
    this.pan(clamp(pixel.x, margin, width - margin) - pixel.x, clamp(pixel.y, margin, height - margin) - pixel.y);
  }

  /** The point in grid coordinates under a pixel. */
  pointAt(map: MapDocument, pixel: Point): Point {
    const x = this.left + pixel.x / this.zoom;
    const row = this.top + pixel.y / this.zoom;
    return { x, y: map.frame.yUp ? map.height - row : row };
  }

  pixelOf(map: MapDocument, point: Point): Point {
    const row = map.frame.yUp ? map.height - point.y : point.y;
    return { x: (point.x - this.left) * this.zoom, y: (row - this.top) * this.zoom };
  }

  copy(): Camera {
    return Object.assign(new Camera(), this);
  }
}

export function clamp(value: number, least: number, greatest: number): number {
  return Math.min(Math.max(value, least), greatest);
}
