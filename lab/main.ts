import address from '../build/lab/wend.wasm?url';
import { Engine } from './engine/engine';
import './panels/app';
import type { App } from './panels/app';
import './style.css';

/** The engine from its own file, or from the page itself if it was built as one file. */
async function compile(): Promise<WebAssembly.Module> {
  const answer = await fetch(address);
  return WebAssembly.compile(await answer.arrayBuffer());
}

async function begin(): Promise<void> {
  const module = await compile();
  const engine = new Engine(module);
  const registry = await engine.call('registry');
  engine.end();
  await (document.querySelector('wend-lab') as App).begin(module, registry, location.hash.slice(1));
}

void begin();
