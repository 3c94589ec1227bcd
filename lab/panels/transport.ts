// <lab-transport>: play, pause, step, scrub, speed.

import { css, html, LitElement, svg } from 'lit';
import { type Clock, speeds } from '../store/clock';
import { panelStyle } from './style';

const icon = (path: string) => html`<svg width="14" height="14" viewBox="0 0 14 14" aria-hidden="true">${svg`<path d=${path}/>`}</svg>`;
const icons = {
  first: icon('M2 2h2v10H2zM12 2v10L5 7z'),
  back: icon('M11 2v10L3 7z'),
  forward: icon('M3 2v10l8-5z'),
  last: icon('M10 2h2v10h-2zM2 2v10l7-5z'),
};

export class Transport extends LitElement {
  static override styles = [panelStyle, css`
    :host { display: flex; align-items: center; gap: 0.5rem; }
    button { min-width: 2.4rem; display: inline-flex; align-items: center; justify-content: center; }
    svg { fill: currentColor; }
    .play { min-width: 5.2rem; }
    input { flex: 1 1 8rem; min-width: 4rem; }
    .count { font-size: 0.8125rem; font-variant-numeric: tabular-nums; white-space: nowrap; color: var(--faint); }
    label { display: flex; align-items: center; flex: none; }
    @media (max-width: 760px) {
      :host { flex-wrap: wrap; }
      input { order: -2; flex-basis: 100%; }
      .count { order: -1; flex: 1 0 calc(100% - 9rem); }
      label { order: -1; flex: 0 1 8rem; }
      button { flex: 1 1 2.2rem; min-width: 2.2rem; padding: 0.35rem; }
      .play { flex-grow: 2; min-width: 4rem; }
    }
  `];
  static override properties = { clock: { attribute: false } };

  declare clock: Clock;
  private quiet: (() => void) | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.quiet = this.clock?.listen(() => this.requestUpdate());
  }
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.quiet?.();
  }

  override render() {
    const { clock } = this;
    return html`
      <button aria-label="To the beginning" title="To the beginning" @click=${() => clock.move(-clock.length)}>${icons.first}</button>
      <button aria-label="One expansion back" title="One expansion back (,)" @click=${() => clock.move(-1)}>${icons.back}</button>
      <button class="play" aria-keyshortcuts="p" title="Play or pause (P)" @click=${() => clock.toggle()}>${clock.playing ? 'Pause' : 'Play'}</button>
      <button aria-label="One expansion forward" title="One expansion forward (.)" @click=${() => clock.move(1)}>${icons.forward}</button>
      <button aria-label="To the end" title="To the end" @click=${() => clock.move(clock.length)}>${icons.last}</button>
      <input type="range" aria-label="Expansions" min="0" max=${clock.length} .value=${String(clock.step)}
        aria-valuetext="${clock.step} of ${clock.length} expansions"
        @input=${(event: Event) => this.scrub(event)}>
      <span class="count">${clock.step.toLocaleString('en')} of ${clock.length.toLocaleString('en')} expanded</span>
      <label>
        <select aria-label="Speed" @change=${(event: Event) => clock.setSpeed((event.target as HTMLSelectElement).selectedIndex)}>
          ${speeds.map(({ label }, i) => html`<option ?selected=${i === clock.speed}>${label}</option>`)}
        </select>
      </label>`;
  }

  private scrub(event: Event): void {
    this.clock.playing = false;
    this.clock.seek(Number((event.target as HTMLInputElement).value));
  }
}

customElements.define('lab-transport', Transport);
