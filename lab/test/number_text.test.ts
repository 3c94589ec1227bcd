// Numbers as text: what std::to_chars and printf's %g write. The texts were written by them.

import { expect, test } from 'vitest';
import { generalText, numberOf, shortestText } from '../engine/number_text';
import { randomFrom } from './engine';

test('the shortest texts are those of std::to_chars', () => {
  const texts: [number, string][] = [
    [0, '0'], [-0, '-0'], [1, '1'], [-2.5, '-2.5'], [0.1, '0.1'], [1e5, '1e+05'], [123456, '123456'], [1e21, '1e+21'], [0.001, '0.001'],
    [0.0001, '1e-04'], [0.00012, '0.00012'], [1.5e300, '1.5e+300'], [5e-324, '5e-324'], [1 / 3, '0.3333333333333333'],
    [2 ** 53, '9007199254740992'], [2 ** 70, '1180591620717411303424'], [1e6, '1e+06'], [Infinity, 'inf'], [-Infinity, '-inf'], [NaN, 'nan'],
    [123456789012345680000, '123456789012345683968'], [100, '100'], [1000, '1000'], [10000, '10000'],
  ];
  for (const [value, text] of texts) expect(shortestText(value)).toBe(text);
});

test('texts of some digits are those of %g', () => {
  const texts: [number, number, string][] = [
    [0, 3, '0'], [1.125, 3, '1.12'], [1.135, 3, '1.14'], [0.0625, 2, '0.062'], [999.95, 3, '1e+03'], [99.95, 3, '100'], [1234567, 6, '1.23457e+06'],
    [0.00001234, 3, '1.23e-05'], [0.0001234, 3, '0.000123'], [2.5, 6, '2.5'], [-7, 4, '-7'], [100, 3, '100'], [3.14159265, 4, '3.142'],
  ];
  for (const [value, digits, text] of texts) expect(generalText(value, digits), String(value)).toBe(text);
});

test('every number reads back as itself', () => {
  const random = randomFrom(1);
  const bits = new DataView(new ArrayBuffer(8));
  for (let i = 0; i < 20_000; ++i) {
    for (const half of [0, 4]) bits.setUint32(half, Math.floor(random() * 2 ** 32));
    const value = bits.getFloat64(0);
    expect(Object.is(numberOf(shortestText(value)), Number.isNaN(value) ? NaN : value), String(value)).toBe(true);
    expect(Object.is(numberOf(shortestText(Math.fround(random() * 1e4))), NaN)).toBe(false);
  }
});

test('texts that are not numbers, or too large ones, are told apart', () => {
  for (const text of ['', ' 1', '1 ', '+1', '0x1', '1e', '1,5', '.', '-', 'e5', '1_0', 'infinit']) expect(numberOf(text), text).toBeUndefined();
  for (const text of ['1e999', '-1e999', '1e-999']) expect(numberOf(text), text).toBeNull();
  for (const [text, value] of [['.5', 0.5], ['5.', 5], ['1E3', 1000], ['-inf', -Infinity], ['INFINITY', Infinity], ['0e999', 0]] as const) {
    expect(numberOf(text), text).toBe(value);
  }
});
