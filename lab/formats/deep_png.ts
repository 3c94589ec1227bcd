// PNG images of 16 bits a sample. Browsers decode them to 8 bits; the library does not.

import { checkSize, fault } from './grid';
import { luma, type GreyImage } from './image';

/** Samples of a pixel, by the colour type of PNG. */
const channelsOf = new Map([[0, 1], [2, 3], [4, 2], [6, 4]]);

/** The image, if it is such a PNG: not interlaced, without a transparent colour. */
export async function readDeepPng(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<GreyImage | null> {
  const isPng = [137, 80, 78, 71, 13, 10, 26, 10].every((byte, i) => bytes[i] === byte);
  if (!isPng || bytes.length < 33) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const channels = channelsOf.get(bytes[25]!);
  if (bytes[24] !== 16 || bytes[28] !== 0 || !channels || width === 0 || height === 0) return null;
  checkSize(file, width, height);
  const packed: Uint8Array<ArrayBuffer>[] = [];
  for (let at = 8; at + 12 <= bytes.length; at += 12 + view.getUint32(at)) {
    const kind = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (kind === 'tRNS') return null;
    if (kind === 'IDAT') packed.push(bytes.subarray(at + 8, at + 8 + view.getUint32(at)));
  }
  const row = 2 * channels * width;
  const rows = await inflated(packed, (1 + row) * height, file);
  unfilter(rows, row, 2 * channels, height, file);
  return greyOf(rows, width, height, channels);
}

/** The first bytes of what was deflated. */
async function inflated(packed: Uint8Array<ArrayBuffer>[], size: number, file: string): Promise<Uint8Array> {
  const all = new Uint8Array(size);
  let total = 0;
  const reader = new Blob(packed).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  try {
    while (total < size) {
      const { done, value } = await reader.read();
      if (done) break;
      all.set(value.subarray(0, size - total), total);
      total += value.length;
    }
  } catch {
    throw fault(file, 0, 'the image is damaged');
  }
  void reader.cancel().catch(() => undefined);
  if (total < size) throw fault(file, 0, 'the image is cut off');
  return all;
}

/** Undoes the filters of the rows in place; each begins with a byte for its own. */
function unfilter(rows: Uint8Array, row: number, pixel: number, height: number, file: string): void {
  for (let y = 0; y < height; ++y) {
    const begin = y * (row + 1) + 1;
    const filter = rows[begin - 1]!;
    if (filter > 4) throw fault(file, 0, 'the image is damaged');
    for (let i = 0; i < row; ++i) {
      const left = i < pixel ? 0 : rows[begin + i - pixel]!;
      const above = y === 0 ? 0 : rows[begin + i - row - 1]!;
      const corner = i < pixel || y === 0 ? 0 : rows[begin + i - row - 1 - pixel]!;
      rows[begin + i]! += [0, left, above, (left + above) >> 1, nearestOf(left, above, corner)][filter]!;
    }
  }
}

/** Which of the three is nearest to left + above - corner. */
function nearestOf(left: number, above: number, corner: number): number {
  const [a, b, c] = [Math.abs(above - corner), Math.abs(left - corner), Math.abs(left + above - 2 * corner)];
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}

function greyOf(rows: Uint8Array, width: number, height: number, channels: number): GreyImage {
  const values = new Uint16Array(width * height);
  const transparent = new Uint8Array(width * height);
  for (let pixel = 0; pixel < values.length; ++pixel) {
    const begin = Math.floor(pixel / width) + 1 + 2 * channels * pixel;
    const sample = (channel: number) => rows[begin + 2 * channel]! * 256 + rows[begin + 2 * channel + 1]!;
    values[pixel] = channels < 3 ? sample(0) : luma(sample(0), sample(1), sample(2));
    transparent[pixel] = channels % 2 === 0 && sample(channels - 1) < 65535 ? 1 : 0;
  }
  return { width, height, maximum: 65535, values, transparent };
}
