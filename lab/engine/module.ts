// EngineModule: wend as a WebAssembly module. One instance has one map, one robot and one search.

import { specOf } from '../store/state';
import { generalText, numberOf, shortestText } from './number_text';
import type {
  CellInfo, DriveReport, Failure, Frame, Knowledge, Layer, MapInfo, Outcome, Places, Pose, Range, Registry, Solution, Task, Widest,
  Window,
} from './types';

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  input(bytes: number): number;
  text(): number;
  text_size(): number;
  registry(): void;
  load(width: number, height: number, resolution: number, originX: number, originY: number, originYaw: number, yUp: number, metric: number): void;
  generate(text: number, width: number, height: number, seed: number): void;
  edit(count: number): void;
  robot(footprint: number, fields: number): void;
  plan(planner: number, smoother: number, fields: number, startX: number, startY: number, startHeading: number,
       goalX: number, goalY: number, goalHeading: number, headings: number, record: number): void;
  places(startX: number, startY: number, startHeading: number, goalX: number, goalY: number, goalHeading: number,
         headings: number): void;
  widest(startX: number, startY: number, goalX: number, goalY: number): void;
  drive(controller: number, robot: number, simulation: number): void;
  generation(): number;
  known(): number;
  cell(x: number, y: number): void;
  show(text: number): void;
  paint(width: number, height: number, left: number, top: number, cells: number, step: number): number;
  palette(): number;
  cells(): number;
  cells_size(): number;
  points(): number;
  points_size(): number;
  expansion(): number;
  parents(): number;
  steps(): number;
  expanded_at(step: number): number;
}

/** A path as the engine tells it. */
type PlanText = Omit<Outcome, 'path' | 'solutions'> & { solutions?: (Omit<Solution, 'path'> & { points: number })[] };
/** Numbers of a point: x, y, heading. */
const pointSize = 3;

/** Numbers as text: see lab/wasm/number_text.cpp. */
function numberCalls(memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  return {
    write_number: (value: number, digits: number, address: number): number => {
      const text = digits === 0 ? shortestText(value) : generalText(value, digits);
      return new TextEncoder().encodeInto(text, new Uint8Array(memory().buffer, address, 48)).written;
    },
    read_number: (address: number, size: number, to: number): number => {
      const value = numberOf(new TextDecoder().decode(new Uint8Array(memory().buffer, address, size)));
      if (typeof value !== 'number') return value === undefined ? 1 : 2;
      new DataView(memory().buffer).setFloat64(to, value, true);
      return 0;
    },
  };
}

/** The system calls that the module may make: the clock and random numbers; it has no files. */
function systemCalls(memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const invalid = 8;  // no such file
  const calls: Record<string, (...args: number[]) => number> = {
    clock_time_get: (...args) => {
      const address = Number(args[2]);
      const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
      new DataView(memory().buffer).setBigUint64(address, nanoseconds, true);
      return 0;
    },
    proc_exit: () => {
      throw new Error('the planner ended unexpectedly');
    },
  };
  return new Proxy(calls, {
    get: (known, name) => known[String(name)] ?? (() => invalid),
  }) as WebAssembly.ModuleImports;
}

export class EngineModule {
  private constructor(private readonly wasm: Exports) {}

