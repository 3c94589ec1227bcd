// Files that a visitor opens together: a map, or a map.yaml and its image, and perhaps queries.

import { readDeepPng } from './deep_png';
import { doubtsAboutFrame } from './doubts';
import { FileFault, fault, type GridFile } from './grid';
import { gridOf, readPicture, readPnm, type GreyImage } from './image';
import { readMapYaml } from './map_yaml';
import { readMovingAi, readScenario, type ScenarioQuery } from './moving_ai';
import { readTextGrid } from './text_grid';

export interface Opened {
  name: string;
  grid: GridFile | null;
  queries: ScenarioQuery[];
}

const mostBytes = 256 << 20;

/** What the files hold, or why not. */
export async function openFiles(files: File[]): Promise<Opened | string> {
  try {
    return await open(files);
  } catch (reason) {
    if (reason instanceof FileFault) return reason.message;
    throw reason;
  }
}

async function open(files: File[]): Promise<Opened> {
  const big = files.find(({ size }) => size > mostBytes);
  if (big) throw fault(big.name, 0, 'the file is larger than 256 MB');
  const ending = (file: File) => /\.([^.]+)$/.exec(file.name)?.[1]?.toLowerCase() ?? '';
  const yaml = files.find((file) => ['yaml', 'yml'].includes(ending(file)));
  const scenario = files.find((file) => ending(file) === 'scen');
  const queries = scenario ? readScenario(await scenario.text(), scenario.name) : [];
  if (yaml) return { name: yaml.name, grid: await openYaml(yaml, files), queries };
  const map = files.find((file) => file !== scenario);
  if (!map) return { name: scenario!.name, grid: null, queries };
  const grid = ['png', 'jpg', 'jpeg', 'webp', 'bmp', 'gif', 'pgm', 'pbm', 'ppm', 'pnm'].includes(ending(map))
    ? gridOf(await imageOf(map)) : await openText(map);
  const wrong = queries.find(({ width, height }) => width !== grid.width || height !== grid.height);
  if (wrong) throw fault(scenario!.name, 0, `its queries are for a map of ${wrong.width} x ${wrong.height} cells, this one has ${grid.width} x ${grid.height}`);
  return { name: map.name, grid, queries };
}

async function openText(file: File): Promise<GridFile> {
  const text = await file.text();
  return text.startsWith('type') ? readMovingAi(text, file.name) : readTextGrid(text, file.name);
}

async function openYaml(yaml: File, files: File[]): Promise<GridFile> {
  const { image, frame, meaning, notes } = readMapYaml(await yaml.text(), yaml.name);
  const name = image.split(/[/\\]/).at(-1)!;
  const picture = files.find((file) => file.name === name);
  if (!picture) throw fault(yaml.name, 0, `open it together with its image, ${name}`);
  const grid = gridOf(await imageOf(picture), meaning, frame);
  return { ...grid, notes: [...notes, ...doubtsAboutFrame(frame), ...grid.notes] };
}

async function imageOf(file: File): Promise<GreyImage> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes[0] === 80 && bytes[1]! >= 49 && bytes[1]! <= 54) return readPnm(bytes, file.name);
  return await readDeepPng(bytes, file.name) ?? readPicture(file, file.name);
}
