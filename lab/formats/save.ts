// Files that a visitor saves: the map, the path, the picture.

import type { MapDocument } from '../store/state';
import { writeTextGrid } from './text_grid';

/** Offers a file to the visitor. */
export function offer(name: string, content: Blob | string): void {
  const blob = typeof content === 'string' ? new Blob([content], { type: 'text/plain' }) : content;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

export function mapText(map: MapDocument): string {
  return writeTextGrid(map);
}

/** The points of a path as CSV: grid coordinates, and metres of the map's frame. */
export function pathCsv(map: MapDocument, path: Float64Array): string {
  const { resolution, originX, originY, originYaw } = map.frame;
  const cos = resolution * Math.cos(originYaw);
  const sin = resolution * Math.sin(originYaw);
  const rows = ['x,y,heading,x_m,y_m'];
  for (let i = 0; i + 2 < path.length; i += 3) {
    const [x, y, heading] = [path[i]!, path[i + 1]!, path[i + 2]!];
    rows.push([x, y, heading, originX + cos * x - sin * y, originY + sin * x + cos * y].join(','));
  }
  return `${rows.join('\n')}\n`;
}

/** The map and a path as SVG, a unit a cell; a way out, its first points, is dashed. Runs of equal cells in a row are one rectangle. */
export function mapSvg(map: MapDocument, path: Float64Array | null, colours: { free: string; obstacle: string; unknown: string; roughMost: string; path: string },
  wayOut = 0): string {
  const { width, height, cells, frame } = map;
  const fill = (byte: number) => (byte === 0 ? colours.obstacle : byte === 255 ? colours.unknown : byte > 1 ? colours.roughMost : '');
  const parts = [`<rect width="${width}" height="${height}" fill="${colours.free}"/>`];
  for (let y = 0; y < height; ++y) {
    const row = frame.yUp ? height - 1 - y : y;
    for (let x = 0; x < width;) {
      const byte = cells[row * width + x]!;
      const begin = x;
      while (x < width && cells[row * width + x] === byte) ++x;
      if (fill(byte) !== '') parts.push(`<rect x="${begin}" y="${y}" width="${x - begin}" height="1" fill="${fill(byte)}"/>`);
    }
  }
  const line = (part: Float64Array, dashes: string) => {
    const points: string[] = [];
    for (let i = 0; i + 2 < part.length; i += 3) points.push(`${part[i]},${frame.yUp ? height - part[i + 1]! : part[i + 1]}`);
    parts.push(`<polyline points="${points.join(' ')}" fill="none" stroke="${colours.path}" stroke-width="0.3" stroke-linejoin="round"${dashes}/>`);
  };
  if (path && wayOut > 0) line(path.subarray(0, 3 * wayOut), ' stroke-dasharray="0.4 0.3"');
  if (path && path.length > 0) line(path.subarray(3 * Math.max(wayOut - 1, 0)), '');
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" shape-rendering="crispEdges">${parts.join('')}</svg>\n`;
}
