// The engine as compiled modules, loaded once for all of a page: one with what a visitor sees first, which comes with the
// page, and one with all, which comes when something else is asked for. The registry names all of it.

import contents from '../../build/lab/contents.json?raw';
import firstAddress from '../../build/lab/first.wasm?url';
import wholeAddress from '../../build/lab/wend.wasm?url';
import type { Choice, State } from '../store/state';
import type { Program } from './engine';
import type { Registry } from './types';

/** What the modules have; contents.ts writes it. */
export interface Contents {
  registry: Registry;
  /** What the first module has of it; it has no smoothers and controllers, and no widest path. */
  first: { planners: string[]; generators: string[] };
}

/** What some work needs of a module. */
export interface Needs {
  planner?: string;
  generator?: string;
  /** A smoother, a controller or the widest path? */
  more?: boolean;
}

export function needsOf({ smoother, following, widest }: State, { planner }: Choice): Needs {
  return { planner, more: smoother !== '' || following.controller !== '' || widest };
}

export class Programs {
  private whole: Promise<Program> | undefined;

  constructor(readonly first: Program, private readonly contents: Contents, private readonly loadWhole: () => Promise<Program>) {}

  get registry(): Registry {
    return this.contents.registry;
  }

  /** Has a module what is needed? */
  has(program: Program, { planner, generator, more }: Needs): boolean {
    const { planners, generators } = this.contents.first;
    return program !== this.first ||
      (!more && (planner === undefined || planners.includes(planner)) && (generator === undefined || generators.includes(generator)));
  }

  /** The first module, or the whole one where that has not what is needed. Fails if it cannot be loaded. */
  async that(needs: Needs): Promise<Program> {
    if (this.has(this.first, needs)) return this.first;
    this.whole ??= this.loadWhole();
    try {
      return await this.whole;
    } catch {
      this.whole = undefined;
      throw new Error('the other planners could not be loaded: the network is away');
    }
  }
}

let loaded: Promise<Programs> | undefined;

export function load(): Promise<Programs> {
  return loaded ??= loadOnce();
}

/** From their own files, or from the page itself if it was built as one file, which has the whole module only. */
async function loadOnce(): Promise<Programs> {
  const its = JSON.parse(contents) as Contents;
  const inside = document.getElementById('wend-wasm');
  if (!inside) return new Programs(await fetchProgram(firstAddress), its, () => fetchProgram(wholeAddress));
  const packed = Uint8Array.from(atob(inside.textContent ?? ''), (letter) => letter.charCodeAt(0));
  const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const { planners, generators } = its.registry;
  const names = (all: { name: string }[]) => all.map(({ name }) => name);
  const program = await new Response(plain).arrayBuffer();
  return new Programs(program, { ...its, first: { planners: names(planners), generators: names(generators) } }, async () => program);
}

async function fetchProgram(address: string): Promise<Program> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}
