// Links: what goes in comes out, for random states; what is cut, changed, huge or wrong is refused with a reason.

import { deflateSync, strToU8 } from 'fflate';
import { beforeAll, describe, expect, test } from 'vitest';
import { plainFrame, type Registry } from '../engine/types';
import { linkOf, longestLink, readLink, type Linked } from '../store/link';
import { initialState, notFollowing, type MapDocument, type State } from '../store/state';
import { newEngine, randomFrom } from './engine';

let registry: Registry;
beforeAll(async () => {
  registry = (await newEngine()).registry();
});

function stateOf(seed: number): State {
  const random = randomFrom(seed);
  const below = (most: number) => Math.floor(random() * most);
  const pick = <Value>(values: readonly Value[]): Value => values[below(values.length)]!;
  const place = () => ({ x: random() * 40, y: random() * 40, heading: random() * 6 - 3 });
  const width = 1 + below(40);
  const height = 1 + below(40);
  const cells = Uint8Array.from({ length: width * height }, () => pick([0, 1, 1, 1, 7, 255]));
  const map: MapDocument = { name: `map "${seed}" ä`, width, height, frame: { ...plainFrame, yUp: random() < 0.5 }, cells, version: 0 };
  if (random() < 0.5) {
    map.recipe = { generator: pick(registry.generators).name, options: {}, width, height, seed: below(1000) };
    map.original = cells.slice();
    if (random() < 0.5) cells[below(cells.length)]! ^= 1;
  }
  const runs = Array.from({ length: 1 + below(4) }, () => {
    const planner = pick(registry.planners);
    const option = planner.options[0];
    return { planner: planner.name, options: option ? { [option.name]: option.default } : {} as Record<string, string> };
  });
  return {
    ...initialState, map, runs, start: place(), goal: place(), headings: random() < 0.5, arrows: random() < 0.5,
    layer: pick(['', 'g', 'cost'] as const), pace: pick(['expansions', 'time'] as const), exercise: pick(['', 'next'] as const),
    following: pick([notFollowing, { controller: 'pid:heading_gain=2', robot: 'robot:speed=1', simulation: 'simulation' }]),
    widest: random() < 0.5, breakPoint: pick([null, { x: 3, y: 4 }]),
    robotFields: pick([{}, { clearance_distance: '0.5', unknown: 'free' }]),
    requestFields: pick([{}, { escape: '0.25' }, { closest: 'true', goal_tolerance: '3' }]), footprint: pick(['point', 'disc:0.3']), smoother: pick(['', 'gradient:beta=0.4']),
  };
}

/** The cells that a link means, on the map that its recipe makes. */
function cellsOf(linked: Linked, original: Uint8Array | undefined): Uint8Array {
  if (!linked.recipe) return linked.cells!;
  return linked.cells ? original!.map((cell, i) => cell + linked.cells![i]!) : original!;
}

