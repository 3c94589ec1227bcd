// Store: the state, who listens to it, and what can be undone.

import { initialState, type State } from './state';

/** Cells before and after a stroke. */
export interface Stroke {
  indices: Uint32Array;
  before: Uint8Array;
  after: Uint8Array;
}

interface Step {
  before: Partial<State>;
  after: Partial<State>;
  stroke?: Stroke;
}

export type Listener = (state: State, before: State, stroke?: Stroke) => void;

/** No more steps than these can be undone. */
const mostSteps = 200;

export class Store {
  private current: State;
  private readonly listeners = new Set<Listener>();
  private past: Step[] = [];
  private future: Step[] = [];

  constructor(state: State = initialState) {
    this.current = state;
  }

  get state(): State {
    return this.current;
  }
  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Returns what ends the listening. */
  listen(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** A change that undo() passes over, such as another layer. */
  set(change: Partial<State>): void {
    this.apply(change);
  }

  /** A change that undo() takes back. */
  commit(change: Partial<State>): void {
    const before = Object.fromEntries(
      Object.keys(change).map((key) => [key, this.current[key as keyof State]])) as Partial<State>;
    this.remember({ before, after: change });
    this.apply(change);
  }

  /** The end of a drag that set() showed: `before` is what it was when it began. */
  commitSince(before: Partial<State>): void {
    const after = Object.fromEntries(
      Object.keys(before).map((key) => [key, this.current[key as keyof State]])) as Partial<State>;
    this.remember({ before, after });
    this.notify(this.current);
  }

  /** Cells that have changed already, as paint() did. */
  commitStroke(stroke: Stroke): void {
    this.remember({ before: {}, after: {}, stroke });
    this.notify(this.current);
  }

  /** Sets cells of the map, without a step to undo. */
  paint(indices: Uint32Array, bytes: Uint8Array): void {
    const map = this.current.map;
    if (!map) return;
    const before = new Uint8Array(indices.length);
    indices.forEach((index, i) => {
      before[i] = map.cells[index]!;
      map.cells[index] = bytes[i]!;
    });
    this.apply({ map: { ...map, version: map.version + 1 } }, { indices, before, after: bytes });
  }

  undo(): boolean {
    return this.travel(this.past, this.future, (step) => [step.before, step.stroke?.before]);
  }
  redo(): boolean {
    return this.travel(this.future, this.past, (step) => [step.after, step.stroke?.after]);
  }

  private travel(
    from: Step[], to: Step[], wanted: (step: Step) => [Partial<State>, Uint8Array | undefined],
  ): boolean {
    const step = from.pop();
    if (!step) return false;
    to.push(step);
    const [change, bytes] = wanted(step);
    if (step.stroke && bytes) this.paint(step.stroke.indices, bytes);
    else this.apply(change);
    return true;
  }

  private remember(step: Step): void {
    this.past.push(step);
    if (this.past.length > mostSteps) this.past.shift();
    this.future = [];
  }

  private apply(change: Partial<State>, stroke?: Stroke): void {
    const before = this.current;
    this.current = { ...before, ...change };
    this.notify(before, stroke);
  }

  private notify(before: State, stroke?: Stroke): void {
    for (const listener of this.listeners) listener(this.current, before, stroke);
  }
}
