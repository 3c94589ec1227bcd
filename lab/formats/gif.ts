// Animated GIFs (GIF89a): one palette for all frames, LZW.

export interface Frame {
  width: number;
  height: number;
  /** Red, green, blue, alpha of each pixel. */
  data: Uint8ClampedArray;
}

/** Colours that are joined have the same five upper bits of each channel. */
const keyOf = (data: Uint8ClampedArray, at: number) => ((data[at]! >> 3) << 10) | ((data[at + 1]! >> 3) << 5) | (data[at + 2]! >> 3);

/** A GIF of frames of one size, each shown for some hundredths of a second, the last one for longer. */
export function writeGif(frames: Frame[], hundredths: number, lastHundredths: number): Uint8Array {
  const first = frames[0]!;
  const { colours, indexOf } = paletteOf(frames);
  const out: number[] = [];
  const word = (value: number) => out.push(value & 255, value >> 8);
  out.push(...new TextEncoder().encode('GIF89a'));
  word(first.width);
  word(first.height);
  out.push(0xf7, 0, 0, ...colours);
  out.push(0x21, 0xff, 11, ...new TextEncoder().encode('NETSCAPE2.0'), 3, 1, 0, 0, 0);
  const parts: Uint8Array[] = [Uint8Array.from(out)];
  frames.forEach((frame, i) => {
    out.length = 0;
    out.push(0x21, 0xf9, 4, 4);
    word(i + 1 === frames.length ? lastHundredths : hundredths);
    out.push(0, 0, 0x2c, 0, 0, 0, 0);
    word(frame.width);
    word(frame.height);
    out.push(0);
    parts.push(Uint8Array.from(out), blocksOf(compressed(pixelsOf(frame, indexOf))));
  });
  parts.push(Uint8Array.of(0x3b));
  return joined(parts);
}

/** The 256 most frequent colours, and the nearest of them for each key. */
function paletteOf(frames: Frame[]): { colours: Uint8Array; indexOf: Uint8Array } {
  const counts = new Uint32Array(1 << 15);
  const sample = new Uint32Array(1 << 15);
  for (const { data } of frames) {
    for (let at = 0; at < data.length; at += 4) {
      const key = keyOf(data, at);
      if (counts[key]!++ === 0) sample[key] = (data[at]! << 16) | (data[at + 1]! << 8) | data[at + 2]!;
    }
  }
  const keys = [...counts.keys()].filter((key) => counts[key]! > 0).sort((a, b) => counts[b]! - counts[a]!);
  const chosen = keys.slice(0, 256).map((key) => sample[key]!);
  const colours = new Uint8Array(768);
  chosen.forEach((colour, i) => colours.set([colour >> 16, (colour >> 8) & 255, colour & 255], 3 * i));
  const indexOf = new Uint8Array(1 << 15);
  for (const key of keys) indexOf[key] = nearest(chosen, sample[key]!);
  return { colours, indexOf };
}

function nearest(colours: number[], colour: number): number {
  let best = 0;
  let least = Infinity;
  colours.forEach((each, i) => {
    const distance = [16, 8, 0].reduce((sum, shift) => sum + (((each >> shift) & 255) - ((colour >> shift) & 255)) ** 2, 0);
    if (distance < least) [best, least] = [i, distance];
  });
  return best;
}

function pixelsOf({ data }: Frame, indexOf: Uint8Array): Uint8Array {
  const pixels = new Uint8Array(data.length / 4);
  for (let i = 0; i < pixels.length; ++i) pixels[i] = indexOf[keyOf(data, 4 * i)]!;
  return pixels;
}

/** LZW with codes of 9 to 12 bits. */
function compressed(pixels: Uint8Array): Uint8Array {
  const clear = 256;
  const bytes: number[] = [];
  let bits = 0;
  let count = 0;
  let size = 9;
  let next = clear + 2;
  let codes = new Map<number, number>();
  const put = (code: number) => {
    bits |= code << count;
    count += size;
    for (; count >= 8; count -= 8, bits >>= 8) bytes.push(bits & 255);
  };
  put(clear);
  let prefix = pixels[0] ?? 0;
  for (let i = 1; i < pixels.length; ++i) {
    const key = (prefix << 8) | pixels[i]!;
    const known = codes.get(key);
    if (known !== undefined) {
      prefix = known;
      continue;
    }
    put(prefix);
    prefix = pixels[i]!;
    if (next === 4096) {
      put(clear);
      codes = new Map();
      size = 9;
      next = clear + 2;
      continue;
    }
    codes.set(key, next);
    // A decoder is one code behind.
    if (next++ === 1 << size) ++size;
  }
  put(prefix);
  put(clear + 1);
  if (count > 0) bytes.push(bits & 255);
  return Uint8Array.from(bytes);
}

/** The smallest code size, then blocks of at most 255 bytes. */
function blocksOf(bytes: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = [Uint8Array.of(8)];
  for (let at = 0; at < bytes.length; at += 255) {
    const block = bytes.subarray(at, at + 255);
    parts.push(Uint8Array.of(block.length), block);
  }
  parts.push(Uint8Array.of(0));
  return joined(parts);
}

function joined(parts: Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
