// The colours of docs/colours.md, which differ in lightness or along blue and yellow for colour-blind readers.

export interface Colours {
  page: string;
  free: string;
  obstacle: string;
  unknown: string;
  tooClose: string;
  roughLeast: string;
  roughMost: string;
  expanded: string;
  frontier: string;
  current: string;
  grid: string;
  path: string;
  start: string;
  goal: string;
  halo: string;
  ink: string;
  chain: string;
  ramp: string[];
}

export const light: Colours = {
  page: '#F3F4F6', free: '#FFFFFF', obstacle: '#2B2D33', unknown: '#C6C9CE', tooClose: '#E4DDEF',
  roughLeast: '#FFF3B0', roughMost: '#D99A00', expanded: '#9BD0F2', frontier: '#4F8FE0',
  current: '#D03A86', grid: '#2B2D33', path: '#0072B2', start: '#009E73', goal: '#D55E00',
  halo: '#FFFFFF', ink: '#3C4047', chain: '#7D0552',
  ramp: ['#FDF3C4', '#F6B565', '#DE6B5B', '#96417F', '#3B2A6B'],
};

export const dark: Colours = {
  page: '#14161A', free: '#23272F', obstacle: '#C2C8D2', unknown: '#4A505B', tooClose: '#40334F',
  roughLeast: '#705408', roughMost: '#E6A817', expanded: '#1D4F73', frontier: '#3B86C8',
  current: '#F25FB0', grid: '#C2C8D2', path: '#62BDF5', start: '#2FD6A3', goal: '#FF8B45',
  halo: '#14161A', ink: '#D5D9E0', chain: '#FFF06A',
  ramp: ['#2B2A55', '#4F3A86', '#86489A', '#C0608F', '#E08C7A'],
};

/** The bytes of a canvas, red first. */
export function bytesOf(colour: string): number {
  const [red, green, blue] = channelsOf(colour);
  return ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
}

function channelsOf(colour: string): [number, number, number] {
  const number = Number.parseInt(colour.slice(1), 16);
  return [number >> 16, (number >> 8) & 255, number & 255];
}

/** 256 colours between those of a ramp. */
function rampOf(colours: string[]): number[] {
  const stops = colours.map(channelsOf);
  return Array.from({ length: 256 }, (_, i) => {
    const at = (i / 255) * (stops.length - 1);
    const index = Math.min(Math.floor(at), stops.length - 2);
    const share = at - index;
    const [red, green, blue] = stops[index]!.map(
      (channel, c) => Math.round(channel + share * (stops[index + 1]![c]! - channel)));
    return ((255 << 24) | (blue! << 16) | (green! << 8) | red!) >>> 0;
  });
}

/** In the order of Palette in lab/wasm/painter.hpp. */
export function paletteOf(colours: Colours): Uint32Array {
  const { page, free, obstacle, unknown, tooClose, roughLeast, roughMost, expanded, frontier, current, grid } = colours;
  const single = [page, free, obstacle, unknown, tooClose, roughLeast, roughMost, expanded, frontier, current, grid];
  return Uint32Array.from([...single.map(bytesOf), ...rampOf(colours.ramp)]);
}
