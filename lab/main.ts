import address from '../build/lab/wend.wasm?url';
import { Engine, type Program } from './engine/engine';
import './panels/app';
import type { App } from './panels/app';
import './style.css';

/** The engine from its own file, or from the page itself if it was built as one file. */
async function load(): Promise<Program> {
  const inside = document.getElementById('wend-wasm');
  if (!inside) return WebAssembly.compile(await (await fetch(address)).arrayBuffer());
  const packed = Uint8Array.from(atob(inside.textContent ?? ''), (letter) => letter.charCodeAt(0));
  const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(plain).arrayBuffer();
}

/** Keeps the page's files for visits without a network. */
function keepOffline(): void {
  if (location.protocol === 'file:' || document.getElementById('wend-wasm')) return;
  navigator.serviceWorker?.register('./worker.js').catch(() => undefined);
}

async function begin(): Promise<void> {
  const program = await load();
  const engine = new Engine(program);
  const registry = await engine.call('registry');
  engine.end();
  await (document.querySelector('wend-lab') as App).begin(program, registry, location.hash.slice(1));
}

void begin().then(keepOffline);
