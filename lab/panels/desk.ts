// What the page does with files: opens them into the state, saves what is shown.

import { writeGif, type Frame } from '../formats/gif';
import { openFiles } from '../formats/files';
import type { ScenarioQuery } from '../formats/moving_ai';
import { posthocTrace } from '../formats/posthoc';
import { mapSvg, mapText, offer, pathCsv } from '../formats/save';
import { documentOf, endsOf } from '../store/maps';
import { centreOf, type State } from '../store/state';
import type { MapView } from '../view/map_view';
import { light } from '../view/palette';
import type { Saved } from './file_panel';

export interface OpenedState {
  change: Partial<State>;
  queries: ScenarioQuery[];
  /** On the map: a sentence each, with the file's name. */
  notes: string[];
}

/** The state that files ask for, or why they do not. */
export async function stateOfFiles(files: File[], state: State): Promise<OpenedState | string> {
  const opened = await openFiles(files);
  if (typeof opened === 'string') return opened;
  const { grid, name, queries } = opened;
  const first = queries[0];
  const ends = first ? endsOfQuery(first) : {};
  if (!grid) {
    const { map } = state;
    if (!first || !map || first.width !== map.width || first.height !== map.height) return `${name}: open it together with its map`;
    return { change: ends, queries, notes: [] };
  }
  const map = documentOf(name, { ...grid.frame, width: grid.width, height: grid.height }, grid.cells);
  return { change: { map, footprint: 'point', robotFields: {}, requestFields: {}, ...endsOf(map), ...ends }, queries, notes: grid.notes.map((note) => `${name}: ${note}.`) };
}

export function endsOfQuery({ start, goal }: ScenarioQuery): Partial<State> {
  return { start: centreOf(...start), goal: centreOf(...goal) };
}

/** Offers a file; returns what to tell the visitor. */
export async function save(what: Saved, state: State, view: MapView | undefined): Promise<string> {
  const map = state.map;
  if (!map) return 'There is no map to save.';
  const outcome = view?.runner.outcome ?? null;
  const path = outcome?.path ?? null;
  const name = map.name.replace(/\.[a-z]+$/i, '').replace(/[^\w-]+/g, '_') || 'map';
  if (what === 'map') offer(`${name}.txt`, mapText(map));
  if (what === 'svg') offer(`${name}.svg`, mapSvg(map, path, light, outcome?.wayOutPoints));
  if (what === 'path') {
    if (!path || path.length === 0) return 'There is no path to save.';
    offer(`${name}.csv`, pathCsv(map, path));
  }
  if (what === 'png') {
    const picture = await view?.picture();
    if (!picture) return 'The picture could not be made.';
    offer(`${name}.png`, picture);
  }
  if (what === 'gif') {
    if (!view || !outcome || outcome.steps === 0) return 'There is no search to save.';
    offer(`${name}.gif`, new Blob([await film(view, outcome.steps)], { type: 'image/gif' }));
  }
  if (what === 'trace') {
    if (!view || !outcome || outcome.steps === 0) return 'There is no search to save.';
    const [expansions, knowledge] = await Promise.all([view.runner.engine.call('expansions'), view.runner.engine.call('knowledge')]);
    offer(`${name}.trace.json`, posthocTrace(map, state.start, state.goal, expansions, knowledge, outcome.status === 'found'));
  }
  return 'Saved.';
}

/** The replay of a search as GIF, in at most 60 frames. */
async function film(view: MapView, steps: number): Promise<Uint8Array<ArrayBuffer>> {
  const count = Math.min(steps + 1, 60);
  const frames: Frame[] = [];
  for (let i = 0; i < count; ++i) {
    const frame = await view.frame(Math.round((steps * i) / (count - 1)));
    if (frame) frames.push(frame);
  }
  return new Uint8Array(writeGif(frames, 12, 200));
}
