// Link: a state as text for the address of the page, and back. Deflated JSON, then the map's bytes: of a map with a
// recipe only the difference to it. What does not read as such is refused with a reason.

import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { plainFrame, type FieldInfo, type Frame, type Layer, type Registry } from '../engine/types';
import { isQueryLink, readQueryLink } from './query_link';
import {
  exercises, notFollowing, type Choice, type Exercise, type Following, type MapDocument, type Pace, type Place, type Recipe, type State,
} from './state';

/** Addresses longer than this are cut by some programs that people send them with. */
export const longestLink = 32_000;
export const mostSide = 4096;

/** Columns and rows of a rectangle of obstacles: the first and the last. */
export type Wall = [left: number, top: number, right: number, bottom: number];

/**
 * What a link says. Without `cells`, the map is its recipe's; with a recipe, they are added to it, modulo 256. Ends that
 * are left out are where the recipe has them, and the step is the usual one.
 */
export interface Linked {
  name: string;
  width: number;
  height: number;
  frame: Frame;
  recipe?: Recipe;
  cells?: Uint8Array;
  walls?: Wall[];
  start?: Place;
  goal?: Place;
  runs: Choice[];
  footprint: string;
  smoother: string;
  headings: boolean;
  robotFields: Record<string, string>;
  requestFields: Record<string, string>;
  layer: Layer;
  arrows: boolean;
  pace: Pace;
  exercise: Exercise;
  following: Following;
  widest: boolean;
  breakPoint: State['breakPoint'];
  step: number | null;
}

export const layers: readonly Layer[] = ['', 'expansion', 'g', 'h', 'f', 'cost', 'clearance'];

/** The text for a state at a step; null if its map is too large for a link. */
export function linkOf(state: State, step: number): string | null {
  const map = state.map;
  if (!map) return null;
  const { start, goal, runs, footprint, smoother, headings, robotFields, requestFields, layer, arrows, pace, exercise, following, widest, breakPoint } = state;
  const bytes = bytesOf(map);
  const head = strToU8(JSON.stringify({
    v: 1, name: map.name, width: map.width, height: map.height, frame: map.frame, recipe: map.recipe,
    start, goal, runs, footprint, smoother, headings, robotFields, requestFields, layer, arrows, pace, exercise, following, widest, breakPoint, step,
  }));
  const all = new Uint8Array(4 + head.length + bytes.length);
  new DataView(all.buffer).setUint32(0, head.length);
  all.set(head, 4);
  all.set(bytes, 4 + head.length);
  const packed = deflateSync(all, { level: 9 });
  const length = Math.ceil((packed.length * 4) / 3);
  return length > longestLink ? null : toBase64(packed);
}

function bytesOf(map: MapDocument): Uint8Array {
  const { cells, original } = map;
  if (!map.recipe || !original) return cells;
  const difference = cells.map((cell, i) => cell - original[i]!);
  return difference.some((byte) => byte !== 0) ? difference : new Uint8Array();
}

/** What a link says, or why it says nothing. */
export function readLink(text: string, registry: Registry): Linked | string {
  try {
    return isQueryLink(text) ? readQueryLink(text, registry) : read(text, registry);
  } catch (fault) {
    return `This link is damaged or was made by another version: ${fault instanceof Error ? fault.message : String(fault)}`;
  }
}

function read(text: string, registry: Registry): Linked {
  if (text.length > 2 * longestLink) throw new Error('it is too long');
  const all = inflate(fromBase64(text), 4 + 65_536 + mostSide * mostSide);
  if (all.length < 4) throw new Error('it is cut off');
  const length = new DataView(all.buffer, all.byteOffset).getUint32(0);
  if (4 + length > all.length) throw new Error('it is cut off');
  const head: unknown = JSON.parse(strFromU8(all.subarray(4, 4 + length)));
  const bytes = all.slice(4 + length);
  const fields = objectIn(head);
  if (fields['v'] !== 1) throw new Error('its version is unknown');
  const width = wholeIn(fields['width'], 1, mostSide, 'width');
  const height = wholeIn(fields['height'], 1, mostSide, 'height');
  const recipe = fields['recipe'] === undefined ? undefined : recipeIn(fields['recipe'], registry);
  if (bytes.length !== width * height && !(recipe && bytes.length === 0)) throw new Error('its map is cut off');
  const runs = listIn(fields['runs']).map((run) => choiceIn(run, registry));
  if (runs.length < 1 || runs.length > 4) throw new Error('it has no planner, or too many');
  return {
    name: textIn(fields['name']), width, height, frame: frameIn(fields['frame']),
    ...(recipe ? { recipe } : {}), ...(bytes.length > 0 ? { cells: bytes } : {}),
    start: placeIn(fields['start']), goal: placeIn(fields['goal']), runs,
    footprint: textIn(fields['footprint']), smoother: textIn(fields['smoother']),
    headings: fields['headings'] === true, layer: oneOf(layers, fields['layer']),
    robotFields: fieldsIn(fields['robotFields'] ?? {}, registry.robotFields), requestFields: fieldsIn(requestIn(fields), registry.requestFields),
    arrows: fields['arrows'] === true, pace: oneOf(['expansions', 'time'] as const, fields['pace']),
    following: followingIn(fields['following']), widest: fields['widest'] === true,
    breakPoint: fields['breakPoint'] === undefined || fields['breakPoint'] === null ? null : cellIn(fields['breakPoint']),
    exercise: oneOf(exercises, fields['exercise'] ?? ''),
    step: wholeIn(fields['step'], 0, 2 ** 32 - 1, 'step'),
  };
}

