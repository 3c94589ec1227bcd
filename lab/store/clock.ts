// Clock: the moment that is shown, for all searches on the page. In expansions, from 0 to `length`.

/** How fast a replay goes: expansions a second, or so that the whole search takes some seconds. */
export interface Speed {
  label: string;
  perSecond?: number;
  wholeIn?: number;
}

export const speeds: readonly Speed[] = [
  { label: '2 a second', perSecond: 2 },
  { label: '10 a second', perSecond: 10 },
  { label: '50 a second', perSecond: 50 },
  { label: 'all in 30 s', wholeIn: 30 },
  { label: 'all in 8 s', wholeIn: 8 },
  { label: 'all in 3 s', wholeIn: 3 },
];
export const usualSpeed = 4;

export class Clock {
  length = 0;
  playing = false;
  speed = usualSpeed;
  /** Playing stops at each of these steps. */
  stops: readonly number[] = [];
  private at = 0;
  private last: number | undefined;
  private readonly listeners = new Set<() => void>();

  get step(): number {
    return Math.floor(this.at);
  }

  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** A search of this length is shown from its end, or from its beginning if it is to be played. */
  restart(length: number, play: boolean): void {
    this.length = length;
    this.at = play ? 0 : length;
    this.playing = play && length > 0;
    this.last = undefined;
    this.notify();
  }

  seek(step: number): void {
    this.at = Math.min(Math.max(step, 0), this.length);
    this.notify();
  }

  /** One expansion forwards or backwards; stops. */
  move(by: number): void {
    this.playing = false;
    this.seek(this.step + by);
  }

  toggle(): void {
    this.playing = !this.playing && this.length > 0;
    if (this.playing && this.step >= this.length) this.at = 0;
    this.last = undefined;
    this.notify();
  }

  setSpeed(speed: number): void {
    this.speed = speed;
    this.notify();
  }

  /** Goes on to a time in milliseconds. */
  tick(now: number): void {
    if (!this.playing) return;
    const { perSecond, wholeIn } = speeds[this.speed]!;
    const rate = perSecond ?? this.length / wholeIn!;
    const before = this.at;
    if (this.last !== undefined) this.at += (rate * (now - this.last)) / 1000;
    this.last = now;
    const stop = Math.min(...this.stops.filter((step) => step > before && step <= this.at));
    if (stop < Infinity) {
      this.at = stop;
      this.playing = false;
    }
    if (this.at >= this.length) {
      this.at = this.length;
      this.playing = false;
    }
    this.notify();
  }

  private notify(): void {
    for (const listener of this.listeners) listener();
  }
}
