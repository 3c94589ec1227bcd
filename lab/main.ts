import address from '../build/lab/wend.wasm?url';
import './panels/app';
import type { App } from './panels/app';
import './style.css';

/** The engine from its own file, or from the page itself if it was built as one file. */
async function compile(): Promise<WebAssembly.Module> {
  const answer = await fetch(address);
  return WebAssembly.compile(await answer.arrayBuffer());
}

const app = document.querySelector('wend-lab') as App;
void compile().then((module) => app.begin(module));
