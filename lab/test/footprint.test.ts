// Outlines of robots for the overlay: the same shapes as those of the command line's --footprint.

import { expect, test } from 'vitest';
import { outlineOf, rectangleOf, rectangleText } from '../view/footprint';

test('a rectangle has its centre ahead of the base point', () => {
  expect(rectangleOf('rect:0.8x0.5,0.2')).toEqual({ length: 0.8, width: 0.5, ahead: 0.2 });
  expect(rectangleOf('rect:2 x 1')).toEqual({ length: 2, width: 1, ahead: 0 });
  expect(outlineOf('rect:4x2,1')).toEqual([[3, 1], [-1, 1], [-1, -1], [3, -1]]);
  expect(rectangleOf('disc:0.3')).toBeNull();
  expect(rectangleOf('rect:2')).toBeNull();
});

test('a rectangle comes back from its text', () => {
  for (const sides of [{ length: 1, width: 0.5, ahead: 0 }, { length: 2.5, width: 1e-3, ahead: -0.25 }]) {
    expect(rectangleOf(rectangleText(sides))).toEqual(sides);
  }
});

test('other shapes are a radius, corners, or nothing', () => {
  expect(outlineOf('point')).toBeNull();
  expect(outlineOf('disc:0.3')).toBe(0.3);
  expect(outlineOf('0.9,0.2; 0.1,0.2; 0.1,-0.2')).toEqual([[0.9, 0.2], [0.1, 0.2], [0.1, -0.2]]);
});
