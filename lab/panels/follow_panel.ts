// <lab-follow>: a simulated robot follows the path: its controller, gains on sliders, its error as a plot.

import { css, html, LitElement, nothing } from 'lit';
import type { Extras } from '../engine/extras';
import { sampleSize, type OptionInfo, type Registry } from '../engine/types';
import { notFollowing, readSpec, specOf, type Following, type State } from '../store/state';
import type { Store } from '../store/store';
import { sentence } from './option_field';
import './plot';
import { panelStyle } from './style';
import { number } from './words';

/** What is asked about the robot and the simulation; the rest is as usual. */
const robot: Setting[] = [
  { part: 'robot', name: 'speed', label: 'Speed, m/s', usual: 0.5, most: 3 },
  { part: 'robot', name: 'turn_rate', label: 'Turn rate, rad/s', usual: 1.5, most: 5 },
  { part: 'simulation', name: 'latency', label: 'Latency, s', usual: 0, most: 1 },
  { part: 'simulation', name: 'position_noise', label: 'Noise of the position, m', usual: 0, most: 0.3 },
];

interface Setting {
  part: keyof Following;
  name: string;
  label: string;
  usual: number;
  most: number;
  least?: number;
}

export class FollowPanel extends LitElement {
  static override styles = [panelStyle, css`
    .value { font-variant-numeric: tabular-nums; }
    .drive { display: flex; gap: 0.5rem; align-items: center; }
    .drive input { flex: 1; min-width: 0; }
  `];
  static override properties = {
    store: { attribute: false }, registry: { attribute: false }, state: { attribute: false }, extras: { attribute: false }, version: { type: String },
  };

  declare store: Store;
  declare registry: Registry;
  declare state: State;
  declare extras: Extras;
  declare version: string;
  private quiet: (() => void) | undefined;
  /** What it was before a slider moved. */
  private since: Following | null = null;

  override connectedCallback(): void {
    super.connectedCallback();
    this.quiet = this.extras.clock.listen(() => this.requestUpdate());
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.quiet?.();
  }

  override render() {
    const { name } = readSpec(this.state.following.controller);
    const info = this.registry.controllers.find((each) => each.name === name);
    return html`<div class="stack">
      <label>Controller
        <select @change=${this.choose}>
          <option value="" ?selected=${!info}>No robot drives</option>
          ${this.registry.controllers.map((each) => html`
            <option value=${each.name} title=${each.summary} ?selected=${each.name === name}>${sentence(each.name.replaceAll('_', ' '), '')}</option>`)}
        </select></label>
      ${info ? html`<p>${sentence(info.summary)}</p>
        ${this.outcome()}
        ${info.options.filter(({ kind }) => kind === 'number').map((option) => this.slider(settingOf(option)))}
        ${robot.map((setting) => this.slider(setting))}` : nothing}</div>`;
  }

  private outcome() {
    const { drive, clock } = this.extras;
    if (!drive) return nothing;
    if ('error' in drive) return html`<p role="alert">${sentence(drive.error)}</p>`;
    const count = drive.samples.length / sampleSize;
    const column = (index: number) => Array.from({ length: count }, (_, i) => drive.samples[i * sampleSize + index]!);
    const plot = { data: [column(0), column(5)], names: ['error'], across: 's', up: 'm from the path', dots: false, logarithmic: false };
    return html`
      <p>The robot ${drive.told} after ${number(drive.time, 1)} s; its error is ${number(drive.rms, 3)} m (root mean square), ${number(drive.largest, 3)} m
        at most.${drive.oscillates ? ' It swings to and fro: the gains are too high.' : ''}</p>
      <div class="drive">
        <button @click=${() => clock.toggle()}>${clock.playing ? 'Stop' : 'Drive'}</button>
        <input type="range" aria-label="Moment of the drive" min="0" max=${clock.length} .value=${String(clock.step)}
          aria-valuetext="${number(drive.samples[Math.min(clock.step, count - 1) * sampleSize]!, 1)} s"
          @input=${(event: Event) => { clock.playing = false; clock.seek(Number(valueOf(event))); }}></div>
      <lab-plot .plot=${this.plotOf(drive, plot)} label="Distance of the robot from the path over time, at most ${number(drive.largest, 3)} m"></lab-plot>`;
  }

  private drawn: { of: unknown; plot: unknown } = { of: null, plot: null };
  /** The same object for the same drive, so that it is not drawn again while the robot moves. */
  private plotOf<Plot>(of: unknown, plot: Plot): Plot {
    if (this.drawn.of !== of) this.drawn = { of, plot };
    return this.drawn.plot as Plot;
  }

  private slider({ part, name, label, usual, most, least = 0 }: Setting) {
    const value = Number(readSpec(this.state.following[part]).options[name] ?? usual);
    return html`<label><span>${label}: <span class="value">${number(value, 3)}</span></span>
      <input type="range" min=${least} max=${Math.max(most, value)} step="any" .value=${String(value)}
        @input=${(event: Event) => this.slide(part, name, valueOf(event))}
        @change=${() => this.settle()}></label>`;
  }

  private slide(part: keyof Following, name: string, value: string): void {
    this.since ??= this.state.following;
    const spec = readSpec(this.state.following[part]);
    this.store.set({ following: { ...this.state.following, [part]: specOf(spec.name, { ...spec.options, [name]: value }) } });
  }

  private settle(): void {
    if (this.since) this.store.commitSince({ following: this.since });
    this.since = null;
  }

  private choose(event: Event): void {
    const controller = valueOf(event);
    this.store.commit({ following: controller === '' ? notFollowing : { ...this.state.following, controller } });
  }
}

/** A gain's slider goes to four times its usual value. */
function settingOf(option: OptionInfo): Setting {
  const usual = Number(option.default);
  return {
    part: 'controller', name: option.name, label: sentence(option.name.replaceAll('_', ' '), ''), usual,
    least: Math.min(option.least, usual), most: Math.min(option.greatest ?? Infinity, usual > 0 ? 4 * usual : 2),
  };
}

function valueOf(event: Event): string {
  return (event.target as HTMLInputElement).value;
}

customElements.define('lab-follow', FollowPanel);
