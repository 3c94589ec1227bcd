// Images as maps: grey values by the thresholds of a map.yaml; see wend/io/map/image_map.hpp. PNG and the like are
// decoded by the browser, PNM here.

import { plainFrame, unknown, type Frame } from '../engine/types';
import { doubtsAboutImage } from './doubts';
import { checkSize, fault, type GridFile } from './grid';

export interface GreyImage {
  width: number;
  height: number;
  maximum: number;
  values: Uint16Array | Uint8Array;
  /** For each pixel: is it not fully opaque? Empty: none. */
  transparent: Uint8Array;
  notes?: string[];
}

export interface Meaning {
  mode: 'trinary' | 'scale' | 'raw';
  negate: boolean;
  occupied: number;
  free: number;
}

export const usualMeaning: Meaning = { mode: 'trinary', negate: false, occupied: 0.65, free: 0.196 };
const scaleFactor = 4;

/** The byte of a grey value. */
export function byteOf(value: number, maximum: number, meaning: Meaning): number {
  const costOf = (v: number) => Math.min(Math.round(1 + (scaleFactor * v) / 100), 254);
  if (meaning.mode === 'raw') {
    const v = Math.round((value / maximum) * 255);
    return v > 100 ? unknown : v === 100 ? 0 : costOf(v);
  }
  const p = meaning.negate ? value / maximum : (maximum - value) / maximum;
  if (p <= meaning.free) return 1;
  if (p >= meaning.occupied) return 0;
  if (meaning.mode === 'trinary') return unknown;
  return costOf(Math.round((100 * (p - meaning.free)) / (meaning.occupied - meaning.free)));
}

export function gridOf(image: GreyImage, meaning: Meaning = usualMeaning, frame: Frame = plainFrame): GridFile {
  const { width, height } = image;
  const table = Uint8Array.from({ length: image.maximum + 1 }, (_, value) => byteOf(value, image.maximum, meaning));
  const cells = new Uint8Array(width * height);
  for (let y = 0; y < height; ++y) {
    const row = frame.yUp ? height - 1 - y : y;
    for (let x = 0; x < width; ++x) {
      const pixel = y * width + x;
      const clear = meaning.mode !== 'raw' && image.transparent[pixel] === 1;
      cells[row * width + x] = clear ? unknown : table[image.values[pixel]!]!;
    }
  }
  return { width, height, frame, cells, notes: [...image.notes ?? [], ...doubtsAboutImage(image, meaning, cells)] };
}

/** The grey of a colour, as `luma()` of wend/io/image/grey_image.hpp. */
export function luma(red: number, green: number, blue: number): number {
  return Math.floor((299 * red + 587 * green + 114 * blue + 500) / 1000);
}

/** PBM, PGM and PPM, as text (P1 to P3) or bytes (P4 to P6). */
export function readPnm(bytes: Uint8Array, file: string): GreyImage {
  let at = 2;
  const kind = String.fromCharCode(...bytes.subarray(0, 2));
  if (!['P1', 'P2', 'P3', 'P4', 'P5', 'P6'].includes(kind)) throw fault(file, 0, `images of kind ${JSON.stringify(kind)} are not read here: save it as PNG or PGM`);
  const isBlank = (byte: number | undefined) => byte === 32 || (byte !== undefined && byte >= 9 && byte <= 13);
  const skipSpace = (): void => {
    while (isBlank(bytes[at]) || bytes[at] === 35) {
      if (bytes[at] === 35) while (at < bytes.length && bytes[at] !== 10) ++at;
      else ++at;
    }
  };
  const next = (digits = 9): number => {
    skipSpace();
    let text = '';
    while (text.length < digits && bytes[at] !== undefined && bytes[at]! >= 48 && bytes[at]! <= 57) text += String.fromCharCode(bytes[at++]!);
    if (text === '') throw fault(file, 0, 'the image is cut off, or a number in it is missing');
    return Number(text);
  };
  const width = next();
  const height = next();
  if (width === 0 || height === 0) throw fault(file, 0, 'the image has no pixels');
  checkSize(file, width, height);
  const bits = kind === 'P1' || kind === 'P4';
  const maximum = bits ? 1 : next();
  if (maximum < 1 || maximum > 65535) throw fault(file, 0, `the maximum ${maximum} is not between 1 and 65535`);
  const channels = kind === 'P3' || kind === 'P6' ? 3 : 1;
  const values = new Uint16Array(width * height);
  /** The grey of the samples that `sample` gives one after the other. */
  const grey = (sample: () => number): number => {
    const first = Math.min(sample(), maximum);
    return channels === 1 ? first : luma(first, Math.min(sample(), maximum), Math.min(sample(), maximum));
  };
  if (kind === 'P1' || kind === 'P2' || kind === 'P3') {
    // In a bitmap, 1 is black.
    for (let i = 0; i < values.length; ++i) values[i] = bits ? 1 - next(1) : grey(() => next());
    skipSpace();
  } else {
    ++at;  // one blank ends the header
    const wide = maximum > 255 ? 2 : 1;
    const row = bits ? Math.ceil(width / 8) : width * channels * wide;
    if (bytes.length < at + row * height) throw fault(file, 0, 'the image is cut off');
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        let from = at + y * row + x * channels * wide;
        const sample = () => (wide === 2 ? bytes[from++]! * 256 + bytes[from++]! : bytes[from++]!);
        values[y * width + x] = bits ? 1 - ((bytes[at + y * row + (x >> 3)]! >> (7 - (x & 7))) & 1) : grey(sample);
      }
    }
    at += row * height;
  }
  const rest = bytes.length - at;
  const notes = rest === 0 || (rest === 1 && isBlank(bytes[at])) ? [] : [`${rest} bytes after the last pixel of the image are ignored`];
  return { width, height, maximum, values, transparent: new Uint8Array(), notes };
}

/** An image that the browser can decode. */
export async function readPicture(blob: Blob, file: string): Promise<GreyImage> {
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  } catch {
    throw fault(file, 0, 'the image is damaged, or of a kind that this browser does not read');
  }
  const { width, height } = bitmap;
  checkSize(file, width, height);
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })!;
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const values = new Uint8Array(width * height);
  const transparent = new Uint8Array(width * height);
  for (let i = 0; i < values.length; ++i) {
    values[i] = luma(data[4 * i]!, data[4 * i + 1]!, data[4 * i + 2]!);
    transparent[i] = data[4 * i + 3] === 255 ? 0 : 1;
  }
  return { width, height, maximum: 255, values, transparent };
}
