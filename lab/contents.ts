// Writes what the page has to know of its modules into build/lab/contents.json: npm run build calls it.

import { readFile, writeFile } from 'node:fs/promises';
import { EngineModule } from './engine/module';
import type { Contents } from './engine/program';

const here = new URL('.', import.meta.url).pathname;
const built = `${here}../build/lab/`;

/** The names in a list of the first module. */
async function listed(file: string): Promise<string[]> {
  const text = await readFile(`${here}wasm/first/wend/${file}.def`, 'utf8');
  return [...text.matchAll(/^WEND_\w+\((\w+)\)$/gm)].map((line) => line[1]!);
}

const engine = await EngineModule.from(await WebAssembly.compile(await readFile(`${built}wend.wasm`)));
const contents: Contents = {
  registry: engine.registry(),
  first: { planners: await listed('planner/planners'), generators: await listed('generate/generators') },
};
await writeFile(`${built}contents.json`, JSON.stringify(contents));