function inflate(packed: Uint8Array, most: number): Uint8Array {
  const parts: Uint8Array[] = [];
  let total = 0;
  let ended = false;
  const stream = new Inflate((part, last) => {
    total += part.length;
    if (total > most) throw new Error('it is too large');
    parts.push(part);
    ended = last;
  });
  // Piece by piece, so that a small text cannot ask for more memory than `most`.
  for (let i = 0; i < packed.length; i += 1024) stream.push(packed.subarray(i, i + 1024), i + 1024 >= packed.length);
  if (!ended) throw new Error('it is cut off');
  const all = new Uint8Array(total);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

function objectIn(value: unknown): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw new Error('a part of it is missing');
  return value as Record<string, unknown>;
}
function listIn(value: unknown): unknown[] {
  if (!Array.isArray(value)) throw new Error('a list in it is missing');
  return value;
}
function textIn(value: unknown): string {
  if (typeof value !== 'string' || value.length > 4000) throw new Error('a text in it is missing or too long');
  return value;
}
function numberIn(value: unknown): number {
  if (typeof value !== 'number' || !Number.isFinite(value) || Math.abs(value) > 1e9) throw new Error('a number in it is missing or too large');
  return value;
}
function wholeIn(value: unknown, least: number, most: number, name: string): number {
  const number = numberIn(value);
  if (!Number.isInteger(number) || number < least || number > most) throw new Error(`its ${name} is not a number from ${least} to ${most}`);
  return number;
}
function oneOf<Value>(values: readonly Value[], value: unknown): Value {
  const found = values.find((each) => each === value);
  if (found === undefined) throw new Error(`it has an unknown choice: ${String(value).slice(0, 40)}`);
  return found;
}
function placeIn(value: unknown): Place {
  const { x, y, heading } = objectIn(value);
  return { x: numberIn(x), y: numberIn(y), heading: numberIn(heading) };
}
function cellIn(value: unknown): { x: number; y: number } {
  const { x, y } = objectIn(value);
  return { x: wholeIn(x, 0, mostSide, 'break-point'), y: wholeIn(y, 0, mostSide, 'break-point') };
}
/** Links from before there was following have none. */
function followingIn(value: unknown): Following {
  if (value === undefined) return notFollowing;
  const { controller, robot, simulation } = objectIn(value);
  return { controller: textIn(controller), robot: textIn(robot), simulation: textIn(simulation) };
}
/** Links from before a request had fields have two of them by themselves, or none. */
function requestIn({ requestFields, escape, closest }: Record<string, unknown>): unknown {
  if (requestFields !== undefined) return requestFields;
  const length = escape === undefined ? 0 : numberIn(escape);
  return { ...(length === 0 ? {} : { escape: String(length) }), ...(closest === true ? { closest: 'true' } : {}) };
}
/** Fields of the registry, with values that it takes. */
export function fieldsIn(value: unknown, known: readonly FieldInfo[]): Record<string, string> {
  const given = optionsIn(value, known);
  for (const [name, text] of Object.entries(given)) {
    const { kind, choices, greatest } = known.find((field) => field.name === name)!;
    const plain = kind === 'integer' ? /^\d{1,9}$/ : /^\d{1,9}(\.\d{1,9})?$/;
    if (kind === 'flag' && text !== 'true' && text !== 'false') throw new Error(`its ${name} is neither true nor false`);
    if (kind === 'choice' && !choices.includes(text)) throw new Error(`its ${name} is none of ${choices.join(', ')}`);
    if (kind !== 'flag' && kind !== 'choice' && (!plain.test(text) || Number(text) > (greatest ?? Infinity))) {
      throw new Error(`its ${name} is not a number of at least 0${greatest === null ? '' : ` and at most ${greatest}`}`);
    }
  }
  return given;
}
function frameIn(value: unknown): Frame {
  const fields = objectIn(value);
  const resolution = numberIn(fields['resolution']);
  if (resolution <= 0) throw new Error('its resolution is not above 0');
  return {
    ...plainFrame, resolution, originX: numberIn(fields['originX']), originY: numberIn(fields['originY']),
    originYaw: numberIn(fields['originYaw'] ?? 0),
    yUp: fields['yUp'] === true, metric: fields['metric'] === true,
  };
}
function optionsIn(value: unknown, known: readonly { name: string }[]): Record<string, string> {
  const options: Record<string, string> = {};
  for (const [name, text] of Object.entries(objectIn(value))) {
    if (!known.some((option) => option.name === name)) throw new Error(`it has an unknown option: ${name.slice(0, 40)}`);
    const plain = textIn(text);
    if (/[,:=]/.test(plain)) throw new Error(`the option ${name} has an invalid value`);
    options[name] = plain;
  }
  return options;
}
function choiceIn(value: unknown, registry: Registry): Choice {
  const { planner, options } = objectIn(value);
  const info = registry.planners.find(({ name }) => name === planner);
  if (!info) throw new Error(`it has an unknown planner: ${String(planner).slice(0, 40)}`);
  return { planner: info.name, options: optionsIn(options, info.options) };
}
function recipeIn(value: unknown, registry: Registry): Recipe {
  const fields = objectIn(value);
  const info = registry.generators.find(({ name }) => name === fields['generator']);
  if (!info) throw new Error(`it has an unknown kind of map: ${String(fields['generator']).slice(0, 40)}`);
  return {
    generator: info.name, options: optionsIn(fields['options'], info.options),
    width: wholeIn(fields['width'], 1, mostSide, 'width'), height: wholeIn(fields['height'], 1, mostSide, 'height'),
    seed: wholeIn(fields['seed'], 0, 2 ** 32 - 1, 'seed'),
  };
}

function toBase64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function fromBase64(text: string): Uint8Array {
  const plain = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
}
