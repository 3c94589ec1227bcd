// The compiled module and its registry, loaded once for all of a page.

import address from '../../build/lab/wend.wasm?url';
import { Engine, type Program } from './engine';
import type { Registry } from './types';

export interface Loaded {
  program: Program;
  registry: Registry;
}

let loaded: Promise<Loaded> | undefined;

export function load(): Promise<Loaded> {
  return loaded ??= loadOnce();
}

async function loadOnce(): Promise<Loaded> {
  const program = await fetchProgram();
  const engine = new Engine(program);
  const registry = await engine.call('registry');
  engine.end();
  return { program, registry };
}

/** From its own file, or from the page itself if it was built as one file. */
async function fetchProgram(): Promise<Program> {
  const inside = document.getElementById('wend-wasm');
  if (!inside) return WebAssembly.compile(await (await fetch(address)).arrayBuffer());
  const packed = Uint8Array.from(atob(inside.textContent ?? ''), (letter) => letter.charCodeAt(0));
  const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(plain).arrayBuffer();
}
