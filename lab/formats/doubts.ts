// Notes on maps that are legal, but probably not meant: the sentences of wend/io/map/doubts.cpp.

import { shortestText } from '../engine/number_text';
import { unknown, type Frame } from '../engine/types';
import { byteOf, type GreyImage, type Meaning } from './image';

const fullTurn = 2 * Math.PI;
const savedUnknown = 205;

/** A yaw that can only be degrees, and a resolution that can only be another unit than metres. */
export function doubtsAboutFrame({ originYaw, resolution }: Frame): string[] {
  const doubts: string[] = [];
  if (Math.abs(originYaw) > fullTurn + 1e-3) {
    const yaw = shortestText(originYaw);
    const turn = originYaw - 360 * Math.round(originYaw / 360);
    doubts.push(`the yaw of the origin is read in radians: ${yaw} is more than a full turn; ${yaw} degrees are ${((turn * fullTurn) / 360).toFixed(4)} radians`);
  }
  if (resolution < 1e-3 || resolution > 10) {
    doubts.push(`the resolution is read in metres a cell: ${shortestText(resolution)} is unusual for a robot`);
  }
  return doubts;
}

/** An image that is almost black, unknown grey that is not unknown here, thresholds by which no cell is free or occupied. */
export function doubtsAboutImage(image: GreyImage, meaning: Meaning, cells: Uint8Array): string[] {
  const greys = greysOf(image);
  const black = almostBlack(image, greys, meaning);
  const missing = black ? null : missingState(image, greys, meaning, cells);
  return [black, knownUnknown(image, meaning), missing].filter((doubt) => doubt !== null);
}

interface Greys {
  darkest: number;
  brightest: number;
}

function greysOf({ values }: GreyImage): Greys {
  let darkest = 65535;
  let brightest = 0;
  for (const value of values) {
    if (value < darkest) darkest = value;
    if (value > brightest) brightest = value;
  }
  return { darkest, brightest };
}

function almostBlack({ maximum }: GreyImage, { brightest }: Greys, { mode }: Meaning): string | null {
  const dark = brightest > 0 && brightest <= Math.floor(maximum / 255);
  if (!dark || (mode === 'raw' && maximum <= 255)) return null;
  return `the brightest pixel is ${brightest} where white is ${maximum}, so the whole image is almost black; it was probably made from values of fewer bits`;
}

function knownUnknown({ values, maximum }: GreyImage, meaning: Meaning): string | null {
  if (meaning.mode !== 'trinary' || maximum % 255 !== 0) return null;
  const grey = (savedUnknown * maximum) / 255;
  let count = 0;
  for (const value of values) if (value === grey) ++count;
  const byte = byteOf(grey, maximum, meaning);
  if (count === 0 || byte === unknown) return null;
  const p = occupancy(savedUnknown, 255, meaning).toFixed(4);
  const [state, why] = byte === 0
    ? ['occupied', `occupied_thresh ${shortestText(meaning.occupied)} is not above its occupancy of ${p}${meaning.negate ? ' with negate: 1' : ''}`]
    : ['free', `free_thresh ${shortestText(meaning.free)} is not below its occupancy of ${p}`];
  return `grey ${savedUnknown}, which map savers write for unknown, counts as ${state} here (${count} ${count === 1 ? 'cell' : 'cells'}): ${why}`;
}

function missingState({ maximum }: GreyImage, { darkest, brightest }: Greys, meaning: Meaning, cells: Uint8Array): string | null {
  if (meaning.mode !== 'trinary' || darkest >= brightest) return null;
  const ends = [occupancy(darkest, maximum, meaning), occupancy(brightest, maximum, meaning)].sort((a, b) => a - b);
  const range = `the occupancies of its pixels are ${ends.map((p) => p.toFixed(4)).join(' to ')}`;
  if (cells.every((byte) => byte === 0 || byte === unknown)) {
    return `no cell is free: ${range}, and free ones are up to free_thresh ${shortestText(meaning.free)}${meaning.negate ? ' (negate: 1 makes white occupied)' : ''}`;
  }
  if (cells.includes(0)) return null;
  return `no cell is occupied: ${range}, and occupied ones begin at occupied_thresh ${shortestText(meaning.occupied)}`;
}

function occupancy(value: number, maximum: number, { negate }: Meaning): number {
  const shade = value / maximum;
  return negate ? shade : 1 - shade;
}
