// Extras: what the page asks about the first search besides the search itself: a drive along its path, the widest path,
// the moments at which its break-point is expanded. Asked again after each answer; only the latest request counts.

import { Clock } from '../store/clock';
import type { State } from '../store/state';
import type { Searches } from './searches';
import { sampleSize, type DriveReport, type Failure, type Widest } from './types';

export class Extras {
  drive: DriveReport | Failure | null = null;
  widest: Widest | Failure | null = null;
  /** Of the drive, in commands. */
  readonly clock = new Clock();
  /** Counts the drives that were asked for. */
  private drives = 0;

  constructor(private readonly searches: Searches, private readonly searchClock: Clock, private readonly changed: () => void) {}

  /** Asks all that the state wants. `anew`: the search has another answer. */
  async ask(state: State, before: State | null): Promise<void> {
    try {
      await this.askAll(state, before);
    } catch {
      this.clear();  // the engine was ended: the next answer asks again
    }
    this.changed();
  }

  /** What belongs to a search that is gone. */
  clear(): void {
    ++this.drives;
    this.widest = null;
    this.take(null);
  }

  private async askAll(state: State, before: State | null): Promise<void> {
    const anew = before === null;
    const runner = this.searches.runners[0];
    if (!runner) return;
    if (anew || state.breakPoint !== before.breakPoint || state.pace !== before.pace) {
      this.searchClock.stops = await this.searches.momentsOf(state.breakPoint, state);
    }
    if (anew || state.widest !== before.widest) {
      this.widest = state.widest ? await runner.engine.call('widest', state.start, state.goal) : null;
    }
    if (anew || state.following !== before.following) {
      const drives = ++this.drives;
      const { controller, robot, simulation } = state.following;
      const drive = controller === '' ? null : await runner.engine.call('drive', controller, robot, simulation);
      if (drives === this.drives) this.take(drive);
    }
  }

  /** The numbers of the drive at the moment that is shown: see sampleSize. */
  sample(): Float64Array | null {
    if (!this.drive || 'error' in this.drive) return null;
    const at = Math.min(this.clock.step, this.drive.samples.length / sampleSize - 1);
    return this.drive.samples.subarray(at * sampleSize, (at + 1) * sampleSize);
  }

  private take(drive: DriveReport | Failure | null): void {
    this.drive = drive;
    const length = drive && 'samples' in drive ? drive.samples.length / sampleSize : 0;
    if (length !== this.clock.length) this.clock.restart(length, false);
  }
}
