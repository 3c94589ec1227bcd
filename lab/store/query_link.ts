// Links that people write by hand, and the attributes of <wend-lab>: "map=rooms&size=61x35&seed=3&planner=astar:weight=2".
// A second planner is a second `planner`. What is left out is as on the page when it opens.

import { plainFrame, type FieldInfo, type Layer, type Registry } from '../engine/types';
import { fieldsIn, layers, mostSide, type Linked, type Wall } from './link';
import { centreOf, exercises, fieldsOfThePage, notFollowing, type Choice, type Exercise, type Place, type Recipe } from './state';

/** The names that such a link may have. */
export function queryNames(registry: Registry): string[] {
  return [
    'map', 'size', 'seed', 'wall', 'start', 'goal', 'planner', 'robot', 'layer', 'pace', 'exercise', 'step',
    ...settable(registry.robotFields), ...settable(registry.requestFields),
  ];
}

const settable = (fields: readonly FieldInfo[]): string[] =>
  fields.map(({ name }) => name).filter((name) => !fieldsOfThePage.has(name));

export const isQueryLink = (text: string): boolean => /^[a-z]+=/.test(text);

/** What a link says. Throws an Error that says what is wrong. */
export function readQueryLink(text: string, registry: Registry): Linked {
  const fields = new URLSearchParams(text);
  for (const name of fields.keys()) {
    if (!queryNames(registry).includes(name)) throw new Error(`it has an unknown part: ${name.slice(0, 40)}`);
  }
  const recipe = recipeIn(fields, registry);
  const { width, height } = recipe;
  const place = (name: string): Place | undefined => {
    const given = fields.get(name);
    return given === null ? undefined : placeIn(name, given, width, height);
  };
  const start = place('start');
  const goal = place('goal');
  const exercise = oneOf<Exercise>('exercise', exercises, fields.get('exercise') ?? '');
  const usual = exercise === 'greedy' ? ['greedy', 'astar'] : ['astar'];
  const planners = fields.getAll('planner');
  if (planners.length > 4) throw new Error('it has more than four planners');
  return {
    name: `${recipe.generator}, seed ${recipe.seed}`, width, height, frame: plainFrame, recipe,
    walls: fields.getAll('wall').map((wall) => wallIn(wall, width, height)),
    ...(start ? { start } : {}), ...(goal ? { goal } : {}),
    runs: (planners.length > 0 ? planners : usual).map((spec) => choiceIn(spec, registry)),
    footprint: fields.get('robot') ?? 'point', smoother: '', headings: false, arrows: false,
    robotFields: fieldsFrom(fields, registry.robotFields), requestFields: fieldsFrom(fields, registry.requestFields),
    layer: oneOf<Layer>('layer', layers, fields.get('layer') ?? ''),
    pace: oneOf('pace', ['expansions', 'time'] as const, fields.get('pace') ?? 'expansions'),
    exercise, following: notFollowing, widest: false, breakPoint: null,
    step: fields.has('step') ? wholeIn('step', fields.get('step')!, 0, 2 ** 32 - 1) : exercise === 'next' ? 1 : null,
  };
}

function recipeIn(fields: URLSearchParams, registry: Registry): Recipe {
  const { name, options } = specIn(fields.get('map') ?? 'rooms');
  const info = registry.generators.find((each) => each.name === name);
  if (!info) throw new Error(`it has an unknown kind of map: ${name.slice(0, 40)}`);
  checkOptions(options, info.options);
  const size = fields.get('size');
  const sides = size === null ? [info.defaultWidth, info.defaultHeight] : numbersIn('size', size, 'x', 2);
  const [width, height] = sides as [number, number];
  const fits = (side: number, least: number) => Number.isInteger(side) && side >= least && side <= mostSide;
  if (!fits(width, info.leastWidth) || !fits(height, info.leastHeight)) {
    throw new Error(`its size must be from ${info.leastWidth}x${info.leastHeight} to ${mostSide}x${mostSide}`);
  }
  return { generator: name, options, width, height, seed: wholeIn('seed', fields.get('seed') ?? '1', 0, 2 ** 32 - 1) };
}

/** "astar:weight=2,leaps=false" */
function specIn(spec: string): { name: string; options: Record<string, string> } {
  const [name, list = ''] = spec.split(/:(.*)/s) as [string, string?];
  const options: Record<string, string> = {};
  for (const pair of list.split(',').filter((each) => each !== '')) {
    const [option, value, more] = pair.split('=');
    if (!option || value === undefined || value === '' || more !== undefined) throw new Error(`'${pair.slice(0, 40)}' is not option=value`);
    options[option] = value;
  }
  return { name, options };
}

function choiceIn(spec: string, registry: Registry): Choice {
  const { name, options } = specIn(spec);
  const info = registry.planners.find((each) => each.name === name);
  if (!info) throw new Error(`it has an unknown planner: ${name.slice(0, 40)}`);
  checkOptions(options, info.options);
  return { planner: name, options };
}

function checkOptions(options: Record<string, string>, known: readonly { name: string }[]): void {
  for (const name of Object.keys(options)) {
    if (!known.some((option) => option.name === name)) throw new Error(`it has an unknown option: ${name.slice(0, 40)}`);
  }
}

function placeIn(name: string, text: string, width: number, height: number): Place {
  const [x, y] = numbersIn(name, text, ',', 2) as [number, number];
  if (x >= width || y >= height) throw new Error(`its ${name} is not on the map`);
  return centreOf(x, y);
}

/** A rectangle of obstacles, both corners included: "30,10,30,20". */
function wallIn(text: string, width: number, height: number): Wall {
  const [x0, y0, x1, y1] = numbersIn('wall', text, ',', 4) as [number, number, number, number];
  if (x0 > x1 || y0 > y1 || x1 >= width || y1 >= height) throw new Error(`its wall ${text.slice(0, 40)} is not on the map`);
  return [x0, y0, x1, y1];
}

function numbersIn(name: string, text: string, between: string, count: number): number[] {
  const words = text.split(between);
  if (words.length !== count || words.some((word) => !/^\d{1,9}$/.test(word))) {
    throw new Error(`its ${name} must be ${count} whole numbers with '${between}' between them`);
  }
  return words.map(Number);
}

function wholeIn(name: string, text: string, least: number, most: number): number {
  const number = /^\d{1,10}$/.test(text) ? Number(text) : NaN;
  if (!(number >= least && number <= most)) throw new Error(`its ${name} is not a number from ${least} to ${most}`);
  return number;
}

/** The fields of the registry that a link names. A flag may stand alone, as an attribute of an element may. */
function fieldsFrom(fields: URLSearchParams, known: readonly FieldInfo[]): Record<string, string> {
  const given = known.filter(({ name }) => settable(known).includes(name) && fields.has(name))
    .map(({ name, kind }) => [name, fields.get(name) || (kind === 'flag' ? 'true' : '')]);
  return fieldsIn(Object.fromEntries(given), known);
}

function oneOf<Value extends string>(name: string, values: readonly Value[], value: string): Value {
  const found = values.find((each) => each === value);
  if (found === undefined) throw new Error(`its ${name} is unknown: ${value.slice(0, 40)}`);
  return found;
}
