// Map documents from recipes, files and links.

import { obstacle, type Failure, type MapInfo, type Registry } from '../engine/types';
import type { Linked } from './link';
import { centreOf, type MapDocument, type Place, type Recipe, type State } from './state';

/** The map that a visitor sees first. */
export const firstRecipe: Recipe = { generator: 'rooms', options: {}, width: 61, height: 35, seed: 3 };

export type Maker = (recipe: Recipe) => Promise<{ info: MapInfo; cells: Uint8Array } | Failure>;

/** A new map of a recipe, and ends in two of its corners. */
export async function fromRecipe(recipe: Recipe, registry: Registry, make: Maker): Promise<Partial<State> | Failure> {
  const made = await make(recipe);
  if ('error' in made) return made;
  const { info, cells } = made;
  return {
    map: documentOf(`${recipe.generator}, seed ${recipe.seed}`, info, cells, recipe),
    ...endsOfRecipe(recipe, registry),
    footprint: 'point', robotFields: {}, requestFields: {},
  };
}

/** The state of a link, but its step. */
export async function fromLink(linked: Linked, registry: Registry, make: Maker): Promise<Partial<State> | Failure> {
  const { runs, footprint, smoother, headings, robotFields, requestFields, layer, arrows, pace, exercise, following, widest, breakPoint } = linked;
  const rest = { runs, footprint, smoother, headings, robotFields, requestFields, layer, arrows, pace, exercise, following, widest, breakPoint };
  const { recipe, cells, name, width, height, frame } = linked;
  const ends = { ...(linked.start ? { start: linked.start } : {}), ...(linked.goal ? { goal: linked.goal } : {}) };
  if (!recipe) return { ...rest, ...ends, map: documentOf(name, { ...frame, width, height }, cells!) };
  const made = await make(recipe);
  if ('error' in made) return made;
  const map = documentOf(name, made.info, made.cells, recipe);
  if (cells) map.cells = made.cells.map((cell, i) => cell + cells[i]!);
  for (const [left, top, right, bottom] of linked.walls ?? []) {
    for (let y = top; y <= bottom; ++y) map.cells.fill(obstacle, y * map.width + left, y * map.width + right + 1);
  }
  return { ...rest, ...endsOfRecipe(recipe, registry), ...ends, map };
}

function endsOfRecipe(recipe: Recipe, registry: Registry): { start: Place; goal: Place } {
  const corner = registry.generators.find(({ name }) => name === recipe.generator)?.freeCorner ?? 1;
  return { start: centreOf(corner, corner), goal: centreOf(recipe.width - 1 - corner, recipe.height - 1 - corner) };
}

export function documentOf(name: string, info: MapInfo, cells: Uint8Array, recipe?: Recipe): MapDocument {
  const { width, height, ...frame } = info;
  return {
    name, width, height, frame, cells, version: 0,
    ...(recipe ? { recipe, original: cells.slice() } : {}),
  };
}

/** Two free cells far from each other, for a map without ends: the first and the last that are free. */
export function endsOf(map: MapDocument): { start: Place; goal: Place } {
  const isFree = (cell: number) => cell !== 0 && cell !== 255;
  const first = Math.max(map.cells.findIndex(isFree), 0);
  const last = Math.max(map.cells.findLastIndex(isFree), 0);
  const place = (index: number) => centreOf(index % map.width, Math.floor(index / map.width));
  return { start: place(first), goal: place(last) };
}
