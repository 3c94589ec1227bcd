// <lab-layers>: what the colours of the map mean.

import { css, html, LitElement, nothing } from 'lit';
import type { Layer, Range } from '../engine/types';
import { endsAtClosest, leadsOut, type State } from '../store/state';
import type { Store } from '../store/store';
import { panelStyle } from './style';
import { number } from './words';

const layers: { layer: Layer; label: string }[] = [
  { layer: '', label: 'Expanded and frontier' },
  { layer: 'expansion', label: 'Order of expansion' },
  { layer: 'g', label: 'g: cost from the start' },
  { layer: 'h', label: 'h: estimate to the goal' },
  { layer: 'f', label: 'f: priority' },
  { layer: 'cost', label: 'Cost to go' },
  { layer: 'clearance', label: 'Clearance' },
];

export class LayersPanel extends LitElement {
  static override styles = [panelStyle, css`
    ul { list-style: none; margin: 0; padding: 0; display: flex; flex-wrap: wrap; gap: 0.3rem 0.9rem; font-size: 0.8125rem; color: var(--faint); }
    li { display: flex; align-items: center; gap: 0.4rem; }
    li i { width: 0.8rem; height: 0.8rem; border-radius: 2px; }
    li i.line { height: 0.25rem; }
    li i.out { width: 1.3rem; background: radial-gradient(circle, var(--path) 65%, transparent 70%) 0 / 0.4rem 100%; }
    li i.gap { width: 1.3rem; height: 0.2rem; background: radial-gradient(circle, var(--goal) 65%, transparent 70%) 0 / 0.3rem 100%; }
    .ramp { display: flex; align-items: center; gap: 0.5rem; font-size: 0.8125rem; font-variant-numeric: tabular-nums; color: var(--faint); }
    .ramp i { flex: 1; height: 0.7rem; border-radius: 3px; background: var(--ramp); }
  `];
  static override properties = { store: { attribute: false }, state: { attribute: false }, range: { attribute: false } };

  declare store: Store;
  declare state: State;
  declare range: Range | null;

  override render() {
    return html`<div class="stack">
      <label>Show
        <select @change=${this.choose}>
          ${layers.map(({ layer, label }) => html`<option ?selected=${layer === this.state.layer}>${label}</option>`)}
        </select></label>
      ${this.legend()}
      <label class="check"><input type="checkbox" .checked=${this.state.arrows}
        @change=${(event: Event) => this.store.set({ arrows: (event.target as HTMLInputElement).checked })}>
        Arrows to parents</label></div>`;
  }

  private legend() {
    if (this.state.layer !== '' && this.range) {
      return html`<div class="ramp"><span>${number(this.range.least, 1)}</span><i></i><span>${number(this.range.greatest, 1)}</span></div>`;
    }
    return html`<ul>
      <li><i style="background:var(--expanded)"></i>expanded</li>
      <li><i style="background:var(--frontier)"></i>frontier</li>
      <li><i style="background:var(--current)"></i>last expanded</li>
      <li><i class="line" style="background:var(--path)"></i>path</li>
      ${leadsOut(this.state) ? html`<li><i class="line out"></i>way out</li>` : nothing}
      ${endsAtClosest(this.state) ? html`<li><i class="line gap"></i>distance that remains</li>` : nothing}</ul>`;
  }

  private choose(event: Event): void {
    const { layer } = layers[(event.target as HTMLSelectElement).selectedIndex]!;
    this.dispatchEvent(new CustomEvent('show', { detail: layer }));
  }
}

customElements.define('lab-layers', LayersPanel);
