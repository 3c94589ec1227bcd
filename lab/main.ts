import { load } from './engine/program';
import './panels/app';
import type { App } from './panels/app';
import './style.css';

/** Keeps the page's files for visits without a network. */
function keepOffline(): void {
  if (location.protocol === 'file:' || document.getElementById('wend-wasm')) return;
  navigator.serviceWorker?.register('./worker.js').catch(() => undefined);
}

async function begin(): Promise<void> {
  const programs = await load();
  await (document.querySelector('wend-lab-page') as App).begin(programs, location.hash.slice(1));
}

void begin().then(keepOffline);
