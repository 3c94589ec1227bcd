// Lesson: the exercise that the page asks, and how it stands. The store has which one, so that a link opens it.

import type { Registry } from '../engine/types';
import type { Searches } from '../engine/searches';
import type { Clock } from '../store/clock';
import type { Exercise } from '../store/state';
import type { Store } from '../store/store';
import type { Point } from '../view/camera';
import * as greedy from './greedy';
import * as heuristic from './heuristic';
import { guess } from './next';
import { noScore, scored, type Score } from './score';

export class Lesson {
  score: Score = noScore;
  /** Was the present question answered right? */
  solved = false;
  /** Of "break greedy": the best ratio so far, and the cells when it began. */
  best = 1;
  private begun: { exercise: Exercise; cells: Uint8Array; of: Uint8Array } | null = null;

  constructor(
    private readonly store: Store, private readonly clock: Clock, private readonly searches: () => Searches,
    private readonly registry: Registry, private readonly say: (message: string) => void,
  ) {}

  get heuristics(): string[] {
    return heuristic.heuristics(this.registry.planners);
  }

  /** Asks an exercise about the present map. */
  begin(exercise: Exercise): void {
    const { state } = this.store;
    this.begun = null;
    if (exercise === 'greedy') this.store.commit({ exercise, runs: greedy.runs });
    else if (exercise === 'heuristic') this.store.commit({ exercise, runs: [this.drawn(heuristic.asked(state.runs[0]))] });
    else this.store.set({ exercise });
    this.clock.playing = false;
    if (exercise === 'next') this.clock.seek(1);
  }

  /** The searches have answered: of an exercise that begins, all begins anew. */
  answered(): void {
    const { exercise, map } = this.store.state;
    if (exercise === '' || !map) {
      this.begun = null;
      return;
    }
    if (this.begun?.exercise !== exercise || this.begun.of !== map.cells) {
      this.begun = { exercise, cells: map.cells.slice(), of: map.cells };
      this.score = noScore;
      this.best = 1;
      this.solved = false;
    }
    if (exercise === 'greedy') this.measure();
  }

  /** The visitor names a cell. */
  async cell(cell: Point): Promise<void> {
    if (this.store.state.exercise !== 'next') return;
    const runner = this.searches().runners[0]!;
    const { map } = this.store.state;
    const step = this.searches().stepOf(0, this.store.state);
    if (!map || !runner.outcome || step >= runner.outcome.steps) return this.say('The search has ended: go back to an earlier moment.');
    const told = {
      expandedAt: (at: number) => runner.engine.call('expandedAt', at),
      cell: (x: number, y: number) => runner.engine.call('cell', x, y),
    };
    this.score = await guess(told, map.width, step, cell, this.score);
    this.clock.move(1);
    this.say(this.score.said);
  }

  /** The visitor names a heuristic. */
  async heuristic(name: string): Promise<void> {
    const run = this.store.state.runs[0]!;
    const truth = heuristic.heuristicOf(run);
    const same = name !== truth && await this.looksTheSame(name);
    this.score = heuristic.named(name, truth, same, this.score);
    this.solved = name === truth || same;
    this.say(this.score.said);
  }

  /** Another search to ask about. */
  another(): void {
    this.solved = false;
    this.score = { ...this.score, said: '' };
    this.store.set({ runs: [this.drawn(this.store.state.runs[0]!)] });
  }

  private drawn(run: ReturnType<typeof heuristic.asked>) {
    return heuristic.another(run, this.registry.planners, Math.random());
  }

  /** Does the search expand the same cells in the same order with this estimate? */
  private async looksTheSame(name: string): Promise<boolean> {
    const { state } = this.store;
    const run = state.runs[0]!;
    const other = await this.searches().tryOut(state, { ...run, options: { ...run.options, heuristic: name } });
    const shown = await this.searches().runners[0]!.engine.call('expansions');
    return other !== null && other.length === shown.length && other.every((cell, i) => cell === shown[i]);
  }

  private measure(): void {
    const [greedyRun, best] = this.searches().runners;
    const costs = [greedyRun?.outcome?.cost, best?.outcome?.cost];
    const ratio = costs[0] && costs[1] ? costs[0] / costs[1] : null;
    const attempt = { ratio, changed: greedy.changedCells(this.begun!.cells, this.begun!.of) };
    if (greedy.counts(attempt)) this.best = Math.max(this.best, ratio!);
    const broken = this.best >= greedy.wanted;
    const said = greedy.told(attempt, this.best);
    this.score = broken && !this.solved ? scored(this.score, true, said) : { ...this.score, said };
    this.solved = broken;
  }
}
