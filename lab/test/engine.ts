// An engine for tests, in this process.

import { readFile } from 'node:fs/promises';
import { EngineModule } from '../engine/module';
import type { Failure } from '../engine/types';

export const root = new URL('../../', import.meta.url).pathname;

export async function newEngine(): Promise<EngineModule> {
  const bytes = await readFile(`${root}build/lab/wend.wasm`);
  return EngineModule.from(await WebAssembly.compile(bytes));
}

/** The answer, if it is not a failure. */
export function good<Answer>(answer: Answer | Failure): Answer {
  if (typeof answer === 'object' && answer !== null && 'error' in answer) throw new Error(String((answer as Failure).error));
  return answer as Answer;
}

/** Random numbers from 0 up to 1: the same for the same seed. */
export function randomFrom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}
