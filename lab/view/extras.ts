// The drive of a robot, the widest path and the break-point, for the overlay.

import type { Extras } from '../engine/extras';
import { sampleSize } from '../engine/types';
import type { MapDocument, State } from '../store/state';
import type { Camera } from './camera';
import { drawFootprint } from './footprint';
import type { Colours } from './palette';

export function drawExtras(
  context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, state: State, colours: Colours, extras: Extras,
): void {
  drawWidest(context, camera, map, colours, extras);
  drawDrive(context, camera, map, state, colours, extras);
}

/** A diamond on the cell at which a replay stops. */
export function drawBreakPoint(context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, state: State, colours: Colours): void {
  if (!state.breakPoint) return;
  const { x, y } = camera.pixelOf(map, { x: state.breakPoint.x + 0.5, y: state.breakPoint.y + 0.5 });
  const size = Math.max(6, Math.min(camera.zoom * 0.5, 12));
  context.beginPath();
  context.moveTo(x, y - size);
  context.lineTo(x + size, y);
  context.lineTo(x, y + size);
  context.lineTo(x - size, y);
  context.closePath();
  context.fillStyle = colours.current;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = colours.halo;
  context.stroke();
}

function drawWidest(context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, colours: Colours, { widest }: Extras): void {
  if (!widest || 'error' in widest || !widest.joined) return;
  context.beginPath();
  for (let i = 0; i + 2 < widest.path.length; i += 3) {
    const { x, y } = camera.pixelOf(map, { x: widest.path[i]!, y: widest.path[i + 1]! });
    context.lineTo(x, y);
  }
  context.lineWidth = 3;
  context.setLineDash([2, 5]);
  context.lineCap = 'round';
  context.strokeStyle = colours.start;
  context.stroke();
  context.setLineDash([]);
  if (widest.radius === null) return;
  const { x, y } = camera.pixelOf(map, widest);
  context.beginPath();
  context.arc(x, y, Math.max(widest.radius * camera.zoom, 5), 0, 2 * Math.PI);
  context.lineWidth = 3;
  context.stroke();
}

function drawDrive(
  context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, state: State, colours: Colours, extras: Extras,
): void {
  const sample = extras.sample();
  if (!sample || !extras.drive || 'error' in extras.drive) return;
  const { samples } = extras.drive;
  context.beginPath();
  for (let i = 0; i <= Math.min(extras.clock.step, samples.length / sampleSize - 1); ++i) {
    const { x, y } = camera.pixelOf(map, { x: samples[i * sampleSize + 1]!, y: samples[i * sampleSize + 2]! });
    context.lineTo(x, y);
  }
  context.lineWidth = 2;
  context.strokeStyle = colours.current;
  context.stroke();
  const [, x, y, heading] = sample as unknown as [number, number, number, number];
  drawFootprint(context, camera, map, { x, y, heading }, state.footprint, colours.current);
  drawArrowhead(context, camera, map, { x, y, heading }, colours);
}

/** The robot itself, as an arrowhead of constant size. */
function drawArrowhead(
  context: CanvasRenderingContext2D, camera: Camera, map: MapDocument, place: { x: number; y: number; heading: number }, colours: Colours,
): void {
  const { x, y } = camera.pixelOf(map, place);
  const angle = map.frame.yUp ? -place.heading : place.heading;
  context.beginPath();
  for (const [turn, size] of [[0, 12], [2.5, 9], [Math.PI, 3], [-2.5, 9]] as const) {
    context.lineTo(x + size * Math.cos(angle + turn), y + size * Math.sin(angle + turn));
  }
  context.closePath();
  context.fillStyle = colours.current;
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = colours.halo;
  context.stroke();
}
