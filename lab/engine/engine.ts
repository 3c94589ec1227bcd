// Engine: an EngineModule in a worker of its own. Calls return promises and are answered in order.

import EngineWorker from './worker?worker&inline';
import type { EngineModule } from './module';
import type { Answer, Call } from './worker';

type Method = {
  [Name in keyof EngineModule]: EngineModule[Name] extends (...args: never[]) => unknown ? Name : never;
}[keyof EngineModule];

interface Waiting {
  resolve(value: unknown): void;
  reject(fault: Error): void;
}

/** A compiled module, or its bytes where a worker is not given compiled ones: on pages from a folder. */
export type Program = WebAssembly.Module | ArrayBuffer;

export class Engine {
  private readonly worker = new EngineWorker();
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;

  constructor(program: Program) {
    this.worker.onmessage = (event: MessageEvent<Answer>) => this.settle(event.data);
    this.worker.onerror = (event) => this.fail(event.message);
    this.worker.postMessage(program);
  }

  call<Name extends Method>(
    method: Name, ...args: Parameters<EngineModule[Name]>
  ): Promise<ReturnType<EngineModule[Name]>> {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (value: unknown) => void, reject });
      this.worker.postMessage({ id, method, args } satisfies Call);
    });
  }

  /** Ends the worker, also in the middle of a search. Calls that wait are rejected. */
  end(): void {
    this.worker.terminate();
    this.fail('stopped');
  }

  private settle({ id, value, fault }: Answer): void {
    const waiting = this.waiting.get(id);
    this.waiting.delete(id);
    if (fault === undefined) waiting?.resolve(value);
    else waiting?.reject(new Error(fault));
  }

  private fail(message: string): void {
    for (const waiting of this.waiting.values()) waiting.reject(new Error(message));
    this.waiting.clear();
  }
}
