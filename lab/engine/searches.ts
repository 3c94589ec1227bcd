// Searches: a runner for each planner of the page, on the same map. Knows which step of each the clock stands for.

import type { Clock } from '../store/clock';
import type { State } from '../store/state';
import type { Stroke } from '../store/store';
import { Engine } from './engine';
import { needsOf, type Programs } from './program';
import { Runner } from './runner';
import type { Planning } from './sampling';
import type { Layer, MapInfo, Failure } from './types';
import { specOf, type Choice, type Recipe } from '../store/state';

export class Searches {
  readonly runners: Runner[] = [];

  constructor(
    private readonly programs: Programs, private readonly clock: Clock,
    /** A search has ended; `all` if none is left. */
    private readonly changed: (all: boolean) => void,
  ) {}

  /** Begins what a change of the state asks for. */
  update(state: State, before: State, stroke: Stroke | undefined, dragging: boolean): void {
    if (stroke) for (const runner of this.runners) runner.edit(stroke);
    this.resize(state.runs.length);
    const all = state.map !== before.map || state.start !== before.start || state.goal !== before.goal ||
      state.footprint !== before.footprint || state.smoother !== before.smoother || state.headings !== before.headings ||
      state.robotFields !== before.robotFields || state.requestFields !== before.requestFields;
    const asksMore = state.following !== before.following || state.widest !== before.widest;
    state.runs.forEach((run, i) => {
      const runner = this.runners[i]!;
      const lacks = asksMore && (runner.failure !== null || !this.programs.has(runner.program, needsOf(state, run)));
      if (all || lacks || run !== before.runs[i]) runner.request(state, run, dragging);
    });
  }

  /** Searches again, also those that were only sketched while ends were dragged. */
  request(state: State, dragging = false): void {
    this.resize(state.runs.length);
    state.runs.forEach((run, i) => this.runners[i]!.request(state, run, dragging));
  }

  async show(layer: Layer): Promise<void> {
    await Promise.all(this.runners.map((runner) => runner.show(layer)));
  }

  /** Ends searches that take too long; their workers begin anew. */
  stop(): void {
    for (const runner of this.runners) runner.stop();
  }

  /** Ends all workers. */
  end(): void {
    this.resize(0);
  }

  get busy(): boolean {
    return this.runners.some((runner) => runner.busy);
  }

  /** The expansions of the longest search. */
  get longest(): number {
    return Math.max(0, ...this.runners.map(({ outcome }) => outcome?.steps ?? 0));
  }

  /** The step of a search at the moment that the clock shows. */
  stepOf(index: number, state: State): number {
    const outcome = this.runners[index]?.outcome;
    if (!outcome) return 0;
    if (state.pace === 'expansions' || this.clock.length === 0) return Math.min(this.clock.step, outcome.steps);
    const slowest = Math.max(...this.runners.map(({ outcome: each }) => each?.seconds ?? 0), 1e-9);
    const seconds = (this.clock.step / this.clock.length) * slowest;
    return Math.min(Math.floor((seconds / Math.max(outcome.seconds, 1e-9)) * outcome.steps), outcome.steps);
  }

  /** The moment of the clock at which a search has made `step` expansions: stepOf() the other way. */
  clockOf(index: number, step: number, state: State): number {
    const outcome = this.runners[index]?.outcome;
    if (!outcome || state.pace === 'expansions' || this.clock.length === 0) return step;
    const slowest = Math.max(...this.runners.map(({ outcome: each }) => each?.seconds ?? 0), 1e-9);
    return Math.ceil((((step / Math.max(outcome.steps, 1)) * outcome.seconds) / slowest) * this.clock.length);
  }

  /** The moments at which a cell is expanded, by any of the searches. */
  async momentsOf(cell: { x: number; y: number } | null, state: State): Promise<number[]> {
    if (!cell) return [];
    const infos = await Promise.all(this.runners.map((runner) => runner.engine.call('cell', cell.x, cell.y)));
    return infos.flatMap((info, i) => ('error' in info || !info.expansion ? [] : [this.clockOf(i, info.expansion, state)]));
  }

  /** A map of a recipe, made beside the searches. */
  async make(recipe: Recipe): Promise<{ info: MapInfo; cells: Uint8Array } | Failure> {
    try {
      const maker = new Engine(await this.programs.that({ generator: recipe.generator }));
      const spec = specOf(recipe.generator, recipe.options);
      const info = await maker.call('generate', spec, recipe.width, recipe.height, recipe.seed);
      const made = 'error' in info ? info : { info, cells: await maker.call('cells') };
      maker.end();
      return made;
    } catch (fault) {
      return { status: 'cancelled', error: (fault as Error).message };
    }
  }

  /** The cells that a search expands, in order, made beside the others; null if it cannot be made. */
  async tryOut(state: State, choice: Choice): Promise<Uint32Array | null> {
    const runner = new Runner(this.programs, () => undefined);
    await runner.search(state, choice);
    const order = runner.outcome ? await runner.engine.call('expansions') : null;
    runner.end();
    return order;
  }

  /** Engines in workers of their own, for other work than the page's searches. */
  helpers(count: number): { planning: Planning; end(): void }[] {
    // The planners of the page: where one is not in the first module, its runner has the whole one.
    const { first } = this.programs;
    const program = this.runners.map((runner) => runner.program).find((each) => each !== first) ?? first;
    return Array.from({ length: count }, () => {
      const engine = new Engine(program);
      return {
        planning: {
          load: (...args) => engine.call('load', ...args), robot: (...args) => engine.call('robot', ...args),
          plan: (task) => engine.call('plan', task),
        },
        end: () => engine.end(),
      };
    });
  }

  private resize(count: number): void {
    while (this.runners.length < count) {
      this.runners.push(new Runner(this.programs, () => this.changed(!this.busy)));
    }
    for (const runner of this.runners.splice(count)) runner.end();
  }
}
