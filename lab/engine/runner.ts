// Runner: one search of the page: an engine, the state that it has been given, and its last answer. Requests that
// come while it works are joined: only the latest counts.

import { specOf, type Choice, type State } from '../store/state';
import type { Stroke } from '../store/store';
import { Engine, type Program } from './engine';
import { needsOf, type Needs, type Programs } from './program';
import type { Failure, Layer, Outcome, Places, Range } from './types';

/** A search that is longer than this while ends are dragged is not written down before they are let go. */
const livelyMilliseconds = 25;

export class Runner {
  engine: Engine;
  outcome: Outcome | null = null;
  failure: Failure | null = null;
  range: Range | null = null;
  busy = false;
  /** Counts answers: who draws it compares. */
  version = 0;

  /** The module of its engine. */
  program: Program;

  private over = false;
  private map: Uint8Array | null = null;
  private pending: Stroke[] = [];
  private robot = '';
  private wanted: { state: State; choice: Choice; dragging: boolean } | null = null;
  private lastRecording = 0;
  private lastSearch = 0;

  constructor(private readonly programs: Programs, private readonly changed: (runner: Runner) => void) {
    this.program = programs.first;
    this.engine = new Engine(this.program);
  }

  /** Cells that changed; for the next request. */
  edit(stroke: Stroke): void {
    this.pending.push(stroke);
  }

  /** Plans for this state as soon as possible. */
  request(state: State, choice: Choice, dragging: boolean): void {
    this.wanted = { state, choice, dragging };
    if (!this.busy) void this.work();
  }

  /** Plans for this state; for one search beside the page's. */
  search(state: State, choice: Choice): Promise<void> {
    return this.plan(state, choice, false);
  }

  /** Ends a search that takes too long. */
  stop(): void {
    if (!this.busy) return;
    this.begin(this.program);
  }

  end(): void {
    this.over = true;
    this.wanted = null;
    this.engine.end();
  }

  /** Another engine in place of this one. */
  private begin(program: Program): void {
    this.engine.end();
    this.program = program;
    this.engine = new Engine(program);
    this.map = null;
    this.robot = '';
  }

  /** Changes to the whole module where the first one has not what is needed. */
  private async equip(needs: Needs): Promise<void> {
    if (this.programs.has(this.program, needs)) return;
    const program = await this.programs.that(needs);
    if (this.over) throw new Error('stopped');
    this.begin(program);
  }

  private async work(): Promise<void> {
    this.busy = true;
    while (this.wanted) {
      const { state, choice, dragging } = this.wanted;
      this.wanted = null;
      try {
        await this.plan(state, choice, dragging);
      } catch (fault) {
        this.outcome = null;
        this.failure = { status: 'cancelled', error: fault instanceof Error ? fault.message : String(fault) };
      }
      ++this.version;
      this.changed(this);
    }
    this.busy = false;
    this.changed(this);
  }

  private async plan(state: State, choice: Choice, dragging: boolean): Promise<void> {
    await this.equip(needsOf(state, choice));
    const painting = dragging && this.pending.length > 0;
    const fault = await this.take(state);
    // A brush does not wait for searches: the next one comes when it is let go.
    if (!fault && painting && this.lastSearch > livelyMilliseconds) {
      this.outcome = null;
      this.failure = null;
      return;
    }
    const record = !dragging || this.lastRecording < livelyMilliseconds;
    const began = performance.now();
    const answer = fault ?? await this.engine.call('plan', {
      planner: specOf(choice.planner, choice.options),
      smoother: state.smoother,
      start: state.start,
      goal: state.goal,
      headings: state.headings,
      record,
      fields: { ...state.requestFields, nearest: String(dragging), time_limit: '60' },
    });
    this.lastSearch = performance.now() - began;
    if (record) this.lastRecording = this.lastSearch;
    const failed = 'error' in answer;
    this.failure = failed ? answer : null;
    this.outcome = failed ? null : answer;
    // A new search has no layer yet.
    if (state.layer === '') this.range = null;
    else await this.show(state.layer);
  }

  async show(layer: Layer): Promise<void> {
    const range = await this.engine.call('show', layer);
    this.range = 'error' in range ? null : range;
  }

  /** Places near both ends where a robot of this shape fits. Fails if the shape or the map is invalid. */
  async places(state: State, footprint: string, headings: boolean): Promise<Places | Failure> {
    const robot = await this.equipRobot({ ...state, footprint });
    return robot ?? this.engine.call('places', state.start, state.goal, headings);
  }

  /** Gives the engine the map, its changes, and the robot. */
  private async take(state: State): Promise<Failure | null> {
    const map = state.map;
    if (!map) return { status: 'invalid_map', error: 'there is no map' };
    const strokes = this.pending;
    this.pending = [];
    if (this.map !== map.cells) {
      const loaded = await this.engine.call('load', map.cells, map.width, map.height, map.frame);
      if ('error' in loaded) return loaded;
      this.map = map.cells;
    } else if (strokes.length > 0) {
      const indices = strokes.flatMap((stroke) => [...stroke.indices]);
      const bytes = indices.map((index) => map.cells[index]!);
      const edited = await this.engine.call('edit', indices, bytes);
      if ('error' in edited) return edited;
    }
    return this.equipRobot(state);
  }

  private async equipRobot({ footprint, robotFields }: State): Promise<Failure | null> {
    const text = footprint + specOf('', robotFields);
    if (this.robot === text) return null;
    const robot = await this.engine.call('robot', footprint, robotFields);
    if ('error' in robot) return robot;
    this.robot = text;
    return null;
  }
}
