// The store: undo takes back exactly what was done, in any mixture of strokes and other changes.

import { describe, expect, test } from 'vitest';
import { plainFrame } from '../engine/types';
import { Clock } from '../store/clock';
import { centreOf, initialState, type State } from '../store/state';
import { Store } from '../store/store';
import { Brush, cellsBetween } from '../view/brush';
import { randomFrom } from './engine';

function newStore(): Store {
  return new Store({
    ...initialState,
    map: { name: 'm', width: 9, height: 7, frame: plainFrame, cells: new Uint8Array(63).fill(1), version: 0 },
  });
}

function shown({ map, start, goal, runs }: State) {
  return { cells: [...map!.cells], start, goal, runs };
}

function change(store: Store, random: () => number): void {
  const below = (most: number) => Math.floor(random() * most);
  const cell = () => ({ x: below(9), y: below(7) });
  const kind = below(4);
  if (kind === 0) return store.commit({ start: centreOf(below(9), below(7)) });
  if (kind === 1) return store.commit({ runs: [{ planner: 'bfs', options: { connectivity: String(4 + 4 * below(2)) } }] });
  if (kind === 2) {
    const before = { goal: store.state.goal };
    for (let i = 0; i < 3; ++i) store.set({ goal: centreOf(below(9), below(7)) });
    return store.commitSince(before);
  }
  const brush = new Brush(store, below(5), 1 + below(3), cell());
  for (let i = 0; i < 3; ++i) brush.moveTo(cell());
  brush.end();
}

describe('the store', () => {
  test('undoes and redoes any mixture of changes', () => {
    for (let seed = 1; seed <= 100; ++seed) {
      const random = randomFrom(seed);
      const store = newStore();
      const states = [shown(store.state)];
      for (let i = 0; i < 12; ++i) {
        const before = JSON.stringify(shown(store.state));
        change(store, random);
        // A stroke over cells that are so already is no step.
        if (JSON.stringify(shown(store.state)) !== before || store.canUndo) states.push(shown(store.state));
      }
      const distinct = states.filter((state, i) => i === 0 || JSON.stringify(state) !== JSON.stringify(states[i - 1]));
      const seen = [shown(store.state)];
      while (store.undo()) seen.push(shown(store.state));
      const back = seen.filter((state, i) => i === 0 || JSON.stringify(state) !== JSON.stringify(seen[i - 1]));
      expect(back.reverse(), `seed ${seed}`).toEqual(distinct);
      while (store.redo());
      expect(shown(store.state), `seed ${seed}`).toEqual(states.at(-1));
    }
  });

  test('forgets what was undone once something else is done', () => {
    const store = newStore();
    store.commit({ start: centreOf(1, 1) });
    store.undo();
    store.commit({ start: centreOf(2, 2) });
    expect(store.redo()).toBe(false);
  });

  test('tells listeners of strokes, with the cells', () => {
    const store = newStore();
    const strokes: number[][] = [];
    store.listen((_, __, stroke) => { if (stroke) strokes.push([...stroke.indices]); });
    new Brush(store, 0, 1, { x: 1, y: 1 }).moveTo({ x: 3, y: 1 });
    expect(strokes.flat()).toEqual([10, 11, 12]);
  });
});

describe('a stroke', () => {
  test('has no gaps', () => {
    const random = randomFrom(1);
    for (let i = 0; i < 200; ++i) {
      const at = () => ({ x: Math.floor(random() * 50), y: Math.floor(random() * 50) });
      const cells = cellsBetween(at(), at());
      cells.slice(1).forEach((cell, k) => {
        expect(Math.max(Math.abs(cell.x - cells[k]!.x), Math.abs(cell.y - cells[k]!.y))).toBeLessThanOrEqual(1);
      });
    }
  });
});

describe('the clock', () => {
  test('plays a whole search in the seconds of its speed, and stops', () => {
    const clock = new Clock();
    clock.restart(1000, true);
    clock.setSpeed(4);  // all in 8 s
    clock.tick(0);
    clock.tick(4000);
    expect(clock.step).toBe(500);
    clock.tick(9000);
    expect(clock.step).toBe(1000);
    expect(clock.playing).toBe(false);
    clock.toggle();
    expect(clock.step).toBe(0);
  });

  test('stops at each of its stops, and goes on from there', () => {
    const clock = new Clock();
    clock.restart(1000, true);
    clock.setSpeed(4);
    clock.stops = [250, 600];
    clock.tick(0);
    clock.tick(7000);
    expect([clock.step, clock.playing]).toEqual([250, false]);
    clock.toggle();
    clock.tick(7000);
    clock.tick(8000);
    expect([clock.step, clock.playing]).toEqual([375, true]);
    clock.tick(12000);
    expect([clock.step, clock.playing]).toEqual([600, false]);
    clock.toggle();
    clock.tick(0);
    clock.tick(9000);
    expect([clock.step, clock.playing]).toEqual([1000, false]);
  });

  test('moves one step at a time, within the search', () => {
    const clock = new Clock();
    clock.restart(2, false);
    clock.move(1);
    expect(clock.step).toBe(2);
    clock.move(-1);
    expect(clock.step).toBe(1);
    clock.move(-5);
    expect(clock.step).toBe(0);
  });
});