describe('links', () => {
  test('carry every state and its step', () => {
    for (let seed = 1; seed <= 300; ++seed) {
      const state = stateOf(seed);
      const linked = readLink(linkOf(state, seed)!, registry) as Linked;
      expect(linked, `seed ${seed}`).toMatchObject({
        name: state.map!.name, frame: state.map!.frame, start: state.start, goal: state.goal, runs: state.runs,
        footprint: state.footprint, smoother: state.smoother, headings: state.headings, layer: state.layer,
        arrows: state.arrows, pace: state.pace, exercise: state.exercise, step: seed,
        robotFields: state.robotFields, requestFields: state.requestFields, following: state.following, widest: state.widest, breakPoint: state.breakPoint,
      });
      expect(cellsOf(linked, state.map!.original), `seed ${seed}`).toEqual(state.map!.cells);
    }
  });

  test('are refused where they are cut', () => {
    for (let seed = 1; seed <= 20; ++seed) {
      const link = linkOf(stateOf(seed), 0)!;
      for (let length = 0; length < link.length - 1; length += 1 + (length >> 3)) {
        expect(readLink(link.slice(0, length), registry), `seed ${seed}, ${length}`).toMatch(/^This link is damaged/);
      }
    }
  });

  test('with changed letters never throw', () => {
    const random = randomFrom(7);
    const letters = 'ABCDEFabcdef0123456789-_?%';
    for (let round = 0; round < 2000; ++round) {
      const link = [...linkOf(stateOf(1 + (round % 20)), 0)!];
      link[Math.floor(random() * link.length)] = letters[Math.floor(random() * letters.length)]!;
      const read = readLink(link.join(''), registry);
      expect(['string', 'object']).toContain(typeof read);
    }
  });

  const coded = (head: unknown, bytes = new Uint8Array(1)) => {
    const text = strToU8(JSON.stringify(head));
    const all = new Uint8Array(4 + text.length + bytes.length);
    new DataView(all.buffer).setUint32(0, text.length);
    all.set(text, 4);
    all.set(bytes, 4 + text.length);
    return Buffer.from(deflateSync(all)).toString('base64url');
  };
  const place = { x: 0.5, y: 0.5, heading: 0 };
  const head = {
    v: 1, name: '', width: 1, height: 1, frame: plainFrame, start: place, goal: place, runs: [{ planner: 'astar', options: {} }],
    footprint: 'point', smoother: '', headings: false, layer: '', arrows: false, pace: 'time', step: 0,
  };

  test('are read field by field', () => {
    expect(readLink(coded(head), registry), 'from before there were fields').toMatchObject({ width: 1, robotFields: {}, requestFields: {} });
    expect(readLink(coded({ ...head, escape: 1.5, closest: true }), registry), 'from when it had two of them')
      .toMatchObject({ requestFields: { escape: '1.5', closest: 'true' } });
    const wrong: [unknown, RegExp][] = [
      [null, /missing/], [{ ...head, v: 2 }, /version/], [{ ...head, width: 1e9 }, /width/], [{ ...head, height: 0.5 }, /height/],
      [{ ...head, width: 2 }, /cut off/], [{ ...head, runs: [] }, /no planner/], [{ ...head, runs: Array(5).fill(head.runs[0]) }, /too many/],
      [{ ...head, runs: [{ planner: 'x', options: {} }] }, /unknown planner/],
      [{ ...head, runs: [{ planner: 'astar', options: { x: '1' } }] }, /unknown option/],
      [{ ...head, runs: [{ planner: 'astar', options: { weight: '1,x=2' } }] }, /invalid value/],
      [{ ...head, start: { x: null, y: 0, heading: 0 } }, /number/], [{ ...head, layer: 'z' }, /unknown choice/],
      [{ ...head, frame: { ...plainFrame, resolution: 0 } }, /resolution/], [{ ...head, recipe: { generator: 'x' } }, /kind of map/],
      [{ ...head, escape: -1 }, /escape is not a number/], [{ ...head, escape: '1' }, /number/], [{ ...head, escape: 1e300 }, /too large/],
      [{ ...head, requestFields: { escape: '-1' } }, /escape is not a number/], [{ ...head, requestFields: { x: '1' } }, /unknown option: x/],
      [{ ...head, robotFields: { clearance_cost: '1000001' } }, /clearance_cost is not a number.* at most 1000000/], [{ ...head, robotFields: { unknown: 'x' } }, /unknown is none of/],
      [{ ...head, requestFields: { closest: 'yes' } }, /neither true nor false/], [{ ...head, requestFields: { expansions: '0.5' } }, /expansions is not a number/],
    ];
    for (const [each, reason] of wrong) expect(readLink(coded(each), registry), JSON.stringify(each)).toMatch(reason);
  });

  test('are written by hand too', () => {
    const text = 'map=random:density=0&size=24x14&seed=2&wall=10,2,10,9&start=3,4&goal=20,7&planner=astar:weight=2,heuristic=zero&planner=bfs' +
      '&layer=g&pace=time&robot=disc:0.4&step=7&escape=1.5&closest=true&clearance_distance=2';
    expect(readLink(text, registry)).toMatchObject({
      name: 'random, seed 2', width: 24, height: 14, recipe: { generator: 'random', options: { density: '0' }, width: 24, height: 14, seed: 2 },
      walls: [[10, 2, 10, 9]], start: { x: 3.5, y: 4.5 }, goal: { x: 20.5, y: 7.5 }, layer: 'g', pace: 'time', footprint: 'disc:0.4', step: 7,
      robotFields: { clearance_distance: '2' }, requestFields: { escape: '1.5', closest: 'true' },
      runs: [{ planner: 'astar', options: { weight: '2', heuristic: 'zero' } }, { planner: 'bfs', options: {} }],
    });
    expect(readLink('exercise=next', registry)).toMatchObject({ exercise: 'next', step: 1, runs: [{ planner: 'astar' }], width: 41 });
    expect(readLink('map=rooms', registry)).toMatchObject({ robotFields: {}, requestFields: {} });
    expect(readLink('closest=', registry), 'an attribute alone').toMatchObject({ requestFields: { closest: 'true' } });
    expect(readLink('closest=false', registry)).toMatchObject({ requestFields: { closest: 'false' } });
    expect(readLink('exercise=greedy', registry)).toMatchObject({ runs: [{ planner: 'greedy' }, { planner: 'astar' }], step: null });
  });

  test('written by hand are refused with what is wrong', () => {
    const wrong: [string, RegExp][] = [
      ['map=x', /kind of map: x/], ['map=maze:x=1', /unknown option: x/], ['maps=1', /unknown part: maps/], ['size=9', /its size/], ['size=9999x9', /its size/],
      ['size=0x9', /its size/], ['seed=-1', /its seed/], ['seed=1e3', /its seed/], ['planner=x', /unknown planner/], ['planner=astar:weight', /option=value/],
      ['planner=astar:weight=', /option=value/], ['planner=astar:x=1', /unknown option/], [Array(5).fill('planner=bfs').join('&'), /more than four/],
      ['start=50,2', /start is not on the map/], ['goal=1', /goal must be 2/], ['wall=1,1,0,1', /wall 1,1,0,1/], ['wall=1,1,99,1', /not on the map/],
      ['layer=x', /layer is unknown/], ['exercise=x', /exercise is unknown/], ['pace=x', /pace is unknown/], ['step=x', /its step/],
      ['escape=-1', /escape is not a number/], ['escape=1e9', /escape is not a number/], ['escape=', /escape is not a number/], ['closest=1', /neither true nor false/],
      ['unknown=x', /unknown is none of/], ['nearest=true', /unknown part: nearest/],
    ];
    for (const [text, reason] of wrong) expect(readLink(text, registry), text).toMatch(reason);
  });

  test('cannot ask for much memory', () => {
    const bomb = coded(head, new Uint8Array(40_000_000));
    expect(bomb.length).toBeLessThan(2 * longestLink);
    expect(readLink(bomb, registry)).toMatch(/too large/);
  });

  test('are not made of maps that are too large', () => {
    const random = randomFrom(3);
    const cells = Uint8Array.from({ length: 1 << 20 }, () => (random() < 0.5 ? 0 : 1));
    const map: MapDocument = { name: '', width: 1024, height: 1024, frame: plainFrame, cells, version: 0 };
    expect(linkOf({ ...initialState, map }, 0)).toBeNull();
  }, 120_000);
});