  static async from(module: WebAssembly.Module): Promise<EngineModule> {
    let memory: WebAssembly.Memory | undefined;
    const calls = numberCalls(() => memory!);
    const system = systemCalls(() => memory!);
    const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      (imports[from] ??= {})[name] = (from === 'lab' ? calls : system)[name]!;
    }
    const instance = await WebAssembly.instantiate(module, imports);
    const wasm = instance.exports as unknown as Exports;
    memory = wasm.memory;
    wasm._initialize();
    return new EngineModule(wasm);
  }

  registry(): Registry {
    this.wasm.registry();
    return this.answer<Registry>();
  }

  load(cells: Uint8Array, width: number, height: number, frame: Frame): MapInfo | Failure {
    this.bytes(this.wasm.input(cells.length), cells.length).set(cells);
    this.wasm.load(width, height, frame.resolution, frame.originX, frame.originY,
                   frame.originYaw, Number(frame.yUp), Number(frame.metric));
    return this.answer<MapInfo | Failure>();
  }

  generate(spec: string, width: number, height: number, seed: number): MapInfo | Failure {
    this.wasm.generate(this.write(spec), width, height, seed);
    return this.answer<MapInfo | Failure>();
  }

  /** Cells of the present map; a copy. */
  cells(): Uint8Array {
    return this.bytes(this.wasm.cells(), this.wasm.cells_size()).slice();
  }

  /** Sets cells to these bytes. */
  edit(indices: ArrayLike<number>, bytes: ArrayLike<number>): MapInfo | Failure {
    const address = this.wasm.input(8 * indices.length);
    const pairs = new Uint32Array(this.wasm.memory.buffer, address, 2 * indices.length);
    for (let i = 0; i < indices.length; ++i) {
      pairs[2 * i] = indices[i]!;
      pairs[2 * i + 1] = bytes[i]!;
    }
    this.wasm.edit(indices.length);
    return this.answer<MapInfo | Failure>();
  }

  /** The robot's shape, and what else is set of it: see Registry.robotFields. */
  robot(footprint: string, fields: Record<string, string> = {}): MapInfo | Failure {
    const [shape, rest] = this.writeAll(footprint, specOf('robot', fields));
    this.wasm.robot(shape!, rest!);
    return this.answer<MapInfo | Failure>();
  }

  plan(task: Task): Outcome | Failure {
    const [planner, smoother, fields] = this.writeAll(task.planner, task.smoother ?? '', specOf('request', task.fields ?? {}));
    this.wasm.plan(planner!, smoother!, fields!, task.start.x, task.start.y, task.start.heading,
                   task.goal.x, task.goal.y, task.goal.heading, Number(task.headings), Number(task.record));
    const outcome = this.answer<PlanText | Failure>();
    if ('error' in outcome) return outcome;
    const points = this.points();
    const found = outcome.solutions ?? [];
    // The answer's points come first, then those of one solution after another.
    let at = points.length - pointSize * found.reduce((sum, solution) => sum + solution.points, 0);
    const path = points.slice(0, at);
    const solutions = found.map(({ points: count, ...solution }) => ({ ...solution, path: points.slice(at, at += pointSize * count) }));
    return { ...outcome, path, solutions };
  }

  /** The nearest places where the robot fits: at their headings, or for a planner on cells. */
  places(start: Pose, goal: Pose, headings: boolean): Places | Failure {
    this.wasm.places(start.x, start.y, start.heading, goal.x, goal.y, goal.heading, Number(headings));
    return this.answer<Places | Failure>();
  }

  widest(start: Pose, goal: Pose): Widest | Failure {
    this.wasm.widest(start.x, start.y, goal.x, goal.y);
    const answer = this.answer<Widest | Failure>();
    return 'error' in answer || !answer.joined ? answer : { ...answer, path: this.points() };
  }

  /** Drives along the last path: "pid:kp=1", "robot:speed=0.3", "simulation:rate=20". */
  drive(controller: string, robot: string, simulation: string): DriveReport | Failure {
    const [itsController, itsRobot, itsSimulation] = this.writeAll(controller, robot, simulation);
    this.wasm.drive(itsController!, itsRobot!, itsSimulation!);
    const answer = this.answer<DriveReport | Failure>();
    return 'error' in answer ? answer : { ...answer, samples: this.points() };
  }

  cell(x: number, y: number): CellInfo | Failure {
    this.wasm.cell(x, y);
    const info = this.answer<CellInfo | Failure>();
    return 'error' in info ? info : { ...info, chain: this.points() };
  }

  show(layer: Layer): Range | Failure {
    this.wasm.show(this.write(layer));
    return this.answer<Range | Failure>();
  }

  /** The colours of lab/wasm/painter.hpp, as bytes of a canvas. */
  setPalette(colours: Uint32Array): void {
    new Uint32Array(this.wasm.memory.buffer, this.wasm.palette(), colours.length).set(colours);
  }

  /** Paints the map after `step` expansions; a copy of the pixels. */
  paint(window: Window, step: number): Uint8ClampedArray<ArrayBuffer> {
    const address = this.wasm.paint(window.width, window.height, window.left, window.top, window.cells, step);
    return new Uint8ClampedArray(this.wasm.memory.buffer, address, 4 * window.width * window.height).slice();
  }

  /** The cells in their order of expansion. */
  expansions(): Uint32Array {
    const order = new Uint32Array(this.wasm.steps());
    for (let step = 1; step <= order.length; ++step) order[step - 1] = this.wasm.expanded_at(step);
    return order;
  }

  /** The index of the cell that an expansion took, from 1; not above the steps of the search. */
  expandedAt(step: number): number {
    return this.wasm.expanded_at(step);
  }

  /** For each cell of the map the index of its parent; 2^32 - 1: none. Empty without a recorded search. */
  parents(): Uint32Array {
    const size = this.wasm.steps() === 0 ? 0 : this.wasm.cells_size();
    return new Uint32Array(this.wasm.memory.buffer, this.wasm.parents(), size).slice();
  }

  /** What the search knew of each cell; empty arrays without a recorded search. */
  knowledge(): Knowledge {
    const size = this.wasm.steps() === 0 ? 0 : this.wasm.cells_size();
    const numbers = (address: number) => new Uint32Array(this.wasm.memory.buffer, address, size).slice();
    return {
      expansion: numbers(this.wasm.expansion()), generation: numbers(this.wasm.generation()), parent: numbers(this.wasm.parents()),
      known: new Float32Array(this.wasm.memory.buffer, this.wasm.known(), 3 * size).slice(),
    };
  }

  private write(text: string): number {
    const coded = utf8(text);
    this.bytes(this.wasm.input(coded.length), coded.length).set(coded);
    return coded.length;
  }

  /** Texts one behind the other: their sizes. */
  private writeAll(...texts: string[]): number[] {
    this.write(texts.join(''));
    return texts.map((text) => utf8(text).length);
  }

  private answer<Answer>(): Answer {
    const text = this.bytes(this.wasm.text(), this.wasm.text_size());
    return JSON.parse(new TextDecoder().decode(text)) as Answer;
  }

  private points(): Float64Array {
    return new Float64Array(this.wasm.memory.buffer, this.wasm.points(), this.wasm.points_size()).slice();
  }

  /** A view of memory: valid until the next call. */
  private bytes(address: number, size: number): Uint8Array {
    return new Uint8Array(this.wasm.memory.buffer, address, size);
  }
}

function utf8(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}
