// A worker: an EngineModule that answers messages one after another.

import { EngineModule } from './module';

/** A call of a method of EngineModule, and its answer. */
export interface Call {
  id: number;
  method: string;
  args: unknown[];
}
export interface Answer {
  id: number;
  value?: unknown;
  fault?: string;
}

const scope = self as unknown as {
  onmessage: ((event: MessageEvent) => void) | null;
  postMessage(message: unknown, transfer?: Transferable[]): void;
};

let engine: Promise<EngineModule>;

scope.onmessage = (event: MessageEvent<Call | WebAssembly.Module | ArrayBuffer>) => {
  const { data } = event;
  if (data instanceof WebAssembly.Module) engine = EngineModule.from(data);
  else if (data instanceof ArrayBuffer) engine = WebAssembly.compile(data).then((module) => EngineModule.from(module));
  else void answer(data);
};

async function answer({ id, method, args }: Call): Promise<void> {
  try {
    const module = await engine as unknown as Record<string, (...args: unknown[]) => unknown>;
    const value = module[method]!(...args);
    const transfer = ArrayBuffer.isView(value) ? [value.buffer as ArrayBuffer] : [];
    scope.postMessage({ id, value } satisfies Answer, transfer);
  } catch (fault) {
    scope.postMessage({ id, fault: String(fault) } satisfies Answer);
  }
}
